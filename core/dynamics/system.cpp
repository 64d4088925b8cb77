// SPDX-License-Identifier: MIT
#include "dynamics/system.h"

#include <cmath>

namespace versorium {

Status checkWindow(const Window& window, int dimension) {
    const auto good = [](double low, double high) {
        return low < high && std::abs(low) < 1e12 && std::abs(high) < 1e12;
    };
    if (good(window.left, window.right) && (dimension == 1 || good(window.bottom, window.top)))
        return {};
    return Status::usage("the window needs finite borders, left below right and bottom below top");
}

System::System(const OrbitProgram& program, const double* coordinates)
    : map_(program.map),
      lists_(std::make_shared<const std::vector<BoundList>>(program.lists)),
      field_(program.field) {
    const double origin[3] = {};
    const double* at = coordinates ? coordinates : origin;
    const auto dimension = static_cast<std::size_t>(map_->dimension);
    const auto count = static_cast<std::size_t>(map_->parameters);
    for (std::size_t k = 0; k < count; ++k)
        parameters_.push_back(program.slice.at(dimension + k, at));
    for (std::size_t k = 0; k < lists_->size(); ++k)
        environment_.lists[k] = dual_.lists[k] = &(*lists_)[k];
    environment_.field = dual_.field = field_.get();
    environment_.overrideCount = dual_.overrideCount = static_cast<int>(program.overrides.size());
    for (std::size_t k = 0; k < program.overrides.size(); ++k) {
        const auto& number = program.overrides[k];
        const double value = program.slice.at(dimension + count + k, at);
        environment_.overrides[k] = {number.list, number.item, number.component, value};
        dual_.overrides[k] = {number.list, number.item, number.component, DualNumber(value)};
    }
    for (double value : parameters_) lifted_.emplace_back(value);
    // A map without parameters still takes the address of the first one.
    if (parameters_.empty()) parameters_.push_back(0), lifted_.emplace_back(0.0);
}

void System::stepWithJacobian(double* state, double* jacobian) const {
    const int size = dimension();
    DualNumber image[kMostDimension];
    for (int column = 0; column < size; ++column) {
        for (int k = 0; k < size; ++k) image[k] = {state[k], k == column ? 1.0 : 0.0};
        map_->stepDual(image, lifted_.data(), dual_);
        for (int k = 0; k < size; ++k) jacobian[k * size + column] = image[k].slope;
    }
    for (int k = 0; k < size; ++k) state[k] = image[k].value;
}

void System::iterateWithJacobian(int n, double* state, double* jacobian) const {
    const int size = dimension();
    double product[kMostDimension * kMostDimension] = {};
    for (int k = 0; k < size; ++k) product[k * size + k] = 1;
    double one[kMostDimension * kMostDimension];
    for (int i = 0; i < n; ++i) {
        stepWithJacobian(state, one);
        double next[kMostDimension * kMostDimension] = {};
        for (int row = 0; row < size; ++row)
            for (int k = 0; k < size; ++k)
                for (int column = 0; column < size; ++column)
                    next[row * size + column] += one[row * size + k] * product[k * size + column];
        std::copy(next, next + size * size, product);
    }
    std::copy(product, product + size * size, jacobian);
}

double System::determinant(const double* state) const {
    double at[kMostDimension], j[kMostDimension * kMostDimension];
    std::copy(state, state + dimension(), at);
    stepWithJacobian(at, j);
    return dimension() == 1 ? j[0] : j[0] * j[3] - j[1] * j[2];
}

}  // namespace versorium
