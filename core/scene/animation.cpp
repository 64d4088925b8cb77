// SPDX-License-Identifier: MIT
#include "scene/animation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "math/elementary.h"
#include "scene/numbers.h"
#include "scene/properties.h"
#include "scene/zoom_path.h"

namespace versorium {
namespace {

constexpr const char* kHeight = "slice.height";
constexpr const char* kCentre = "slice.center[";
// Recordings at 60 frames a second for an hour.
constexpr std::size_t kMostRecorded = 60 * 3600;

// What may move under this name. Roots move, though nothing records them by itself.
std::optional<SceneProperty> movingProperty(const Scene& scene, const std::string& name) {
    std::optional<SceneProperty> found = propertyNamed(scene, name);
    if (!found || found->path != name) return std::nullopt;
    return found->moves || numberNamed(scene, name) ? std::move(found) : std::nullopt;
}

bool isCentre(const std::string& name) { return name.starts_with(kCentre); }

double eased(Easing easing, double part) {
    if (easing == Easing::hold) return part < 1 ? 0 : 1;
    return easing == Easing::smooth ? part * part * (3 - 2 * part) : part;
}

// Which of the samples are needed so that what is interpolated between them stays within `most` of
// all: the farthest one between two that are kept is kept as well. gap(first, last, i) says how far
// sample i is from it.
template <class Gap>
std::vector<std::size_t> needed(std::size_t count, double most, Gap gap) {
    std::vector<char> kept(count, 0);
    kept.front() = kept.back() = 1;
    std::vector<std::pair<std::size_t, std::size_t>> spans{{0, count - 1}};
    while (!spans.empty()) {
        const auto [first, last] = spans.back();
        spans.pop_back();
        double farthest = most;
        std::size_t at = 0;
        for (std::size_t i = first + 1; i < last; ++i)
            if (const double own = gap(first, last, i); own > farthest) farthest = own, at = i;
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

namespace {

// The key frames of a number around a time.
struct Span {
    const KeyFrame *before = nullptr, *after = nullptr;

    bool moves() const { return before && after; }
    double first(const std::string& name) const {
        return (before ? before : after)->values.at(name);
    }
    double part(double time) const {
        return eased(before->easing, (time - before->time) / (after->time - before->time));
    }
};

Span spanOf(const Motion& motion, const std::string& name, double time) {
    Span span;
    for (const KeyFrame& key : motion.keys) {
        if (!key.values.contains(name)) continue;
        if (key.time <= time)
            span.before = &key;
        else if (!span.after)
            span.after = &key;
    }
    return span;
}

double heightAt(const Motion& motion, double time) {
    const Span span = spanOf(motion, kHeight, time);
    if (!span.moves()) return span.first(kHeight);
    return heightOnTheWay(span.first(kHeight), span.after->values.at(kHeight), span.part(time));
}

// How much of its way the centre has gone between two key frames of its own, where those of the
// height are others: it moves by the same share of the height at all times, as between common ones.
double partByHeights(const Motion& motion, const Span& span, double time) {
    constexpr int kPieces = 512;
    double done = 0, whole = 0;
    const double length = span.after->time - span.before->time;
    for (int k = 0; k < kPieces; ++k) {
        const double middle = (k + 0.5) / kPieces;
        const double part = std::clamp((time - span.before->time) / length * kPieces - k, 0.0, 1.0);
        const double height = heightAt(motion, span.before->time + middle * length);
        done += part * height;
        whole += height;
    }
    return done / whole;
}

}  // namespace

std::map<std::string, double> valuesAt(const Motion& motion, double time) {
    std::map<std::string, double> values;
    for (const KeyFrame& key : motion.keys)
        for (const auto& [name, value] : key.values) values.emplace(name, value);
    const bool zooms = values.contains(kHeight);
    const Span height = zooms ? spanOf(motion, kHeight, time) : Span{};
    for (auto& [name, value] : values) {
        const Span span = name == kHeight ? height : spanOf(motion, name, time);
        value = span.first(name);
        if (!span.moves()) continue;
        const double to = span.after->values.at(name);
        if (name == kHeight) {
            value = heightOnTheWay(value, to, span.part(time));
            continue;
        }
        double part = span.part(time);
        if (isCentre(name) && zooms) {
            if (height.before == span.before && height.after == span.after)
                part =
                    centreOnTheWay(height.first(kHeight), height.after->values.at(kHeight), part);
            else if (span.before->easing != Easing::hold)
                part = partByHeights(motion, span, time);
        }
        // From the end that is nearer, so that no digit of it is lost.
        value = part > 0.5 ? to + (value - to) * (1 - part) : value + (to - value) * part;
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
    std::map<double, KeyFrame> keys;
    const auto write = [&](std::size_t column, std::size_t at) {
        KeyFrame& key = keys[samples_[at].time];
        key.time = samples_[at].time;
        key.values[names_[column]] = samples_[at].values[column];
    };
    const auto value = [&](std::size_t column, std::size_t at) {
        return samples_[at].values[column];
    };
    const auto partOf = [&](std::size_t first, std::size_t last, std::size_t at) {
        return (samples_[at].time - samples_[first].time) /
               (samples_[last].time - samples_[first].time);
    };
    const auto moves = [&](std::size_t column) {
        return std::any_of(samples_.begin(), samples_.end(), [&](const Sample& sample) {
            return sample.values[column] != samples_[0].values[column];
        });
    };
    // The view as one: a gap is measured in picture heights.
    std::vector<std::size_t> view, centre;
    std::size_t height = names_.size();
    for (std::size_t k = 0; k < names_.size(); ++k) {
        if (names_[k] == kHeight) height = k;
        if (isCentre(names_[k])) centre.push_back(k);
        if ((names_[k] == kHeight || isCentre(names_[k])) && moves(k)) view.push_back(k);
    }
    if (!view.empty()) {
        const auto gap = [&](std::size_t first, std::size_t last, std::size_t at) {
            const double part = partOf(first, last, at);
            const double from = value(height, first), to = value(height, last);
            const double way = centreOnTheWay(from, to, part), own = value(height, at);
            double largest = std::abs(log(heightOnTheWay(from, to, part) / own));
            for (std::size_t k : centre) {
                const double there = value(k, first) + (value(k, last) - value(k, first)) * way;
                largest = std::max(largest, std::abs(there - value(k, at)) / own);
            }
            return largest;
        };
        for (std::size_t at : needed(samples_.size(), tolerance, gap))
            for (std::size_t k : view) write(k, at);
    }
    for (std::size_t k = 0; k < names_.size(); ++k) {
        if (names_[k] == kHeight || isCentre(names_[k]) || !moves(k)) continue;
        double low = value(k, 0), high = low;
        for (std::size_t i = 0; i < samples_.size(); ++i)
            low = std::min(low, value(k, i)), high = std::max(high, value(k, i));
        const auto gap = [&](std::size_t first, std::size_t last, std::size_t at) {
            const double from = value(k, first);
            return std::abs(value(k, at) -
                            (from + (value(k, last) - from) * partOf(first, last, at)));
        };
        for (std::size_t at : needed(samples_.size(), tolerance * (high - low), gap)) write(k, at);
    }
    if (keys.empty()) return std::nullopt;
    Motion motion;
    for (auto& [time, key] : keys) motion.keys.push_back(std::move(key));
    return motion;
}

}  // namespace versorium
