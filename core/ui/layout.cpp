// SPDX-License-Identifier: MIT
#include "ui/layout.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "ui/lesson/lesson_pane.h"
#include "ui/panels/panels.h"
#include "ui/plots/plots.h"
#include "ui/views/view.h"
#include "ui/widgets/help.h"

namespace versorium {
namespace {

constexpr float kNarrow = 900;  // below this width views become tabs
constexpr float kInspector = 330, kPlot = 150, kTallPlot = 300, kLesson = 340;
constexpr float kFinger = 44;  // a button that a finger meets

struct Tab {
    std::string label;
    const char* control;
    std::function<void()> press;
};

// What a row of buttons may have around each label and between each two, so that all fit: as much
// as usual, but less where words are long.
constexpr float kLeastRoom = 2;  // pixels

float roomAround(const std::vector<Tab>& tabs, float wide) {
    for (const Tab& tab : tabs) wide -= ImGui::CalcTextSize(tab.label.c_str(), nullptr, true).x;
    const float parts = 3 * static_cast<float>(tabs.size()) - 1;
    return std::clamp(std::floor(wide / parts), kLeastRoom, ImGui::GetStyle().FramePadding.x);
}

void drawViews(StudioContext& context, ImVec2 low, ImVec2 high) {
    const Workspace& workspace = context.workspace;
    const int count = workspace.maximised ? 1 : static_cast<int>(workspace.views.size());
    if (count == 1) return drawView(context, workspace.focused, low, high);
    const float gap = 6 * context.scale;
    if (workspace.analysis() && !workspace.maximised) {
        // The set on the left as large as the four beside it.
        const float half = std::floor((high.x - low.x - gap) / 2);
        drawView(context, 0, low, {low.x + half, high.y});
        const float left = low.x + half + gap;
        const float width = std::floor((high.x - left - gap) / 2);
        const float tall = std::floor((high.y - low.y - gap) / 2);
        for (int k = 0; k < 4; ++k) {
            const ImVec2 corner{left + static_cast<float>(k % 2) * (width + gap),
                                low.y + static_cast<float>(k / 2) * (tall + gap)};
            drawView(context, k + 1, corner, {corner.x + width, corner.y + tall});
        }
        return;
    }
    const int rows = count == 4 ? 2 : 1;
    const float width = std::floor((high.x - low.x - gap) / 2);
    const float height = std::floor((high.y - low.y - gap * static_cast<float>(rows - 1)) /
                                    static_cast<float>(rows));
    for (int k = 0; k < count; ++k) {
        const ImVec2 corner{low.x + static_cast<float>(k % 2) * (width + gap),
                            low.y + static_cast<float>(k / 2) * (height + gap)};
        drawView(context, k, corner, {corner.x + width, corner.y + height});
    }
}

// Who draws the focused view, with which precision and why; a click chooses. Returns where it
// begins.
float drawRenderer(StudioContext& context, float right) {
    const LivePicture& picture =
        context.views[static_cast<std::size_t>(context.workspace.focused)].picture;
    std::string text = picture.onGpu() ? tr("GPU, 32 bits") : tr("CPU, double precision");
    if (picture.memberGoal() > 0)
        text = tr("{1} of {2} sets counted",
                  {std::to_string(picture.members()), std::to_string(picture.memberGoal())}) +
               "  ·  " + text;
    if (picture.compiling())
        text += tr(", compiling …");
    else if (!picture.finished())
        text += tr(", refining …");
    const float left = right - ImGui::CalcTextSize(text.c_str()).x;
    ImGui::SetCursorScreenPos({left, ImGui::GetCursorScreenPos().y});
    ImGui::TextDisabled("%s", text.c_str());
    if (ImGui::IsItemClicked()) ImGui::OpenPopup("renderer");
    if (!ImGui::IsPopupOpen("renderer") && ImGui::IsItemHovered()) {
        const std::string why = picture.onGpu()
                                    ? context.gpu.limits().device
                                    : tr("Why the CPU: {1}", {trMessage(picture.whyCpu())});
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(26 * ImGui::GetFontSize());
        ImGui::TextUnformatted((why + ".\n" + tr("Click to choose who draws.")).c_str());
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    }
    if (!ImGui::BeginPopup("renderer")) return left;
    const std::pair<RendererChoice, const char*> choices[] = {
        {RendererChoice::automatic, tr("Automatic")},
        {RendererChoice::gpu, tr("GPU, where 32 bits suffice")},
        {RendererChoice::cpu, tr("CPU, always in double precision")}};
    for (const auto& [choice, name] : choices)
        if (ImGui::MenuItem(name, nullptr, context.renderer == choice)) context.choose(choice);
    ImGui::EndPopup();
    return left;
}

}  // namespace

void WindowLayout::draw(StudioContext& context, ImVec2 low, ImVec2 size) {
    narrow_ = ImGui::GetMainViewport()->WorkSize.x < kNarrow * context.scale;
    if (narrow_)
        drawNarrow(context, low, size);
    else
        drawWide(context, low, size);
}

void WindowLayout::drawStatus(StudioContext& context) {
    if (const std::string& notice = context.notices.shown(); !notice.empty()) {
        ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark), "%s", notice.c_str());
        return;
    }
    if (const std::string hint = drawingHint(context); !hint.empty()) {
        ImGui::TextUnformatted(hint.c_str());
        return;
    }
    if (!context.probe.text.empty()) {
        ImGui::TextUnformatted(context.probe.text.c_str());
        return;
    }
    if (context.welcome) {
        ImGui::TextUnformatted(
            narrow_ ? tr("Drag the ring, then press Points: each point here is a whole picture "
                         "there. Or press Draw.")
                    : tr("Drag the ring. Every point of the left picture is a whole picture on the "
                         "right. Or press D and draw a shape."));
        return;
    }
    ImGui::TextDisabled("%s", tr("Ctrl K finds every command, ? lists their keys"));
}

