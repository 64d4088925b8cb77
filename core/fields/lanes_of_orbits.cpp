// SPDX-License-Identifier: MIT
#include "fields/lanes_of_orbits.h"

#include <cmath>
#include <limits>

#include "maps/critical.h"

namespace versorium {

OrbitLanes::OrbitLanes(const OrbitProgram& program, int count, const double* const* coordinates,
                       const EvaluateOptions& options)
    : program_(&program), count_(count) {
    const MapKernels& map = *program.map;
    target_ = &kernelTarget(options.flavour);
    capacity_ = (count + kBatchPadding - 1) / kBatchPadding * kBatchPadding;
    states_.assign(static_cast<std::size_t>(map.dimension),
                   std::vector<double>(static_cast<std::size_t>(capacity_), 0.0));
    parameters_.resize(static_cast<std::size_t>(map.parameters));
    overrides_.resize(program.overrides.size());
    parameterSlopes_.assign(parameters_.size(), 0.0);
    overrideSlopes_.assign(overrides_.size(), 0.0);
    fillStart(coordinates);
    if (program.critical) criticalStart(-1);
}

void OrbitLanes::fillStart(const double* const* coordinates) {
    const Slice& slice = program_->slice;
    const std::size_t axes = slice.axes.size();
    const auto fill = [&](std::size_t number, std::vector<double>& values) {
        for (int i = 0; i < count_; ++i) {
            double at[3] = {};
            for (std::size_t k = 0; k < axes; ++k) at[k] = coordinates[k][i];
            values[static_cast<std::size_t>(i)] = slice.at(number, at);
        }
    };
    std::size_t number = 0;
    for (auto& values : states_) fill(number++, values);
    const auto bind = [&](Values& values) {
        values.varies = slice.varies(number);
        values.numbers.assign(values.varies ? static_cast<std::size_t>(capacity_) : 1, 0.0);
        if (values.varies)
            fill(number, values.numbers);
        else
            values.numbers[0] = slice.origin[number];
        ++number;
    };
    for (Values& values : parameters_) bind(values);
    for (Values& values : overrides_) bind(values);
}

void OrbitLanes::criticalStart(int axis) {
    const MapKernels& map = *program_->map;
    bool moves = false;
    for (std::size_t k = 0; k < parameters_.size(); ++k)
        moves = moves || (parameters_[k].varies && movesCritical(map, static_cast<int>(k)));
    for (const Values& values : overrides_) moves = moves || values.varies;
    Environment<double> environment;
    for (std::size_t k = 0; k < program_->lists.size(); ++k)
        environment.lists[k] = &program_->lists[k];
    environment.field = program_->field.get();
    environment.overrideCount = static_cast<int>(overrides_.size());
    std::vector<double> parameters(parameters_.size() + 1);
    double point[kMostDimension] = {}, slope[kMostDimension] = {};
    bool found = false;
    for (int i = 0; i < count_; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const auto value = [&](const Values& v) { return v.numbers[v.varies ? at : 0]; };
        if (i == 0 || moves) {
            for (std::size_t k = 0; k < parameters_.size(); ++k)
                parameters[k] = value(parameters_[k]);
            for (std::size_t k = 0; k < overrides_.size(); ++k) {
                const auto& number = program_->overrides[k];
                environment.overrides[k] = {number.list, number.item, number.component,
                                            value(overrides_[k])};
            }
            found = criticalPoint(map, *program_->critical, parameters.data(), environment, point,
                                  axis >= 0 ? parameterSlopes_.data() : nullptr,
                                  axis >= 0 ? overrideSlopes_.data() : nullptr,
                                  axis >= 0 ? slope : nullptr);
        }
        for (std::size_t k = 0; k < states_.size(); ++k) {
            if (axis >= 0)
                slopes_[k][at] = found ? slope[k] : 0.0;
            else
                states_[k][at] = found ? point[k] : std::numeric_limits<double>::quiet_NaN();
        }
    }
}

void OrbitLanes::seedSlopes(int axis) {
    slopes_.assign(states_.size(), std::vector<double>(static_cast<std::size_t>(capacity_), 0.0));
    if (axis < 0) return;
    const auto& direction = program_->slice.axes[static_cast<std::size_t>(axis)];
    std::size_t number = 0;
    for (auto& values : slopes_) std::fill(values.begin(), values.end(), direction[number++]);
    for (double& value : parameterSlopes_) value = direction[number++];
    for (double& value : overrideSlopes_) value = direction[number++];
    if (program_->critical) criticalStart(axis);
}

double OrbitLanes::squaredNorm(std::size_t i) const {
    double norm = states_[0][i] * states_[0][i];
    for (std::size_t k = 1; k < states_.size(); ++k) norm = norm + states_[k][i] * states_[k][i];
    return norm;
}

OrbitBatch<double> OrbitLanes::batch(bool withSlopes) {
    OrbitBatch<double> batch;
    batch.count = count_;
    batch.capacity = capacity_;
    for (std::size_t k = 0; k < states_.size(); ++k) batch.state[k] = states_[k].data();
    for (std::size_t k = 0; k < parameters_.size(); ++k)
        batch.parameters[k] = {parameters_[k].numbers.data(), parameters_[k].varies};
    for (std::size_t k = 0; k < program_->lists.size(); ++k) batch.lists[k] = &program_->lists[k];
    batch.field = program_->field.get();
    batch.program = program_->map->program();
    batch.overrideCount = static_cast<int>(overrides_.size());
    for (std::size_t k = 0; k < overrides_.size(); ++k) {
        const auto& number = program_->overrides[k];
        batch.overrides[k] = {number.list,
                              number.item,
                              number.component,
                              {overrides_[k].numbers.data(), overrides_[k].varies}};
    }
    if (withSlopes) {
        for (std::size_t k = 0; k < slopes_.size(); ++k) batch.slope[k] = slopes_[k].data();
        for (std::size_t k = 0; k < parameterSlopes_.size(); ++k)
            batch.parameterSlopes[k] = parameterSlopes_[k];
        for (std::size_t k = 0; k < overrideSlopes_.size(); ++k)
            batch.overrideSlopes[k] = overrideSlopes_[k];
    }
    return batch;
}

void OrbitLanes::advance(int steps) {
    OrbitBatch<double> all = batch();
    for (int i = 0; i < steps; ++i) target_->advance[program_->map->index](all);
}

void OrbitLanes::advanceDual() {
    OrbitBatch<double> all = batch(true);
    target_->advanceDual[program_->map->index](all);
}

const EscapeResult& EscapeRun::run(OrbitLanes& lanes, Needed needed) {
    const OrbitProgram& program = *program_;
    const auto count = static_cast<std::size_t>(lanes.count());
    OrbitBatch<double> batch = lanes.batch();
    const auto capacity = static_cast<std::size_t>(batch.capacity);
    scratch_.resize(scratchSize(batch.capacity, program.map->parameters + kMostOverrides));
    index_.resize(6 * capacity);
    result_.steps.resize(capacity);
    batch.steps = result_.steps.data();
    batch.scratch = scratch_.data();
    batch.scratchIndex = index_.data();
    const double radius2 = program.escapeRadius * program.escapeRadius;
    batch.squaredRadius =
        program.onlyLastTested ? std::numeric_limits<double>::infinity() : radius2;
    batch.iterations = program.iterations;
    batch.needLast = needed == Needed::last || program.onlyLastTested;
    batch.needEscaped = needed != Needed::steps || program.onlyLastTested;
    batch.squaredCapture = capture_ * capture_;
    batch.shortcuts = options_->shortcuts;
    if (program.measuresGrowth() && needed != Needed::steps) {
        result_.previousNorm.assign(capacity, 0.0);
        batch.previous = result_.previousNorm.data();
    }
    lanes.escape(batch);
    result_.escaped.resize(count);
    result_.squaredNorm.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        if (batch.needEscaped) result_.squaredNorm[i] = lanes.squaredNorm(i);
        result_.escaped[i] = result_.steps[i] <= program.iterations;
        if (program.onlyLastTested) {
            result_.escaped[i] = !(result_.squaredNorm[i] <= radius2);
            result_.steps[i] = program.iterations + (result_.escaped[i] ? 0 : 1);
        }
    }
    return result_;
}

}  // namespace versorium
