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

    // All orbits at `from`'s states again. Both must be of the same points.
    void startAt(const OrbitLanes& from) { states_ = from.states_; }
    // Steps of all orbits, escaped or not.
    void advance(int steps);
    // Derivatives along an axis of the slice (of the start itself where it moves), then steps that
    // carry them on. `axis` < 0: state slopes are the caller's, parameters stand still.
    void seedSlopes(int axis);
    void advanceDual();

    // The batch with pointers into this object; valid until it changes.
    OrbitBatch<double> batch(bool withSlopes = false);
    void escape(OrbitBatch<double>& batch) const { target_->escape[program_->map->index](batch); }

  private:
    void fillStart(const double* const* coordinates);
    void criticalStart(int axis);

    const OrbitProgram* program_;
    const KernelTarget* target_;
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
    // Of the one before, where the orbit escaped and the program measures its growth.
    std::vector<double> previousNorm;
};

// What is read of the states after runEscape: nothing, those of orbits that escaped, or all.
enum class Needed { steps, escaped, last };

// Runs the escape kernel, as often as wanted; afterwards the states are the last iterates, as far
// as they are needed.
class EscapeRun {
  public:
    // `capture`: orbits within this distance of 0 never escape; 0 where nothing is known.
    EscapeRun(const OrbitProgram& program, const EvaluateOptions& options, double capture = 0)
        : program_(&program), options_(&options), capture_(capture) {}
    // The result is valid until the next run. Without Needed::last or Needed::escaped its squared
    // norms mean nothing.
    const EscapeResult& run(OrbitLanes& lanes, Needed needed);

  private:
    const OrbitProgram* program_;
    const EvaluateOptions* options_;
    double capture_;
    std::vector<double> scratch_;
    std::vector<std::int32_t> index_;
    EscapeResult result_;
};

}  // namespace versorium
