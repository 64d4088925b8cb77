// SPDX-License-Identifier: MIT
// The slice of a picture, as properties: which numbers run along its axes, and where it lies.
#include <cmath>

#include "scene/properties.h"

namespace versorium {
namespace {

constexpr double kFarthestCentre = 1e300;

Json axisToJson(const SliceAxis& axis) {
    Json terms = Json::object();
    for (const auto& [name, weight] : axis.terms) terms[name] = weight;
    return terms;
}

Status readAxis(const Json& json, const std::string& path, SliceAxis& axis) {
    if (!json.is_object() || json.empty())
        return Status::data(path + ": an object such as {\"z.re\": 1} is expected");
    SliceAxis read;
    for (auto item = json.begin(); item != json.end(); ++item) {
        if (!item->is_number() || item->get<double>() == 0 || !std::isfinite(item->get<double>()))
            return Status::data(path + "." + item.key() +
                                ": the weight must be a number other than 0");
        read.terms.emplace_back(item.key(), item->get<double>());
    }
    axis = std::move(read);
    return {};
}

Property<SliceSpec> axesProperty() {
    Property<SliceSpec> axes{
        {.path = "axes",
         .label = trLater("axes"),
         .help = trLater("1 to 3 directions, to the right and up first: weights of named "
                         "numbers."),
         .least = 1,
         .most = 3}};
    axes.get = [](const SliceSpec& slice) {
        Json json = Json::array();
        for (const SliceAxis& axis : slice.axes) json.push_back(axisToJson(axis));
        return json;
    };
    axes.set = [](SliceSpec& slice, const Json& json, const std::string& path) -> Status {
        if (!json.is_array() || json.empty() || json.size() > 3)
            return Status::data(path + ": a list of 1 to 3 directions is expected");
        std::vector<SliceAxis> read(json.size());
        for (std::size_t k = 0; k < read.size(); ++k)
            if (Status status = readAxis(json[k], path + "[" + std::to_string(k) + "]", read[k]);
                !status.ok())
                return status;
        slice.axes = std::move(read);
        if (slice.centre.size() != slice.axes.size()) {
            slice.centre.assign(slice.axes.size(), 0.0);
            slice.centreLow.assign(slice.axes.size(), 0.0);
        }
        return {};
    };
    axes.parts = [](const SliceSpec& slice) {
        PropertyTable<SliceSpec> all;
        for (std::size_t k = 0; k < slice.axes.size(); ++k) {
            const std::string number = std::to_string(k);
            Property<SliceSpec> one{
                {.path = "axes[" + number + "]",
                 .alias = k == 0   ? "axis0"
                          : k == 1 ? "axis1"
                                   : "axis2",
                 .label = k == 0   ? trLater("axis →")
                          : k == 1 ? trLater("axis ↑")
                                   : trLater("axis ⊙"),
                 .help = trLater("Which number runs along this axis of the view.")}};
            one.get = [k](const SliceSpec& of) { return axisToJson(of.axes[k]); };
            one.set = [k](SliceSpec& of, const Json& json, const std::string& path) {
                return readAxis(json, path, of.axes[k]);
            };
            all.push_back(std::move(one));
        }
        return all;
    };
    return axes;
}

Property<SliceSpec> originProperty() {
    return {{.path = "origin",
             .label = trLater("origin"),
             .help = trLater("Where numbers on an axis start from, if not from 0, such as "
                             "{\"c.re\": 0.3}.")},
            [](const SliceSpec& slice) {
                Json json = Json::object();
                for (const auto& [name, value] : slice.origin) json[name] = value;
                return json;
            },
            [](SliceSpec& slice, const Json& json, const std::string& path) -> Status {
                if (!json.is_object())
                    return Status::data(path + ": an object such as {\"c.re\": 0.3} is expected");
                std::map<std::string, double> read;
                for (auto item = json.begin(); item != json.end(); ++item) {
                    if (!item->is_number() || !std::isfinite(item->get<double>()))
                        return Status::data(path + ": " + item.key() + " must be a number");
                    read[item.key()] = item->get<double>();
                }
                slice.origin = std::move(read);
                return {};
            }};
}

// One number for each axis. The low part belongs to the centre: a new centre has none.
Property<SliceSpec> centreProperty(std::vector<double> SliceSpec::*member, ValueInfo info) {
    info.kind = ValueKind::numbers;
    info.least = 1;
    info.most = 3;
    return {info, [member](const SliceSpec& slice) { return numbersToJson(slice.*member); },
            [member](SliceSpec& slice, const Json& json, const std::string& path) {
                const std::size_t axes = slice.axes.size();
                return readNumbers(json, axes, axes, slice.*member).in(path);
            }};
}

}  // namespace

const PropertyTable<SliceSpec>& sliceTable() {
    static const PropertyTable<SliceSpec> table = [] {
        Property<SliceSpec> centre = centreProperty(
            &SliceSpec::centre,
            {.path = "center",
             .label = trLater("centre"),
             .help = trLater("Coordinates of the picture's centre along the axes.")});
        const auto part = [](const char* alias, const char* label) {
            return ValueInfo{.alias = alias,
                             .label = label,
                             .help = trLater("The middle of the view along this axis. Double "
                                             "click to type it."),
                             .low = -kFarthestCentre,
                             .high = kFarthestCentre,
                             .sliderLow = -2,
                             .sliderHigh = 2,
                             .moves = true};
        };
        centre.set = [set = centre.set](SliceSpec& slice, const Json& json,
                                        const std::string& path) {
            const Status status = set(slice, json, path);
            if (status.ok()) slice.centreLow.assign(slice.axes.size(), 0.0);
            return status;
        };
        return PropertyTable<SliceSpec>{
            axesProperty(),
            originProperty(),
            withComponents(
                centre, {part("centre0", trLater("centre →")), part("centre1", trLater("centre ↑")),
                         part("centre2", trLater("centre ⊙"))}),
            centreProperty(&SliceSpec::centreLow,
                           {.path = "center_low",
                            .label = trLater("centre, low part"),
                            .help = trLater("Low parts of the same, added for deep views.")}),
            numberOf(&SliceSpec::height,
                     {.path = "height",
                      .label = trLater("height"),
                      .help = trLater("What the view shows from bottom to top. Smaller is deeper."),
                      .low = 1e-300,
                      .high = 1e12,
                      .sliderLow = 1e-12,
                      .sliderHigh = 10,
                      .logarithmic = true,
                      .moves = true}),
        };
    }();
    return table;
}

}  // namespace versorium
