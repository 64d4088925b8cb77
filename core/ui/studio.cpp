// SPDX-License-Identifier: MIT
#include "ui/studio.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "io/document.h"
#include "ui/controls/access.h"
#include "ui/controls/controls.h"
#include "ui/dialogs/dialogs.h"
#include "ui/keyboard.h"
#include "ui/lesson/lesson_pane.h"
#include "ui/panels/panels.h"
#include "ui/plots/plots.h"
#include "ui/session/context.h"
#include "ui/session/open_file.h"
#include "ui/views/view.h"
#include "ui/widgets/help.h"

namespace versorium {
namespace {

constexpr double kQuiet = 0.4;          // seconds without a change before it is recorded
constexpr double kProgressEvery = 0.1;  // seconds
constexpr float kNarrow = 900;          // below this width views become tabs
constexpr float kInspector = 330, kStrip = 150, kWebStrip = 300, kLesson = 340;

// What a row of buttons may have around each label and between each two, so that all fit: as much
// as usual, but less where words are long.
constexpr float kLeastRoom = 2;  // pixels

float roomAround(const std::vector<std::string>& labels, float wide) {
    for (const std::string& label : labels)
        wide -= ImGui::CalcTextSize(label.c_str(), nullptr, true).x;
    const float parts = 3 * static_cast<float>(labels.size()) - 1;
    return std::clamp(std::floor(wide / parts), kLeastRoom, ImGui::GetStyle().FramePadding.x);
}

}  // namespace

struct Studio::State {
    explicit State(Host& host) : context(host) {}

    StudioContext context;
    double lastFrame = -1;
    double fragmentAt = 0;
    std::string fragmentText;
    bool fragmentOld = true;
    // What stands below the view on a narrow screen, and whether the strip takes the view's place.
    enum class Sheet { none, controls, lesson } sheet = Sheet::none;
    bool stripShown = false;
    bool lessonWasOpen = false;
    bool narrow = false;  // one view at a time

    bool shows(std::size_t view) const {
        const Workspace& workspace = context.workspace;
        return !(workspace.maximised || narrow) || static_cast<int>(view) == workspace.focused;
    }
    void takeAnswers();
    std::string address() const;
    void settle();
    void animate();
    void drawViews(ImVec2 low, ImVec2 high);
    void drawStatus();
    float drawRenderer(float right);
    void drawWide(ImVec2 low, ImVec2 size);
    void drawNarrow(ImVec2 low, ImVec2 size);
};

void Studio::State::takeAnswers() {
    while (std::optional<WorkAnswer> answer = context.host.takeAnswer())
        if (const auto* picture = std::get_if<PictureResult>(&answer->result))
            context.views[static_cast<std::size_t>(picture->view)].picture.take(std::move(*answer));
        else if (std::holds_alternative<GridResult>(answer->result))
            context.takeGrid(*answer);
        else if (!takeCandidate(context, *answer))
            context.gallery.take(std::move(*answer));
    context.takeExport();
}

// A lesson is named by its step, anything else by its state. A teacher's link stays what it is.
std::string Studio::State::address() const {
    if (context.teacher) return {};
    if (context.lessons.now && context.lessons.now->own && !context.lessons.now->wandering()) {
        const LessonSession& session = context.lessons.now->session;
        return lessonLink(session.lesson().id, session.at());
    }
    const Expected<std::string> link = workspaceToLink(context.workspace);
    return link ? *link : std::string();
}

// Records what was done, once the hand is off it, and keeps the link up to date.
void Studio::State::settle() {
    const double now = context.host.now();
    if (context.edited.unrecorded()) {
        fragmentOld = true;
        if (!ImGui::IsAnyMouseDown() && now - context.edited.editedAt() > kQuiet &&
            !context.player.moves()) {
            context.record();
        }
    }
    if (fragmentOld && now - fragmentAt > 0.5 && !ImGui::IsAnyMouseDown()) {
        fragmentOld = context.edited.unrecorded();
        fragmentAt = now;
        if (const std::string link = address(); !link.empty() && link != fragmentText) {
            fragmentText = link;
            context.host.setFragment(fragmentText);
        }
    }
    // What is still to be settled, or shown, comes by itself.
    if (context.edited.unrecorded() || fragmentOld) context.host.wakeAfter(0.5 * kQuiet);
    if (context.host.exportProgress() >= 0) context.host.wakeAfter(kProgressEvery);
}

void Studio::State::animate() {
    const double now = context.host.now();
    if (lastFrame >= 0) context.player.advance(now - lastFrame);
    lastFrame = now;
}

void Studio::State::drawViews(ImVec2 low, ImVec2 high) {
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

void Studio::State::drawStatus() {
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
            narrow ? tr("Drag the ring, then press Points: each point here is a whole picture "
                        "there. Or press Draw.")
                   : tr("Drag the ring. Every point of the left picture is a whole picture on the "
                        "right. Or press D and draw a shape."));
        return;
    }
    ImGui::TextDisabled("%s", tr("Ctrl K finds every command, ? lists their keys"));
}

