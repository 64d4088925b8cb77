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
#include "ui/layout.h"
#include "ui/lesson/lesson_pane.h"
#include "ui/session/context.h"
#include "ui/session/open_file.h"

namespace versorium {
namespace {

constexpr double kQuiet = 0.4;          // seconds without a change before it is recorded
constexpr double kProgressEvery = 0.1;  // seconds

}  // namespace

struct Studio::State {
    explicit State(Host& host) : context(host) {}

    StudioContext context;
    double lastFrame = -1;
    double fragmentAt = 0;
    std::string fragmentText;
    bool fragmentOld = true;
    WindowLayout layout;
    void takeAnswers();
    std::string address() const;
    void settle();
    void animate();
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
    state.layout.draw(context, low, size);
    drawDialogs(context);
    ImGui::End();
    keepLocks(context);
    noteGoal(context);
    state.settle();
}

bool Studio::busy() const {
    const StudioContext& context = state_->context;
    for (std::size_t k = 0; k < context.workspace.views.size(); ++k)
        if (state_->layout.shows(context.workspace, k) && context.views[k].picture.working())
            return true;
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
        if (state_->layout.shows(workspace, k) && !state_->context.views[k].picture.finished())
            return false;
    return !state_->context.player.moves() && !state_->context.gliding();
}

std::string Studio::controls() const { return controlsText(state_->context); }
bool Studio::setControl(const std::string& id, const std::string& value) {
    return versorium::setControl(state_->context, id, value);
}
void Studio::focusView(int view) {
    const Workspace& workspace = state_->context.workspace;
    if (view >= 0 && view < static_cast<int>(workspace.views.size())) state_->context.focus(view);
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
