// SPDX-License-Identifier: MIT
// The project's benchmark: every row beside the textbook loop it is measured against, in one run.
// Prints Google Benchmark's table or JSON, then the ratios of the median CPU times.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>

#include "benchmark/baselines.h"
#include "benchmark/views.h"
#include "fields/ensemble.h"
#include "maps/formula_map.h"
#include "render/bind.h"
#include "render/cpu/cpu_renderer.h"

namespace versorium {
namespace {

constexpr int kSide = 1024;
constexpr int kIterations = 1000;
constexpr int kTile = 4096;

// One picture by an escape kernel, in tiles that stay in the cache.
template <class T>
class KernelPicture {
  public:
    KernelPicture(const MapKernels& map, bool startVaries)
        : map_(map), startVaries_(startVaries), values_(map.parameters, std::vector<T>(kTile)) {
        for (int k = 0; k < map.dimension; ++k) state_.emplace_back(kTile);
        scratch_.resize(scratchSize(kTile, map.parameters + kMostOverrides));
        index_.resize(6 * kTile);
        steps_.resize(kTile);
    }
    std::vector<T>& parameter(int k) { return values_[static_cast<std::size_t>(k)]; }

    std::int64_t run(BatchFunction<T> escape, const textbook::View& view, int iterations,
                     double squaredRadius, bool shortcuts) {
        std::int64_t total = 0;
        for (int first = 0; first < kSide * kSide; first += kTile) {
            for (int i = 0; i < kTile; ++i) {
                const auto at = static_cast<std::size_t>(i);
                const T u = static_cast<T>(view.u((first + i) % kSide, kSide));
                const T v = static_cast<T>(view.v((first + i) / kSide, kSide));
                state_[0][at] = startVaries_ ? u : T(0);
                state_[1][at] = startVaries_ ? v : T(0);
                if (!startVaries_) values_[0][at] = u, values_[1][at] = v;
            }
            OrbitBatch<T> batch;
            batch.count = batch.capacity = kTile;
            for (std::size_t k = 0; k < state_.size(); ++k) batch.state[k] = state_[k].data();
            for (std::size_t k = 0; k < values_.size(); ++k)
                batch.parameters[k] = {values_[k].data(), !startVaries_ && k < 2};
            batch.program = map_.program();
            batch.squaredRadius = static_cast<T>(squaredRadius);
            batch.iterations = iterations;
            batch.steps = steps_.data();
            batch.scratch = scratch_.data();
            batch.scratchIndex = index_.data();
            batch.needLast = false;
            batch.shortcuts = shortcuts;
            escape(batch);
            for (std::int32_t n : steps_) total += std::min<std::int32_t>(n, iterations);
        }
        return total;
    }

