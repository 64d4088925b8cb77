// SPDX-License-Identifier: MIT
#include "render/colouring.h"

#include <algorithm>
#include <cmath>

namespace versorium {
namespace {

constexpr double kPi = 3.14159265358979323846;

// The scale that suits a field when the scene names none.
Scale defaultScale(FieldName field, const OrbitProgram& program, double height) {
    const double n = std::max(2, program.iterations);
    switch (field) {
        case FieldName::escapeStep:
        case FieldName::smoothEscape:
            return {ScaleKind::log, 1, n};
        case FieldName::attractionStep:
            return {ScaleKind::log, 1, n};
        case FieldName::squaredNorm:
            return {ScaleKind::log, 1e-3, 1e3};
        case FieldName::logModulus:
            return {ScaleKind::linear, -8, 8};
        case FieldName::imageModulus:
            return {ScaleKind::truncatedLog, -8, 8};
        case FieldName::versor:
            return {ScaleKind::linear, -1, 1};
        case FieldName::argument:
            return {ScaleKind::cyclic, -kPi, kPi};
        case FieldName::distance:
            return {ScaleKind::log, 1e-4 * height, 0.25 * height};
        case FieldName::lyapunov:
            return {ScaleKind::linear, -1, 1};
        case FieldName::standardError:
            return {ScaleKind::linear, 0, 0.02};
        case FieldName::period:
            return {ScaleKind::linear, 0, 16};
        default:
            return {ScaleKind::linear, 0, 1};
    }
}

bool usable(const Colouring& colouring) { return !colouring.range.empty(); }

}  // namespace

int ColourPass::ask(FieldName field) {
    const auto found = std::find(fields_.begin(), fields_.end(), field);
    if (found != fields_.end()) return static_cast<int>(found - fields_.begin());
    fields_.push_back(field);
    return static_cast<int>(fields_.size()) - 1;
}

Expected<ColourPass> ColourPass::make(const Scene& scene, const OrbitProgram& program) {
    const Colouring& colouring = scene.colour;
    ColourPass pass;
    pass.rule_ = colouring.rule;
    pass.shown_ = colouring.field;
    pass.dimension_ = program.map->dimension;
    pass.iterations_ = program.iterations;
    pass.squaredRadius_ = program.escapeRadius * program.escapeRadius;
    pass.escaped_ = colouring.escaped;
    pass.attracted_ = colouring.attracted;
    pass.smoothing_ = colouring.smoothing;

    Expected<Palette> palette = colouring.ownPalette.is_null()
                                    ? paletteNamed(colouring.palette)
                                    : paletteFromJson(colouring.ownPalette);
    if (!palette) return palette.status();
    pass.palette_ = std::move(*palette);
    pass.scale_ = defaultScale(pass.shown_, program, scene.slice.height);
    if (colouring.scale) pass.scale_.kind = *colouring.scale;
    if (usable(colouring))
        pass.scale_.low = colouring.range[0], pass.scale_.high = colouring.range[1];
    if (colouring.reverse) std::swap(pass.scale_.low, pass.scale_.high);
    if (Status status = pass.scale_.check(); !status.ok()) return status.in("colour.range");

    if (colouring.rule == ColourRule::gradient) {
        pass.memberAt_ = pass.ask(FieldName::membership);
        pass.stepsAt_ = pass.ask(FieldName::escapeStep);
        if (colouring.smoothing == Smoothing::ratio)
            pass.normAt_ = pass.ask(FieldName::squaredNorm);
        if (colouring.smoothing == Smoothing::logLog)
            pass.smoothAt_ = pass.ask(FieldName::smoothEscape);
        // One colour for the whole attracted region needs no look at its steps.
        if (!(colouring.attracted.start == colouring.attracted.finish))
            pass.attractedAt_ = pass.ask(FieldName::attractionStep);
    } else if (colouring.rule == ColourRule::versor) {
        pass.shown_ = FieldName::versor;
        pass.shownAt_ = pass.ask(FieldName::versor);
    } else if (colouring.rule == ColourRule::phase || colouring.rule == ColourRule::domain) {
        if (pass.rule_ == ColourRule::domain) pass.modulusAt_ = pass.ask(FieldName::imageModulus);
        pass.shown_ = FieldName::argument;
        pass.shownAt_ = pass.ask(FieldName::argument);
        pass.scale_ = {ScaleKind::cyclic, -kPi, kPi};
    } else {
        pass.shownAt_ = pass.ask(pass.shown_);
        if (const auto inside = fieldOf(colouring.interior))
            pass.interiorField_ = pass.ask(*inside);
    }
    if (pass.shownAt_ >= 0) pass.contours_ = colouring.contours;
    if (const auto outlined = fieldOf(colouring.outline)) pass.outlineField_ = pass.ask(*outlined);
    pass.outlineColour_ = *colourFromHex(colouring.outlineColour);
    return pass;
}

Colour ColourPass::gradient(const std::vector<std::vector<double>>& values, std::size_t i) const {
    const auto at = [&](int field) { return values[static_cast<std::size_t>(field)][i]; };
    if (at(memberAt_) != 0) {
        const double step = attractedAt_ >= 0 ? at(attractedAt_) : 0;
        return bandedColour(attracted_, step, iterations_);
    }
    if (normAt_ >= 0)
        return smoothedColour(escaped_, at(stepsAt_), at(normAt_), squaredRadius_, iterations_);
    if (smoothAt_ >= 0)
        return gradientColour(escaped_, logEscapePosition(at(smoothAt_), iterations_));
    return bandedColour(escaped_, at(stepsAt_), iterations_);
}

Colour ColourPass::colour(const std::vector<std::vector<double>>& values, std::size_t count,
                          std::size_t i) const {
    switch (rule_) {
        case ColourRule::gradient:
            return gradient(values, i);
        case ColourRule::versor: {
            const auto& versor = values[static_cast<std::size_t>(shownAt_)];
            // The complex numbers have one imaginary part only; the real part is shown as well.
            if (dimension_ == 2) return versorColour(versor[i], versor[count + i], 0);
            if (dimension_ == 3)
                return versorColour(versor[i], versor[count + i], versor[2 * count + i]);
            if (dimension_ == 1) return versorColour(versor[i], versor[i], versor[i]);
            return versorColour(versor[count + i], versor[2 * count + i], versor[3 * count + i]);
        }
        case ColourRule::phase:
            return phaseColour(palette_, values[static_cast<std::size_t>(shownAt_)][i]);
        case ColourRule::domain:
            return domainColour(palette_, values[static_cast<std::size_t>(modulusAt_)][i],
                                values[static_cast<std::size_t>(shownAt_)][i]);
        default:
            break;
    }
    if (interiorField_ >= 0 && values[static_cast<std::size_t>(interiorField_)][i] != 0)
        return palette_.interior;
    const double value = values[static_cast<std::size_t>(shownAt_)][i];
    return palette_.at(scale_.position(value));
}

unsigned char ColourPass::side(const std::vector<std::vector<double>>& values,
                               std::size_t i) const {
    const auto at = [&](int field) { return values[static_cast<std::size_t>(field)][i]; };
    int reached = 0;
    for (double level : contours_) reached += at(shownAt_) >= level;
    const bool inside = outlineField_ >= 0 && at(outlineField_) != 0;
    return static_cast<unsigned char>(2 * reached + inside);
}

}  // namespace versorium