void WindowLayout::drawWide(StudioContext& context, ImVec2 low, ImVec2 size) {
    if (context.lessons.open && !context.host.drawsLessons()) {
        const float pane = std::min(kLesson * context.scale, 0.36f * size.x);
        ImGui::SetCursorScreenPos(low);
        ImGui::BeginChild("lesson", {pane, size.y}, ImGuiChildFlags_AlwaysUseWindowPadding);
        drawLessonPane(context);
        ImGui::EndChild();
        low.x += pane + 8;
        size.x -= pane + 8;
    }
    const float bar = ImGui::GetFrameHeightWithSpacing();
    const float inspector = kInspector * context.scale;
    const bool web = context.workspace.plot == PlotPanel::web ||
                     context.workspace.plot == PlotPanel::diagram ||
                     context.workspace.plot == PlotPanel::profile;
    const float strip =
        std::min((web ? kTallPlot : kPlot) * context.scale, size.y * (web ? 0.45f : 0.25f));
    const float left = size.x - inspector - 8;
    drawViews(context, low, {low.x + left, low.y + size.y - bar - strip - 6});
    ImGui::SetCursorScreenPos({low.x, low.y + size.y - bar - strip});
    ImGui::BeginChild("strip", {left, strip}, ImGuiChildFlags_AlwaysUseWindowPadding);
    drawPlot(context);
    ImGui::EndChild();
    ImGui::SetCursorScreenPos({low.x, low.y + size.y - bar + 4});
    const float end = drawRenderer(context, low.x + left - 8) - 12 * context.scale;
    ImGui::SetCursorScreenPos({low.x + 8, low.y + size.y - bar + 4});
    ImGui::PushClipRect(low, {end, low.y + size.y}, true);
    drawStatus(context);
    ImGui::PopClipRect();
    ImGui::SetCursorScreenPos({low.x + size.x - inspector, low.y});
    ImGui::BeginChild("inspector", {inspector, size.y}, ImGuiChildFlags_AlwaysUseWindowPadding);
    if (!drawOpenControls(context)) drawInspector(context);
    ImGui::EndChild();
}

