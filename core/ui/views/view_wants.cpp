// SPDX-License-Identifier: MIT
#include "ui/views/view_wants.h"

#include "scene/parts.h"

namespace versorium {
namespace {

// A picture that waits, to be no flash too many, is tried again after this.
constexpr double kHeldSeconds = 0.1;

// The scene without what changes no orbit and no count of members.
std::string orbitsText(Json json) {
    json.erase("colour");
    const auto ensemble = json.find("ensemble");
    if (ensemble != json.end()) ensemble->erase("count");
    if (ensemble == json.end() || (*ensemble)["set"] != "solid") json.erase("iso");
    return json.dump();
}

// Printed only where something has changed, and without assets.
void renew(WantedPicture& wanted, const StudioContext& context, int view, double aspect) {
    if (wanted.revision == context.revision() && !wanted.key.empty() && wanted.aspect == aspect)
        return;
    wanted.revision = context.revision();
    wanted.aspect = aspect;
    wanted.scene = pictureScene(context.workspace.views[static_cast<std::size_t>(view)], aspect);
    Json json = sceneKey(wanted.scene);
    wanted.key = json.dump();
    wanted.orbits = orbitsText(std::move(json));
}

}  // namespace

void wantPicture(StudioContext& context, int view, const Viewport& place, double seconds) {
    ViewState& state = context.views[static_cast<std::size_t>(view)];
    WantedPicture& wanted = state.wanted;
    renew(wanted, context, view, static_cast<double>(place.size.width) / place.size.height);
    state.picture.want(context.host, context.gpuUse(), view,
                       {wanted.scene, wanted.key, wanted.orbits, context.bound.program(view), place,
                        context.player.moves() || context.gliding()});
    state.picture.work(context.host, seconds);
    if (state.picture.held()) context.host.wakeAfter(kHeldSeconds);
}

}  // namespace versorium
