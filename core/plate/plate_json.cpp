// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "io/document.h"
#include "plate/markup.h"
#include "plate/plate.h"

namespace versorium {
namespace {

constexpr double kAnyNumber = 1e300;

// A text whose markup is right.
void readMarkup(ObjectReader& reader, const char* key, std::string& text) {
    reader.text(key, text);
    if (const Status status = checkMarkup(text); !status.ok()) reader.fail(key, status.message());
}

void readOptional(ObjectReader& reader, const char* key, std::optional<double>& value) {
    if (!reader.has(key)) return;
    if (reader.child(key)->is_null()) {
        value.reset();
        return;
    }
    double number = 0;
    reader.number(key, number, -kAnyNumber, kAnyNumber);
    value = number;
}

Status readAxis(const Json& value, const std::string& path, PlotAxis& axis) {
    ObjectReader reader(value, path);
    readMarkup(reader, "name", axis.name);
    reader.word("scale", axis.scale, {"linear", "log"});
    readOptional(reader, "low", axis.low);
    readOptional(reader, "high", axis.high);
    if (axis.low && axis.high && !(*axis.low < *axis.high))
        reader.fail("high", "it must be above \"low\"");
    if (axis.scale == "log" && ((axis.low && *axis.low <= 0) || (axis.high && *axis.high <= 0)))
        reader.fail("low", "a logarithmic axis needs ends above 0");
    return reader.finish();
}

Status readLine(const Json& value, const std::string& path, PlotLine& line) {
    ObjectReader reader(value, path);
    readMarkup(reader, "name", line.name);
    reader.word("style", line.style, {"line", "points", "both"});
    reader.numbers("x", line.x, 0, Plate::kPointLimit);
    reader.numbers("y", line.y, 0, Plate::kPointLimit);
    if (line.x.size() != line.y.size())
        reader.fail("y", std::to_string(line.y.size()) + " values for " +
                             std::to_string(line.x.size()) + " in \"x\"");
    for (const auto* list : {&line.x, &line.y})
        for (const double number : *list)
            if (!(std::abs(number) <= kAnyNumber)) reader.fail("a number is too large");
    return reader.finish();
}

Status readPlot(const Json& value, const std::string& path, LinePlot& plot) {
    ObjectReader reader(value, path);
    reader.number("aspect", plot.aspect, 0.2, 8);
    if (const Json* axis = reader.child("x")) reader.fail(readAxis(*axis, path + ".x", plot.x));
    if (const Json* axis = reader.child("y")) reader.fail(readAxis(*axis, path + ".y", plot.y));
    if (const Json* lines = reader.child("lines")) {
        if (!lines->is_array() || lines->size() > 64)
            reader.fail("lines", "a list of at most 64 lines is expected");
        std::size_t points = 0;
        for (std::size_t i = 0; i < lines->size() && !reader.failed(); ++i) {
            plot.lines.emplace_back();
            reader.fail(readLine((*lines)[i], path + ".lines[" + std::to_string(i) + "]",
                                 plot.lines.back()));
            points += plot.lines.back().x.size();
        }
        if (points > Plate::kPointLimit) reader.fail("lines", "too many points in all");
    }
    return reader.finish();
}

Status readDiagram(const Json& value, const std::string& path, DiagramPlot& diagram) {
    ObjectReader reader(value, path);
    std::vector<double> periods;
    reader.number("aspect", diagram.aspect, 0.2, 8)
        .text("parameter", diagram.parameter)
        .number("from", diagram.from, -1e9, 1e9)
        .number("to", diagram.to, -1e9, 1e9)
        .integer("component", diagram.component, 0, 3)
        .number("low", diagram.low, -1e9, 1e9)
        .number("high", diagram.high, -1e9, 1e9)
        .integer("transient", diagram.transient, 0, 1000000)
        .integer("points", diagram.points, 1, 1000000)
        .integer("across", diagram.across, 1, 16)
        .numbers("periods", periods, 0, 6);
    for (double period : periods) {
        if (!(period >= 1 && period <= 4096) || period != std::floor(period))
            reader.fail("periods", "whole numbers from 1 to 4096 are expected");
        else
            diagram.periods.push_back(static_cast<int>(period));
    }
    if (diagram.parameter.empty()) reader.fail("parameter", "the name of a number is expected");
    if (!(diagram.from < diagram.to)) reader.fail("to", "it must be above \"from\"");
    if (!(diagram.low < diagram.high)) reader.fail("high", "it must be above \"low\"");
    return reader.finish();
}

Status readProfile(const Json& value, const std::string& path, ProfilePlot& profile) {
    ObjectReader reader(value, path);
    reader.number("aspect", profile.aspect, 0.2, 8)
        .number("to", profile.to, 0, 1e6)
        .integer("radii", profile.radii, 2, 10000);
    return reader.finish();
}

void readMarks(ObjectReader& reader, const std::string& path, PlatePanel& panel) {
    const Json* marks = reader.child("marks");
    if (!marks) return;
    if (!marks->is_array() || marks->size() > Plate::kMarkLimit)
        return reader.fail("marks", "a list of at most " + std::to_string(Plate::kMarkLimit) +
                                        " marks {\"of\": \"panel\"} is expected");
    if (!marks->empty() && panel.kind != PanelKind::scene)
        return reader.fail("marks", "only a panel of kind \"scene\" has them");
    for (std::size_t i = 0; i < marks->size(); ++i) {
        PlateMark mark;
        ObjectReader one((*marks)[i], path + ".marks[" + std::to_string(i) + "]");
        one.text("of", mark.of);
        readMarkup(one, "label", mark.label);
        reader.fail(one.finish());
        panel.marks.push_back(std::move(mark));
    }
}

using Curve = std::vector<std::array<double, 2>>;

// A list of points [x, y]; no more than `left`, which shrinks by them.
Status readCurve(const Json& value, const std::string& path, std::size_t& left, Curve& curve) {
    if (!value.is_array() || value.size() > left)
        return Status::data(path + ": must be a list of points [x, y], 100000 in all at most");
    left -= value.size();
    for (const Json& point : value) {
        if (!point.is_array() || point.size() != 2 || !point[0].is_number() ||
            !point[1].is_number())
            return Status::data(path + ": a point is [x, y]");
        curve.push_back({point[0].get<double>(), point[1].get<double>()});
        if (!std::isfinite(curve.back()[0]) || !std::isfinite(curve.back()[1]))
            return Status::data(path + ": a point must be finite");
    }
    return {};
}

Status readParts(const Json& value, const std::string& path, std::vector<OverlayPart>& parts) {
    if (!value.is_array() || value.size() > Plate::kMarkLimit)
        return Status::data(path + ": must be a list of at most 6 parts");
    std::size_t left = Plate::kPointLimit;
    for (std::size_t i = 0; i < value.size(); ++i) {
        const std::string here = path + "[" + std::to_string(i) + "]";
        ObjectReader reader(value[i], here);
        OverlayPart part;
        readMarkup(reader, "name", part.name);
        reader.boolean("points", part.points);
        if (const Json* curves = reader.child("curves")) {
            if (!curves->is_array() || curves->size() > Plate::kPointLimit)
                return Status::data(here + ".curves: must be a list of curves");
            for (const Json& curve : *curves) {
                part.curves.emplace_back();
                if (Status status = readCurve(curve, here + ".curves", left, part.curves.back());
                    !status.ok())
                    return status;
            }
        }
        if (Status status = reader.finish(); !status.ok()) return status;
        parts.push_back(std::move(part));
    }
    return {};
}

Status readOverlay(const Json& value, const std::string& path, PlateOverlay& overlay) {
    ObjectReader reader(value, path);
    if (const Json* parts = reader.child("parts"))
        reader.fail(readParts(*parts, path + ".parts", overlay.parts));
    reader.integer("cycles", overlay.cycles, 0, 16)
        .integer("manifolds", overlay.manifolds, 0, 8)
        .number("length", overlay.length, 0.01, 1000)
        .boolean("critical_set", overlay.criticalSet);
    return reader.finish();
}

bool goodName(const std::string& name) {
    if (name.empty() || name.size() > 20) return false;
    for (const char c : name)
        if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
              c == '-'))
            return false;
    return true;
}

