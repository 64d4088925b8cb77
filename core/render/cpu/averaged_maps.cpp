// SPDX-License-Identifier: MIT
#include "render/cpu/averaged_maps.h"

#include <algorithm>
#include <chrono>

namespace versorium {
namespace {

// A portion that follows another one is at most so many times as large: the first one of a map may
// have been quick by chance.
constexpr double kGrowth = 8;
// A portion is planned for this part of the time that is left, since some take longer.
constexpr double kPlanned = 0.9;
// What is left of the time is not worth another portion below this part of it.
constexpr double kEnough = 0.7;

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

}  // namespace

Expected<std::shared_ptr<AveragedMap>> AveragedMaps::of(const Scene& scene, Size size) {
    const auto wanted = static_cast<std::uint64_t>(scene.ensemble.count);
    const std::string key = AveragedMap::keyOf(scene, size);
    const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
        return entry.map->members() <= wanted && entry.map->key() == key;
    });
    if (found != entries_.end()) {
        std::rotate(entries_.begin(), found, found + 1);
        return entries_.front().map;
    }
    Expected<AveragedMap> made = AveragedMap::make(scene, size);
    if (!made) return made.status();
    const std::size_t perSide = static_cast<std::size_t>(scene.samples);
    const std::size_t samples = static_cast<std::size_t>(size.width) *
                                static_cast<std::size_t>(size.height) * perSide * perSide;
    entries_.insert(entries_.begin(),
                    {std::make_shared<AveragedMap>(std::move(*made)), 0, samples});
    std::size_t sum = 0;
    for (std::size_t k = 0; k < entries_.size(); ++k) {
        sum += entries_[k].samples;
        // The newest one is kept however large it is.
        if (k > 0 && (k >= kMostMaps || sum > kMostSamples)) {
            entries_.resize(k);
            break;
        }
    }
    return entries_.front().map;
}

Status AveragedMaps::count(AveragedMap& map, const Scene& scene, double seconds, Binder& binder,
                           Job& job) {
    const auto entry = std::find_if(entries_.begin(), entries_.end(),
                                    [&](const Entry& one) { return one.map.get() == &map; });
    double unknown = 0;
    double& rate = entry == entries_.end() ? unknown : entry->rate;
    const auto wanted = static_cast<std::uint64_t>(scene.ensemble.count);
    const double begin = now();
    double last = 0;
    while (map.members() < wanted) {
        const double since = now();
        const double left = seconds - (since - begin);
        if (last > 0 && left < (1 - kEnough) * seconds) break;
        double members = std::max(1.0, kPlanned * rate * left);
        if (last > 0) members = std::min(members, kGrowth * last);
        const std::uint64_t portion =
            std::min(wanted - map.members(), static_cast<std::uint64_t>(members));
        if (Status status = map.add(binder, portion, {}, job); !status.ok()) return status;
        last = static_cast<double>(portion);
        rate = last / std::max(1e-6, now() - since);
    }
    return {};
}

}  // namespace versorium
