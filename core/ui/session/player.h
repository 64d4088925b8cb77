// SPDX-License-Identifier: MIT
#pragma once
// What moves by itself: a number that runs between two ends, and the workspace's motion
// (scene/animation.h) while it is recorded or played.

#include <string>

#include "scene/animation.h"

namespace versorium {

struct StudioContext;

class Player {
  public:
    explicit Player(StudioContext& context) : context_(context) {}

    // An animated number: it runs between its ends until it is stopped, eased to and fro, or
    // steadily from the low end to the high one and again from the low one.
    struct Animation {
        std::string number;
        double low = 0, high = 1;
        double seconds = 8;  // of a round
        double phase = 0;    // in rounds
        bool running = false;
        bool toAndFro = true;
    } animation;

    bool recording = false, playing = false;
    bool again = false;  // from the beginning once it has ended
    double at = 0;       // seconds from the motion's beginning
    int key = -1;        // the chosen key frame
    bool dragsKey = false;

    // Moves a number between two others, from where it is.
    void animate(const std::string& name, double low, double high);
    // Takes the animation on by a part of a round.
    void advanceAnimation(double rounds);

    // What the user does with the focused view becomes the motion, from now until it is stopped.
    void record(bool on);
    void play(bool on);
    // Shows the motion at a time.
    void showMotionAt(double time);
    // What is shown now becomes the key frame at the player's time: all that the motion moves, or,
    // where it moves nothing yet, everything.
    void setKey();
    void removeKey();
    void saveMotion();

    // Takes on whatever moves, by the time that has passed.
    void advance(double seconds);
    bool moves() const { return animation.running || playing || recording; }
    // Something else is open now.
    void stop();

  private:
    static constexpr double kLongestFrame = 0.1;  // seconds: after a pause nothing jumps
    StudioContext& context_;
    double since = 0;  // when the recording began
    Recorder recorder;
};

}  // namespace versorium
