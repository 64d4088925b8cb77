// SPDX-License-Identifier: MIT
#include "scene/animation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "math/elementary.h"
#include "scene/numbers.h"
#include "scene/properties.h"

namespace versorium {
namespace {

constexpr const char* kHeight = "slice.height";
// Recordings at 60 frames a second for an hour.
constexpr std::size_t kMostRecorded = 60 * 3600;

// What may move under this name. Roots move, though nothing records them by itself.
std::optional<SceneProperty> movingProperty(const Scene& scene, const std::string& name) {
    std::optional<SceneProperty> found = propertyNamed(scene, name);
    if (!found || found->path != name) return std::nullopt;
    return found->moves || numberNamed(scene, name) ? std::move(found) : std::nullopt;
}

double between(const std::string& name, double from, double to, double part) {
    if (name == kHeight && from > 0 && to > 0)
        return from == to ? from : exp(log(from) + (log(to) - log(from)) * part);
    return from + (to - from) * part;
}

double eased(Easing easing, double part) {
    if (easing == Easing::hold) return part < 1 ? 0 : 1;
    return easing == Easing::smooth ? part * part * (3 - 2 * part) : part;
}

// Which of the samples are needed so that straight lines between them stay within `most` of all:
// the farthest one between two that are kept is kept as well.
std::vector<std::size_t> needed(const std::vector<double>& times, const std::vector<double>& values,
                                double most) {
    std::vector<char> kept(values.size(), 0);
    kept.front() = kept.back() = 1;
    std::vector<std::pair<std::size_t, std::size_t>> spans{{0, values.size() - 1}};
    while (!spans.empty()) {
        const auto [first, last] = spans.back();
        spans.pop_back();
        double farthest = most;
        std::size_t at = 0;
        for (std::size_t i = first + 1; i < last; ++i) {
            const double part = (times[i] - times[first]) / (times[last] - times[first]);
            const double gap =
                std::abs(values[i] - (values[first] + (values[last] - values[first]) * part));
            if (gap > farthest) farthest = gap, at = i;
        }
        if (at == 0) continue;
        kept[at] = 1;
        spans.emplace_back(first, at);
        spans.emplace_back(at, last);
    }
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < kept.size(); ++i)
        if (kept[i]) result.push_back(i);
    return result;
}

Expected<KeyFrame> keyFromJson(const Json& json, const std::string& path, const Scene& scene) {
    KeyFrame key;
    ObjectReader reader(json, path);
    reader.number("time", key.time, 0, kMostSeconds).word("easing", key.easing);
    const Json* values = reader.child("values");
    if (!values || !values->is_object()) {
        reader.fail("values", "an object such as {\"c.re\": -0.7} is expected");
    } else {
        for (auto item = values->begin(); item != values->end(); ++item) {
            const std::string where = path + ".values." + item.key();
            if (!movingValue(scene, item.key()))
                reader.fail(Status::data(where + ": nothing of this name can move; there are " +
                                         numberNames(scene) +
                                         ", slice.center[0], slice.height, iterations, iso"));
            else if (!item->is_number() || !std::isfinite(item->get<double>()))
                reader.fail(Status::data(where + ": must be a finite number"));
            else
                key.values[item.key()] = item->get<double>();
        }
    }
    if (Status status = reader.finish(); !status.ok()) return status;
    return key;
}

}  // namespace

int Motion::frames() const {
    return 1 + static_cast<int>(std::floor(duration() * framesPerSecond + 1e-9));
}

std::optional<double> movingValue(const Scene& scene, const std::string& name) {
    const std::optional<SceneProperty> property = movingProperty(scene, name);
    if (!property) return std::nullopt;
    return property->get(scene).get<double>();
}

bool setMovingValue(Scene& scene, const std::string& name, double value) {
    const std::optional<SceneProperty> property = movingProperty(scene, name);
    if (!property) return false;
    if (!std::isfinite(value)) return true;
    if (property->kind == ValueKind::whole && !numberNamed(scene, name)) value = std::round(value);
    value = std::clamp(value, property->low, property->high);
    const Status status = property->set(scene, value, name);
    assert(status.ok());
    return status.ok();
}

std::vector<std::string> movingNames(const Scene& scene) {
    std::vector<std::string> names;
    for (const SceneProperty& property : propertiesOf(scene))
        if (property.moves) names.push_back(property.path);
    return names;
}

std::map<std::string, double> valuesAt(const Motion& motion, double time) {
    struct Span {
        const KeyFrame *before = nullptr, *after = nullptr;
    };
    std::map<std::string, Span> spans;
    for (const KeyFrame& key : motion.keys)
        for (const auto& [name, value] : key.values) {
            Span& span = spans[name];
            if (key.time <= time)
                span.before = &key;
            else if (!span.after)
                span.after = &key;
        }
    std::map<std::string, double> values;
    for (const auto& [name, span] : spans) {
        const KeyFrame& from = span.before ? *span.before : *span.after;
        double value = from.values.at(name);
        if (span.before && span.after)
            value =
                between(name, value, span.after->values.at(name),
                        eased(from.easing, (time - from.time) / (span.after->time - from.time)));
        values[name] = value;
    }
    return values;
}

