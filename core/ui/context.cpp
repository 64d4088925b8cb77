// SPDX-License-Identifier: MIT
#include "ui/context.h"

#include <algorithm>
#include <cmath>

#include "io/document.h"
#include "render/picture.h"
#include "ui/texture.h"

namespace versorium {
namespace {

constexpr std::array<const char*, 3> kRendererWords = {"automatic", "graphics", "processor"};
constexpr double kLeastHeight = 1e-13, kMostHeight = 1e6;

Workspace firstWorkspace() {
    Expected<Scene> scene = presetNamed("mandelbrot");
    Workspace workspace = workspaceOf(scene ? *scene : sceneOf(catalogue()[0]));
    setSharedNumber(workspace, "c.re", -0.7269);
    setSharedNumber(workspace, "c.im", 0.1889);
    setSharedNumber(workspace, "z.re", 0.35);
    setSharedNumber(workspace, "z.im", 0.2);
    return workspace;
}

bool isQuick(const Scene& scene) {
    if (!mapOf(scene).info.field) return true;
    const std::vector<std::string> meshes = builtinMeshes();
    return scene.shape.source.rfind("asset:", 0) != 0 &&
           std::find(meshes.begin(), meshes.end(), scene.shape.source) == meshes.end();
}

std::string documentText(const Scene& scene, Size size) {
    Document document;
    document.body = withoutAssets(sceneToJson(scene), document.assets);
    if (size.width > 0)
        document.render =
            Json{{"width", size.width}, {"height", size.height}, {"flavour", "exact"}};
    return printJson(documentToJson(document));
}

}  // namespace

StudioContext::StudioContext(Host& shell)
    : host(shell), workspace(firstWorkspace()), history(workspace) {
    const std::string stored = host.stored("renderer");
    for (std::size_t k = 0; k < kRendererWords.size(); ++k)
        if (stored == kRendererWords[k]) renderer = static_cast<RendererChoice>(k);
}

void StudioContext::touch() {
    ++revision;
    touched = true;
    touchedAt = host.now();
    host.wake();
}

void StudioContext::say(std::string text) {
    notice = std::move(text);
    noticeAt = host.now();
    host.announce(notice);
    host.wake();
}

void StudioContext::report(const Status& status) {
    if (!status.ok()) say(status.message());
}

void StudioContext::undo() {
    if (touched) history.record(workspace);
    if (!history.canUndo()) return say("There is nothing to undo");
    workspace = history.undo();
    ++revision;
    touched = false;
    host.wake();
}

void StudioContext::redo() {
    if (!history.canRedo()) return say("There is nothing to redo");
    workspace = history.redo();
    ++revision;
    touched = false;
    host.wake();
}

void StudioContext::open(Workspace opened) {
    if (touched) history.record(workspace);
    workspace = std::move(opened);
    animation.running = false;
    for (ViewState& view : views) view.visits = {};
    welcome = false;
    touch();
}

void StudioContext::newMap(const std::string& name) {
    const MapKernels* map = findMap(name);
    if (!map) return;
    const int count = static_cast<int>(workspace.views.size());
    Scene scene = sceneOf(*map);
    Workspace next = workspaceOf(scene);
    if (count != 2) setViewCount(next, count);
    open(std::move(next));
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
    workspace.views[static_cast<std::size_t>(view)].slice = visits.places[visits.at];
    touch();
}

void StudioContext::home(int view) {
    visit(view);
    Scene& scene = workspace.views[static_cast<std::size_t>(view)];
    const Scene there = showsParameters(scene) ? parameterView(scene) : dynamicalView(scene);
    if (there.slice.axes == scene.slice.axes) {
        scene.slice.centre = there.slice.centre;
        scene.slice.height = there.slice.height;
    } else {
        std::fill(scene.slice.centre.begin(), scene.slice.centre.end(), 0.0);
        scene.slice.height = 4;
    }
    std::fill(scene.slice.centreLow.begin(), scene.slice.centreLow.end(), 0.0);
    touch();
}

void StudioContext::zoom(int view, double factor, double u, double v) {
    Scene& scene = workspace.views[static_cast<std::size_t>(view)];
    const double height = std::clamp(scene.slice.height * factor, kLeastHeight, kMostHeight);
    const double size = std::max({1.0, std::abs(u), std::abs(v)});
    if (factor < 1 && height < 2e-13 * size)
        return say("This is as deep as double precision goes: zoom out with -, or Home");
    const double real = height / scene.slice.height;
    const double at[2] = {u, v};
    for (std::size_t k = 0; k < 2 && k < scene.slice.centre.size(); ++k)
        scene.slice.centre[k] = at[k] + (scene.slice.centre[k] - at[k]) * real;
    scene.slice.height = height;
    touch();
}

void StudioContext::pan(int view, double widths, double heights) {
    Scene& scene = workspace.views[static_cast<std::size_t>(view)];
    const ViewState& state = views[static_cast<std::size_t>(view)];
    const double tall = std::max(1.0f, state.high.y - state.low.y);
    const double wide = std::max(1.0f, state.high.x - state.low.x);
    const double height = shownHeight(scene, wide / tall);
    scene.slice.centre[0] += widths * height * wide / tall;
    if (scene.slice.centre.size() > 1) scene.slice.centre[1] += heights * height;
    touch();
}

void StudioContext::choose(RendererChoice choice) {
    renderer = choice;
    host.store("renderer", kRendererWords[static_cast<std::size_t>(choice)]);
    host.wake();
}

void StudioContext::nextRenderer() {
    choose(static_cast<RendererChoice>((static_cast<std::size_t>(renderer) + 1) %
                                       kRendererWords.size()));
    const char* said[] = {"Drawn by whoever is faster", "Drawn by the graphics processor",
                          "Drawn by the processor"};
    say(said[static_cast<std::size_t>(renderer)]);
}

GpuUse StudioContext::gpuUse() {
    if (renderer == RendererChoice::processor) return {nullptr, "chosen by you"};
    if (!drawsWithOpenGl()) return {nullptr, "there is no OpenGL here"};
    if (const Status status = gpu.prepare(); !status.ok()) return {nullptr, status.message()};
    if (renderer == RendererChoice::automatic && gpu.limits().software)
        return {nullptr, "faster here than the graphics driver, which computes in software (" +
                             gpu.limits().device + ")"};
    return {&gpu, {}};
}

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
    const std::string text = documentText(workspace.view(), {0, 0});
    Expected<std::string> path =
        host.saveFile(workspace.view().map + ".json",
                      {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
    if (!path) return report(path.status());
    say("Saved: " + *path);
}

void StudioContext::startExport() {
    const ViewState& state = views[static_cast<std::size_t>(workspace.focused)];
    const double tall = std::max(1.0f, state.high.y - state.low.y);
    const double wide = std::max(1.0f, state.high.x - state.low.x);
    const Size size{exportWidth,
                    std::max(1, static_cast<int>(std::lround(exportWidth * tall / wide)))};
    Scene scene = workspace.view();
    scene.aspect = wide / tall;
    scene.slice.height = shownHeight(scene, scene.aspect);
    if (Status status = checkSize(scene, size); !status.ok()) return report(status);
    host.startExport({documentText(scene, size), scene.map + ".png"});
}

const OrbitProgram* StudioContext::bind(Bound& bound, const Scene& scene) {
    if (bound.revision != revision) {
        bound.revision = revision;
        bound.program.reset();
        if (isQuick(scene)) {
            Job job(1);
            Expected<OrbitProgram> program = binder_.bind(scene, job);
            if (program) bound.program = std::move(*program);
        }
    }
    return bound.program ? &*bound.program : nullptr;
}

const OrbitProgram* StudioContext::program(int view) {
    return bind(bound_[static_cast<std::size_t>(view)],
                workspace.views[static_cast<std::size_t>(view)]);
}

const OrbitProgram* StudioContext::orbitProgram() {
    return bind(bound_[kMostViews], orbitScene(workspace));
}

}  // namespace versorium