float WindowLayout::drawTabs(StudioContext& context, ImVec2 low, float wide) {
    const Workspace& workspace = context.workspace;
    const bool controls = sheet_ == Sheet::controls;
    std::vector<Tab> looks, tools;
    for (std::size_t k = 0; k < workspace.views.size(); ++k) {
        std::string label = tr(traitsOf(workspace.views[k]).tab);
        if (workspace.analysis()) label = k == 0 ? tr("Set") : std::to_string(k);
        looks.push_back({label + "##" + std::to_string(k), "view tab", [this, &context, k] {
                             plotShown_ = false;
                             context.focus(static_cast<int>(k));
                         }});
    }
    looks.push_back({tr("Orbit"), "strip tab", [this] { plotShown_ = !plotShown_; }});
    looks.push_back({controls ? tr("Close") : tr("Controls"), "sheet",
                     [this, controls] { sheet_ = controls ? Sheet::none : Sheet::controls; }});
    tools.push_back(
        {tr("Draw"), "draw shape", [&context] { chooseTool(context, Drawing::Tool::outline); }});
    tools.push_back({tr("Undo"), "undo", [&context] { context.undo(); }});
    tools.push_back(
        {tr("Lessons"), "lessons", [&context] { context.lessons.open = !context.lessons.open; }});
    // In one row where they fit, else in two.
    std::vector<std::vector<Tab>> rows{looks};
    rows[0].insert(rows[0].end(), tools.begin(), tools.end());
    float room = roomAround(rows[0], wide);
    if (room <= kLeastRoom) {
        rows = {looks, tools};
        room = roomAround(looks, wide);
    }
    const float bar = std::max(ImGui::GetFrameHeight(), kFinger * context.scale);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {room, ImGui::GetStyle().FramePadding.y});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {room, ImGui::GetStyle().ItemSpacing.y});
    float top = low.y;
    for (const std::vector<Tab>& row : rows) {
        ImGui::SetCursorScreenPos({low.x, top});
        for (std::size_t k = 0; k < row.size(); ++k) {
            if (k > 0) ImGui::SameLine();
            if (ImGui::Button(row[k].label.c_str(), {0, bar})) row[k].press();
            explain(row[k].control);
        }
        top += bar + 6;
    }
    ImGui::PopStyleVar(2);
    return top;
}

void WindowLayout::drawNarrow(StudioContext& context, ImVec2 low, ImVec2 size) {
    const float top = drawTabs(context, low, size.x);
    const bool lesson = context.lessons.open && !context.host.drawsLessons();
    if (lesson && !lessonWasOpen_) sheet_ = Sheet::lesson;
    if (!lesson && sheet_ == Sheet::lesson) sheet_ = Sheet::none;
    lessonWasOpen_ = lesson;
    const float below = sheet_ != Sheet::none ? size.y * 0.48f : 0;
    const float status = 2 * ImGui::GetTextLineHeight() + 8;
    const ImVec2 end{low.x + size.x, low.y + size.y - below - status};
    if (plotShown_) {
        ImGui::SetCursorScreenPos({low.x, top});
        ImGui::BeginChild("strip", {size.x, end.y - top}, ImGuiChildFlags_AlwaysUseWindowPadding);
        drawPlot(context);
        ImGui::EndChild();
    } else {
        drawView(context, context.workspace.focused, {low.x, top}, end);
    }
    ImGui::SetCursorScreenPos({low.x + 8, end.y + 4});
    ImGui::PushTextWrapPos(size.x);
    drawStatus(context);
    ImGui::PopTextWrapPos();
    if (sheet_ == Sheet::none) return;
    ImGui::SetCursorScreenPos({low.x, low.y + size.y - below});
    ImGui::BeginChild("sheet", {size.x, below}, ImGuiChildFlags_AlwaysUseWindowPadding);
    if (sheet_ == Sheet::lesson)
        drawLessonPane(context);
    else if (!drawOpenControls(context))
        drawInspector(context);
    ImGui::EndChild();
}

}  // namespace versorium