// Who draws the focused view, with which precision and why; a click chooses. Returns where it
// begins.
float Studio::State::drawRenderer(float right) {
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

void Studio::State::drawWide(ImVec2 low, ImVec2 size) {
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
    const bool web = context.workspace.strip == Strip::web ||
                     context.workspace.strip == Strip::diagram ||
                     context.workspace.strip == Strip::profile;
    const float strip =
        std::min((web ? kWebStrip : kStrip) * context.scale, size.y * (web ? 0.45f : 0.25f));
    const float left = size.x - inspector - 8;
    drawViews(low, {low.x + left, low.y + size.y - bar - strip - 6});
    ImGui::SetCursorScreenPos({low.x, low.y + size.y - bar - strip});
    ImGui::BeginChild("strip", {left, strip}, ImGuiChildFlags_AlwaysUseWindowPadding);
    drawOrbitStrip(context);
    ImGui::EndChild();
    ImGui::SetCursorScreenPos({low.x, low.y + size.y - bar + 4});
    const float end = drawRenderer(low.x + left - 8) - 12 * context.scale;
    ImGui::SetCursorScreenPos({low.x + 8, low.y + size.y - bar + 4});
    ImGui::PushClipRect(low, {end, low.y + size.y}, true);
    drawStatus();
    ImGui::PopClipRect();
    ImGui::SetCursorScreenPos({low.x + size.x - inspector, low.y});
    ImGui::BeginChild("inspector", {inspector, size.y}, ImGuiChildFlags_AlwaysUseWindowPadding);
    if (!drawOpenControls(context)) drawInspector(context);
    ImGui::EndChild();
}

void Studio::State::drawNarrow(ImVec2 low, ImVec2 size) {
    const Workspace& workspace = context.workspace;
    const float bar = std::max(ImGui::GetFrameHeight(), 44 * context.scale);
    const ImVec2 button{0, bar};
    const bool controls = sheet == Sheet::controls;
    struct Tab {
        std::string label;
        const char* control;
        std::function<void()> press;
    };
    std::vector<Tab> looks, tools;
    for (std::size_t k = 0; k < workspace.views.size(); ++k) {
        std::string label = tr(traitsOf(workspace.views[k]).tab);
        if (workspace.analysis()) label = k == 0 ? tr("Set") : std::to_string(k);
        looks.push_back({label + "##" + std::to_string(k), "view tab", [this, k] {
                             stripShown = false;
                             context.mark(static_cast<int>(k));
                         }});
    }
    looks.push_back({tr("Orbit"), "strip tab", [this] { stripShown = !stripShown; }});
    looks.push_back({controls ? tr("Close") : tr("Controls"), "sheet",
                     [this, controls] { sheet = controls ? Sheet::none : Sheet::controls; }});
    tools.push_back(
        {tr("Draw"), "draw shape", [this] { chooseTool(context, Drawing::Tool::outline); }});
    tools.push_back({tr("Undo"), "undo", [this] { context.undo(); }});
    tools.push_back(
        {tr("Lessons"), "lessons", [this] { context.lessons.open = !context.lessons.open; }});
    const auto labelsOf = [](const std::vector<Tab>& tabs) {
        std::vector<std::string> labels;
        for (const Tab& tab : tabs) labels.push_back(tab.label);
        return labels;
    };
    // In one row where they fit, else in two.
    std::vector<std::vector<Tab>> rows{looks};
    rows[0].insert(rows[0].end(), tools.begin(), tools.end());
    float room = roomAround(labelsOf(rows[0]), size.x);
    if (room <= kLeastRoom) {
        rows = {looks, tools};
        room = roomAround(labelsOf(looks), size.x);
    }
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {room, ImGui::GetStyle().FramePadding.y});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {room, ImGui::GetStyle().ItemSpacing.y});
    float top = low.y;
    for (const std::vector<Tab>& row : rows) {
        ImGui::SetCursorScreenPos({low.x, top});
        for (std::size_t k = 0; k < row.size(); ++k) {
            if (k > 0) ImGui::SameLine();
            if (ImGui::Button(row[k].label.c_str(), button)) row[k].press();
            explain(row[k].control);
        }
        top += bar + 6;
    }
    ImGui::PopStyleVar(2);
    const bool lesson = context.lessons.open && !context.host.drawsLessons();
    if (lesson && !lessonWasOpen) sheet = Sheet::lesson;
    if (!lesson && sheet == Sheet::lesson) sheet = Sheet::none;
    lessonWasOpen = lesson;
    const float below = sheet != Sheet::none ? size.y * 0.48f : 0;
    const float status = 2 * ImGui::GetTextLineHeight() + 8;
    const ImVec2 end{low.x + size.x, low.y + size.y - below - status};
    if (stripShown) {
        ImGui::SetCursorScreenPos({low.x, top});
        ImGui::BeginChild("strip", {size.x, end.y - top}, ImGuiChildFlags_AlwaysUseWindowPadding);
        drawOrbitStrip(context);
        ImGui::EndChild();
    } else {
        drawView(context, workspace.focused, {low.x, top}, end);
    }
    ImGui::SetCursorScreenPos({low.x + 8, end.y + 4});
    ImGui::PushTextWrapPos(size.x);
    drawStatus();
    ImGui::PopTextWrapPos();
    if (sheet == Sheet::none) return;
    ImGui::SetCursorScreenPos({low.x, low.y + size.y - below});
    ImGui::BeginChild("sheet", {size.x, below}, ImGuiChildFlags_AlwaysUseWindowPadding);
    if (sheet == Sheet::lesson)
        drawLessonPane(context);
    else if (!drawOpenControls(context))
        drawInspector(context);
    ImGui::EndChild();
}

