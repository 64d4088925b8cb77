// SPDX-License-Identifier: MIT
#pragma once
// A recorded or written motion (A section 5.2): key frames give some of a scene's numbers at some
// times; between the key frames that name it, a number is interpolated.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace versorium {

// How a number goes on from a key frame to its next one.
enum class Easing { linear, smooth, hold };

template <>
struct EnumWords<Easing> {
    static constexpr std::array<std::string_view, 3> table{"linear", "smooth", "hold"};
};

struct KeyFrame {
    double time = 0;  // seconds from the beginning, at least 0
    Easing easing = Easing::linear;
    std::map<std::string, double> values;
    friend bool operator==(const KeyFrame&, const KeyFrame&) = default;
};

struct Motion {
    double framesPerSecond = 30;
    std::vector<KeyFrame> keys;  // times rise strictly

    double duration() const { return keys.empty() ? 0 : keys.back().time; }
    // Its pictures are at times 0, 1/fps, 2/fps … duration; at least one.
    int frames() const;
    friend bool operator==(const Motion&, const Motion&) = default;
};

struct Animation {
    Scene scene;  // what no key frame names
    Motion motion;
};

inline constexpr std::size_t kMostKeys = 20000;
inline constexpr double kMostSeconds = 3600;

// What can move: the numbers of scene/numbers.h, "slice.center[0]", "slice.height", "iterations",
// "iso" and "layers[0].x" with y, scale, opacity and frame. Nothing for other names.
std::optional<double> movingValue(const Scene& scene, const std::string& name);
// Values are brought into the range that a scene allows. False where the name means nothing.
bool setMovingValue(Scene& scene, const std::string& name, double value);
// Everything that can move in this scene; list components are left out.
std::vector<std::string> movingNames(const Scene& scene);

// Before a number's first key frame it has the value of that one, after the last one of the last.
// Heights go by equal ratios and the centre with them (scene/zoom_path.h), so that zooms look
// steady and keep their target in sight.
std::map<std::string, double> valuesAt(const Motion& motion, double time);
Scene sceneAt(const Animation& animation, double time);
Scene frameOf(const Animation& animation, int frame);

// The key frame at this time, made where there is none.
KeyFrame& keyAt(Motion& motion, double time);

// Strict: ErrorKind::data with the path of the fault. Key frames name what can move in `scene`.
Status readMotion(ObjectReader& reader, const Scene& scene, Motion& motion);
void motionToJson(const Motion& motion, Json& json);
Expected<Animation> animationFromJson(const Json& json);
Json animationToJson(const Animation& animation);

// Takes down what a user does, at any moments, and makes key frames of it: as few as reproduce
// every number within `tolerance` of the range that it went through, and the view within that share
// of its height.
class Recorder {
  public:
    void begin(const Scene& scene, double now);
    void take(const Scene& scene, double now);  // the same map, with as many layers
    // Nothing where nothing moved.
    std::optional<Motion> finish(double tolerance = 0.004) const;
    double seconds() const { return samples_.empty() ? 0 : samples_.back().time; }

  private:
    double start_ = 0;
    std::vector<std::string> names_;
    struct Sample {
        double time;
        std::vector<double> values;
    };
    std::vector<Sample> samples_;
};

}  // namespace versorium
