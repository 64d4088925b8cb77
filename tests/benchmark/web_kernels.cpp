// SPDX-License-Identifier: MIT
// The Mandelbrot kernels as functions that web_bench.mjs calls from Node.
#include <algorithm>
#include <vector>

#include "benchmark/views.h"
#include "maps/catalogue.h"

namespace versorium {
namespace {

constexpr int kTile = 4096;

template <class T>
double mandelbrot(int side, int iterations, BatchFunction<T> escape) {
    std::vector<T> state[2], c[2], scratch(scratchSize(kTile, 2 + kMostOverrides));
    for (int k = 0; k < 2; ++k) state[k].resize(kTile), c[k].resize(kTile);
    std::vector<std::int32_t> steps(kTile), index(6 * kTile);
    double total = 0;
    for (int first = 0; first < side * side; first += kTile) {
        for (int i = 0; i < kTile; ++i) {
            const auto at = static_cast<std::size_t>(i);
            state[0][at] = state[1][at] = 0;
            c[0][at] = static_cast<T>(textbook::kHome.u((first + i) % side, side));
            c[1][at] = static_cast<T>(textbook::kHome.v((first + i) / side, side));
        }
        OrbitBatch<T> batch;
        batch.count = batch.capacity = kTile;
        for (int k = 0; k < 2; ++k) {
            batch.state[k] = state[k].data();
            batch.parameters[k] = {c[k].data(), true};
        }
        batch.iterations = iterations;
        batch.steps = steps.data();
        batch.scratch = scratch.data();
        batch.scratchIndex = index.data();
        batch.needLast = false;
        batch.shortcuts = false;
        escape(batch);
        for (std::int32_t n : steps) total += std::min<std::int32_t>(n, iterations);
    }
    return total;
}

}  // namespace
}  // namespace versorium

// Both return the number of iterations done.
extern "C" double mandelbrotDouble(int side, int iterations) {
    using namespace versorium;
    return mandelbrot(side, iterations,
                      kernelTarget(Flavour::exact).escape[findMap("quadratic")->index]);
}
extern "C" double mandelbrotFloat(int side, int iterations) {
    using namespace versorium;
    return mandelbrot(side, iterations,
                      kernelTarget(Flavour::exact).escapeFloat[findMap("quadratic")->index]);
}
