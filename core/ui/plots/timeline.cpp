// SPDX-License-Identifier: MIT
// The motion in the strip below the views: record, play, and its key frames on a line of time that
// are chosen, dragged, added and taken away.
#include <algorithm>
#include <cmath>

#include "ui/plots/plots.h"
#include "ui/session/context.h"
#include "ui/widgets/help.h"
#include "ui/widgets/shown_number.h"

namespace versorium {
namespace {

constexpr std::array<const char*, 3> kEasings = {trLater("linear"), trLater("smooth"),
                                                 trLater("hold")};
constexpr double kLeastShown = 2;  // seconds
constexpr int kCurvePoints = 240;
constexpr std::size_t kMostCurves = 8;
constexpr double kLeastGap = 1e-3;  // seconds between key frames

bool button(const char* label, const char* control) {
    const bool pressed = ImGui::SmallButton(tr(label));
    explain(control);
    ImGui::SameLine(0, 4);
    return pressed;
}

bool numberBox(const char* id, const char* control, double& value, double low, double high,
               const char* format, double speed) {
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 4.4f);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(4, 0));
    const bool changed = dragNumber(id, value, speed, format, low, high);
    ImGui::PopStyleVar();
    explain(control);
    ImGui::SameLine(0, 8);
    return changed;
}

void drawHead(StudioContext& context) {
    Player& player = context.player;
    const Motion& motion = context.workspace.motion;
    if (button(player.recording ? "■ Stop" : "● Record", "record"))
        context.player.record(!player.recording);
    if (button("|←", "motion first")) context.player.play(false), context.player.showMotionAt(0);
    if (button(player.playing ? "Pause" : "Play", "play motion"))
        context.player.play(!player.playing);
    ImGui::SameLine(0, 8);
    double at = player.at;
    if (numberBox("##at", "motion time", at, 0, kMostSeconds, tr("%.2f s"), 0.02)) {
        context.player.play(false);
        motion.keys.empty() ? void(player.at = at) : context.player.showMotionAt(at);
    }
    if (button("Set key", "set key")) context.player.setKey();
    if (player.key >= 0 && player.key < static_cast<int>(motion.keys.size())) {
        const auto k = static_cast<std::size_t>(player.key);
        if (button("Remove", "remove key")) return context.player.removeKey();
        ImGui::SetNextItemWidth(ImGui::GetFontSize() * 5);
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(4, 0));
        int easing = static_cast<int>(motion.keys[k].easing);
        std::array<const char*, 3> words = kEasings;
        for (const char*& word : words) word = tr(word);
        if (ImGui::Combo("##easing", &easing, words.data(), static_cast<int>(words.size())))
            context.edit(
                [&](Workspace& w) { w.motion.keys[k].easing = static_cast<Easing>(easing); });
        ImGui::PopStyleVar();
        explain("easing");
        ImGui::SameLine(0, 8);
    }
    double rate = motion.framesPerSecond;
    if (numberBox("##rate", "frame rate", rate, 1, 240, tr("%.0f fps"), 0.2))
        context.edit([&](Workspace& w) { w.motion.framesPerSecond = rate; });
    if (!motion.keys.empty()) {
        if (button("Save", "save motion")) context.player.saveMotion();
        if (button("Export", "export motion")) {
            context.exporting.motion = true;
            context.exporting.plate = false;
            context.dialogs.exporting = true;
        }
    }
    ImGui::NewLine();
}

// Where seconds lie in the diagram.
struct TimeAxis {
    float left, right;
    double seconds;
    float at(double time) const {
        return left + static_cast<float>(time / seconds) * (right - left);
    }
    double time(float x) const {
        return std::clamp((x - left) / (right - left), 0.0f, 1.0f) * seconds;
    }
};

void drawSeconds(const TimeAxis& line, float low, float high) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    double step = 1;
    for (const double wide : {0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 30.0, 60.0, 300.0, 600.0}) {
        step = wide;
        if (line.at(step) - line.at(0) > 5 * ImGui::GetFontSize()) break;
    }
    for (int k = 0; k * step <= line.seconds; ++k) {
        const float x = line.at(k * step);
        list.AddLine({x, low}, {x, high}, ImGui::GetColorU32(ImGuiCol_Border));
        drawText(list, {x + 4, high - ImGui::GetFontSize() - 2},
                 ImGui::GetColorU32(ImGuiCol_TextDisabled), shownNumber(k * step, 3) + " s");
    }
}