Studio::Studio(Host& host) : state_(new State(host)) {
    const std::string stored = host.stored("theme");
    for (std::size_t k = 0; k < themes().size(); ++k)
        if (themes()[k].name == stored) state_->context.theme = k;
    // Something moves until the first touch.
    if (!host.reducedMotion())
        state_->context.player.animation = {.number = "c.im",
                                            .low = 0.13,
                                            .high = 0.24,
                                            .seconds = 24,
                                            .phase = 0.25,
                                            .running = true};
}
Studio::~Studio() = default;

void Studio::prepare(float scale) {
    const StudioTheme& theme = themes()[state_->context.theme];
    state_->context.scale = scale;
    state_->context.fontsChanged = false;
    applyTheme(theme, scale);
    loadFonts(theme, scale);
}

bool Studio::wantsPrepare() const { return state_->context.fontsChanged; }

void Studio::frame() {
    State& state = *state_;
    StudioContext& context = state.context;
    context.buttonDown = ImGui::IsAnyMouseDown();
    state.takeAnswers();
    handleKeys(context);
    context.glide();
    state.animate();
    const ImGuiViewport& screen = *ImGui::GetMainViewport();
    ImGui::SetNextWindowPos(screen.WorkPos);
    ImGui::SetNextWindowSize(screen.WorkSize);
    ImGui::Begin("Versorium", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                     ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoNavInputs);
    const float margin = 6;
    const ImVec2 low{screen.WorkPos.x + margin, screen.WorkPos.y + margin};
    const ImVec2 size{screen.WorkSize.x - 2 * margin, screen.WorkSize.y - 2 * margin};
    // Only those that are drawn have a rectangle.
    for (ViewState& view : context.views) view.low = view.high = {};
    state.narrow = screen.WorkSize.x < kNarrow * context.scale;
    if (state.narrow)
        state.drawNarrow(low, size);
    else
        state.drawWide(low, size);
    drawDialogs(context);
    ImGui::End();
    keepLocks(context);
    noteGoal(context);
    state.settle();
}

