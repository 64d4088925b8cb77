// SPDX-License-Identifier: MIT
#pragma once
// The arrays behind an OrbitBatch: the orbits of some points of a program's slice, as values.

#include <vector>

#include "fields/evaluate.h"

namespace versorium {

class OrbitLanes {
  public:
    OrbitLanes(const OrbitProgram& program, int count, const double* const* coordinates,
               const EvaluateOptions& options);

    int count() const { return count_; }
    std::vector<double>& state(int k) { return states_[static_cast<std::size_t>(k)]; }
    const std::vector<double>& state(int k) const { return states_[static_cast<std::size_t>(k)]; }
    std::vector<double>& slope(int k) { return slopes_[static_cast<std::size_t>(k)]; }
    double squaredNorm(std::size_t i) const;

    // Steps of all orbits, escaped or not.
    void advance(int steps);
    // Derivatives along an axis of the slice (of the start itself where it moves), then steps that
    // carry them on. `axis` < 0: state slopes are the caller's, parameters stand still.
    void seedSlopes(int axis);
    void advanceDual();

    // The batch with pointers into this object; valid until it changes.
    OrbitBatch<double> batch(bool withSlopes = false);
    const BatchRow<double>& row() const { return *row_; }

  private:
    void fillStart(const double* const* coordinates);
    void criticalStart(int axis);

    const OrbitProgram* program_;
    const BatchRow<double>* row_;
    int count_, capacity_;
    std::vector<std::vector<double>> states_, slopes_;
    // One value, or one for each orbit.
    struct Values {
        std::vector<double> numbers;
        bool varies = false;
    };
    std::vector<Values> parameters_, overrides_;
    std::vector<double> parameterSlopes_, overrideSlopes_;
};

struct EscapeResult {
    std::vector<std::int32_t> steps;
    std::vector<char> escaped;
    std::vector<double> squaredNorm;  // of the last iterate
};

// Runs the escape kernel; afterwards the states are the last iterates (for orbits that do not
// escape only with needLast).
EscapeResult runEscape(const OrbitProgram& program, OrbitLanes& lanes, bool needLast,
                       const EvaluateOptions& options);

}  // namespace versorium
