// SPDX-License-Identifier: MIT
#include "ui/session/planar_change.h"

#include <cmath>
#include <tuple>

#include "maps/critical.h"
#include "maps/planar.h"
#include "render/frame.h"
#include "scene/parts.h"

namespace versorium {
namespace {

using Complex64 = std::complex<double>;
using Names = std::map<std::string, std::string>;  // what takes the place of a number

constexpr double kSame = 1e-9;

std::string text(double value) { return formatNumber(value, 17); }

// As the formula parser reads it.
std::string text(Complex64 value) {
    if (value.imag() == 0) return "(" + text(value.real()) + ")";
    return "(" + text(value.real()) + (value.imag() < 0 ? " - " : " + ") +
           text(std::abs(value.imag())) + "*i)";
}

// Rounding of the interpolation: what is a decimal number of ten places is meant to be one.
double tidy(double value) {
    const double near = std::round(value * 1e10) / 1e10;
    return std::abs(value - near) < 1e-13 ? near : value;
}

std::optional<ComplexPolynomial> polynomialOf(const System& system,
                                              const std::vector<double>& parameters) {
    const MapKernels& map = system.map();
    if (map.info.algebra != Algebra::complex) return std::nullopt;
    const auto image = [&](Complex64 z) {
        double state[2] = {z.real(), z.imag()};
        map.step(state, parameters.data(), system.environment());
        return Complex64(state[0], state[1]);
    };
    // The discrete Fourier transform at the eighth roots of unity.
    constexpr double kHalf = 0.70710678118654752440;
    constexpr double kRoots[8][2] = {{1, 0},  {kHalf, kHalf},   {0, 1},  {-kHalf, kHalf},
                                     {-1, 0}, {-kHalf, -kHalf}, {0, -1}, {kHalf, -kHalf}};
    const auto root = [&](std::size_t m) { return Complex64(kRoots[m % 8][0], kRoots[m % 8][1]); };
    std::array<Complex64, 8> values, k{};
    for (std::size_t m = 0; m < 8; ++m) values[m] = image(root(m));
    for (std::size_t j = 0; j < 8; ++j) {
        for (std::size_t m = 0; m < 8; ++m) k[j] += values[m] * std::conj(root(m * j));
        k[j] /= 8.0;
        if (!std::isfinite(k[j].real()) || !std::isfinite(k[j].imag())) return std::nullopt;
        if (j > 4 && std::abs(k[j]) > kSame) return std::nullopt;
    }
    ComplexPolynomial polynomial;
    for (std::size_t j = 0; j < 5; ++j) polynomial.k[j] = {tidy(k[j].real()), tidy(k[j].imag())};
    polynomial.k[0] = image(0);
    for (const Complex64 z : {Complex64(0.3, 1.7), Complex64(-1.9, 0.4), Complex64(0.8, -2.2)}) {
        Complex64 sum = 0;
        for (std::size_t j = 5; j-- > 0;) sum = sum * z + polynomial.k[j];
        if (!(std::abs(sum - image(z)) <= kSame * (1 + std::abs(sum)))) return std::nullopt;
    }
    if (polynomial.degree() < 1) return std::nullopt;
    return polynomial;
}

// The complex parameter that is added; empty where none is.
std::string constantOf(const System& system, const ComplexPolynomial& polynomial) {
    std::size_t component = 0;
    for (const ParameterInfo& parameter : system.map().info.parameters) {
        const auto width = static_cast<std::size_t>(widthOf(parameter.kind));
        if (parameter.kind == ParameterKind::complex) {
            std::vector<double> moved = system.parameters();
            moved[component] += 0.5;
            moved[component + 1] += 0.25;
            const auto other = polynomialOf(system, moved);
            bool alone = other.has_value();
            for (std::size_t j = 0; alone && j < 5; ++j)
                alone = std::abs(other->k[j] - polynomial.k[j] -
                                 (j == 0 ? Complex64(0.5, 0.25) : Complex64(0))) < kSame;
            if (alone) return std::string(parameter.name);
        }
        component += width;
    }
    return {};
}

// What is added to g and to h, by the names of a planar system.
std::pair<std::string, std::string> constantTerms(const MapInfo& info) {
    constexpr int kEach = Layout<PlanarComponent<double>>::kWidth;
    return {parameterComponent(info, planar::d), parameterComponent(info, kEach + planar::d)};
}

// The same slice by the other map's names; nothing where a number has no counterpart.
std::optional<SliceSpec> renamed(const SliceSpec& slice, const Names& names) {
    SliceSpec other = slice;
    for (SliceAxis& axis : other.axes)
        for (auto& [name, weight] : axis.terms) {
            const auto found = names.find(name);
            if (found == names.end()) return std::nullopt;
            name = found->second;
        }
    other.origin.clear();
    for (const auto& [name, value] : slice.origin) {
        const auto found = names.find(name);
        if (found == names.end()) return std::nullopt;
        other.origin[found->second] = value;
    }
    return other;
}

// The views of the workspace with another map. `numbers` says its parameters for each of them.
void change(StudioContext& context, const Scene& home, const Names& names,
            const std::function<void(const Scene& from, Scene& to)>& numbers) {
    Workspace next = context.workspace;
    // Places of an analysis need the axes that they lie on.
    if (next.analysis() && !renamed(next.views[0].slice, names)) setViewCount(next, 2);
    for (Scene& view : next.views) {
        Scene scene = home;
        const Scene& old = view;
        numbers(old, scene);
        scene.start = old.start;
        scene.iterations = old.iterations;
        scene.escapeRadius = old.escapeRadius.value_or(automaticRadius(old));
        scene.escapeTest = old.escapeTest;
        scene.trap = old.trap;
        keepLook(scene, old);
        scene.samples = old.samples;
        if (const auto slice = renamed(old.slice, names)) {
            scene.slice = *slice;
            if (old.criticalStart && hasCriticalPoints(mapOf(scene)))
                scene.criticalStart = old.criticalStart;
        } else {
            const SliceSpec place = homeView(viewKind(old), scene).slice;
            if (!place.axes.empty()) scene.slice = place;
        }
        view = std::move(scene);
    }
    next.pins.clear();
    next.ranges.clear();
    next.motion = {};
    next.diagram = {};
    context.open(std::move(next));
}

std::string formulaOf(const ComplexPolynomial& polynomial) {
    std::string sum;
    for (std::size_t j = 5; j-- > 1;) {
        if (polynomial.k[j] == Complex64(0)) continue;
        if (!sum.empty()) sum += " + ";
        if (polynomial.k[j] != Complex64(1)) sum += text(polynomial.k[j]) + "*";
        sum += j == 1 ? "z" : "z^" + std::to_string(j);
    }
    return sum + " + c";
}

using Home = std::pair<Scene, std::string>;  // a map, and its parameter that is added

// The map of the catalogue with the numbers that make it this polynomial.
std::optional<Home> homeAs(const MapKernels& map, const ComplexPolynomial& polynomial) {
    const MapInfo& info = map.info;
    const auto terms = info.polynomial;
    if (terms.empty() || terms[0].empty()) return std::nullopt;
    Scene scene = sceneOf(map);
    const auto degree = static_cast<std::size_t>(polynomial.degree());
    const ParameterInfo* exponent = findParameter(info, info.degreeParameter);
    if (exponent) {
        const auto power = static_cast<double>(degree);
        if (power < exponent->low || power > exponent->high) return std::nullopt;
        scene.parameters[std::string(exponent->name)] = {power};
    }
    for (std::size_t j = 1; j < polynomial.k.size(); ++j) {
        const std::string_view said = j < terms.size()          ? terms[j]
                                      : exponent && j == degree ? "1"
                                                                : "";
        if (said == "1" || said.empty()) {
            if (polynomial.k[j] != Complex64(said.empty() ? 0 : 1)) return std::nullopt;
        } else {
            scene.parameters[std::string(said)] = {polynomial.k[j].real(), polynomial.k[j].imag()};
        }
    }
    return Home{std::move(scene), terms[0]};
}

// A family with a fixed exponent comes before one that takes any.
std::optional<Home> complexHome(const ComplexPolynomial& polynomial) {
    if (polynomial.degree() < 1) return std::nullopt;
    for (const bool anyDegree : {false, true})
        for (const MapKernels& map : catalogue()) {
            const MapInfo& info = map.info;
            if (info.algebra != Algebra::complex || info.field ||
                info.degreeParameter.empty() == anyDegree)
                continue;
            if (auto home = homeAs(map, polynomial)) return home;
        }
    Expected<Scene> typed = sceneOfMap(formulaOf(polynomial));
    if (!typed) return std::nullopt;
    return Home{std::move(*typed), "c"};
}

}  // namespace

PlanarNumbers planarNumbersOf(const Scene& scene) {
    PlanarNumbers numbers{};
    const MapInfo& info = mapOf(scene).info;
    for (std::size_t k = 0; k < numbers.size(); ++k)
        numbers[k] = scene.parameters.at(parameterComponent(info, static_cast<int>(k)))[0];
    return numbers;
}

std::optional<ComplexPolynomial> polynomialOf(StudioContext& context) {
    const std::optional<System> system = shownSystem(context);
    if (!system) return std::nullopt;
    return polynomialOf(*system, system->parameters());
}

bool hasComplexForm(const StudioContext& context) {
    const Workspace& workspace = context.workspace;
    if (!mapOf(workspace.views[0]).info.planarCoefficients) return false;
    const auto polynomial =
        complexPolynomialOf(planarNumbersOf(workspace.views[workspace.speaker()]));
    return polynomial && polynomial->degree() >= 1;
}

void showAsComplexMap(StudioContext& context) {
    const Workspace& workspace = context.workspace;
    if (!hasComplexForm(context))
        return context.say(
            "This is no complex polynomial: the Cauchy-Riemann equations do not hold");
    const auto polynomial =
        complexPolynomialOf(planarNumbersOf(workspace.views[workspace.speaker()]));
    const auto home = complexHome(*polynomial);
    if (!home) return context.say("This polynomial is too long for a formula");
    const std::string constant = home->second;
    const MapInfo& planar = mapOf(workspace.views[0]).info;
    const auto terms = constantTerms(planar);
    const MapInfo& complex = mapOf(home->first).info;
    const Names names{{stateComponent(planar, 0), stateComponent(complex, 0)},
                      {stateComponent(planar, 1), stateComponent(complex, 1)},
                      {terms.first, constant + ".re"},
                      {terms.second, constant + ".im"}};
    change(context, home->first, names, [&](const Scene& from, Scene& to) {
        to.parameters[constant] = {from.parameters.at(terms.first)[0],
                                   from.parameters.at(terms.second)[0]};
    });
    context.say("The same pictures by a complex map");
}

void showAsPlanarSystem(StudioContext& context) {
    const std::optional<System> system = shownSystem(context);
    const auto polynomial =
        system ? polynomialOf(*system, system->parameters()) : std::optional<ComplexPolynomial>();
    if (!polynomial) return context.say("This map is no complex polynomial of degree 1 to 4");
    const Scene home =
        sceneOf(*findMapWhere([](const MapInfo& info) { return info.planarCoefficients; }));
    const std::string constant = constantOf(*system, *polynomial);
    const MapInfo& complex = system->map().info;
    const MapInfo& planar = mapOf(home).info;
    Names names{{stateComponent(complex, 0), stateComponent(planar, 0)},
                {stateComponent(complex, 1), stateComponent(planar, 1)}};
    if (!constant.empty())
        std::tie(names[constant + ".re"], names[constant + ".im"]) = constantTerms(planar);
    change(context, home, names, [&](const Scene& from, Scene& to) {
        ComplexPolynomial own = *polynomial;
        if (!constant.empty()) {
            const std::vector<double>& c = from.parameters.at(constant);
            const std::vector<double>& spoken =
                context.workspace.views[context.workspace.speaker()].parameters.at(constant);
            own.k[0] += Complex64(c[0] - spoken[0], c[1] - spoken[1]);
        }
        const PlanarNumbers numbers = planarNumbersOf(own);
        const MapInfo& info = mapOf(to).info;
        for (std::size_t k = 0; k < numbers.size(); ++k)
            to.parameters[parameterComponent(info, static_cast<int>(k))] = {numbers[k]};
    });
    context.say("The same pictures by a planar system");
}

}  // namespace versorium
