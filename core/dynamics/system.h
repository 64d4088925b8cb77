// SPDX-License-Identifier: MIT
#pragma once
// Discrete dynamical systems: one map with all its parameters fixed, as a function of its state
// alone. What this room finds (cycles, manifolds of saddles, critical curves, A 4.2) belongs to a
// system; a program's slice gives one for each of its points.
//
// Conventions of this room: points are the components of the state in their order; a Window is in
// the units of the first two of them, and only its left and right count on the real line. Jacobians
// are row-major, by dual numbers. Work on many points takes a Job: it can be cancelled
// (ErrorKind::cancelled), and its results never depend on the number of threads.

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "fields/evaluate.h"

namespace versorium {

using PlanePoint = std::array<double, 2>;
using Polyline = std::vector<PlanePoint>;

inline double distance(const PlanePoint& a, const PlanePoint& b) {
    const double x = a[0] - b[0], y = a[1] - b[1];
    return std::sqrt(x * x + y * y);
}

struct Window {
    double left = -2, right = 2, bottom = -2, top = 2;

    double width() const { return right - left; }
    double height() const { return top - bottom; }
    bool contains(double x, double y) const {
        return x >= left && x <= right && y >= bottom && y <= top;
    }
    // By this share of its sides, on every side.
    Window grown(double share) const {
        const double dx = share * width(), dy = share * height();
        return {left - dx, right + dx, bottom - dy, top + dy};
    }
};

// ErrorKind::usage for a window that is empty or not finite.
Status checkWindow(const Window& window, int dimension);

class System {
  public:
    // The parameters that the program's slice takes at these coordinates, one for each axis (null:
    // at its origin). The program need not outlive the system.
    explicit System(const OrbitProgram& program, const double* coordinates = nullptr);

    const MapKernels& map() const { return *map_; }
    int dimension() const { return map_->dimension; }
    const std::vector<double>& parameters() const { return parameters_; }
    const Environment<double>& environment() const { return environment_; }

    // f, in place.
    void step(double* state) const { map_->step(state, parameters_.data(), environment_); }
    // f in place, and its Jacobian at the state before: dimension² numbers.
    void stepWithJacobian(double* state, double* jacobian) const;
    // fⁿ in place, and its Jacobian.
    void iterateWithJacobian(int n, double* state, double* jacobian) const;
    // det Df of a map of the plane (f' of one of the line).
    double determinant(const double* state) const;

  private:
    const MapKernels* map_;
    std::shared_ptr<const std::vector<BoundList>> lists_;
    std::shared_ptr<const DistanceField> field_;
    std::vector<double> parameters_;
    std::vector<DualNumber> lifted_;
    Environment<double> environment_;
    Environment<DualNumber> dual_;
};

}  // namespace versorium
