// SPDX-License-Identifier: MIT
// The inspector: the map with its formula, its parameters, what is seen and how it is coloured.
#include <algorithm>
#include <cmath>

#include "render/colouring.h"
#include "ui/panels/roots_panel.h"
#include "ui/session/context.h"
#include "ui/session/ensemble_change.h"
#include "ui/widgets/help.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/panel_parts.h"

namespace versorium {
namespace {

// The plane of a complex number, with the other components below it.
bool pad(const char* id, double& x, double& y, double low, double high) {
    const float side = std::min(ImGui::GetContentRegionAvail().x * 0.42f, 130.0f);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton(id, {side, side});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end{corner.x + side, corner.y + side};
    list.AddRectFilled(corner, end, ImGui::GetColorU32(ImGuiCol_FrameBg), 6);
    const ImU32 line = ImGui::GetColorU32(ImGuiCol_Border);
    const auto across = [&](double value) {
        return static_cast<float>((value - low) / (high - low)) * side;
    };
    list.AddLine({corner.x + across(0), corner.y}, {corner.x + across(0), end.y}, line);
    list.AddLine({corner.x, end.y - across(0)}, {end.x, end.y - across(0)}, line);
    list.PushClipRect(corner, end, true);
    drawMark(list, {corner.x + across(x), end.y - across(y)}, 6, MarkShape::ring,
             ImGui::GetColorU32(ImGuiCol_CheckMark));
    list.PopClipRect();
    explain("pad");
    if (!ImGui::IsItemActive()) return false;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const auto value = [&](float part) {
        return low + (high - low) * std::clamp(part / side, 0.0f, 1.0f);
    };
    const double u = value(mouse.x - corner.x), v = value(end.y - mouse.y);
    const bool changed = u != x || v != y;
    x = u;
    y = v;
    return changed;
}

// What a parameter is called in formulas.
std::string labelOf(const std::string& part) {
    constexpr std::pair<const char*, const char*> kLetters[] = {
        {"alpha", "α"},
        {"beta", "β"},
        {"tau", "τ"},
        {kAsPrinted, trLater("φ + β (print)")},
        {"log_scale", trLater("log scale")},
        {"exponent_beta", trLater("exponent β")}};
    for (const auto& [name, letter] : kLetters)
        if (part == name) return tr(letter);
    return part;
}

void parameters(StudioContext& context) {
    Workspace& workspace = context.workspace;
    const MapInfo& info = mapOf(workspace.views[0]).info;
    int component = 0;
    for (const ParameterInfo& parameter : info.parameters) {
        const int width = widthOf(parameter.kind);
        const std::string name(parameter.name);
        std::vector<double> value = name == kAsPrinted
                                        ? workspace.view().parameters[name]
                                        : workspace.views[workspace.speaker()].parameters[name];
        bool changed = false;
        ImGui::PushID(name.c_str());
        if (width >= 2) {
            changed |= pad("pad", value[0], value[1], std::max(parameter.low, -2.0),
                           std::min(parameter.high, 2.0));
            ImGui::SameLine();
            ImGui::BeginGroup();
            if (info.parameters.size() > 1) ImGui::TextDisabled("%s", name.c_str());
        }
        for (int k = 0; k < width; ++k) {
            const std::string part = parameterComponent(info, component + k);
            const bool whole = parameter.kind == ParameterKind::whole;
            const std::string label = width == 1 ? labelOf(part) : part.substr(part.rfind('.') + 1);
            const NumberLook look{
                .help = parameter.help.empty() ? helpOf("parameter") : parameter.help,
                .low = width >= 2 ? std::max(parameter.low, -2.0) : parameter.low,
                .high = width >= 2 ? std::min(parameter.high, 2.0) : parameter.high,
                .home = parameter.value[static_cast<std::size_t>(k)],
                .whole = whole,
                .slider = width == 1,
                .animated = !whole};
            changed |= numberField(context, part, label, value[static_cast<std::size_t>(k)], look);
        }
        if (width >= 2) {
            if (ImGui::SmallButton(tr("reset"))) {
                value.assign(parameter.value.begin(), parameter.value.begin() + width);
                changed = true;
            }
            explain("reset");
            ImGui::EndGroup();
        }
        ImGui::PopID();
        if (changed) {
            setSharedParameter(workspace, name, value);
            context.touch();
        }
        component += width;
    }
}

void axisControl(StudioContext& context, std::size_t k) {
    const Scene& scene = context.workspace.view();
    const auto& terms = scene.slice.axes[k].terms;
    std::string name = terms.size() == 1 ? terms[0].first : "";
    if (!chooseName(k == 0 ? "axis →" : "axis ↑", "axis", name, axisNames(scene), "several"))
        return;
    setAxis(context.workspace, k, name);
    context.touch();
}

void borderControls(StudioContext& context) {
    Scene& scene = context.workspace.view();
    const double aspect = context.aspect(context.workspace.focused);
    const char* labels[] = {trLater("left"), trLater("right"), trLater("bottom"), trLater("top")};
    const std::array<double, 4> borders = bordersOf(scene, aspect);
    for (int k = 0; k < 4 && k / 2 < static_cast<int>(scene.slice.centre.size()); ++k) {
        double value = borders[static_cast<std::size_t>(k)];
        const NumberLook look{.help = helpOf("border"),
                              .low = value - scene.slice.height,
                              .high = value + scene.slice.height,
                              .slider = false};
        if (numberField(context, labels[k], labels[k], value, look) &&
            setBorder(scene, k, value, aspect))
            context.touch();
    }
}

void sliceControls(StudioContext& context) {
    Scene& scene = context.workspace.view();
    for (std::size_t k = 0; k < 2 && k < scene.slice.axes.size(); ++k) axisControl(context, k);
    const SliceSpec there = homeOf(scene);
    for (std::size_t k = 0; k < 2 && k < scene.slice.centre.size(); ++k) {
        const char* label = k == 0 ? trLater("centre →") : trLater("centre ↑");
        if (numberField(context, label, label, scene.slice.centre[k],
                        {.help = helpOf("centre"), .home = there.centre[k]})) {
            scene.slice.centreLow[k] = 0;
            context.touch();
        }
    }
    double height = scene.slice.height;
    if (numberField(context, "height", "height", height,
                    {.help = helpOf("height"),
                     .low = 1e-12,
                     .high = 10,
                     .home = there.height,
                     .logarithmic = true}) &&
        height >= kLeastHeight && height <= kMostHeight) {
        scene.slice.height = height;
        context.touch();
    }
    const bool open =
        ImGui::TreeNodeEx(named("borders").c_str(), ImGuiTreeNodeFlags_SpanAvailWidth);
    explain("borders");
    if (open) {
        borderControls(context);
        ImGui::TreePop();
    }
}

// The values at the palette's ends, in units in which shifting and stretching are linear.
bool rangeControls(StudioContext& context) {
    const Scene& scene = context.workspace.view();
    Colouring& colour = context.workspace.view().colour;
    const OrbitProgram* program = context.program(context.workspace.focused);
    if (!program) return false;
    const Expected<ColourPass> pass = ColourPass::make(scene, *program);
    bool own = !colour.range.empty(), changed = false;
    const bool toggled = ImGui::Checkbox(tr("a range of your own"), &own);
    explain("own range");
    if (toggled) {
        colour.range.clear();
        if (own && pass) colour.range = {pass->scale().low, pass->scale().high};
        if (own && colour.reverse && pass) std::swap(colour.range[0], colour.range[1]);
        return true;
    }
    if (!own || !pass) return false;
    const bool log = pass->scale().kind == ScaleKind::log;
    std::vector<double> next = colour.range;
    const double span = std::abs(next[1] - next[0]);
    for (std::size_t k = 0; k < 2; ++k) {
        const char* label = k == 0 ? trLater("from") : trLater("to");
        changed |= numberField(context, std::string("colour ") + label, label, next[k],
                               {.help = helpOf(k == 0 ? "range from" : "range to"),
                                .low = log ? std::min(1e-3, std::min(next[0], next[1]))
                                           : std::min(next[0], next[1]) - span,
                                .high = log ? 1e4 : std::max(next[0], next[1]) + span,
                                .logarithmic = log});
    }
    const auto dragged = [&](const char* label, const char* control) {
        ImGui::Button(named(label).c_str());
        explain(control);
        const float moved = ImGui::IsItemActive() ? ImGui::GetIO().MouseDelta.x : 0;
        return static_cast<double>(moved) / 300;
    };
    double low = log ? std::log(next[0]) : next[0], high = log ? std::log(next[1]) : next[1];
    const double shift = dragged("↔ shift", "shift range") * (high - low);
    ImGui::SameLine();
    const double stretch = 0.5 * dragged("↔ stretch", "stretch range") * (high - low);
    if (shift != 0 || stretch != 0) {
        low += shift - stretch, high += shift + stretch;
        next = {log ? std::exp(low) : low, log ? std::exp(high) : high};
        changed = true;
    }
    const Scale scale{pass->scale().kind, next[0], next[1]};
    if (!changed || !scale.check().ok()) return false;
    colour.range = next;
    return true;
}

bool gradientControls(StudioContext& context, const char* what, Gradient& range) {
    bool changed = false;
    ImGui::PushID(what);
    const auto edit = [&](const char* label, DisplayColour& c) {
        float v[4] = {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b),
                      static_cast<float>(c.a)};
        if (ImGui::ColorEdit4(named(label).c_str(), v,
                              ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_AlphaPreviewHalf |
                                  ImGuiColorEditFlags_NoTooltip)) {
            c = {v[0], v[1], v[2], v[3]};
            changed = true;
        }
        explain(label);
    };
    ImGui::TextDisabled("%s", tr(what));
    ImGui::SameLine();
    edit("fast", range.start);
    ImGui::SameLine();
    edit("slow", range.finish);
    double exponent = range.exponent;
    if (numberField(context, std::string(what) + " exponent", "colour exponent", exponent,
                    {.help = helpOf("exponent"), .low = 0.05, .high = 4, .home = 1}) &&
        exponent >= 0.01 && exponent <= 100) {
        range.exponent = exponent;
        changed = true;
    }
    ImGui::PopID();
    return changed;
}

void choosePalette(StudioContext& context) {
    Colouring& colour = context.workspace.view().colour;
    std::string name = colour.palette;
    if (!choose("palette", "palette", name, paletteNames())) return;
    colour.palette = name;
    colour.ownPalette = nullptr;
    context.touch();
}

// The languages by their own names.
void chooseLanguage(StudioContext& context) {
    ImGui::SetNextItemWidth(-1);
    const bool open = ImGui::BeginCombo("##language", languageNow().name.c_str());
    if (!open) return explain("language");
    for (const Language& language : languages())
        if (ImGui::Selectable(language.name.c_str(), language.id == languageNow().id))
            context.speak(language.id);
    ImGui::EndCombo();
}

void colourControls(StudioContext& context) {
    Colouring& colour = context.workspace.view().colour;
    bool changed = choose("colour by", "colour by", colour.rule,
                          {"palette", "gradient", "versor", "phase", "domain"});
    const bool palette = colour.rule == "palette";
    if (palette) {
        std::vector<std::string> fields;
        for (const FieldInfo& field : allFields())
            if (field.field != FieldName::versor) fields.emplace_back(field.name);
        if (choose("field", "field", colour.field, fields)) {
            colour.range.clear();
            colour.scale.clear();
            changed = true;
        }
    }
    if (palette || colour.rule == "phase" || colour.rule == "domain") {
        choosePalette(context);
        ImGui::PushID("palette editor");
        drawPaletteEditor(context);
        ImGui::PopID();
        changed |= ImGui::Checkbox(tr("reversed"), &colour.reverse);
        explain("reversed");
    }
    if (palette) {
        changed |=
            choose("scale", "scale", colour.scale,
                   {"", "linear", "log", "truncated_log", "sqrt", "cyclic"}, "the field's own");
        changed |= rangeControls(context);
        bool inside = colour.interior == "membership";
        if (ImGui::Checkbox(tr("the set in its own colour"), &inside)) {
            colour.interior = inside ? "membership" : "none";
            changed = true;
        }
        explain("the set in its own colour");
    }
    if (colour.rule == "gradient") {
        changed |= gradientControls(context, "escaped", colour.escaped);
        changed |= gradientControls(context, "attracted", colour.attracted);
        changed |= choose("smoothing", "smoothing", colour.smoothing, {"none", "ratio", "log-log"});
    }
    changed |= choose("outline", "outline", colour.outline, {"none", "membership", "solid"});
    if (changed) context.touch();
}

}  // namespace

