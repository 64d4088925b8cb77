// SPDX-License-Identifier: MIT
#include "ui/session/context.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/document.h"
#include "io/grid_files.h"
#include "render/picture.h"
#include "ui/backend/texture.h"
#include "ui/session/open_file.h"
#include "ui/session/view_plane.h"

namespace versorium {
namespace {

constexpr double kPinchPause = 0.5;  // seconds
constexpr double kTurn = 2 * std::numbers::pi;

Workspace firstWorkspace() {
    Expected<Scene> scene = presetNamed("mandelbrot");
    Workspace workspace = workspaceOf(scene ? *scene : sceneOf(catalogue()[0]));
    setSharedNumber(workspace, "c.re", -0.7269);
    setSharedNumber(workspace, "c.im", 0.1889);
    setSharedNumber(workspace, "z.re", 0.35);
    setSharedNumber(workspace, "z.im", 0.2);
    return workspace;
}

std::string documentText(const Scene& scene) {
    Document document;
    document.body = sceneBody(scene);
    addAssets(scene, document.assets);
    return printJson(documentToJson(document));
}

}  // namespace

StudioContext::StudioContext(Host& shell)
    : host(shell), workspace(firstWorkspace()), history(workspace) {
    renderer = fromWord<RendererChoice>(host.stored("renderer")).value_or(renderer);
    if (!setLanguage(host.stored("language"))) setLanguage(languageOf(host.preferredLanguage()));
    gallery.load(host);
    formulas.load(host);
}

void StudioContext::animate(const std::string& name, double low, double high) {
    const double part = std::clamp((sharedNumber(workspace, name) - low) / (high - low), 0.0, 1.0);
    animation.number = name;
    animation.low = low;
    animation.high = high;
    animation.phase = animation.toAndFro ? std::acos(1 - 2 * part) / kTurn : part;
    animation.running = true;
    host.wake();
}

void StudioContext::advanceAnimation(double rounds) {
    animation.phase += rounds;
    animation.phase -= std::floor(animation.phase);
    const double part =
        animation.toAndFro ? 0.5 - 0.5 * std::cos(kTurn * animation.phase) : animation.phase;
    setSharedNumber(workspace, animation.number,
                    animation.low + (animation.high - animation.low) * part);
    touch();
}

void StudioContext::record(bool on) {
    if (on == player.recording) return;
    if (on) {
        play(false);
        workspace.motionView = workspace.focused;
        player.recorder.begin(movingScene(workspace), host.now());
        player.since = host.now();
        player.recording = true;
        player.at = 0;
        workspace.strip = Strip::motion;
        say("Recording: move, zoom, turn the numbers. Press R again to stop");
        return;
    }
    player.recording = false;
    player.recorder.take(movingScene(workspace), host.now());
    std::optional<Motion> motion = player.recorder.finish();
    if (!motion) return say("Nothing moved while it was recorded");
    motion->framesPerSecond = workspace.motion.framesPerSecond;
    workspace.motion = std::move(*motion);
    player.at = workspace.motion.duration();
    player.key = -1;
    touch();
    say(tr("Recorded: {1} s in {2} key frames", {shownNumber(workspace.motion.duration(), 3),
                                                 std::to_string(workspace.motion.keys.size())}));
}

void StudioContext::play(bool on) {
    if (on && player.recording) record(false);
    if (on && workspace.motion.keys.empty())
        return say("There is no motion yet: press R to record one, or set key frames");
    if (on && player.at >= workspace.motion.duration()) player.at = 0;
    if (on) animation.running = false;
    player.playing = on;
    host.wake();
}

void StudioContext::showMotionAt(double time) {
    player.at = std::clamp(time, 0.0, kMostSeconds);
    showMotion(workspace, player.at);
    touch();
}

void StudioContext::setKey() {
    Motion& motion = workspace.motion;
    if (motion.keys.empty()) workspace.motionView = workspace.focused;
    if (motion.keys.size() >= kMostKeys) return say("There are as many key frames as may be");
    const Scene now = movingScene(workspace);
    std::map<std::string, double> values = valuesAt(motion, player.at);
    if (values.empty())
        for (const std::string& name : movingNames(now)) values[name] = 0;
    for (auto& [name, value] : values) value = movingValue(now, name).value_or(value);
    KeyFrame& key = keyAt(motion, player.at);
    key.values = std::move(values);
    player.key = static_cast<int>(&key - motion.keys.data());
    workspace.strip = Strip::motion;
    touch();
    say(tr("Key frame {1} at {2} s", {std::to_string(player.key + 1), shownNumber(player.at, 3)}));
}

void StudioContext::removeKey() {
    auto& keys = workspace.motion.keys;
    if (player.key < 0 || player.key >= static_cast<int>(keys.size())) return;
    keys.erase(keys.begin() + player.key);
    player.key = -1;
    touch();
}

void StudioContext::saveMotion() {
    if (workspace.motion.keys.empty()) return say("There is no motion to save yet");
    const std::string text = printJson(documentToJson(motionDocument(workspace)));
    Expected<std::string> path =
        host.saveFile(workspace.view().map + "-motion.json",
                      {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
    if (!path) return report(path.status());
    say(tr("Saved: {1}. versorium animate makes pictures or a film of it", {trMessage(*path)}));
}

void StudioContext::touch() {
    ++revision;
    touched = true;
    touchedAt = host.now();
    host.wake();
}

void StudioContext::record() {
    history.record(workspace);
    // The steps of a lesson are no scenes of the user's own.
    if (!lessons.now || lessons.now->wandering()) gallery.remember(host, workspace);
    touched = false;
}

void StudioContext::say(const std::string& text) {
    notice = tr(std::string_view(text));
    noticeAt = host.now();
    host.announce(notice);
    host.wake();
    host.wakeAfter(kNoticeFor);
}

void StudioContext::report(const Status& status) {
    if (!status.ok()) say(trMessage(status.message()));
}

void StudioContext::undo() {
    if (touched) history.record(workspace);
    if (!history.canUndo()) return say("There is nothing to undo");
    workspace = history.undo();
    for (ViewState& view : views) view.glide.reset();
    ++revision;
    touched = false;
    host.wake();
}

void StudioContext::redo() {
    if (!history.canRedo()) return say("There is nothing to redo");
    workspace = history.redo();
    for (ViewState& view : views) view.glide.reset();
    ++revision;
    touched = false;
    host.wake();
}

void StudioContext::open(Workspace opened) {
    leaveStep(*this);
    if (touched) record();
    gallery.beginAnew();
    take(std::move(opened));
}

void StudioContext::openStage(Workspace stage) {
    if (touched) record();
    take(std::move(stage));
    permit(*this);
}

void StudioContext::take(Workspace next) {
    workspace = std::move(next);
    animation.running = false;
    player = {};
    for (ViewState& view : views) view.visits = {}, view.glide.reset();
    welcome = false;
    touch();
}

void StudioContext::openMotion(versorium::Animation animation) {
    Workspace opened = workspaceOf(animation.scene);
    opened.motion = std::move(animation.motion);
    opened.motionView = opened.focused;
    open(std::move(opened));
    workspace.strip = Strip::motion;
}

void StudioContext::newMap(const std::string& name) {
    const MapKernels* map = findMap(name);
    if (!map) return;
    const int count = static_cast<int>(workspace.views.size());
    Scene scene = sceneOf(*map);
    Workspace next = workspaceOf(scene);
    if (count != 2) setViewCount(next, count);
    next.strip = workspace.strip;
    open(std::move(next));
}

void StudioContext::show(Strip strip) {
    if (workspace.strip == strip) return;
    workspace.strip = strip;
    touch();
}

void StudioContext::mark(int view) {
    if (workspace.focused == view) return;
    workspace.focused = view;
    // Other numbers are shown.
    if (workspace.analysis() || mapOf(workspace.view()).info.field) ++revision;
}

void StudioContext::visit(int view) {
    Visits& visits = views[static_cast<std::size_t>(view)].visits;
    const SliceSpec& place = workspace.views[static_cast<std::size_t>(view)].slice;
    if (!visits.places.empty() && visits.places[visits.at] == place) return;
    if (!visits.places.empty()) visits.places.resize(visits.at + 1);
    visits.places.push_back(place);
    visits.at = visits.places.size() - 1;
}

void StudioContext::revisit(int view, int step) {
    visit(view);
    Visits& visits = views[static_cast<std::size_t>(view)].visits;
    const auto target = static_cast<long long>(visits.at) + step;
    if (target < 0 || target >= static_cast<long long>(visits.places.size())) return;
    visits.at = static_cast<std::size_t>(target);
    glideTo(view, visits.places[visits.at]);
}

void StudioContext::home(int view) {
    visit(view);
    glideTo(view, homeOf(workspace.views[static_cast<std::size_t>(view)]));
}

void StudioContext::zoom(int view, double factor, double u, double v, bool eased) {
    ViewState& state = views[static_cast<std::size_t>(view)];
    Scene& scene = workspace.views[static_cast<std::size_t>(view)];
    const SliceSpec place = zoomed(state.glide ? state.glide->to : scene.slice, factor, u, v);
    const double size = std::max({1.0, std::abs(u), std::abs(v)});
    if (factor < 1 && place.height < 2e-13 * size)
        return say("This is as deep as double precision goes: zoom out with -, or Home");
    if (eased) return glideTo(view, place);
    state.glide.reset();
    scene.slice = place;
    touch();
}

void StudioContext::glideTo(int view, SliceSpec place) {
    ViewState& state = views[static_cast<std::size_t>(view)];
    Scene& scene = workspace.views[static_cast<std::size_t>(view)];
    state.glide.reset();
    if (host.reducedMotion())
        scene.slice = std::move(place);
    else
        state.glide = Glide{scene.slice, std::move(place), host.now()};
    touch();
}

bool StudioContext::glide() {
    for (std::size_t k = 0; k < workspace.views.size(); ++k) {
        std::optional<Glide>& way = views[k].glide;
        if (!way) continue;
        const double part = (host.now() - way->begin) / kGlideSeconds;
        workspace.views[k].slice = between(way->from, way->to, part);
        if (part >= 1) way.reset();
        touch();
    }
    return gliding();
}

bool StudioContext::gliding() const {
    return std::any_of(views.begin(), views.end(),
                       [](const ViewState& view) { return view.glide.has_value(); });
}

bool StudioContext::pinch(ScreenPoint from, ScreenPoint to, double factor) {
    if (!(factor > 0) || !std::isfinite(factor) || dialogOpen()) return false;
    for (std::size_t k = 0; k < workspace.views.size(); ++k) {
        ViewState& state = views[k];
        const bool shown = !workspace.maximised || static_cast<int>(k) == workspace.focused;
        if (!shown || from.x < state.low.x || from.x >= state.high.x || from.y < state.low.y ||
            from.y >= state.high.y)
            continue;
        // One place to come back to for all that two fingers do without a pause.
        if (host.now() - state.pinchedAt > kPinchPause) visit(static_cast<int>(k));
        state.pinchedAt = host.now();
        state.drag = {.fingers = true};
        mark(static_cast<int>(k));
        Scene& scene = workspace.views[k];
        const Size size{static_cast<int>(state.high.x - state.low.x),
                        static_cast<int>(state.high.y - state.low.y)};
        const ViewPlane before{state.low, state.high, viewportOf(scene, size)};
        scene.slice.centre[0] -= (to.x - from.x) / before.unit();
        if (scene.slice.centre.size() > 1) scene.slice.centre[1] += (to.y - from.y) / before.unit();
        const ViewPlane plane{state.low, state.high, viewportOf(scene, size)};
        zoom(static_cast<int>(k), 1 / factor, plane.u(to.x), plane.v(to.y));
        touch();
        return true;
    }
    return false;
}

void StudioContext::pan(int view, double widths, double heights) {
    Scene& scene = workspace.views[static_cast<std::size_t>(view)];
    const ViewState& state = views[static_cast<std::size_t>(view)];
    const double tall = std::max(1.0f, state.high.y - state.low.y);
    const double wide = std::max(1.0f, state.high.x - state.low.x);
    views[static_cast<std::size_t>(view)].glide.reset();
    const double height = shownHeight(scene, wide / tall);
    scene.slice.centre[0] += widths * height * wide / tall;
    if (scene.slice.centre.size() > 1) scene.slice.centre[1] += heights * height;
    touch();
}

void StudioContext::choose(RendererChoice choice) {
    renderer = choice;
    host.store("renderer", std::string(wordOf(choice)));
    host.wake();
}

void StudioContext::nextRenderer() {
    choose(static_cast<RendererChoice>((static_cast<std::size_t>(renderer) + 1) %
                                       EnumWords<RendererChoice>::table.size()));
    const char* said[] = {trLater("Drawn by whoever is faster"),
                          trLater("Drawn by the graphics processor"),
                          trLater("Drawn by the processor")};
    say(said[static_cast<std::size_t>(renderer)]);
}

GpuUse StudioContext::gpuUse() {
    if (renderer == RendererChoice::processor) return {nullptr, trLater("chosen by you")};
    if (!drawsWithOpenGl()) return {nullptr, trLater("there is no OpenGL here")};
    if (const Status status = gpu.prepare(); !status.ok()) return {nullptr, status.message()};
    if (renderer == RendererChoice::automatic && gpu.limits().software)
        return {nullptr,
                tr("faster here than the graphics driver, which computes in software ({1})",
                   {gpu.limits().device})};
    return {&gpu, {}};
}

void StudioContext::speak(const std::string& id) {
    if (!setLanguage(id)) return;
    host.store("language", id);
    translateLesson(*this);
    // What was found is said anew.
    ++revision;
    host.wake();
}

void StudioContext::stepOrbit(int steps) {
    workspace.orbitAt = std::clamp(workspace.orbitAt + steps, 0, kMostOrbitSteps);
    workspace.orbitSteps = std::max(workspace.orbitSteps, workspace.orbitAt);
    touch();
}

void StudioContext::paste() { report(openText(*this, host.clipboard())); }

void StudioContext::copyLink() {
    Expected<std::string> link = workspaceToLink(workspace);
    if (!link) return report(link.status());
    const std::string address = host.publicAddress();
    if (address.empty())
        return say(
            "No public address is known that a link could begin with: set public_url in "
            "the settings, or save the scene (Ctrl S) and send its file");
    host.setClipboard(address + "#" + *link);
    say("The link is on the clipboard");
}

void StudioContext::saveScene() {
    const std::string text = documentText(workspace.view());
    Expected<std::string> path =
        host.saveFile(workspace.view().map + ".json",
                      {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
    if (!path) return report(path.status());
    say(tr("Saved: {1}", {trMessage(*path)}));
}

void StudioContext::startExport() { beginExport(exporting, false); }

void StudioContext::copyImage() {
    ExportOptions options = exporting;
    options.allViews = options.allViews && exportOpen;
    options.plate = options.plate && exportOpen;
    options.motion = false;
    beginExport(options, true);
}

void StudioContext::beginExport(const ExportOptions& options, bool toClipboard) {
    std::vector<double> aspects;
    for (std::size_t k = 0; k < workspace.views.size(); ++k)
        aspects.push_back(aspect(static_cast<int>(k)));
    ExportOptions spoken = options;
    spoken.language = languageNow().id;
    Expected<Document> document = exportDocument(workspace, aspects, spoken);
    if (!document) return report(document.status());
    copying = toClipboard;
    const bool film = options.film && host.makesFilms();
    const std::string what =
        options.plate && !options.builtIn.empty() ? options.builtIn : workspace.view().map;
    const std::string name = what + (options.motion  ? film ? ".webm" : ".zip"
                                     : options.plate ? "-plate.png"
                                                     : ".png");
    // Whoever makes it has the assets, or gets them as they are.
    Assets assets = std::move(document->assets);
    document->assets.clear();
    host.startExport({printJson(documentToJson(*document)), name, toClipboard, std::move(assets)});
    host.wake();
}

double StudioContext::aspect(int view) const {
    const ViewState& state = views[static_cast<std::size_t>(view)];
    const double tall = std::max(1.0f, state.high.y - state.low.y);
    return std::max(1.0f, state.high.x - state.low.x) / tall;
}

const OrbitProgram* StudioContext::bind(Bound& bound, const Scene& scene) {
    if (bound.revision != revision) {
        bound.revision = revision;
        bound.program.reset();
        if (std::optional<Scene> missing = binder_.missingGrid(scene)) {
            askForGrid(std::move(*missing));
        } else {
            Job job(1);
            Expected<OrbitProgram> program = binder_.bind(scene, job);
            if (program) bound.program = std::move(*program);
        }
    }
    return bound.program ? &*bound.program : nullptr;
}

void StudioContext::askForGrid(Scene scene) {
    const auto same = [&](const ShapeSpec& shape) {
        ShapeSpec other = scene.shape;
        other.outside = shape.outside;
        return other == shape;
    };
    if ((gridFor_ && same(gridFor_->shape)) || gridRefused_ == scene.shape.source) return;
    gridFor_ = std::move(scene);
    ++gridAsked_;
    host.requestWork(requestOf(gridAsked_, *gridFor_, GridJob{}));
}

void StudioContext::takeGrid(const WorkAnswer& answer) {
    if (answer.id != gridAsked_ || !gridFor_) return;
    Expected<Grid> grid = unpackGrid(std::get<GridResult>(answer.result).bytes);
    if (grid) {
        binder_.keep(*gridFor_, std::make_shared<const Grid>(std::move(*grid)));
        gridRefused_.clear();
    } else {
        gridRefused_ = gridFor_->shape.source;  // the pictures say why
    }
    gridFor_.reset();
    ++revision;
    host.wake();
}

const OrbitProgram* StudioContext::program(int view) {
    return bind(bound_[static_cast<std::size_t>(view)],
                workspace.views[static_cast<std::size_t>(view)]);
}

const OrbitProgram* StudioContext::orbitProgram() {
    return bind(bound_[kMostViews], orbitScene(workspace));
}

const std::vector<std::vector<double>>& StudioContext::orbit() {
    if (orbitRevision_ == revision) return orbit_;
    orbitRevision_ = revision;
    orbit_.clear();
    if (const OrbitProgram* bound = orbitProgram()) {
        const Scene scene = orbitScene(workspace);
        const double start[3] = {scene.slice.centre[0], scene.slice.centre[1], 0};
        orbit_ = orbitOf(*bound, start, workspace.orbitSteps);
    }
    return orbit_;
}

}  // namespace versorium
