// SPDX-License-Identifier: MIT
#pragma once
// A formula that a user typed, as a map like those of the catalogue: a row of kernels that run its
// tape. Its name is "formula"; what tells one from another is the text.

#include <memory>

#include "maps/catalogue.h"
#include "math/complex.h"
#include "trace/formula.h"

namespace versorium {

inline constexpr std::string_view kFormulaName = "formula";

class FormulaMap : public std::enable_shared_from_this<FormulaMap> {
  public:
    // The same text gives the same object while it is among the last ones that were asked for. A
    // reference to a map stays good that long as well.
    static Expected<std::shared_ptr<const FormulaMap>> make(std::string_view text,
                                                            FormulaFault* fault = nullptr);

    FormulaMap(const FormulaMap&) = delete;
    const MapKernels& kernels() const { return *kernels_; }
    const Formula& formula() const { return formula_; }
    const TapeCode& code() const { return code_; }
    // The coefficients of the derivative, constant first; empty where it is no polynomial.
    std::vector<Complex<double>> slope(const double* parameters) const;

  private:
    FormulaMap() = default;
    void describe();

    Formula formula_;
    TapeProgram program_, slopeProgram_;
    TapeCode code_;
    std::vector<ParameterInfo> parameters_;
    MapInfo info_;
    std::unique_ptr<MapKernels> kernels_;
};

}  // namespace versorium