bool Studio::busy() const {
    const StudioContext& context = state_->context;
    for (std::size_t k = 0; k < context.workspace.views.size(); ++k)
        if (state_->shows(k) && context.views[k].picture.working()) return true;
    return context.player.moves() || context.gliding();
}

bool Studio::pinch(float fromX, float fromY, float toX, float toY, double factor) {
    return state_->context.pinch({fromX, fromY}, {toX, toY}, factor);
}

Status Studio::openPreset(const std::string& name) {
    Expected<Scene> scene = presetNamed(name);
    if (!scene) return scene.status();
    state_->context.open(workspaceOf(*scene));
    return {};
}

Status Studio::openFormula(const std::string& text) {
    state_->context.welcome = false;
    return applyFormula(state_->context, text);
}

Status Studio::openBytes(const std::string& name, std::span<const unsigned char> bytes) {
    return versorium::openBytes(state_->context, name, bytes);
}

Status Studio::openFragment(const std::string& fragment) {
    if (fragment.empty() || fragment == this->fragment()) return {};
    if (isTeacherLink(fragment)) {
        const Expected<TeacherLink> link = parseTeacherLink(fragment);
        const Status status = link ? followTeacherLink(state_->context, *link) : link.status();
        state_->context.report(status);
        return status;
    }
    Expected<Workspace> workspace = workspaceFromLink(fragment);
    if (!workspace) {
        state_->context.report(workspace.status());
        return workspace.status();
    }
    state_->context.teacher.reset();
    state_->context.open(std::move(*workspace));
    return {};
}

std::string Studio::fragment() const { return state_->address(); }

Status Studio::openLesson(const std::string& id, std::optional<std::size_t> step) {
    return versorium::openLesson(state_->context, id, step);
}
std::string Studio::lessonRing() const { return ringAnswer(state_->context); }
std::string Studio::lesson() const { return lessonText(state_->context); }
bool Studio::lessonDo(const std::string& action, const std::string& value) {
    return versorium::lessonDo(state_->context, action, value);
}

bool Studio::finished() const {
    const Workspace& workspace = state_->context.workspace;
    for (std::size_t k = 0; k < workspace.views.size(); ++k)
        if (state_->shows(k) && !state_->context.views[k].picture.finished()) return false;
    return !state_->context.player.moves() && !state_->context.gliding();
}

std::string Studio::controls() const { return controlsText(state_->context); }
bool Studio::setControl(const std::string& id, const std::string& value) {
    return versorium::setControl(state_->context, id, value);
}
void Studio::markView(int view) {
    const Workspace& workspace = state_->context.workspace;
    if (view >= 0 && view < static_cast<int>(workspace.views.size())) state_->context.mark(view);
}

int Studio::pictures() const {
    int count = 0;
    for (const ViewState& view : state_->context.views) count += view.picture.pictures();
    return count;
}

void Studio::tell(const Status& status) { state_->context.report(status); }
void Studio::stopAnimation() {
    state_->context.player.animation.running = false;
    state_->context.player.playing = false;
}

void Studio::contextLost() {
    state_->context.gpu.forget();
    for (ViewState& view : state_->context.views) view.picture.contextLost();
    state_->context.gallery.contextLost();
    state_->context.sheet.contextLost();
    state_->context.studies.contextLost();
    state_->context.drawing.contextLost();
    state_->context.space.contextLost();
}

}  // namespace versorium
