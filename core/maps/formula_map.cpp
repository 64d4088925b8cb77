// SPDX-License-Identifier: MIT
#include "maps/formula_map.h"

#include <algorithm>
#include <deque>
#include <mutex>

#include "maps/complex_polynomials.h"
#include "maps/critical.h"
#include "maps/formula_shape.h"
#include "maps/formula_step.h"
#include "maps/shape_modulus.h"
#include "trace/formula_growth.h"

namespace versorium {
namespace {

static_assert(kFormulaParameters == kFormulaNumbers);

constexpr std::size_t kMostKept = 256;

Algebra algebraOf(FormulaSpace space) {
    switch (space) {
        case FormulaSpace::line:
            return Algebra::real;
        case FormulaSpace::complex:
            return Algebra::complex;
        case FormulaSpace::plane:
            return Algebra::plane;
        default:
            return Algebra::quaternion;
    }
}

ParameterKind kindOf(FormulaKind kind) {
    switch (kind) {
        case FormulaKind::real:
            return ParameterKind::real;
        case FormulaKind::whole:
            return ParameterKind::whole;
        case FormulaKind::complex:
            return ParameterKind::complex;
        default:
            return ParameterKind::quaternion;
    }
}

// Large enough that escape times are smooth: the leading term has taken over there.
double radiusOf(const Formula& formula) {
    if (formula.shape) return shape_modulus::kEscapeRadius;
    switch (formula.space) {
        case FormulaSpace::complex:
            return formula.degree >= 2 ? 100 : 50;
        case FormulaSpace::line:
            return 16;
        default:
            return 100;
    }
}

template <int D>
MapKernels rowOf(const MapInfo& info, const FormulaMap* map, const TapeCode& code, bool second) {
    using M = FormulaStep<D>;
    StepFunction<SecondNumber>::Plain secondStep = nullptr;
    if constexpr (D == 2)
        if (second) secondStep = &stepFlat<M, SecondNumber>;
    constexpr int kPlace = D == 1 ? 0 : D == 2 ? 1 : 2;
    return {info,
            static_cast<int>(catalogue().size()) + kPlace,
            D,
            code.parameterSize,
            {&stepFlat<M, double>, &code},
            {&stepFlat<M, float>, &code},
            {&stepFlat<M, DualNumber>, &code},
            {secondStep, &code},
            nullptr,
            0,
            nullptr,
            nullptr,
            map};
}

std::unique_ptr<MapKernels> rowOfDimension(int dimension, const MapInfo& info,
                                           const FormulaMap* map, const TapeCode& code,
                                           bool second) {
    return std::make_unique<MapKernels>(dimension == 1   ? rowOf<1>(info, map, code, second)
                                        : dimension == 2 ? rowOf<2>(info, map, code, second)
                                                         : rowOf<4>(info, map, code, second));
}

// The formulas that were asked for last, by the texts that were typed and by their normal forms.
struct Kept {
    std::mutex mutex;
    std::deque<std::pair<std::string, std::shared_ptr<const FormulaMap>>> maps;

