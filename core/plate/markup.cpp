// SPDX-License-Identifier: MIT
#include "plate/markup.h"

namespace versorium {
namespace {

constexpr int kDepth = 8;
constexpr std::size_t kLengthLimit = 20000;
constexpr char32_t kHat = 0x302;

class Parser {
  public:
    explicit Parser(std::string_view text) : text_(text) {}

    // Items up to the end, or up to the closing brace when `inside`.
    Status items(Markup& out, bool bold, bool inside, int depth) {
        if (depth > kDepth) return fault("nested too deep");
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '}' && inside) {
                ++at_;
                return {};
            }
            if (Status status = item(out, bold, depth); !status.ok()) return status;
        }
        return inside ? fault("a brace { is not closed") : Status();
    }

  private:
    Status fault(const std::string& what) const {
        return Status::data("in the text \"" + std::string(text_.substr(0, 60)) +
                            (text_.size() > 60 ? "…" : "") + "\" at byte " + std::to_string(at_) +
                            ": " + what);
    }

    Status item(Markup& out, bool bold, int depth) {
        const char c = text_[at_];
        const bool brace = at_ + 1 < text_.size() && text_[at_ + 1] == '{';
        if ((c == '_' || c == '^') && brace) {
            at_ += 2;
            return script(out, c == '^', bold, depth);
        }
        if (c == '\\') return command(out, bold, depth);
        char32_t letter = 0;
        if (!next(letter)) return fault("not UTF-8");
        if (letter == kHat && !out.empty() && out.back().kind == MarkupItem::Kind::letter) {
            MarkupItem hat{
                .kind = MarkupItem::Kind::hat, .bold = bold, .upper = {out.back()}, .lower = {}};
            out.back() = std::move(hat);
        } else if (letter == ' ' || letter == '\n' || letter == '\t') {
            out.push_back({.kind = MarkupItem::Kind::space,
                           .letter = ' ',
                           .bold = bold,
                           .upper = {},
                           .lower = {}});
        } else {
            out.push_back({.letter = letter, .bold = bold, .upper = {}, .lower = {}});
        }
        return {};
    }

    Status script(Markup& out, bool upper, bool bold, int depth) {
        Markup inner;
        if (Status status = items(inner, bold, true, depth + 1); !status.ok()) return status;
        // A sub- and a superscript in a row stand above each other.
        const bool joins = !out.empty() && out.back().kind == MarkupItem::Kind::script &&
                           (upper ? out.back().upper : out.back().lower).empty();
        if (!joins)
            out.push_back(
                {.kind = MarkupItem::Kind::script, .bold = bold, .upper = {}, .lower = {}});
        (upper ? out.back().upper : out.back().lower) = std::move(inner);
        return {};
    }

    Status command(Markup& out, bool bold, int depth) {
        const std::string_view rest = text_.substr(at_ + 1);
        if (!rest.empty() && std::string_view("_^{}\\").find(rest[0]) != std::string_view::npos) {
            out.push_back(
                {.letter = static_cast<char32_t>(rest[0]), .bold = bold, .upper = {}, .lower = {}});
            at_ += 2;
            return {};
        }
        if (rest.starts_with("bold{")) {
            at_ += 6;
            return items(out, true, true, depth + 1);
        }
        if (rest.starts_with("hat{")) {
            at_ += 5;
            MarkupItem hat{.kind = MarkupItem::Kind::hat, .bold = bold, .upper = {}, .lower = {}};
            if (Status status = items(hat.upper, bold, true, depth + 1); !status.ok())
                return status;
            out.push_back(std::move(hat));
            return {};
        }
        if (rest.starts_with("par") && (rest.size() == 3 || rest[3] == ' ')) {
            if (depth > 0) return fault("a paragraph cannot begin within braces");
            at_ += rest.size() == 3 ? 4 : 5;
            out.push_back({.kind = MarkupItem::Kind::paragraph, .upper = {}, .lower = {}});
            return {};
        }
        return fault("unknown command; there are \\hat{…}, \\bold{…}, \\par, _{…}, ^{…} and \\\\");
    }

    bool next(char32_t& letter) {
        const auto lead = static_cast<unsigned char>(text_[at_]);
        const std::size_t length = lead < 0x80   ? 1
                                   : lead < 0xc2 ? 0
                                   : lead < 0xe0 ? 2
                                   : lead < 0xf0 ? 3
                                   : lead < 0xf5 ? 4
                                                 : 0;
        if (length == 0 || at_ + length > text_.size()) return false;
        letter = length == 1 ? lead : lead & (0x7fU >> length);
        for (std::size_t k = 1; k < length; ++k) {
            const auto byte = static_cast<unsigned char>(text_[at_ + k]);
            if ((byte & 0xc0) != 0x80) return false;
            letter = letter << 6 | (byte & 0x3fU);
        }
        at_ += length;
        return true;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

void appendPlain(std::string& out, const Markup& markup);

void appendScript(std::string& out, char sign, const Markup& markup) {
    if (markup.empty()) return;
    out += sign;
    if (markup.size() > 1) out += '(';
    appendPlain(out, markup);
    if (markup.size() > 1) out += ')';
}

void appendPlain(std::string& out, const Markup& markup) {
    for (const MarkupItem& item : markup) switch (item.kind) {
            case MarkupItem::Kind::letter:
            case MarkupItem::Kind::space:
                appendUtf8(out, item.letter);
                break;
            case MarkupItem::Kind::paragraph:
                out += "\n\n";
                break;
            case MarkupItem::Kind::hat:
                appendPlain(out, item.upper);
                appendUtf8(out, kHat);
                break;
            case MarkupItem::Kind::script:
                appendScript(out, '_', item.lower);
                appendScript(out, '^', item.upper);
                break;
        }
}

}  // namespace

Expected<Markup> parseMarkup(std::string_view text) {
    if (text.size() > kLengthLimit)
        return Status::data("a text of a plate is longer than " + std::to_string(kLengthLimit) +
                            " bytes");
    Markup markup;
    Status status = Parser(text).items(markup, false, false, 0);
    if (!status.ok()) return status;
    return markup;
}

std::string plainText(std::string_view markup) {
    const Expected<Markup> parsed = parseMarkup(markup);
    if (!parsed) return std::string(markup);
    std::string out;
    appendPlain(out, *parsed);
    return out;
}

std::string escapeMarkup(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '_' || c == '^' || c == '{' || c == '}' || c == '\\') out += '\\';
        out += c;
    }
    return out;
}

void appendUtf8(std::string& out, char32_t letter) {
    if (letter < 0x80) {
        out += static_cast<char>(letter);
    } else if (letter < 0x800) {
        out += static_cast<char>(0xc0 | letter >> 6);
        out += static_cast<char>(0x80 | (letter & 0x3f));
    } else if (letter < 0x10000) {
        out += static_cast<char>(0xe0 | letter >> 12);
        out += static_cast<char>(0x80 | (letter >> 6 & 0x3f));
        out += static_cast<char>(0x80 | (letter & 0x3f));
    } else {
        out += static_cast<char>(0xf0 | letter >> 18);
        out += static_cast<char>(0x80 | (letter >> 12 & 0x3f));
        out += static_cast<char>(0x80 | (letter >> 6 & 0x3f));
        out += static_cast<char>(0x80 | (letter & 0x3f));
    }
}

}  // namespace versorium
