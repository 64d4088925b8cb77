// SPDX-License-Identifier: MIT
// Commands for what moves: the animated number, and the motion with its key frames.
#include "ui/controls/command_families.h"
#include "ui/session/context.h"

namespace versorium {
namespace {

constexpr double kAnimationStep = 1.0 / 120;  // rounds

// False, and it is said, where no number was chosen yet.
bool hasNumber(StudioContext& context) {
    if (context.player.animation.number.empty())
        context.say("Choose a number first: the triangle beside it");
    return !context.player.animation.number.empty();
}

}  // namespace

void addMotionCommands(StudioContext& context, Commands& all) {
    StudioContext* c = &context;
    const auto add = [&](Command command) { all.push_back(std::move(command)); };
    const auto hasMotion = [c] { return !c->workspace.motion.keys.empty(); };
    add({"animation.play",
         trLater("Play or pause the animated number"),
         trLater("A number runs between its ends. The triangle beside a number chooses it."),
         {"Space"},
         [c] {
             if (hasNumber(*c)) c->player.animation.running = !c->player.animation.running;
             c->host.wake();
         }});
    add({"animation.step",
         trLater("One step of the animated number"),
         trLater("Stops the animation and takes it on by a small step."),
         {"Space", false, true},
         [c] {
             c->player.animation.running = false;
             if (hasNumber(*c)) c->player.advanceAnimation(kAnimationStep);
         }});
    add({"motion.record",
         trLater("Record a motion, or stop"),
         trLater("What you do with the focused view becomes key frames, until you stop."),
         {"R"},
         [c] { c->player.record(!c->player.recording); }});
    add({"motion.play",
         trLater("Play or pause the motion"),
         trLater("Shows the key frames and what lies between them."),
         {"R", false, true},
         [c] { c->player.play(!c->player.playing); }});
    add({"motion.key.set",
         trLater("Set a key frame"),
         trLater("What is shown now becomes the key frame at the player's time."),
         {"K"},
         [c] { c->player.setKey(); }});
    add({"motion.key.remove",
         trLater("Remove the chosen key frame"),
         trLater("The others stay where they are."),
         {},
         [c] { c->player.removeKey(); },
         [c] { return c->player.key >= 0; }});
    add({"motion.save",
         trLater("Save the motion as a file"),
         trLater("A file that versorium animate makes pictures or a film of."),
         {},
         [c] { c->player.saveMotion(); },
         hasMotion});
    add({"motion.clear",
         trLater("Remove the motion"),
         trLater("Takes all key frames away. Undo brings them back."),
         {},
         [c] {
             c->player.stop();
             c->edit([](Workspace& w) { w.motion = {}; });
         },
         hasMotion});
}

}  // namespace versorium
