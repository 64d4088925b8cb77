// SPDX-License-Identifier: MIT
#include "ui/session/player.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/document.h"
#include "ui/session/context.h"
#include "ui/widgets/shown_number.h"

namespace versorium {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

}  // namespace

void Player::animate(const std::string& name, double low, double high) {
    const double part =
        std::clamp((sharedNumber(context_.workspace, name) - low) / (high - low), 0.0, 1.0);
    animation.number = name;
    animation.low = low;
    animation.high = high;
    animation.phase = animation.toAndFro ? std::acos(1 - 2 * part) / kTurn : part;
    animation.running = true;
    context_.host.wake();
}

void Player::advanceAnimation(double rounds) {
    animation.phase += rounds;
    animation.phase -= std::floor(animation.phase);
    const double part =
        animation.toAndFro ? 0.5 - 0.5 * std::cos(kTurn * animation.phase) : animation.phase;
    context_.edit([&](Workspace& next) {
        setSharedNumber(next, animation.number,
                        animation.low + (animation.high - animation.low) * part);
    });
}

void Player::record(bool on) {
    if (on == recording) return;
    if (on) {
        play(false);
        context_.edit([](Workspace& next) {
            next.motionView = next.focused;
            next.plot = PlotPanel::motion;
        });
        recorder.begin(movingScene(context_.workspace), context_.host.now());
        since = context_.host.now();
        recording = true;
        at = 0;
        context_.say("Recording: move, zoom, turn the numbers. Press R again to stop");
        return;
    }
    recording = false;
    recorder.take(movingScene(context_.workspace), context_.host.now());
    std::optional<Motion> motion = recorder.finish();
    if (!motion) return context_.say("Nothing moved while it was recorded");
    motion->framesPerSecond = context_.workspace.motion.framesPerSecond;
    context_.edit([&](Workspace& next) { next.motion = std::move(*motion); });
    at = context_.workspace.motion.duration();
    key = -1;
    context_.say(tr("Recorded: {1} s in {2} key frames",
                    {shownNumber(context_.workspace.motion.duration(), 3),
                     std::to_string(context_.workspace.motion.keys.size())}));
}

void Player::play(bool on) {
    if (on && recording) record(false);
    if (on && context_.workspace.motion.keys.empty())
        return context_.say("There is no motion yet: press R to record one, or set key frames");
    if (on && at >= context_.workspace.motion.duration()) at = 0;
    if (on) animation.running = false;
    playing = on;
    context_.host.wake();
}

void Player::showMotionAt(double time) {
    at = std::clamp(time, 0.0, kMostSeconds);
    context_.edit([&](Workspace& next) { showMotion(next, at); });
}

void Player::setKey() {
    if (context_.workspace.motion.keys.size() >= kMostKeys)
        return context_.say("There are as many key frames as may be");
    context_.edit([&](Workspace& next) {
        Motion& motion = next.motion;
        if (motion.keys.empty()) next.motionView = next.focused;
        const Scene now = movingScene(next);
        std::map<std::string, double> values = valuesAt(motion, at);
        if (values.empty())
            for (const std::string& name : movingNames(now)) values[name] = 0;
        for (auto& [name, value] : values) value = movingValue(now, name).value_or(value);
        KeyFrame& frame = keyAt(motion, at);
        frame.values = std::move(values);
        key = static_cast<int>(&frame - motion.keys.data());
        next.plot = PlotPanel::motion;
    });
    context_.say(tr("Key frame {1} at {2} s", {std::to_string(key + 1), shownNumber(at, 3)}));
}

void Player::removeKey() {
    if (key < 0 || key >= static_cast<int>(context_.workspace.motion.keys.size())) return;
    context_.edit([&](Workspace& next) { next.motion.keys.erase(next.motion.keys.begin() + key); });
    key = -1;
}

void Player::saveMotion() {
    if (context_.workspace.motion.keys.empty())
        return context_.say("There is no motion to save yet");
    const std::string text = printJson(documentToJson(motionDocument(context_.workspace)));
    Expected<std::string> path =
        context_.host.saveFile(context_.workspace.view().map + "-motion.json",
                               {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
    if (!path) return context_.report(path.status());
    context_.say(
        tr("Saved: {1}. versorium animate makes pictures or a film of it", {trMessage(*path)}));
}

void Player::advance(double seconds) {
    if (animation.running) advanceAnimation(std::min(kLongestFrame, seconds) / animation.seconds);
    if (playing) {
        const double end = context_.workspace.motion.duration();
        double next = at + std::min(kLongestFrame, seconds);
        if (next >= end) {
            playing = again && end > 0;
            next = playing ? next - end : end;
        }
        showMotionAt(next);
    }
    if (recording) {
        const double now = context_.host.now();
        recorder.take(movingScene(context_.workspace), now);
        at = now - since;
        if (at >= kMostSeconds) record(false);
    }
}

void Player::stop() {
    animation.running = false;
    recording = playing = false;
    again = dragsKey = false;
    at = since = 0;
    recorder = {};
    key = -1;
}

}  // namespace versorium
