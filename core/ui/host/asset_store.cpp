// SPDX-License-Identifier: MIT
#include "ui/host/asset_store.h"

#include <algorithm>

namespace versorium {

std::size_t AssetStore::bytes() const {
    std::size_t sum = 0;
    for (const auto& [hash, asset] : assets_) sum += asset->bytes.size();
    return sum;
}

void AssetStore::put(const std::string& hash, std::shared_ptr<const Asset> asset) {
    std::erase_if(assets_, [&](const auto& one) { return one.first == hash; });
    assets_.emplace_back(hash, std::move(asset));
    while (assets_.size() > 1 && bytes() > mostBytes_) assets_.erase(assets_.begin());
}

std::vector<std::string> AssetStore::fill(Assets& assets) {
    std::vector<std::string> missing;
    for (auto& entry : assets) {
        const std::string& hash = entry.first;  // no binding: lambdas cannot take one in clang 14
        auto& asset = entry.second;
        if (asset) continue;
        const auto found = std::find_if(assets_.begin(), assets_.end(),
                                        [&](const auto& one) { return one.first == hash; });
        if (found == assets_.end()) {
            missing.push_back(hash);
            continue;
        }
        asset = found->second;
        std::rotate(found, found + 1, assets_.end());
    }
    return missing;
}

}  // namespace versorium