Status readPanel(const Json& value, const std::string& path, const Assets& assets,
                 PlatePanel& panel) {
    ObjectReader reader(value, path);
    std::string kind = "scene";
    reader.text("name", panel.name).word("kind", kind, {"scene", "plot", "diagram", "profile"});
    panel.kind = kind == "plot"      ? PanelKind::plot
                 : kind == "diagram" ? PanelKind::diagram
                 : kind == "profile" ? PanelKind::profile
                                     : PanelKind::scene;
    reader.integer("span", panel.span, 1, 6);
    reader.boolean("axes", panel.axes).boolean("keys", panel.keys);
    readMarkup(reader, "title", panel.title);
    readMarkup(reader, "x_label", panel.xLabel);
    readMarkup(reader, "y_label", panel.yLabel);
    readMarkup(reader, "bar_label", panel.barLabel);
    if (!goodName(panel.name)) reader.fail("name", "1 to 20 letters, digits or - are expected");
    if (const Json* scene = reader.child("scene")) {
        if (panel.kind == PanelKind::plot) reader.fail("scene", "a plot has no scene");
        Expected<Scene> read = sceneWithAssets(*scene, assets);
        if (!read) return read.status().in(reader.pathOf("scene"));
        panel.scene = *std::move(read);
    } else if (panel.hasScene()) {
        reader.fail("scene", "the scene is missing");
    }
    if (const Json* plot = reader.child("plot")) {
        if (panel.kind != PanelKind::plot)
            reader.fail("plot", "only a panel of kind \"plot\" has one");
        reader.fail(readPlot(*plot, reader.pathOf("plot"), panel.plot));
    }
    if (const Json* diagram = reader.child("diagram")) {
        if (panel.kind != PanelKind::diagram)
            reader.fail("diagram", "only a panel of kind \"diagram\" has one");
        reader.fail(readDiagram(*diagram, reader.pathOf("diagram"), panel.diagram));
    } else if (panel.kind == PanelKind::diagram) {
        reader.fail("diagram", "the diagram is missing");
    }
    if (const Json* profile = reader.child("profile")) {
        if (panel.kind != PanelKind::profile)
            reader.fail("profile", "only a panel of kind \"profile\" has one");
        reader.fail(readProfile(*profile, reader.pathOf("profile"), panel.profile));
    }
    readMarks(reader, path, panel);
    if (const Json* overlay = reader.child("overlay")) {
        if (panel.kind != PanelKind::scene)
            reader.fail("overlay", "only a panel of kind \"scene\" has one");
        reader.fail(readOverlay(*overlay, reader.pathOf("overlay"), panel.overlay));
    }
    return reader.finish();
}