  private:
    const MapKernels& map_;
    bool startVaries_;
    std::vector<std::vector<T>> values_, state_;
    std::vector<T> scratch_;
    std::vector<std::int32_t> index_, steps_;
};

void countRate(benchmark::State& state, std::int64_t iterations) {
    state.counters["iterations/s"] =
        benchmark::Counter(static_cast<double>(iterations), benchmark::Counter::kIsRate);
}

// 26 coefficients, none of them zero, whose orbits from the unit square neither escape nor settle.
const std::vector<double>& quartic() {
    static const std::vector<double> k = {
        -0.41, -0.62, 0.05, 0.03,  0.52, 0.31, -0.04, 0.02, 0.11, 0.03, -0.05, 0.02,  0.21, 0, 0,
        0.63,  0.12,  0.04, -0.02, -0.3, 0.15, 0.05,  0.03, 0.22, 0.04, 0.03,  -0.04, -0.1, 0, 0};
    return k;
}
// Hénon's map as the planar family writes it; the same with every zero made tiny, so that no
// shorter form applies and the numbers stay the same.
std::vector<double> henon(double zero) {
    std::vector<double> k(30, zero);
    k[12] = 1, k[1] = -1.4, k[4] = 0.3, k[15] = 1;
    k[13] = k[14] = k[28] = k[29] = 0;
    return k;
}

struct Ratio {
    std::string row, baseline, goal;
};
std::vector<Ratio>& ratios() {
    static std::vector<Ratio> all;
    return all;
}

std::string nameOf(const KernelTarget& target) {
    return std::string(target.flavour == Flavour::fast ? "fast" : "exact") + "/" + target.name;
}

template <class T>
void addMandelbrot(const KernelTarget& target, const std::string& type, const char* goal) {
    const MapKernels& map = *findMap("quadratic");
    const std::string name = "mandelbrot/" + type + "/" + nameOf(target);
    benchmark::RegisterBenchmark(name.c_str(), [&target, &map](benchmark::State& state) {
        KernelPicture<T> picture(map, false);
        std::int64_t total = 0;
        for (auto _ : state)
            total +=
                picture.run(target.escapeOf<T>(map.index), textbook::kHome, kIterations, 4, false);
        countRate(state, total);
    });
    ratios().push_back({name, "mandelbrot/" + type + "/textbook", goal});
}

// A typed z^2 + c against the built-in quadratic kernel, neither with shortcuts.
template <class T>
void addFormula(const KernelTarget& target, const std::string& type) {
    static const std::shared_ptr<const FormulaMap> kTyped = *FormulaMap::make("z^2 + c");
    const MapKernels& map = kTyped->kernels();
    const std::string name = "formula/" + type + "/" + nameOf(target);
    benchmark::RegisterBenchmark(name.c_str(), [&target, &map](benchmark::State& state) {
        KernelPicture<T> picture(map, false);
        std::int64_t total = 0;
        for (auto _ : state)
            total +=
                picture.run(target.escapeOf<T>(map.index), textbook::kHome, kIterations, 4, false);
        countRate(state, total);
    });
    ratios().push_back({name, "mandelbrot/" + type + "/" + nameOf(target), "0.25"});
}

void addShortcuts(const KernelTarget& target) {
    const MapKernels& map = *findMap("quadratic");
    const std::string name = "mandelbrot/shortcuts/" + nameOf(target);
    benchmark::RegisterBenchmark(name.c_str(), [&target, &map](benchmark::State& state) {
        KernelPicture<double> picture(map, false);
        for (auto _ : state)
            picture.run(target.escape[map.index], textbook::kHome, kIterations, 4, true);
    });
    ratios().push_back({name, "mandelbrot/double/" + nameOf(target), "3"});
}

void addPlanar(const KernelTarget& target, const std::string& name, const std::vector<double>& k,
               double height, int iterations, double squaredRadius, const std::string& baseline,
               const char* goal) {
    const MapKernels& map = *findMap("planar");
    const std::string full = name + "/" + nameOf(target);
    benchmark::RegisterBenchmark(full.c_str(), [=, &target, &map](benchmark::State& state) {
        KernelPicture<double> picture(map, true);
        for (int i = 0; i < 30; ++i)
            std::fill(picture.parameter(i).begin(), picture.parameter(i).end(),
                      k[static_cast<std::size_t>(i)]);
        std::int64_t total = 0;
        for (auto _ : state)
            total += picture.run(target.escape[map.index], {0, 0, height}, iterations,
                                 squaredRadius, false);
        countRate(state, total);
        // 24 multiply-adds a step.
        state.counters["flop/s"] =
            benchmark::Counter(48.0 * static_cast<double>(total), benchmark::Counter::kIsRate);
    });
    if (!baseline.empty()) ratios().push_back({full, baseline, goal});
}

void addThreads(int threads) {
    const std::string name = "mandelbrot/picture/threads-" + std::to_string(threads);
    benchmark::RegisterBenchmark(name.c_str(), [threads](benchmark::State& state) {
        CpuRenderer renderer;
        Scene scene = *presetNamed("mandelbrot");
        scene.iterations = 5000;
        scene.samples = 1;
        for (auto _ : state) {
            Job job(threads);
            Frame frame;
            benchmark::DoNotOptimize(
                renderer.render(scene, {kSide, kSide}, {.shortcuts = false}, job, frame));
        }
    })->UseRealTime();
}

// Members of degree 10, roots in the box of the shape.
constexpr int kAveragedSide = 64, kAveragedMembers = 100;

OrbitProgram averagedProgram(double alpha) {
    Scene scene = *sceneOfMap("shape-modulus-complex-rational");
    scene.parameters["alpha"] = {alpha};
    scene.shape.source = "star(5, 1.4, 0.7)";
    scene.iterations = 12;
    scene.slice.height = 3.2;
    scene.ensemble.count = kAveragedMembers;
    scene.ensemble.roots = EnsembleRoots{};
    scene.ensemble.roots->draw.lowPower = scene.ensemble.roots->draw.highPower = 1;
    Binder binder;
    Job job(1);
    return *binder.bind(scene, job);
}

void addAveraged(double alpha) {
    const std::string name = "averaged/alpha-" + std::to_string(static_cast<int>(alpha));
    const auto program = std::make_shared<OrbitProgram>(averagedProgram(alpha));
    const auto view = textbook::View{0, 0, 3.2};
    benchmark::RegisterBenchmark((name + "/scalar").c_str(), [=](benchmark::State& state) {
        std::vector<std::vector<RootList::Root>> members;
        OrbitProgram member = *program;
        for (int k = 0; k < kAveragedMembers; ++k) {
            program->ensemble->choose(static_cast<std::uint64_t>(k), member);
            members.push_back(member.lists[0]);
        }
        std::vector<std::uint32_t> counts(kAveragedSide * kAveragedSide);
        for (auto _ : state)
            textbook::averagedMembership(kAveragedSide, view.height, program->iterations, alpha,
                                         *program->field, members, counts);
    });
    for (Flavour flavour : {Flavour::exact, Flavour::fast}) {
        const std::string row = name + (flavour == Flavour::fast ? "/fast" : "/exact");
        benchmark::RegisterBenchmark(row.c_str(), [=](benchmark::State& state) {
            std::vector<double> u, v;
            for (int i = 0; i < kAveragedSide * kAveragedSide; ++i) {
                u.push_back(view.u(i % kAveragedSide, kAveragedSide));
                v.push_back(view.v(i / kAveragedSide, kAveragedSide));
            }
            const double* coordinates[3] = {u.data(), v.data(), nullptr};
            std::vector<std::uint32_t> counts(u.size());
            EvaluateOptions options;
            options.flavour = flavour;
            constexpr int kTileOfThese = 4096;
            for (auto _ : state)
                for (int first = 0; first < static_cast<int>(u.size()); first += kTileOfThese) {
                    const double* tile[3] = {coordinates[0] + first, coordinates[1] + first,
                                             nullptr};
                    countMembers(*program, 0, kAveragedMembers, kTileOfThese, tile,
                                 counts.data() + first, options);
                }
        });
        ratios().push_back({row, name + "/scalar", "10"});
    }
}

void addAll() {
    using textbook::kHome;
    benchmark::RegisterBenchmark("mandelbrot/double/textbook", [](benchmark::State& state) {
        std::vector<std::int32_t> steps(kSide * kSide);
        std::int64_t total = 0;
        for (auto _ : state) total += textbook::mandelbrot<double>(kSide, kIterations, steps);
        countRate(state, total);
    });
    benchmark::RegisterBenchmark("mandelbrot/float/textbook", [](benchmark::State& state) {
        std::vector<std::int32_t> steps(kSide * kSide);
        std::int64_t total = 0;
        for (auto _ : state) total += textbook::mandelbrot<float>(kSide, kIterations, steps);
        countRate(state, total);
    });
    benchmark::RegisterBenchmark("planar/image/textbook", [](benchmark::State& state) {
        std::vector<std::int32_t> steps(kSide * kSide);
        std::int64_t total = 0;
        for (auto _ : state)
            total += textbook::planarDotProducts(kSide, 3, 100, 16, quartic().data(), steps);
        countRate(state, total);
    });
    for (const KernelTarget& target : kernelTargets()) {
        const bool fast = target.flavour == Flavour::fast;
        const bool wide = std::string(target.name) == "x86-64-v4";
        addMandelbrot<double>(target, "double", fast ? (wide ? "22" : "18") : (wide ? "16" : "14"));
        addMandelbrot<float>(target, "float", "35");
        addFormula<double>(target, "double");
        addFormula<float>(target, "float");
        addShortcuts(target);
        addPlanar(target, "planar/image", quartic(), 3, 100, 16, "planar/image/textbook", "12");
        addPlanar(target, "planar/steady", quartic(), 0.2, 1000, 1e6, "", "");
        addPlanar(target, "henon/generic", henon(1e-300), 3, 100, 100, "", "");
        addPlanar(target, "henon/special", henon(0), 3, 100, 100, "henon/generic/" + nameOf(target),
                  "3");
    }
#if VERSORIUM_BENCH_X86
    const auto peak = [](const char* name, double (*function)(int)) {
        benchmark::RegisterBenchmark(name, [function](benchmark::State& state) {
            double operations = 0;
            for (auto _ : state) operations += function(1000000);
            state.counters["flop/s"] = benchmark::Counter(operations, benchmark::Counter::kIsRate);
        });
    };
    for (const KernelTarget& target : kernelTargets()) {
        if (target.flavour != Flavour::fast) continue;
        const bool wide = std::string(target.name) == "x86-64-v4";
        peak(wide ? "fma-peak/x86-64-v4" : "fma-peak/x86-64-v3",
             wide ? textbook::fmaPeakV4 : textbook::fmaPeakV3);
    }
#endif
    addAveraged(8);
    addAveraged(4);
    addThreads(1);
    addThreads(2);
    ratios().push_back({"mandelbrot/picture/threads-2", "mandelbrot/picture/threads-1", "1.8"});
}

// Collects all runs; the ratios are those of the medians.
class Collector : public benchmark::ConsoleReporter {
  public:
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs)
            if (run.run_type == Run::RT_Iteration) {
                const bool real = run.benchmark_name().find("real_time") != std::string::npos;
                const std::string name = run.run_name.function_name;
                times_[name].push_back(real ? run.GetAdjustedRealTime() : run.GetAdjustedCPUTime());
                const auto rate = run.counters.find("flop/s");
                if (rate != run.counters.end()) rates_[name].push_back(rate->second.value);
            }
        ConsoleReporter::ReportRuns(runs);
    }
    static double median(std::vector<double> values) {
        if (values.empty()) return 0;
        std::sort(values.begin(), values.end());
        return values[values.size() / 2];
    }
    void printRatios() {
        std::fprintf(stderr, "\n%-44s %-44s %8s %6s\n", "row", "measured against", "ratio", "goal");
        for (const Ratio& ratio : ratios()) {
            const double own = median(times_[ratio.row]), base = median(times_[ratio.baseline]);
            if (own > 0 && base > 0)
                std::fprintf(stderr, "%-44s %-44s %7.2fx %6s\n", ratio.row.c_str(),
                             ratio.baseline.c_str(), base / own, ratio.goal.c_str());
        }
        for (const char* isa : {"x86-64-v3", "x86-64-v4"}) {
            const double own = median(rates_[std::string("planar/steady/fast/") + isa]);
            const double peak = median(rates_[std::string("fma-peak/") + isa]);
            if (own > 0 && peak > 0)
                std::fprintf(stderr, "%-44s %-44s %7.0f%% %6s\n",
                             (std::string("planar/steady/fast/") + isa).c_str(),
                             (std::string("fma-peak/") + isa).c_str(), 100 * own / peak, "90%");
        }
    }

  private:
    std::map<std::string, std::vector<double>> times_, rates_;
};

}  // namespace
}  // namespace versorium

int main(int argc, char** argv) {
    // Five interleaved repetitions unless the caller asks for others.
    std::vector<char*> arguments{argv, argv + argc};
    std::string defaults[] = {"--benchmark_repetitions=5", "--benchmark_min_time=0.05",
                              "--benchmark_enable_random_interleaving=true"};
    for (std::string& text : defaults) arguments.insert(arguments.begin() + 1, text.data());
    int count = static_cast<int>(arguments.size());
    versorium::addAll();
    benchmark::Initialize(&count, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
    bool json = false;
    for (char* argument : arguments)
        json = json || std::string(argument) == "--benchmark_format=json";
    versorium::Collector collector;
    if (json) {
        // The JSON stands alone on standard output; its reader makes the ratios.
        benchmark::RunSpecifiedBenchmarks();
        return 0;
    }
    benchmark::RunSpecifiedBenchmarks(&collector);
    collector.printRatios();
    return 0;
}
