// SPDX-License-Identifier: MIT
// What lies behind a view and how it moves, in the list of controls: layers, motion.
#include <algorithm>

#include "render/movie.h"
#include "ui/controls/control_list.h"
#include "ui/session/open_file.h"

namespace versorium {

void collectLayers(StudioContext& context, ControlList& all) {
    all.begin("Images behind and in front");
    StudioContext* c = &context;
    const Scene& scene = context.workspace.view();
    for (std::size_t k = 0; k < scene.layers.size(); ++k) {
        const std::string place = "layers[" + std::to_string(k) + "]";
        const std::string id = place + ".";
        all.group(place);
        const auto label = [&](const char* what) {
            return tr("image {1}: {2}", {std::to_string(k + 1), tr(what)});
        };
        all.command(id + "remove", label("take it away"), "", [c, k] {
            c->edit([k](Workspace& w) {
                auto& layers = w.view().layers;
                layers.erase(layers.begin() + static_cast<std::ptrdiff_t>(k));
                dropUnnamedAssets(w);
            });
        });
    }
    if (scene.layers.size() < kMostLayers)
        all.choice("layer", "add an image", "", {"leaf", "white sheet"},
                   [c](const std::string& wanted) {
                       c->edit([&](Workspace& w) { addBuiltInLayer(w.view(), wanted == "leaf"); });
                   });
    all.values({"images_are_layers"});
}

void collectMotion(StudioContext& context, ControlList& all) {
    all.begin("Motion");
    StudioContext* c = &context;
    const Player& player = context.player;
    const Motion& motion = context.workspace.motion;
    all.toggle("recording", "record what is moved", player.recording,
               [c](bool on) { c->player.record(on); });
    all.choice("animation", "play an animation of the program's own", "", animationNames(),
               [c](const std::string& name) {
                   Expected<Movie> movie = animationNamed(name);
                   if (!movie) return c->report(movie.status());
                   c->openMotion(std::move(movie->animation));
                   c->player.play(true);
               });
    all.number("motion time", "time in the motion, seconds", player.at, 0.1, 0, kMostSeconds,
               [c](double value) {
                   c->player.play(false);
                   c->player.showMotionAt(value);
               });
    all.command("set key", "Set a key frame here", "K", [c] { c->player.setKey(); });
    if (motion.keys.empty()) return;
    all.toggle("playing", "play the motion", player.playing, [c](bool on) { c->player.play(on); });
    all.values({"motion.again"});
    all.number("key", "chosen key frame", player.key + 1, 1, 0,
               static_cast<double>(motion.keys.size()), [c](double value) {
                   c->player.key = static_cast<int>(value) - 1;
                   if (c->player.key < 0) return;
                   c->player.play(false);
                   c->player.showMotionAt(
                       c->workspace.motion.keys[static_cast<std::size_t>(c->player.key)].time);
               });
    if (player.key >= 0 && player.key < static_cast<int>(motion.keys.size())) {
        const auto key = static_cast<std::size_t>(player.key);
        all.choice("easing", "from the chosen key frame on",
                   std::string(wordOf(motion.keys[key].easing)), wordsOf<Easing>(),
                   [c, key](const std::string& wanted) {
                       c->edit([&](Workspace& w) {
                           w.motion.keys[key].easing = *fromWord<Easing>(wanted);
                       });
                   });
        all.command("remove key", "Take the chosen key frame away", "",
                    [c] { c->player.removeKey(); });
    }
    all.number("frame rate", "pictures of a second", motion.framesPerSecond, 1, 1, 240,
               [c](double value) {
                   c->edit([value](Workspace& w) { w.motion.framesPerSecond = value; });
               });
    const auto begin = [c](bool film) {
        ExportOptions options = c->exporting;
        c->exporting.motion = true;
        c->exporting.plate = false;
        c->exporting.film = film;
        c->startExport();
        c->exporting = options;
    };
    all.command("export motion", "Export the motion's pictures in a ZIP", "",
                [begin] { begin(false); });
    if (context.host.makesFilms())
        all.command("export film", "Export the motion as a film (WebM)", "",
                    [begin] { begin(true); });
}

}  // namespace versorium