Json optionalJson(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json axisToJson(const PlotAxis& axis) {
    Json value;
    value["name"] = axis.name;
    value["scale"] = axis.scale;
    value["low"] = optionalJson(axis.low);
    value["high"] = optionalJson(axis.high);
    return value;
}

Json plotToJson(const LinePlot& plot) {
    Json value;
    value["aspect"] = plot.aspect;
    value["x"] = axisToJson(plot.x);
    value["y"] = axisToJson(plot.y);
    Json lines = Json::array();
    for (const PlotLine& line : plot.lines) {
        Json item;
        item["name"] = line.name;
        item["style"] = line.style;
        item["x"] = line.x;
        item["y"] = line.y;
        lines.push_back(std::move(item));
    }
    value["lines"] = std::move(lines);
    return value;
}

Json diagramToJson(const DiagramPlot& diagram) {
    Json value;
    value["aspect"] = diagram.aspect;
    value["parameter"] = diagram.parameter;
    value["from"] = diagram.from;
    value["to"] = diagram.to;
    value["component"] = diagram.component;
    value["low"] = diagram.low;
    value["high"] = diagram.high;
    value["transient"] = diagram.transient;
    value["points"] = diagram.points;
    value["across"] = diagram.across;
    value["periods"] = diagram.periods;
    return value;
}

Json panelToJson(const PlatePanel& panel) {
    Json value;
    value["name"] = panel.name;
    value["title"] = panel.title;
    value["kind"] = panel.kind == PanelKind::plot      ? "plot"
                    : panel.kind == PanelKind::diagram ? "diagram"
                    : panel.kind == PanelKind::profile ? "profile"
                                                       : "scene";
    value["span"] = panel.span;
    value["axes"] = panel.axes;
    value["keys"] = panel.keys;
    value["x_label"] = panel.xLabel;
    value["y_label"] = panel.yLabel;
    value["bar_label"] = panel.barLabel;
    if (panel.kind == PanelKind::plot)
        value["plot"] = plotToJson(panel.plot);
    else
        value["scene"] = sceneBody(panel.scene);
    if (panel.kind == PanelKind::diagram) value["diagram"] = diagramToJson(panel.diagram);
    if (panel.kind == PanelKind::profile)
        value["profile"] = Json{{"aspect", panel.profile.aspect},
                                {"to", panel.profile.to},
                                {"radii", panel.profile.radii}};
    if (panel.kind != PanelKind::scene) return value;
    Json marks = Json::array();
    for (const PlateMark& mark : panel.marks)
        marks.push_back(Json{{"of", mark.of}, {"label", mark.label}});
    value["marks"] = std::move(marks);
    value["overlay"] = Json{{"cycles", panel.overlay.cycles},
                            {"manifolds", panel.overlay.manifolds},
                            {"length", panel.overlay.length},
                            {"critical_set", panel.overlay.criticalSet},
                            {"parts", Json::array()}};
    for (const OverlayPart& part : panel.overlay.parts)
        value["overlay"]["parts"].push_back(
            {{"name", part.name}, {"points", part.points}, {"curves", part.curves}});
    return value;
}

}  // namespace

