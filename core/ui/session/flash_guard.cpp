// SPDX-License-Identifier: MIT
#include "ui/session/flash_guard.h"

#include <algorithm>
#include <cmath>

#include "colour/srgb.h"

namespace versorium {
namespace {

constexpr float kLeastChange = 0.1F, kBright = 0.8F;
constexpr double kWindow = 1;       // seconds
constexpr double kShare = 0.25;     // of the cells
constexpr int kSamplesOfACell = 8;  // along each side, at most

}  // namespace

// A change in one direction goes on until the luminance has come back by a tenth.
bool FlashGuard::changes(const Cell& cell, float light) {
    if (!cell.extreme) return false;
    const float by = light - *cell.extreme;
    return std::abs(by) >= kLeastChange && std::min(light, *cell.extreme) < kBright &&
           (by > 0 ? 1 : -1) != cell.direction;
}

bool FlashGuard::admit(const Lights& lights, double now) {
    std::size_t over = 0;
    for (std::size_t k = 0; k < cells_.size(); ++k) {
        Cell& cell = cells_[k];
        while (!cell.changes.empty() && cell.changes.front() <= now - kWindow)
            cell.changes.pop_front();
        over += changes(cell, lights[k]) && cell.changes.size() >= 2 * kMostFlashes;
    }
    if (static_cast<double>(over) > kShare * static_cast<double>(cells_.size())) return false;
    for (std::size_t k = 0; k < cells_.size(); ++k) {
        Cell& cell = cells_[k];
        const float light = lights[k];
        if (changes(cell, light)) {
            cell.direction = light > *cell.extreme ? 1 : -1;
            cell.extreme = light;
            cell.changes.push_back(now);
        } else if (!cell.extreme ||
                   (light - *cell.extreme) * static_cast<float>(cell.direction) > 0) {
            cell.extreme = light;
        }
    }
    return true;
}

FlashGuard::Lights lightsOf(std::span<const unsigned char> rgba, Size size) {
    static const std::array<float, 256> linear = [] {
        std::array<float, 256> table{};
        for (std::size_t k = 0; k < table.size(); ++k)
            table[k] = static_cast<float>(linearFromSrgb(static_cast<double>(k) / 255));
        return table;
    }();
    FlashGuard::Lights lights{};
    const auto along = [](int cell, int cells, int sample, int samples, int pixels) {
        const double at = (cell + (sample + 0.5) / samples) / cells * pixels;
        return static_cast<std::size_t>(std::min(static_cast<int>(at), pixels - 1));
    };
    const int across = std::clamp(size.width / FlashGuard::kColumns, 1, kSamplesOfACell);
    const int down = std::clamp(size.height / FlashGuard::kRows, 1, kSamplesOfACell);
    for (int row = 0; row < FlashGuard::kRows; ++row)
        for (int column = 0; column < FlashGuard::kColumns; ++column) {
            float sum = 0;
            for (int j = 0; j < down; ++j)
                for (int i = 0; i < across; ++i) {
                    const std::size_t x =
                        along(column, FlashGuard::kColumns, i, across, size.width);
                    const std::size_t y = along(row, FlashGuard::kRows, j, down, size.height);
                    const unsigned char* p =
                        &rgba[4 * (y * static_cast<std::size_t>(size.width) + x)];
                    sum += 0.2126F * linear[p[0]] + 0.7152F * linear[p[1]] + 0.0722F * linear[p[2]];
                }
            lights[static_cast<std::size_t>(row * FlashGuard::kColumns + column)] =
                sum / static_cast<float>(across * down);
        }
    return lights;
}

}  // namespace versorium