Scene sceneAt(const Animation& animation, double time) {
    Scene scene = animation.scene;
    for (const auto& [name, value] : valuesAt(animation.motion, time))
        setMovingValue(scene, name, value);
    return scene;
}

Scene frameOf(const Animation& animation, int frame) {
    return sceneAt(animation, frame / animation.motion.framesPerSecond);
}

KeyFrame& keyAt(Motion& motion, double time) {
    const auto place = std::find_if(motion.keys.begin(), motion.keys.end(),
                                    [&](const KeyFrame& key) { return key.time >= time; });
    if (place != motion.keys.end() && place->time == time) return *place;
    return *motion.keys.insert(place, KeyFrame{time, Easing::linear, {}});
}

Status readMotion(ObjectReader& reader, const Scene& scene, Motion& motion) {
    reader.number("frames_per_second", motion.framesPerSecond, 1, 240);
    const Json* keys = reader.child("keys");
    const std::string whole = reader.pathOf("keys");
    if (!keys || !keys->is_array() || keys->empty() || keys->size() > kMostKeys)
        return Status::data(whole + ": a list of 1 to " + std::to_string(kMostKeys) +
                            " key frames is expected");
    for (std::size_t k = 0; k < keys->size(); ++k) {
        const std::string path = whole + "[" + std::to_string(k) + "]";
        Expected<KeyFrame> key = keyFromJson((*keys)[k], path, scene);
        if (!key) return key.status();
        if (k > 0 && !(key->time > motion.keys.back().time))
            return Status::data(path + ".time: must be later than the key frame before");
        motion.keys.push_back(std::move(*key));
    }
    return {};
}

void motionToJson(const Motion& motion, Json& json) {
    json["frames_per_second"] = motion.framesPerSecond;
    json["keys"] = Json::array();
    for (const KeyFrame& key : motion.keys) {
        Json values = Json::object();
        for (const auto& [name, value] : key.values) values[name] = value;
        json["keys"].push_back(
            Json{{"time", key.time}, {"easing", wordOf(key.easing)}, {"values", values}});
    }
}

Expected<Animation> animationFromJson(const Json& json) {
    Animation animation;
    ObjectReader reader(json, "");
    int version = Scene::kVersion;
    reader.integer("versorium", version, 1, std::numeric_limits<int>::max());
    if (!reader.failed() && version > Scene::kVersion)
        return Status::data("versorium: version " + std::to_string(version) +
                            " is newer than this program; update it");
    const Json* scene = reader.child("scene");
    if (!scene) return Status::data("scene: is missing");
    Expected<Scene> read = sceneFromJson(*scene);
    if (!read) return read.status().in("scene");
    animation.scene = std::move(*read);
    if (Status status = readMotion(reader, animation.scene, animation.motion); !status.ok())
        return status;
    if (Status status = reader.finish(); !status.ok()) return status;
    return animation;
}

Json animationToJson(const Animation& animation) {
    Json json{{"versorium", Scene::kVersion}, {"scene", sceneToJson(animation.scene)}};
    motionToJson(animation.motion, json);
    return json;
}

void Recorder::begin(const Scene& scene, double now) {
    start_ = now;
    names_ = movingNames(scene);
    samples_.clear();
    take(scene, now);
}

void Recorder::take(const Scene& scene, double now) {
    const double time = now - start_;
    if (samples_.size() >= kMostRecorded || time > kMostSeconds ||
        (!samples_.empty() && !(time > samples_.back().time)))
        return;
    Sample sample{time, {}};
    for (std::size_t k = 0; k < names_.size(); ++k) {
        const auto value = movingValue(scene, names_[k]);
        sample.values.push_back(value ? *value : samples_.empty() ? 0 : samples_.back().values[k]);
    }
    samples_.push_back(std::move(sample));
}

std::optional<Motion> Recorder::finish(double tolerance) const {
    if (samples_.size() < 2) return std::nullopt;
    std::vector<double> times;
    for (const Sample& sample : samples_) times.push_back(sample.time);
    std::map<double, KeyFrame> keys;
    for (std::size_t k = 0; k < names_.size(); ++k) {
        std::vector<double> values;
        for (const Sample& sample : samples_) values.push_back(sample.values[k]);
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        if (*low == *high) continue;
        std::vector<double> measured = values;
        if (names_[k] == kHeight)
            for (double& value : measured) value = log(value);
        const auto [least, most] = std::minmax_element(measured.begin(), measured.end());
        for (std::size_t at : needed(times, measured, tolerance * (*most - *least))) {
            keys[times[at]].time = times[at];
            keys[times[at]].values[names_[k]] = values[at];
        }
    }
    if (keys.empty()) return std::nullopt;
    Motion motion;
    for (auto& [time, key] : keys) motion.keys.push_back(std::move(key));
    return motion;
}

}  // namespace versorium
