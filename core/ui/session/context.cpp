// SPDX-License-Identifier: MIT
#include "ui/session/context.h"

#include <algorithm>
#include <cmath>

#include "io/document.h"
#include "render/picture.h"
#include "ui/backend/texture.h"
#include "ui/session/open_file.h"
#include "ui/session/view_plane.h"

namespace versorium {
namespace {

constexpr double kPinchPause = 0.5;  // seconds

Workspace firstWorkspace() {
    Expected<Scene> scene = presetNamed("mandelbrot");
    Workspace workspace = workspaceOf(scene ? *scene : sceneOf(catalogue()[0]));
    setSharedNumber(workspace, "c.re", -0.7269);
    setSharedNumber(workspace, "c.im", 0.1889);
    setSharedNumber(workspace, "z.re", 0.35);
    setSharedNumber(workspace, "z.im", 0.2);
    return workspace;
}

// Older versions kept other words.
RendererChoice rendererCalled(const std::string& word) {
    if (word == "graphics") return RendererChoice::gpu;
    if (word == "processor") return RendererChoice::cpu;
    return fromWord<RendererChoice>(word).value_or(RendererChoice::automatic);
}

std::string documentText(const Scene& scene) {
    Document document;
    document.body = sceneBody(scene);
    addAssets(scene, document.assets);
    return printJson(documentToJson(document));
}

}  // namespace

StudioContext::StudioContext(Host& shell)
    : host(shell),
      edited(firstWorkspace(), shell),
      bound(edited, shell),
      notices(shell),
      player(*this) {
    renderer = rendererCalled(host.stored("renderer"));
    if (!setLanguage(host.stored("language"))) setLanguage(languageOf(host.preferredLanguage()));
    gallery.load(host);
    formulas.load(host);
}

void StudioContext::record() {
    edited.record();
    // The steps of a lesson are no scenes of the user's own.
    if (!lessons.now || lessons.now->wandering()) gallery.remember(host, workspace);
}

void StudioContext::undo() {
    if (!edited.undo()) return say("There is nothing to undo");
    for (ViewState& view : views) view.glide.reset();
}

void StudioContext::redo() {
    if (!edited.redo()) return say("There is nothing to redo");
    for (ViewState& view : views) view.glide.reset();
}

void StudioContext::open(Workspace opened) {
    leaveStep(*this);
    if (edited.unrecorded()) record();
    gallery.beginAnew();
    take(std::move(opened));
}

void StudioContext::openStage(Workspace stage) {
    if (edited.unrecorded()) record();
    take(std::move(stage));
    permit(*this);
}

void StudioContext::take(Workspace next) {
    edit([&](Workspace& now) { now = std::move(next); });
    player.stop();
    for (ViewState& view : views) view.history = {}, view.glide.reset();
    welcome = false;
}

void StudioContext::openMotion(versorium::Animation animation) {
    Workspace opened = workspaceOf(animation.scene);
    opened.motion = std::move(animation.motion);
    opened.motionView = opened.focused;
    opened.plot = PlotPanel::motion;
    open(std::move(opened));
}

void StudioContext::newMap(const std::string& name) {
    const MapKernels* map = findMap(name);
    if (!map) return;
    const int count = static_cast<int>(workspace.views.size());
    Scene scene = sceneOf(*map);
    Workspace next = workspaceOf(scene);
    if (count != 2) setViewCount(next, count);
    next.plot = workspace.plot;
    open(std::move(next));
}

void StudioContext::show(PlotPanel plot) {
    if (workspace.plot != plot) edit([&](Workspace& next) { next.plot = plot; });
}

void StudioContext::focus(int view) {
    if (workspace.focused == view) return;
    edited.focus(view);
    // Other numbers are shown.
    if (workspace.analysis() || mapOf(workspace.view()).info.field) edited.refresh();
}

void StudioContext::remember(int view) {
    ViewHistory& history = views[static_cast<std::size_t>(view)].history;
    const SliceSpec& place = workspace.views[static_cast<std::size_t>(view)].slice;
    if (!history.places.empty() && history.places[history.at] == place) return;
    if (!history.places.empty()) history.places.resize(history.at + 1);
    history.places.push_back(place);
    history.at = history.places.size() - 1;
}

void StudioContext::goInHistory(int view, int step) {
    remember(view);
    ViewHistory& history = views[static_cast<std::size_t>(view)].history;
    const auto target = static_cast<long long>(history.at) + step;
    if (target < 0 || target >= static_cast<long long>(history.places.size())) return;
    history.at = static_cast<std::size_t>(target);
    glideTo(view, history.places[history.at]);
}

void StudioContext::home(int view) {
    remember(view);
    glideTo(view, homeOf(workspace.views[static_cast<std::size_t>(view)]));
}

void StudioContext::zoom(int view, double factor, double u, double v, bool eased) {
    ViewState& state = views[static_cast<std::size_t>(view)];
    const Scene& scene = workspace.views[static_cast<std::size_t>(view)];
    const SliceSpec place = zoomed(state.glide ? state.glide->to : scene.slice, factor, u, v);
    const double size = std::max({1.0, std::abs(u), std::abs(v)});
    if (factor < 1 && place.height < 2e-13 * size)
        return say("This is as deep as double precision goes: zoom out with -, or Home");
    if (eased) return glideTo(view, place);
    moveTo(view, place);
}

void StudioContext::moveTo(int view, SliceSpec place) {
    const auto k = static_cast<std::size_t>(view);
    views[k].glide.reset();
    edit([&](Workspace& next) { next.views[k].slice = std::move(place); });
}

void StudioContext::glideTo(int view, SliceSpec place) {
    ViewState& state = views[static_cast<std::size_t>(view)];
    if (host.reducedMotion()) return moveTo(view, std::move(place));
    const SliceSpec& from = workspace.views[static_cast<std::size_t>(view)].slice;
    state.glide = Glide{from, std::move(place), host.now()};
    host.wake();
}

bool StudioContext::glide() {
    for (std::size_t k = 0; k < workspace.views.size(); ++k) {
        std::optional<Glide>& way = views[k].glide;
        if (!way) continue;
        const double part = (host.now() - way->begin) / kGlideSeconds;
        edit([&](Workspace& next) { next.views[k].slice = between(way->from, way->to, part); });
        if (part >= 1) way.reset();
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
        if (host.now() - state.pinchedAt > kPinchPause) remember(static_cast<int>(k));
        state.pinchedAt = host.now();
        state.drag = {.fingers = true};
        focus(static_cast<int>(k));
        const Scene& scene = workspace.views[k];
        const Size size{static_cast<int>(state.high.x - state.low.x),
                        static_cast<int>(state.high.y - state.low.y)};
        const ViewPlane before{state.low, state.high, viewportOf(scene, size)};
        moveTo(static_cast<int>(k), shifted(scene.slice, (from.x - to.x) / before.unit(),
                                            (to.y - from.y) / before.unit()));
        const ViewPlane plane{state.low, state.high, viewportOf(scene, size)};
        zoom(static_cast<int>(k), 1 / factor, plane.u(to.x), plane.v(to.y));
        return true;
    }
    return false;
}

void StudioContext::pan(int view, double widths, double heights) {
    const Scene& scene = workspace.views[static_cast<std::size_t>(view)];
    const ViewState& state = views[static_cast<std::size_t>(view)];
    const double tall = std::max(1.0f, state.high.y - state.low.y);
    const double wide = std::max(1.0f, state.high.x - state.low.x);
    const double height = shownHeight(scene, wide / tall);
    moveTo(view, shifted(scene.slice, widths * height * wide / tall, heights * height));
}

void StudioContext::chooseTheme(const std::string& name) {
    for (std::size_t k = 0; k < themes().size(); ++k)
        if (themes()[k].name == name) theme = k;
    host.store("theme", name);
    fontsChanged = true;
    host.wake();
}

void StudioContext::choose(RendererChoice choice) {
    renderer = choice;
    host.store("renderer", std::string(wordOf(choice)));
    host.wake();
}

void StudioContext::nextRenderer() {
    choose(static_cast<RendererChoice>((static_cast<std::size_t>(renderer) + 1) %
                                       EnumWords<RendererChoice>::table.size()));
    const char* said[] = {trLater("Drawn by whoever is faster"), trLater("Drawn by the GPU"),
                          trLater("Drawn by the CPU")};
    say(said[static_cast<std::size_t>(renderer)]);
}

GpuUse StudioContext::gpuUse() {
    if (renderer == RendererChoice::cpu) return {nullptr, trLater("chosen by you")};
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
    edited.refresh();
}

void StudioContext::stepOrbit(int steps) {
    edit([&](Workspace& next) {
        next.orbitAt = std::clamp(next.orbitAt + steps, 0, kMostOrbitSteps);
        next.orbitSteps = std::max(next.orbitSteps, next.orbitAt);
    });
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
    options.allViews = options.allViews && dialogs.exporting;
    options.plate = options.plate && dialogs.exporting;
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

void StudioContext::takeGrid(const WorkAnswer& answer) {
    if (bound.takeGrid(answer)) edited.refresh();
}

void StudioContext::takeExport() {
    std::optional<Expected<std::string>> outcome = host.takeExport();
    if (!outcome) return;
    if (*outcome) {
        const std::string where = trMessage(**outcome);
        say(copying ? tr("The picture is in {1}", {where}) : tr("Exported: {1}", {where}));
        dialogs.exporting = false;
    } else if (outcome->status().kind() == ErrorKind::cancelled) {
        say("The export was cancelled; nothing was written");
    } else {
        report(outcome->status());
    }
}

void StudioContext::chooseFile() {
    if (!host.chooseFile()) dialogs.files = true;
}

double StudioContext::aspect(int view) const {
    const ViewState& state = views[static_cast<std::size_t>(view)];
    const double tall = std::max(1.0f, state.high.y - state.low.y);
    return std::max(1.0f, state.high.x - state.low.x) / tall;
}

}  // namespace versorium