    std::shared_ptr<const FormulaMap> find(std::string_view text) {
        const std::lock_guard lock(mutex);
        const auto found = std::find_if(maps.begin(), maps.end(),
                                        [&](const auto& entry) { return entry.first == text; });
        if (found == maps.end()) return nullptr;
        std::rotate(maps.begin(), found, found + 1);
        return maps.front().second;
    }
    void add(std::string text, std::shared_ptr<const FormulaMap> map) {
        const std::lock_guard lock(mutex);
        maps.emplace_front(std::move(text), std::move(map));
        if (maps.size() > kMostKept) maps.pop_back();
    }
};

Kept& kept() {
    static Kept kKept;
    return kKept;
}

}  // namespace

Expected<std::shared_ptr<const FormulaMap>> FormulaMap::make(std::string_view text,
                                                             FormulaFault* fault) {
    if (auto known = kept().find(text)) return known;
    Expected<Formula> formula = parseFormula(text, fault, &formulaShape());
    if (!formula) return formula.status();
    if (auto known = kept().find(formula->text)) {
        kept().add(std::string(text), known);
        return known;
    }
    if (formula->shape) formula->tape = shapeTape(*formula);
    Expected<TapeProgram> program = TapeProgram::make(formula->tape);
    if (!program) {
        if (fault) *fault = {0, program.status().message()};
        return program.status();
    }
    std::shared_ptr<FormulaMap> map(new FormulaMap);
    map->formula_ = std::move(*formula);
    map->program_ = std::move(*program);
    map->code_ = map->program_.code();
    if (map->formula_.degree > 0) {
        Expected<TapeProgram> slope = TapeProgram::make(map->formula_.slope);
        if (slope)
            map->slopeProgram_ = std::move(*slope);
        else
            map->formula_.degree = 0;
    }
    map->describe();
    if (map->formula_.text != text) kept().add(map->formula_.text, map);
    kept().add(std::string(text), map);
    return std::shared_ptr<const FormulaMap>(map);
}

void FormulaMap::describe() {
    for (const FormulaParameter& parameter : formula_.parameters)
        parameters_.push_back({.name = parameter.name,
                               .kind = kindOf(parameter.kind),
                               .value = parameter.value,
                               .low = parameter.low,
                               .high = parameter.high,
                               .help = {}});
    if (formula_.shape) {
        const auto own = shapeParameters(formula_.space);
        for (std::size_t k = 0; k < own.size(); ++k) {
            parameters_[k].help = own[k].help;
            parameters_[k].ofView = own[k].ofView;
        }
    }
    // What the catalogue has a letter for is shown by this letter.
    for (ParameterInfo& parameter : parameters_)
        for (const MapKernels& map : catalogue())
            if (const ParameterInfo* known = findParameter(map.info, parameter.name);
                known && parameter.label.empty())
                parameter.label = known->label;
    info_ = {.name = kFormulaName,
             .title = "Typed formula",
             .formula = formula_.body,
             .algebra = algebraOf(formula_.space),
             .parameters = parameters_,
             .field = formula_.shape,
             .escapeRadius = radiusOf(formula_),
             .homeHeight = formula_.shape                         ? shape_modulus::kHomeHeight
                           : formula_.space == FormulaSpace::line ? 4.0
                           : formula_.unicritical || formula_.space == FormulaSpace::quaternion
                               ? 3.2
                           : formula_.degree >= 2 ? 4.0
                                                  : 6.0,
             .source = "typed by you"};
    // The exponent of the catalogue's family goes by this name in formulas as well.
    if (const ParameterInfo* power = findParameter(info_, Power::info.degreeParameter))
        info_.degreeParameter = power->name;
    // A family of the catalogue that is typed is still that family.
    for (const MapKernels& map : catalogue())
        if (map.info.formula == info_.formula && map.info.algebra == info_.algebra) {
            info_.polynomial = map.info.polynomial;
            info_.parameterCentre = map.info.parameterCentre;
        }
    const int dimension = dimensionOf(formula_.space);
    std::vector<double> values;
    for (const ParameterInfo& parameter : parameters_)
        for (int k = 0; k < widthOf(parameter.kind); ++k)
            values.push_back(parameter.value[static_cast<std::size_t>(k)]);
    values.push_back(0);
    // With other parameters it may be another one (render/growth.h).
    const double growth = growthOf(formula_, values.data()).value_or(0);
    info_.degree = growth > 1 ? growth : 0;
    // The image of infinity follows all parameters (maps/critical.h).
    if (valueAtInfinity(formula_, values.data()))
        formula_.movesCritical.assign(formula_.movesCritical.size(), true);
    kernels_ = rowOfDimension(dimension, info_, this, code_, !formula_.shape);
    if (dimension != 2 || formula_.shape) return;
    // Critical points are offered where there is one to begin with.
    double point[2];
    if (!criticalPoint(*kernels_, 0, values.data(), {}, point))
        kernels_ = rowOfDimension(dimension, info_, this, code_, false);
}

std::vector<Complex<double>> FormulaMap::slope(const double* parameters) const {
    if (formula_.degree < 1) return {};
    const TapeCode code = slopeProgram_.code();
    std::vector<double> values(static_cast<std::size_t>(code.stateSize), 0.0);
    runOnce(code, values.data(), parameters);
    std::vector<Complex<double>> coefficients;
    for (std::size_t k = 0; k + 1 < values.size(); k += 2)
        coefficients.push_back({values[k], values[k + 1]});
    return coefficients;
}

}  // namespace versorium
