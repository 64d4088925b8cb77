// SPDX-License-Identifier: MIT
#pragma once
// Assets that have come to a process, by SHA-256. Those that nobody has asked for the longest go
// first once there are too many bytes; whoever sent them is then asked again.

#include <string>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace versorium {

class AssetStore {
  public:
    // A scene has at most half of that: the assets of one job never push each other out.
    explicit AssetStore(std::size_t mostBytes = 2 * kMostAssetBytes) : mostBytes_(mostBytes) {}

    void put(const std::string& hash, std::shared_ptr<const Asset> asset);
    // Gives each of them that is null its asset; returns the names of those that are not here.
    std::vector<std::string> fill(Assets& assets);
    Assets all() const { return {assets_.begin(), assets_.end()}; }
    std::size_t bytes() const;

  private:
    std::size_t mostBytes_;
    std::vector<std::pair<std::string, std::shared_ptr<const Asset>>> assets_;  // newest last
};

}  // namespace versorium
