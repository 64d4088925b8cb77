// SPDX-License-Identifier: MIT
// The field in which a formula is typed, with what is wrong in it while it is typed.
#include <algorithm>
#include <cstring>

#include "imgui_internal.h"
#include "maps/formula_shape.h"
#include "ui/panels/panels.h"
#include "ui/session/context.h"
#include "ui/session/formulas.h"
#include "ui/widgets/help.h"

namespace versorium {
namespace {

constexpr std::size_t kBytes = 4 * kFormulaCharacters + 1;

// A text field over a string of at most `Size` - 1 bytes.
template <std::size_t Size>
bool textField(const char* id, const char* hint, std::string& value, ImGuiInputTextFlags flags) {
    static char buffer[Size];
    const std::size_t size = std::min(value.size(), Size - 1);
    std::memcpy(buffer, value.data(), size);
    buffer[size] = 0;
    const bool done = ImGui::InputTextWithHint(id, hint, buffer, Size, flags);
    value = buffer;
    return done;
}

// The bytes of the first so many characters.
std::size_t bytesOf(const std::string& text, std::size_t characters) {
    std::size_t i = 0;
    for (; i < text.size() && characters > 0; --characters) {
        ++i;
        while (i < text.size() && (static_cast<unsigned char>(text[i]) & 0xc0u) == 0x80u) ++i;
    }
    return i;
}

// A small arrow below the character that is wrong.
void drawPointer(const FormulaEditor& editor, ImGuiID id, ImVec2 low, ImVec2 high) {
    const std::string before = editor.text.substr(0, bytesOf(editor.text, editor.fault.position));
    const ImGuiInputTextState* state = ImGui::GetInputTextState(id);
    const float scrolled = state && ImGui::GetActiveID() == id ? state->ScrollX : 0;
    const float padding = ImGui::GetStyle().FramePadding.x;
    const float x = std::clamp(low.x + padding + ImGui::CalcTextSize(before.c_str()).x - scrolled,
                               low.x + padding, high.x - padding);
    const float size = ImGui::GetFontSize() * 0.32f;
    const ImVec2 tip{x + size, high.y - 2};
    ImGui::GetWindowDrawList()->AddTriangleFilled({tip.x - size, tip.y + 2 * size},
                                                  {tip.x + size, tip.y + 2 * size}, tip,
                                                  ImGui::GetColorU32(ImGuiCol_PlotLinesHovered));
    ImGui::Dummy({1, size * 1.5f});
}

void drawSaving(StudioContext& context, const std::string& text) {
    FormulaEditor& editor = context.formula;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x * 0.55f);
    const bool enter = textField<SavedFormulas::kNameSize + 1>(
        "##formula name", tr("a name for it"), editor.name, ImGuiInputTextFlags_EnterReturnsTrue);
    explain("formula name");
    ImGui::SameLine();
    const bool pressed = ImGui::Button(tr("Save formula"));
    explain("save formula");
    if (enter || pressed) {
        const Status status = context.formulas.save(context.host, editor.name, text);
        if (status.ok()) {
            context.say(tr("The formula is saved as {1}", {editor.name}));
            editor.name.clear();
        } else {
            context.report(status);
        }
    }
    const auto& all = context.formulas.all();
    const auto own = std::find_if(all.begin(), all.end(),
                                  [&](const SavedFormula& one) { return one.text == text; });
    if (own == all.end()) return;
    ImGui::TextDisabled("%s", tr("saved as {1}", {own->name}).c_str());
    ImGui::SameLine();
    const std::string name = own->name;
    if (ImGui::SmallButton(tr("forget it"))) context.formulas.forget(context.host, name);
    explain("forget formula");
}

}  // namespace

void drawFormulaChoices(StudioContext& context) {
    if (ImGui::Selectable(tr("Formula of your own…"), false)) editFormula(context);
    explain("formula");
    // A copy: choosing one changes nothing in the list, but what is drawn may.
    const std::vector<SavedFormula> all = context.formulas.all();
    const Scene& scene = context.workspace.views[0];
    const std::string now = scene.formula ? scene.formula->formula().text : std::string();
    for (const SavedFormula& one : all) {
        ImGui::PushID(one.name.c_str());
        if (ImGui::Selectable(one.name.c_str(), one.text == now) && one.text != now)
            context.report(applyFormula(context, one.text));
        explainBy(one.text);
        ImGui::PopID();
    }
    ImGui::Separator();
}

void drawFormulaPanel(StudioContext& context) {
    FormulaEditor& editor = context.formula;
    const std::shared_ptr<const FormulaMap> present = context.workspace.views[0].formula;
    if (!present && !editor.open) return;
    // Undo, links and presets change the formula behind the field's back.
    if (present && present->formula().text != editor.shown) {
        editor.text = editor.shown = present->formula().text;
        editor.fault = {};
    }
    const bool blocked = ImGui::GetTopMostPopupModal() != nullptr;
    if (editor.focusFrames > 0) context.host.wake();
    if (editor.focusFrames > 0 && !blocked) {
        // The studio's window takes no part in walking by keys, which SetKeyboardFocusHere needs.
        ImGui::FocusWindow(ImGui::GetCurrentWindow());
        ImGui::ActivateItemByID(ImGui::GetID("##formula"));
        ImGui::GetCurrentContext()->NavNextActivateFlags =
            ImGuiActivateFlags_PreferInput |
            (editor.fault.message.empty() ? 0 : ImGuiActivateFlags_TryToPreserveState);
    }
    ImGui::SetNextItemWidth(-1);
    const std::string before = editor.text;
    const bool enter = textField<kBytes>("##formula", "z^2 + c", editor.text,
                                         ImGuiInputTextFlags_EnterReturnsTrue);
    editor.focusFrames = ImGui::IsItemActive() ? 0 : std::max(0, editor.focusFrames - 1);
    const ImGuiID id = ImGui::GetItemID();
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const bool left = ImGui::IsItemDeactivatedAfterEdit();
    explain("formula");
    if (editor.text != before) {
        editor.fault = {};
        FormulaFault fault;
        if (!parseFormula(editor.text, &fault, &formulaShape())) editor.fault = fault;
    }
    if (enter || left) {
        FormulaFault fault;
        if (const auto read = FormulaMap::make(editor.text, &fault)) {
            context.report(applyFormula(context, editor.text));
        } else {
            editor.fault = fault;
            // Enter on a fault leaves the cursor where it is.
            if (enter) editor.focusFrames = 30;
        }
    }
    if (!editor.fault.message.empty()) {
        drawPointer(editor, id, low, high);
        ImGui::PushTextWrapPos();
        ImGui::TextUnformatted(trMessage(editor.fault.message).c_str());
        ImGui::PopTextWrapPos();
    } else if (!present || editor.text != editor.shown) {
        ImGui::TextDisabled("%s", tr("Enter takes it"));
        if (present) return;
        ImGui::SameLine();
        if (ImGui::SmallButton(tr("never mind"))) editor.open = false;
        explain("no formula");
    } else {
        drawSaving(context, present->formula().text);
    }
}

}  // namespace versorium
