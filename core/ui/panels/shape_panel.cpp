// SPDX-License-Identifier: MIT
// The inspector's part of a shape modulus: the shape, drawn, chosen or typed, and α and β over
// space, painted or given by a second shape.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "io/shape_file_kind.h"
#include "scene/shape_controls.h"
#include "scene/shape_name.h"
#include "ui/panels/number_field.h"
#include "ui/panels/panels.h"
#include "ui/panels/value_widgets.h"
#include "ui/session/context.h"
#include "ui/session/shape_change.h"
#include "ui/widgets/help.h"
#include "ui/widgets/panel_parts.h"

namespace versorium {
namespace {

constexpr std::size_t kTextBytes = 1 << 16;

// The text of a shape as it is typed, and what the scene had when it was last shown.
struct ShapeText {
    std::string text, shown;
};
struct ShapeTexts {
    ShapeText shape, alpha, beta;
};

bool toolButton(StudioContext& context, const char* label, const char* control,
                Drawing::Tool tool) {
    const bool held = context.drawing.tool == tool;
    if (held) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(ImGuiCol_HeaderActive));
    const bool pressed = ImGui::Button(tr(label));
    if (held) ImGui::PopStyleColor();
    explain(control);
    if (pressed) chooseTool(context, tool);
    return pressed;
}

// A field for a shape's text; true when Enter was pressed.
bool shapeText(const char* id, const char* control, std::string& text) {
    static char buffer[kTextBytes];
    const std::size_t size = std::min(text.size(), kTextBytes - 1);
    std::memcpy(buffer, text.data(), size);
    buffer[size] = 0;
    ImGui::SetNextItemWidth(-1);
    const bool done = ImGui::InputTextWithHint(id, "star(5, 0.9, 0.45)", buffer, kTextBytes,
                                               ImGuiInputTextFlags_EnterReturnsTrue);
    explain(control);
    text = buffer;
    return done;
}

// Built-in shapes behind a label; empty unless one was chosen.
std::string chosenShape(const char* id, const char* control, const std::string& now) {
    std::string chosen;
    ImGui::SetNextItemWidth(-1);
    const bool open = ImGui::BeginCombo(id, now.c_str(), ImGuiComboFlags_HeightLarge);
    if (!open) explain(control);
    if (!open) return chosen;
    for (const ShapeChoice& choice : shapeChoices()) {
        if (ImGui::Selectable(tr(choice.name))) chosen = choice.source;
        explainBy(choice.source);
    }
    ImGui::EndCombo();
    return chosen;
}

// Made of a picture's pixels.
bool isPictureShape(const Scene& scene) {
    constexpr std::string_view kAsset = "asset:";
    if (!scene.shape.source.starts_with(kAsset)) return false;
    const auto asset = scene.assets.find(scene.shape.source.substr(kAsset.size()));
    return asset != scene.assets.end() &&
           shapeFileKindOf(asset->second->bytes, asset->second->name) == ShapeFileKind::picture;
}

void shapeControls(StudioContext& context) {
    const Scene& scene = context.workspace.view();
    if (toolButton(context, "Draw", "draw shape", Drawing::Tool::outline)) return;
    ImGui::SameLine();
    const std::string chosen =
        chosenShape("##shape", "shape choice", trMessage(shapeName(scene, scene.shape.source)));
    if (!chosen.empty()) return context.report(setShape(context, chosen));
    ShapeText& typed = context.panels.of<ShapeTexts>().shape;
    const std::string source = scene.shape.source.starts_with("asset:") ? "" : scene.shape.source;
    if (typed.shown != source) typed.text = typed.shown = source;
    if (shapeText("##shape text", "shape text", typed.text)) {
        context.report(setShape(context, typed.text));
        return;
    }
    if (isPictureShape(scene)) {
        drawValue(context, "shape.threshold");
        drawValue(context, "shape.by_alpha");
        drawValue(context, "shape.invert");
    }
    const OrbitProgram* program = context.bound.program(context.workspace.focused);
    if (!program || !program->field) {
        ImGui::TextDisabled("%s", tr("Its distances are being measured …"));
        return;
    }
    const double zero[3] = {};
    double phi = program->field->at(zero[0], zero[1], zero[2]);
    if (traitsOf(scene).shape) {
        const std::array<double, 3> shift = shapeControls(scene).seenShift();
        phi = program->field->at(-shift[0], -shift[1], -shift[2]);
    }
    if (phi > 0) {
        ImGui::PushTextWrapPos();
        const std::string warning =
            tr("The origin lies outside of the shape (φ = {1}): nothing draws orbits to 0, and the "
               "set may be empty. Move it by shift.",
               {shownNumber(phi, 3)});
        ImGui::TextDisabled("%s", warning.c_str());
        ImGui::PopTextWrapPos();
    }
    if (ImGui::SmallButton(tr("φ + β, as printed, beside it"))) showAsPrinted(context);
    explain("as printed");
}

template <class S>
auto& specOf(S& scene, bool alpha) {
    return alpha ? scene.alphaOverSpace : scene.betaOverSpace;
}

// Sets the same in all views.
void setSpec(StudioContext& context, bool alpha, const ModulationSpec& spec) {
    Workspace next = context.workspace;
    for (Scene& scene : next.views) specOf(scene, alpha) = spec;
    if (Status status = checkModulation(next.view()); !status.ok()) return context.report(status);
    dropUnnamedAssets(next);
    context.edit([&](Workspace& w) { w = std::move(next); });
}

void brushControls(StudioContext& context, bool alpha, const ModulationSpec& spec) {
    toolButton(context, alpha ? "Paint α" : "Paint β", "paint",
               alpha ? Drawing::Tool::alpha : Drawing::Tool::beta);
    ImGui::SameLine();
    drawValue(context, "brush.erases");
    ImGui::SameLine();
    ImGui::TextDisabled("%s", tr("{1} dabs", {std::to_string(spec.discs.size())}).c_str());
    if (!spec.discs.empty()) {
        ImGui::SameLine();
        if (ImGui::SmallButton(tr("clear"))) {
            ModulationSpec none = spec;
            none.discs.clear();
            setSpec(context, alpha, none);
        }
        explain("clear paint");
    }
    drawValues(context, {alpha ? "brush.alpha" : "brush.beta", "brush.radius"});
}

void secondShapeControls(StudioContext& context, bool alpha, const ModulationSpec& now) {
    const Scene& scene = context.workspace.view();
    ModulationSpec spec = now;
    ImGui::TextDisabled("%s", tr("within a second shape"));
    ImGui::SameLine();
    const std::string chosen =
        chosenShape("##second", "second shape",
                    now.shape.empty() ? tr("none") : trMessage(shapeName(scene, now.shape)));
    ShapeTexts& texts = context.panels.of<ShapeTexts>();
    ShapeText& typed = alpha ? texts.alpha : texts.beta;
    const std::string source = now.shape.starts_with("asset:") ? "" : now.shape;
    if (typed.shown != source) typed.text = typed.shown = source;
    bool changed = shapeText("##second text", "second shape text", typed.text);
    if (changed) spec.shape = typed.text;
    if (!chosen.empty()) spec.shape = chosen, changed = true;
    if (!now.shape.empty()) {
        const std::string path = alpha ? "modulation.alpha." : "modulation.beta.";
        for (const char* part : {"value", "between[0]", "between[1]"})
            drawValue(context, path + part);
        spec = specOf(context.workspace.view(), alpha);
        if (ImGui::SmallButton(tr("no second shape"))) spec.shape.clear(), changed = true;
        explain("no second shape");
    }
    if (changed) setSpec(context, alpha, spec);
}

void modulationControls(StudioContext& context, bool alpha) {
    const ModulationSpec spec = specOf(context.workspace.view(), alpha);
    ImGui::PushID(alpha ? "alpha over space" : "beta over space");
    const std::string title = named(alpha ? "α over space" : "β over space");
    const bool open = ImGui::TreeNodeEx(title.c_str(), ImGuiTreeNodeFlags_SpanAvailWidth);
    explain("over space");
    if (open) {
        brushControls(context, alpha, spec);
        secondShapeControls(context, alpha, spec);
        ImGui::TreePop();
    }
    ImGui::PopID();
}

}  // namespace

void drawShapePanel(StudioContext& context) {
    heading("Shape");
    if (!mapOf(context.workspace.view()).info.field) {
        toolButton(context, "Draw a shape", "draw shape", Drawing::Tool::outline);
        return;
    }
    shapeControls(context);
    for (const bool alpha : {true, false}) modulationControls(context, alpha);
    const Scene& scene = context.workspace.view();
    if (scene.alphaOverSpace.modulates() || scene.betaOverSpace.modulates()) {
        drawValue(context, "brush.overlay");
    }
}

}  // namespace versorium