void drawInspector(StudioContext& context) {
    Workspace& workspace = context.workspace;
    const MapInfo& info = mapOf(workspace.views[0]).info;
    heading("Map");
    ImGui::SetNextItemWidth(-1);
    const bool open =
        ImGui::BeginCombo("##map", tr(info.title).c_str(), ImGuiComboFlags_HeightLarge);
    if (!open) explain("map");
    if (open) {
        drawFormulaChoices(context);
        for (const MapKernels& map : catalogue())
            if (ImGui::Selectable(tr(map.info.title).c_str(), map.info.name == info.name) &&
                map.info.name != info.name) {
                context.newMap(std::string(map.info.name));
                break;
            }
        ImGui::EndCombo();
    }
    const MapInfo& shown = mapOf(workspace.views[0]).info;
    if (!workspace.views[0].formula) {
        ImGui::PushTextWrapPos();
        ImGui::TextUnformatted(tr(shown.formula).c_str());
        ImGui::PopTextWrapPos();
        explainBy(shown.source);
    }
    drawFormulaPanel(context);
    if (ImGui::Button(tr("Gallery"))) context.galleryOpen = true;
    explain("gallery");
    if (rowButton("Find", "find")) context.searchOpen = true;
    if (rowButton("Open", "open")) context.chooseFile();
    if (rowButton("Export", "export dialog")) context.exportOpen = true;
    if (rowButton("Lessons", "lessons")) context.lessons.open = !context.lessons.open;

    heading("Parameters");
    if (workspace.views[0].map != "planar") parameters(context);
    drawPlanarPanel(context);
    drawShapePanel(context);
    drawSpaceView(context);

    if (hasRoots(workspace)) {
        heading("Versor d: roots and poles");
        drawVersorPanel(context);
    }
    const bool circled = workspace.basins || !workspace.circles.empty();
    if (takesCircles(workspace) && section("Basins and circles", circled))
        drawCircleControls(context);

    if (showsParameters(workspace.view())) {
        heading("Start of the orbits in the marked view");
        drawStartControls(context);
    }

    heading("Fixed points and cycles");
    drawCycleControls(context);

    heading("Under the pointer");
    drawProbe(context);

    heading("Orbits");
    Scene& scene = workspace.view();
    double iterations = scene.iterations;
    if (numberField(context, "iterations", "max steps N", iterations,
                    {.help = helpOf("iterations"),
                     .low = 1,
                     .high = 10000,
                     .home = sceneOf(mapOf(scene)).iterations,
                     .whole = true,
                     .logarithmic = true})) {
        scene.iterations = static_cast<int>(std::clamp(iterations, 1.0, 1e6));
        context.touch();
    }
    double radius = scene.escapeRadius.value_or(automaticRadius(scene));
    if (std::isfinite(radius) &&
        numberField(context, "escape radius", "escape radius", radius,
                    {.help = helpOf("escape radius"),
                     .low = 0.5,
                     .high = 100,
                     .home = automaticRadius(scene),
                     .logarithmic = true}) &&
        radius > 0) {
        scene.escapeRadius = radius;
        context.touch();
    }

    if (choose("escape test", "escape test", scene.escapeTest, {"first", "last"})) context.touch();

    drawComparedControls(context);

    heading(workspace.views.size() > 1 ? "Slice of the marked view" : "Slice");
    sliceControls(context);
    heading("Colours");
    colourControls(context);
    if (section("Average over random maps", workspace.view().ensemble.varies()))
        drawEnsemble(context);
    if (section("Images behind and in front", !workspace.view().layers.empty()))
        drawLayers(context);
    heading("Language");
    chooseLanguage(context);
}

}  // namespace versorium
