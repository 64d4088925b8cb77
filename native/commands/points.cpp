// SPDX-License-Identifier: MIT
#include "commands/points.h"

#include <algorithm>

#include "io/csv.h"
#include "io/files.h"
#include "maps/catalogue.h"
#include "scene/numbers.h"

namespace versorium {
namespace {

constexpr std::size_t kMostPoints = 20000000;
constexpr std::size_t kMostAxes = 3;
constexpr std::string_view kLetters[] = {"x", "y", "z", "w"};

std::string lower(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

std::string axisName(const SliceAxis& axis) {
    std::string name;
    for (const auto& [number, weight] : axis.terms) name += (name.empty() ? "" : " + ") + number;
    return name;
}

std::string axesText(const Scene& scene) {
    std::string all;
    for (const SliceAxis& axis : scene.slice.axes)
        all += (all.empty() ? "" : ", ") + axisName(axis);
    return all;
}

// The number of the scene that a column means; a letter alone means none.
std::string numberOf(const Scene& scene, const std::string& column) {
    if (numberNamed(scene, column)) return column;
    if (numberNamed(scene, lower(column))) return lower(column);
    const MapInfo& info = mapOf(scene).info;
    const std::string small = lower(column);
    for (int k = 0; k < dimensionOf(info.algebra); ++k)
        if (lower(stateComponent(info, k)) == small) return stateComponent(info, k);
    for (int k = 0; k < parameterSize(info); ++k)
        if (lower(parameterComponent(info, k)) == small) return parameterComponent(info, k);
    return {};
}

class Columns {
  public:
    Columns(const std::vector<std::string>& header, const Scene& scene)
        : header_(header), scene_(scene) {}

    std::vector<std::size_t> places;

    Status find(PointTable& table) {
        table.scene = scene_;
        std::vector<std::size_t> letters, numbers;
        for (std::size_t k = 0; k < header_.size(); ++k) {
            const std::string small = lower(header_[k]);
            if (std::find(std::begin(kLetters), std::end(kLetters), small) != std::end(kLetters))
                letters.push_back(k);
            else if (!numberOf(scene_, header_[k]).empty())
                numbers.push_back(k);
        }
        for (std::size_t i = 0; i < header_.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                if (!header_[i].empty() && lower(header_[i]) == lower(header_[j]))
                    return Status::data("the column \"" + header_[i] + "\" stands twice");
        if (letters.empty() && numbers.empty()) return missing();
        // Where a letter is a number's own name, as x of a map of the line, it may stand for it.
        const auto isNumber = [&](std::size_t k) {
            return numberNamed(scene_, lower(header_[k])).has_value();
        };
        if ((letters.size() != scene_.slice.axes.size() || !numbers.empty()) &&
            std::all_of(letters.begin(), letters.end(), isNumber)) {
            numbers.insert(numbers.end(), letters.begin(), letters.end());
            std::sort(numbers.begin(), numbers.end());
            letters.clear();
        }
        if (!letters.empty() && !numbers.empty())
            return Status::data("columns are letters (x, y, …) or names of numbers, such as \"" +
                                header_[numbers[0]] + "\", not both");
        return letters.empty() ? byNames(table, numbers) : byLetters(table, letters);
    }

  private:
    Status missing() const {
        return Status::data(
            "a head line with columns x,y is expected: coordinates along the axes " +
            axesText(scene_) +
            "; names of numbers of the scene may stand there, "
            "such as " +
            axisName(scene_.slice.axes[0]));
    }
    Status byLetters(PointTable& table, const std::vector<std::size_t>& letters) {
        const std::size_t axes = scene_.slice.axes.size();
        const auto dimension = static_cast<std::size_t>(mapOf(scene_).dimension);
        const bool spatial = dimension >= 3 && letters.size() > axes;
        const std::size_t count = spatial ? letters.size() : axes;
        for (std::size_t k = 0; k < count; ++k) {
            const auto found = std::find_if(letters.begin(), letters.end(), [&](std::size_t i) {
                return lower(header_[i]) == kLetters[k];
            });
            if (found == letters.end())
                return Status::data("the column " + std::string(kLetters[k]) +
                                    " is missing: the "
                                    "points lie along the axes " +
                                    axesText(scene_) + ", one column for each");
            places.push_back(*found);
        }
        if (letters.size() != count || count > dimension + (spatial ? 0 : kMostAxes))
            return Status::data("there are " + std::to_string(letters.size()) +
                                " columns for the axes " + axesText(scene_) +
                                "; starting points go by their names, such as " +
                                stateComponent(mapOf(scene_).info, 0));
        table.start = spatial;
        return {};
    }
    Status byNames(PointTable& table, const std::vector<std::size_t>& numbers) {
        const auto dimension = static_cast<std::size_t>(mapOf(scene_).dimension);
        std::vector<std::string> names;
        for (std::size_t k : numbers) names.push_back(numberOf(scene_, header_[k]));
        // All components of a start of four numbers do not fit on three axes.
        if (numbers.size() > kMostAxes && numbers.size() == dimension) {
            for (std::size_t k = 0; k < dimension; ++k) {
                const auto found = std::find(names.begin(), names.end(),
                                             stateComponent(mapOf(scene_).info, int(k)));
                if (found == names.end()) return tooMany(numbers.size());
                places.push_back(numbers[static_cast<std::size_t>(found - names.begin())]);
            }
            table.start = true;
            return {};
        }
        if (numbers.size() > kMostAxes) return tooMany(numbers.size());
        places = numbers;
        SliceSpec& slice = table.scene.slice;
        slice.axes.clear();
        for (const std::string& name : names) {
            slice.axes.push_back({{{name, 1.0}}});
            slice.origin.erase(name);
            if (numberNamed(scene_, name)->kind == NumberKind::state)
                table.scene.criticalStart.reset();
        }
        slice.centre.assign(names.size(), 0.0);
        slice.centreLow.assign(names.size(), 0.0);
        return {};
    }
    static Status tooMany(std::size_t count) {
        return Status::data(std::to_string(count) +
                            " columns are numbers of the scene, and at most three may be");
    }

    const std::vector<std::string>& header_;
    const Scene& scene_;
};

// "p.csv, line 2: …"
Status inFile(const Status& status, const std::string& path) {
    const bool line = status.message().starts_with("line ");
    return {status.kind(), path + (line ? ", " : ": ") + status.message()};
}

}  // namespace

Expected<PointTable> readPoints(const std::string& path, const Scene& scene) {
    Expected<Bytes> bytes = readFile(path);
    if (!bytes) return bytes.status();
    const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    Expected<CsvReader> reader = CsvReader::open(text);
    if (!reader) return inFile(reader.status(), path);
    const auto where = [&](std::size_t line) { return path + ", line " + std::to_string(line); };
    PointTable table;
    Columns columns(reader->header(), scene);
    if (const Status status = columns.find(table); !status.ok())
        return status.in(where(reader->headerLine()));
    for (std::size_t place : columns.places) table.names.push_back(reader->header()[place]);
    while (true) {
        const Expected<bool> more = reader->next();
        if (!more) return inFile(more.status(), path);
        if (!*more) break;
        if (table.points.size() >= kMostPoints)
            return Status::data(where(reader->line()) + ": too many points");
        std::vector<double>& point = table.points.emplace_back();
        for (std::size_t place : columns.places) {
            const Expected<double> value = reader->number(reader->cells()[place]);
            if (!value) return value.status().in(where(reader->line()));
            point.push_back(*value);
        }
    }
    if (table.points.empty())
        return Status::data(where(reader->headerLine()) + ": no points follow the head line");
    return table;
}

}  // namespace versorium