// What moves, each number within its own range.
void drawCurves(const Motion& motion, const TimeAxis& line, float low, float high) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    std::map<std::string, std::vector<double>> curves;
    for (int k = 0; k < kCurvePoints; ++k)
        for (const auto& [name, value] :
             valuesAt(motion, motion.duration() * k / (kCurvePoints - 1)))
            curves[name].push_back(value);
    std::size_t shown = 0;
    ImVec2 label{line.left + 6, low + 3};
    for (const auto& [name, values] : curves) {
        const auto [least, most] = std::minmax_element(values.begin(), values.end());
        if (*least == *most || shown == kMostCurves) continue;
        const ImU32 colour = pinColour(static_cast<int>(shown++ % 4));
        std::vector<ImVec2> points;
        for (std::size_t k = 0; k < values.size(); ++k) {
            const double part = (values[k] - *least) / (*most - *least);
            points.push_back(
                {line.at(motion.duration() * static_cast<double>(k) / (kCurvePoints - 1)),
                 high - 10 - static_cast<float>(part) * (high - low - 20)});
        }
        list.AddPolyline(points.data(), static_cast<int>(points.size()), colour, 0, 1.3f);
        drawText(list, label, colour, name);
        label.x += ImGui::CalcTextSize(name.c_str()).x + ImGui::GetFontSize();
    }
}

int keyNear(const Motion& motion, const TimeAxis& line, float x, float reach) {
    int nearest = -1;
    for (std::size_t k = 0; k < motion.keys.size(); ++k) {
        const float distance = std::abs(line.at(motion.keys[k].time) - x);
        if (distance > reach) continue;
        reach = distance;
        nearest = static_cast<int>(k);
    }
    return nearest;
}

void moveKey(StudioContext& context, double time) {
    const auto& keys = context.workspace.motion.keys;
    const auto k = static_cast<std::size_t>(context.player.key);
    const double least = k > 0 ? keys[k - 1].time + kLeastGap : 0;
    const double most = k + 1 < keys.size() ? keys[k + 1].time - kLeastGap : kMostSeconds;
    if (least > most) return;
    const double wanted = std::clamp(time, least, most);
    if (wanted == keys[k].time) return;
    context.edit([&](Workspace& w) { w.motion.keys[k].time = wanted; });
    context.player.at = wanted;
}

}  // namespace

void drawTimeline(StudioContext& context) {
    Player& player = context.player;
    const Motion& motion = context.workspace.motion;
    player.key = std::min(player.key, static_cast<int>(motion.keys.size()) - 1);
    drawHead(context);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 space = ImGui::GetContentRegionAvail();
    if (space.x < 60 || space.y < 24) return;
    const ImVec2 high{low.x + space.x, low.y + space.y};
    ImGui::InvisibleButton("time", space);
    explain("time line");
    const bool pressed = ImGui::IsItemActivated(), held = ImGui::IsItemActive();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg), 6);
    // A dragged last key frame must not change what its place means.
    static double shownSeconds = kLeastShown;
    if (!held) shownSeconds = std::max({kLeastShown, 1.08 * motion.duration(), 1.02 * player.at});
    const TimeAxis line{low.x + 12, high.x - 12, shownSeconds};
    list.PushClipRect(low, high, true);
    drawSeconds(line, low.y, high.y);
    if (motion.keys.empty() && !player.recording)
        drawText(
            list, {low.x + 12, low.y + 0.4f * space.y}, ImGui::GetColorU32(ImGuiCol_TextDisabled),
            tr("Record (R) what you do with the focused view, or set key frames (K) by hand."));
    else
        drawCurves(motion, line, low.y, high.y - 16);
    const float middle = low.y + 0.5f * space.y, mark = 6 * context.scale;
    const float x = ImGui::GetIO().MousePos.x;
    if (pressed) {
        context.player.play(false);
        player.key = keyNear(motion, line, x, 2 * mark);
        player.dragsKey = player.key >= 0;
        if (player.dragsKey)
            context.player.showMotionAt(motion.keys[static_cast<std::size_t>(player.key)].time);
    }
    if (held && player.dragsKey && ImGui::GetIO().MouseDelta.x != 0 && player.key >= 0)
        moveKey(context, line.time(x));
    else if (held && !player.dragsKey && line.time(x) != player.at)
        motion.keys.empty() ? void(player.at = line.time(x))
                            : context.player.showMotionAt(line.time(x));
    for (std::size_t k = 0; k < motion.keys.size(); ++k) {
        const ImVec2 at{line.at(motion.keys[k].time), middle};
        const bool chosen = static_cast<int>(k) == player.key;
        drawMark(list, at, chosen ? 1.3f * mark : mark, MarkShape::diamond,
                 ImGui::GetColorU32(chosen ? ImGuiCol_CheckMark : ImGuiCol_Text));
    }
    const float now = line.at(std::min(player.at, line.seconds));
    list.AddLine(
        {now, low.y}, {now, high.y},
        player.recording ? IM_COL32(240, 90, 80, 255) : ImGui::GetColorU32(ImGuiCol_CheckMark), 2);
    list.PopClipRect();
}

}  // namespace versorium
