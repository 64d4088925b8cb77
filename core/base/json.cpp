// SPDX-License-Identifier: MIT
#include "base/json.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace versorium {
namespace {

// Builds the document from the parser's events, so that depth and duplicate keys are checked before
// anything is copied.
class StrictBuilder final : public nlohmann::json_sax<Json> {
  public:
    Json root;
    std::string fault;

    bool null() override { return add(nullptr); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(std::int64_t value) override { return add(value); }
    bool number_unsigned(std::uint64_t value) override { return add(value); }
    bool number_float(double value, const std::string& text) override {
        if (!std::isfinite(value)) return refuse(path() + ": the number " + text + " is too large");
        return add(value);
    }
    bool string(std::string& value) override { return add(std::move(value)); }
    bool binary(Json::binary_t&) override { return refuse("binary values are not JSON"); }
    bool start_object(std::size_t) override { return open(Json::object()); }
    bool start_array(std::size_t) override { return open(Json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(std::string& value) override {
        key_ = value;
        // Looking for a key takes time in proportion to their number.
        if (stack_.back()->size() >= kJsonKeys)
            return refuse(path() + ": more than " + std::to_string(kJsonKeys) +
                          " keys in one object");
        if (stack_.back()->contains(value))
            return refuse(path() + ": the key stands twice; keep one of them");
        return true;
    }
    bool parse_error(std::size_t, const std::string&,
                     const nlohmann::detail::exception& error) override {
        const std::string text = error.what();
        const std::size_t start = text.find("] ");
        fault = "not JSON: " + (start == std::string::npos ? text : text.substr(start + 2));
        return false;
    }

  private:
    bool refuse(std::string message) {
        fault = std::move(message);
        return false;
    }

    Json* place(Json value) {
        if (stack_.empty()) {
            root = std::move(value);
            return &root;
        }
        Json& parent = *stack_.back();
        if (parent.is_array()) {
            parent.push_back(std::move(value));
            return &parent.back();
        }
        return &(parent[key_] = std::move(value));
    }
    bool add(Json value) {
        place(std::move(value));
        return true;
    }
    bool open(Json value) {
        if (stack_.size() >= kJsonDepth)
            return refuse("nested more than " + std::to_string(kJsonDepth) + " levels deep");
        const std::string name = stack_.empty() ? "" : stack_.back()->is_array() ? "[]" : key_;
        stack_.push_back(place(std::move(value)));
        names_.push_back(name);
        return true;
    }
    bool close() {
        stack_.pop_back();
        names_.pop_back();
        return true;
    }
    std::string path() const {
        std::string text;
        for (const std::string& name : names_)
            if (!name.empty()) text += name == "[]" ? name : (text.empty() ? "" : ".") + name;
        return text.empty() ? key_ : text + "." + key_;
    }

    // Pointers into `root`: a parent never grows while a child is open.
    std::vector<Json*> stack_;
    std::vector<std::string> names_;
    std::string key_;
};

bool plainList(const Json& value) {
    for (const Json& item : value)
        if (item.is_structured()) return false;
    return true;
}

void print(const Json& value, int depth, std::string& out) {
    const std::string pad(static_cast<std::size_t>(2 * depth + 2), ' ');
    if (!value.is_structured()) {
        out += value.dump(-1, ' ', false, Json::error_handler_t::replace);
    } else if (value.empty()) {
        out += value.is_array() ? "[]" : "{}";
    } else if (value.is_array() && plainList(value)) {
        out += '[';
        for (std::size_t i = 0; i < value.size(); ++i) {
            if (i > 0) out += ", ";
            print(value[i], depth, out);
        }
        out += ']';
    } else {
        const bool array = value.is_array();
        out += array ? "[" : "{";
        bool first = true;
        for (auto item = value.begin(); item != value.end(); ++item) {
            out += first ? "\n" : ",\n";
            first = false;
            out += pad;
            if (!array) out += Json(item.key()).dump() + ": ";
            print(*item, depth + 1, out);
        }
        out += "\n" + pad.substr(2) + (array ? "]" : "}");
    }
}

}  // namespace

Expected<Json> parseJson(std::string_view text) {
    StrictBuilder builder;
    if (!Json::sax_parse(text.begin(), text.end(), &builder))
        return Status::data(builder.fault.empty() ? "not JSON" : builder.fault);
    return std::move(builder.root);
}

std::string printJson(const Json& value) {
    std::string out;
    print(value, 0, out);
    out += '\n';
    return out;
}

std::string formatNumber(double value) {
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value < 0 ? "-inf" : "inf";
    char buffer[40];
    // Whole numbers of moderate size without an exponent: "10", not "1e+01".
    if (value == std::floor(value) && std::abs(value) < 1e15 &&
        (value != 0 || !std::signbit(value))) {
        std::snprintf(buffer, sizeof buffer, "%.0f", value);
        return buffer;
    }
    for (int digits = 1; digits <= 17; ++digits) {
        std::snprintf(buffer, sizeof buffer, "%.*g", digits, value);
        if (std::strtod(buffer, nullptr) == value) break;
    }
    return buffer;
}

std::string formatNumber(double value, int digits) {
    if (!std::isfinite(value)) return formatNumber(value);
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.*g", digits, value);
    return buffer;
}

Json numbersToJson(const std::vector<double>& values) {
    Json list = Json::array();
    for (double value : values) list.push_back(value);
    return list;
}

Status readNumber(const Json& json, double low, double high, double& value) {
    if (!json.is_number()) return Status::data("a number is expected");
    const double number = json.get<double>();
    if (!(number >= low && number <= high))
        return Status::data(formatNumber(number) + " is out of range: " + formatNumber(low) +
                            " to " + formatNumber(high));
    value = number;
    return {};
}

Status readWhole(const Json& json, int low, int high, int& value) {
    double number = 0;
    if (Status status = readNumber(json, low, high, number); !status.ok()) return status;
    if (number != std::floor(number))
        return Status::data(formatNumber(number) + " is not a whole number");
    value = static_cast<int>(number);
    return {};
}

Status readToggle(const Json& json, bool& value) {
    if (!json.is_boolean()) return Status::data("true or false is expected");
    value = json.get<bool>();
    return {};
}

Status readText(const Json& json, std::string& value) {
    if (!json.is_string()) return Status::data("a text in quotes is expected");
    value = json.get<std::string>();
    return {};
}

Status readWord(const Json& json, const std::vector<std::string>& words, std::string& value) {
    std::string chosen;
    if (Status status = readText(json, chosen); !status.ok()) return status;
    std::string all;
    for (const std::string& word : words) {
        if (word == chosen) {
            value = chosen;
            return {};
        }
        all += (all.empty() ? "" : ", ") + word;
    }
    return Status::data("\"" + chosen + "\" is not one of: " + all);
}

Status readNumbers(const Json& json, std::size_t least, std::size_t most,
                   std::vector<double>& value) {
    const Json list = json.is_number() ? Json::array({json}) : json;
    std::vector<double> read;
    bool good = list.is_array() && list.size() >= least && list.size() <= most;
    for (std::size_t k = 0; good && k < list.size(); ++k) {
        good = list[k].is_number() && std::isfinite(list[k].get<double>());
        if (good) read.push_back(list[k].get<double>());
    }
    if (!good)
        return Status::data(least == most
                                ? "a list of " + std::to_string(least) + " numbers is expected"
                                : "a list of " + std::to_string(least) + " to " +
                                      std::to_string(most) + " numbers is expected");
    value = std::move(read);
    return {};
}

ObjectReader::ObjectReader(const Json& value, std::string path)
    : value_(value), path_(std::move(path)) {
    if (!value_.is_object()) fail("an object { … } is expected here");
}

std::string ObjectReader::pathOf(const char* key) const {
    return path_.empty() ? key : path_ + "." + key;
}

void ObjectReader::fail(const Status& status) {
    if (status_.ok() && !status.ok()) status_ = status;
}
void ObjectReader::fail(const std::string& message) {
    fail(Status::data(path_.empty() ? message : path_ + ": " + message));
}
void ObjectReader::fail(const char* key, const std::string& message) {
    fail(Status::data(pathOf(key) + ": " + message));
}

bool ObjectReader::has(const char* key) const { return value_.is_object() && value_.contains(key); }

const Json* ObjectReader::child(const char* key) {
    known_.insert(key);
    if (!has(key)) return nullptr;
    return &*value_.find(key);
}

ObjectReader& ObjectReader::number(const char* key, double& value, double low, double high) {
    if (const Json* found = child(key)) fail(readNumber(*found, low, high, value).in(pathOf(key)));
    return *this;
}

ObjectReader& ObjectReader::integer(const char* key, int& value, int low, int high) {
    if (const Json* found = child(key)) fail(readWhole(*found, low, high, value).in(pathOf(key)));
    return *this;
}

ObjectReader& ObjectReader::boolean(const char* key, bool& value) {
    if (const Json* found = child(key)) fail(readToggle(*found, value).in(pathOf(key)));
    return *this;
}

ObjectReader& ObjectReader::text(const char* key, std::string& value) {
    if (const Json* found = child(key)) fail(readText(*found, value).in(pathOf(key)));
    return *this;
}

ObjectReader& ObjectReader::word(const char* key, std::string& value,
                                 const std::vector<std::string>& words) {
    if (const Json* found = child(key)) fail(readWord(*found, words, value).in(pathOf(key)));
    return *this;
}

ObjectReader& ObjectReader::numbers(const char* key, std::vector<double>& value, std::size_t least,
                                    std::size_t most) {
    if (const Json* found = child(key))
        fail(readNumbers(*found, least, most, value).in(pathOf(key)));
    return *this;
}

Status ObjectReader::finish() {
    if (!status_.ok()) return status_;
    for (auto item = value_.begin(); item != value_.end(); ++item)
        if (!known_.contains(item.key())) {
            std::string all;
            for (const std::string& name : known_) all += (all.empty() ? "" : ", ") + name;
            return Status::data(pathOf(item.key().c_str()) + ": unknown key; known here: " + all);
        }
    return {};
}

}  // namespace versorium
