// SPDX-License-Identifier: MIT
#include "render/shape_profile.h"

#include <algorithm>
#include <cmath>

#include "scene/shape_controls.h"
#include "shape/bounds.h"

namespace versorium {

RadialOptions radialOptions(const Scene& scene, double escapeRadius) {
    RadialOptions options;
    options.dimensions = mapOf(scene).info.algebra == Algebra::complex ? 2 : 3;
    const ShapeControls controls = shapeControls(scene);
    options.alpha = controls.alpha;
    options.beta = controls.beta;
    options.asPrinted = controls.asPrinted;
    options.escapeRadius = escapeRadius;
    options.shift = controls.seenShift();
    return options;
}

double shapeReach(const DistanceField& field, const RadialOptions& options) {
    const ShapeBounds bounds = boundsOf(field, options.dimensions);
    double square = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(options.dimensions); ++k) {
        const double far = std::max(std::abs(bounds.low[k] + options.shift[k]),
                                    std::abs(bounds.high[k] + options.shift[k]));
        square += far * far;
    }
    return std::sqrt(square);
}

Expected<RadialProfile> shapeProfile(Binder& binder, const Scene& scene, double to, int radii,
                                     Job& job) {
    if (!mapOf(scene).info.field)
        return Status::usage("the map \"" + scene.map +
                             "\" has no shape; a shape-modulus map is expected");
    Expected<OrbitProgram> program = binder.bind(scene, job);
    if (!program) return program.status();
    RadialOptions options = radialOptions(scene, program->escapeRadius);
    options.radii = radii;
    options.to = to > 0 ? to : 1.5 * shapeReach(*program->field, options);
    return radialProfile(*program->field, options, job);
}

std::string profileCsv(const RadialProfile& profile) {
    std::string text = "radius,mean_phi,low,high,modulus\n";
    for (std::size_t i = 0; i < profile.radius.size(); ++i)
        text += formatNumber(profile.radius[i]) + "," + formatNumber(profile.mean[i]) + "," +
                formatNumber(profile.low[i]) + "," + formatNumber(profile.high[i]) + "," +
                formatNumber(profile.modulus[i]) + "\n";
    return text;
}

}  // namespace versorium
