// SPDX-License-Identifier: MIT
#pragma once
// The second pass: fields become colours. Nothing is iterated here.

#include <span>
#include <vector>

#include "colour/palette.h"
#include "fields/evaluate.h"
#include "scene/scene.h"

namespace versorium {

class ColourPass {
  public:
    static Expected<ColourPass> make(const Scene& scene, const OrbitProgram& program);

    // What has to be measured, in the order in which `colour` takes it.
    const std::vector<FieldName>& fields() const { return fields_; }
    // Linear light, straight alpha. values[f][channel * count + i] for the i-th of count points.
    Colour colour(const std::vector<std::vector<double>>& values, std::size_t count,
                  std::size_t i) const;
    // Where the point lies between the contours of the shown field (how many levels its value
    // reaches), and whether it is in the outlined set: lines run where this differs between
    // neighbours. 0 without lines.
    unsigned char side(const std::vector<std::vector<double>>& values, std::size_t i) const;
    bool hasLines() const { return outlineField_ >= 0 || !contours_.empty(); }
    Colour outlineColour() const { return outlineColour_; }

    // Of the palette rule.
    const Scale& scale() const { return scale_; }
    const Palette& palette() const { return palette_; }
    FieldName shown() const { return shown_; }

  private:
    int ask(FieldName field);
    Colour gradient(const std::vector<std::vector<double>>& values, std::size_t i) const;

    ColourRule rule_ = ColourRule::palette;
    FieldName shown_ = FieldName::smoothEscape;
    std::vector<FieldName> fields_;
    int shownAt_ = -1, interiorField_ = -1, outlineField_ = -1;
    int stepsAt_ = -1, normAt_ = -1, memberAt_ = -1, attractedAt_ = -1, smoothAt_ = -1,
        modulusAt_ = -1;
    Scale scale_;
    Palette palette_;
    Colour outlineColour_;
    std::vector<double> contours_;
    Gradient escaped_, attracted_;
    Smoothing smoothing_ = Smoothing::ratio;
    double iterations_ = 1, squaredRadius_ = 4;
    int dimension_ = 2;
};

}  // namespace versorium
