// SPDX-License-Identifier: MIT
#include "ui/session/contact_sheet.h"

#include <algorithm>
#include <limits>

#include "ui/backend/texture.h"
#include "ui/session/context.h"

namespace versorium {
namespace {

constexpr int kPictureHeight = 200;  // pixels
constexpr int kMostSteps = 2000;     // of a small picture, as of the gallery's

// The focused view, or one beside it that shows starting points.
const Scene& viewOf(const Workspace& workspace) {
    const int points = viewOfKind(workspace, ViewKind::startingPoints);
    return points < 0 ? workspace.view() : workspace.views[static_cast<std::size_t>(points)];
}

}  // namespace

void ContactSheet::forget() {
    for (Candidate& one : candidates) freeTexture(one.texture);
    candidates.clear();
    asked = -1;
}

void askForCandidate(StudioContext& context) {
    ContactSheet& sheet = context.sheet;
    if (sheet.asked >= 0) return;
    const auto missing =
        std::find_if(sheet.candidates.begin(), sheet.candidates.end(),
                     [](const auto& one) { return one.rgba.empty() && one.message.empty(); });
    if (missing == sheet.candidates.end()) return;
    context.gallery.letGo();
    Scene scene = viewOf(context.workspace);
    scene.lists[drawnList(context.workspace)] = missing->roots;
    scene.iterations = std::min(scene.iterations, kMostSteps);
    // What the small picture shows is a rectangle of 4 to 3.
    const ThumbnailJob job{.size = {kPictureHeight * 4 / 3, kPictureHeight}};
    sheet.asked = static_cast<int>(missing - sheet.candidates.begin());
    context.host.requestWork(requestOf(++sheet.id, scene, job));
}

void ContactSheet::contextLost() {
    for (Candidate& one : candidates) one.texture = 0;
}

void openContactSheet(StudioContext& context, int seed) {
    if (!hasRoots(context.workspace))
        return context.say("This map has no roots that could be drawn");
    const Expected<RandomRoots> options = drawOptions(context);
    if (!options) return context.report(options.status());
    ContactSheet& sheet = context.sheet;
    sheet.forget();
    sheet.count = std::clamp(sheet.count, ContactSheet::kLeast, ContactSheet::kMost);
    for (int k = 0; k < sheet.count; ++k) {
        ContactSheet::Candidate one;
        one.seed = seed > std::numeric_limits<int>::max() - k ? k : seed + k;
        one.roots = randomRoots(*options, static_cast<std::uint64_t>(one.seed));
        sheet.candidates.push_back(std::move(one));
    }
    sheet.at = std::min(sheet.at, sheet.count - 1);
    context.dialogs.candidates = true;
    context.host.wake();
}

bool takeCandidate(StudioContext& context, WorkAnswer& answer) {
    ContactSheet& sheet = context.sheet;
    if (sheet.asked < 0 || answer.id != sheet.id) return false;
    ContactSheet::Candidate& one = sheet.candidates[static_cast<std::size_t>(sheet.asked)];
    sheet.asked = -1;
    one.message = std::move(answer.message);
    if (!one.message.empty()) return true;
    ThumbnailResult& made = std::get<ThumbnailResult>(answer.result);
    one.rgba = std::move(made.rgba);
    one.size = made.size;
    return true;
}

void pickCandidate(StudioContext& context, int candidate) {
    ContactSheet& sheet = context.sheet;
    if (candidate < 0 || candidate >= static_cast<int>(sheet.candidates.size())) return;
    const ContactSheet::Candidate& one = sheet.candidates[static_cast<std::size_t>(candidate)];
    const Status status =
        context.edit([&](Workspace& w) { return setRootList(w, drawnList(w), one.roots); });
    if (!status.ok()) return context.report(status);
    context.versor.draw.seed = one.seed;
    context.versor.chosen = {};
    context.say(tr("The versor of seed {1}: {2} roots",
                   {std::to_string(one.seed), std::to_string(one.roots.roots.size())}));
}

}  // namespace versorium