Expected<Plate> plateFromJson(const Json& value, const Assets& assets) {
    Plate plate;
    ObjectReader reader(value, "");
    int version = Plate::kVersion;
    reader.integer("version", version, 1, 1000000);
    if (version > Plate::kVersion)
        return Status::data("version: this plate needs a newer program: it is version " +
                            std::to_string(version) + ", known here is " +
                            std::to_string(Plate::kVersion));
    reader.text("language", plate.language);
    readMarkup(reader, "title", plate.title);
    readMarkup(reader, "caption", plate.caption);
    readMarkup(reader, "note", plate.note);
    reader.integer("columns", plate.columns, 0, 6);
    const Json* panels = reader.child("panels");
    if (!panels || !panels->is_array() || panels->empty() || panels->size() > Plate::kPanelLimit) {
        reader.fail("panels",
                    "a list of 1 to " + std::to_string(Plate::kPanelLimit) + " panels is expected");
        return reader.finish();
    }
    for (std::size_t i = 0; i < panels->size() && !reader.failed(); ++i) {
        PlatePanel panel;
        panel.name = static_cast<char>('a' + i);
        const std::string path = "panels[" + std::to_string(i) + "]";
        reader.fail(readPanel((*panels)[i], path, assets, panel));
        for (const PlatePanel& other : plate.panels)
            if (other.name == panel.name)
                reader.fail(Status::data(path + ".name: \"" + panel.name + "\" is taken"));
        plate.panels.push_back(std::move(panel));
    }
    if (Status status = reader.finish(); !status.ok()) return status;
    for (const PlatePanel& panel : plate.panels)
        for (const PlateMark& mark : panel.marks) {
            const auto of =
                std::find_if(plate.panels.begin(), plate.panels.end(),
                             [&](const PlatePanel& other) { return other.name == mark.of; });
            if (of == plate.panels.end() || of->kind != PanelKind::scene || &*of == &panel)
                return Status::data("panel " + panel.name + ": marks: \"" + mark.of +
                                    "\" is no other panel with a scene");
        }
    return plate;
}

Json plateToJson(const Plate& plate) {
    Json value;
    value["version"] = Plate::kVersion;
    value["language"] = plate.language;
    value["title"] = plate.title;
    value["caption"] = plate.caption;
    value["note"] = plate.note;
    value["columns"] = plate.columns;
    Json panels = Json::array();
    for (const PlatePanel& panel : plate.panels) panels.push_back(panelToJson(panel));
    value["panels"] = std::move(panels);
    return value;
}

}  // namespace versorium
