// SPDX-License-Identifier: MIT
#include "render/glsl/colour_shader.h"

#include "colour/rules.h"
#include "colour/scale.h"
#include "fields/field_names.h"
#include "render/glsl/shader.h"

namespace versorium {
namespace {

constexpr const char* kFieldText = R"(
uniform sampler2D uFields;
uniform sampler2D uImage;
uniform int uDimension;
uniform float uIterations;
uniform float uSquaredRadius;
uniform bool uBoundless;      // the escape radius is infinite
uniform bool uOnlyLast;
uniform float uTwiceLogRadius;
uniform float uLogDegree;
uniform float uIso;
uniform float uMembers;       // that an averaged map has counted

const float kPi = 3.14159265358979;

bool isUndefined(float x) {
    return (floatBitsToUint(x) & 0x7fffffffu) > 0x7f800000u;
}
bool isInfinite(float x) {
    return (floatBitsToUint(x) & 0x7fffffffu) == 0x7f800000u;
}
float undefinedValue() {
    return uintBitsToFloat(0x7fc00000u);
}
float logarithm(float x) {
    if (isInfinite(x) && x > 0.0) return x;
    return x > 0.0 ? log(x) : x == 0.0 ? uintBitsToFloat(0xff800000u) : undefinedValue();
}
// Growth that is measured along the orbit (fields/evaluate.cpp, measuredStep).
float measuredStepOf(float n, float norm, float previous) {
    if (uBoundless) return n;
    // In 32 bits a norm may be undefined because it overflowed on the way.
    float last = log(1.0 + (isUndefined(norm) ? 1e36 : min(norm, 1e36)));
    float before = log(1.0 + previous);
    if (!(before > 0.0) || !(last > before)) return n + 1.0;
    return n + 1.0 - clamp(log(last / log(1.0 + uSquaredRadius)) / log(last / before), 0.0, 1.0);
}
float smoothStepOf(float n, float norm) {
    if (uBoundless || uTwiceLogRadius < 0.0) return n + 1.0;
    // In 32 bits a norm is undefined because it overflowed on the way.
    if (isUndefined(norm)) return n;
    if (uTwiceLogRadius == 0.0) return norm > 1.0 ? n : n + 1.0;
    if (isInfinite(norm)) return n;
    float ratio = logarithm(norm) / uTwiceLogRadius;
    if (!(ratio > 1.0)) return n + 1.0;
    return n + clamp(1.0 - log(ratio) / uLogDegree, 0.0, 1.0);
}
// Scaled, so that squares do not overflow.
float modulusOf(vec4 image) {
    float most = 0.0;
    for (int k = 0; k < 4; ++k) {
        if (isUndefined(image[k])) return undefinedValue();
        most = max(most, abs(image[k]));
    }
    return most == 0.0 || isInfinite(most) ? most : most * length(image / most);
}
vec4 versorOf(vec4 image) {
    float modulus = modulusOf(image);
    if (isUndefined(modulus) || modulus == 0.0) return vec4(undefinedValue());
    if (!isInfinite(modulus)) return image / modulus;
    vec4 versor;
    for (int k = 0; k < 4; ++k) versor[k] = isInfinite(image[k]) ? undefinedValue() : 0.0;
    return versor;
}
float argumentOf(vec4 image) {
    float y = uDimension > 1 ? image.y : 0.0;
    if (isUndefined(image.x) || isUndefined(y)) return undefinedValue();
    return image.x == 0.0 && y == 0.0 ? 0.0 : atan(y, image.x);
}
bool escapedOf(vec4 kept) {
    if (!uOnlyLast) return kept.z != 0.0;
    return isUndefined(kept.y) || !(uBoundless || kept.y <= uSquaredRadius);
}
float fieldOf(int field, vec4 kept, vec4 image) {
    bool escaped = escapedOf(kept);
    float n = uOnlyLast ? uIterations : min(kept.x, uIterations);
    switch (field) {
        case MEMBERSHIP: return escaped ? 0.0 : 1.0;
        case ESCAPE_STEP: return n;
        case SMOOTH_ESCAPE:
            if (!escaped) return n;
            return uLogDegree > 0.0 || uOnlyLast ? smoothStepOf(n, kept.y)
                                                 : measuredStepOf(n, kept.y, kept.w);
        case SQUARED_NORM: return kept.y;
        case LOG_MODULUS: return 0.5 * logarithm(kept.y);
        case SOLID: return 0.5 * logarithm(kept.y) < uIso && !isUndefined(kept.y) ? 1.0 : 0.0;
        case ATTRACTION_STEP:
            return escaped ? undefinedValue() : kept.w > 0.0 ? kept.w : uIterations;
        case IMAGE_MODULUS: return modulusOf(image);
        case ARGUMENT: return argumentOf(image);
        case MEAN_MEMBERSHIP: return kept.x / uMembers;
        case STANDARD_ERROR: {
            if (uMembers < 2.0) return undefinedValue();
            float mean = kept.x / uMembers;
            return sqrt(mean * (1.0 - mean) / (uMembers - 1.0));
        }
        default: return 0.0;
    }
}
)";

constexpr const char* kColourText = R"(
uniform int uRule;
uniform int uShown;
uniform int uInterior;        // a field, or -1
uniform int uScale;
uniform vec2 uRange;          // where the scale is linear
uniform sampler2D uPalette;   // linear light, straight alpha
uniform bool uCyclicPalette;
uniform bool uSteppedPalette;
uniform vec4 uInteriorColour;
uniform vec4 uUndefinedColour;
uniform vec3 uBackground;
uniform vec4 uEscaped[2];     // display values
uniform vec4 uAttracted[2];
uniform vec2 uExponents;      // of the escaped and of the attracted region
uniform int uSmoothing;       // 0 none, 1 ratio, 2 log-log
uniform bool uAttractedVaries;
uniform int uSamples;         // along each side of a pixel
uniform ivec2 uSize;          // of the picture
uniform int uContourCount;
uniform float uContours[MOST_CONTOURS];
uniform float uLineReach;     // in samples: where a line covers nothing any more
uniform vec4 uLineColour;

out vec4 outColour;

vec3 linearFromSrgb(vec3 c) {
    return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), greaterThan(c, vec3(0.04045)));
}
vec3 srgbFromLinear(vec3 c) {
    c = clamp(c, 0.0, 1.0);
    return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055,
               greaterThan(c, vec3(0.0031308)));
}
float straighten(float value) {
    if (uScale == SCALE_LOG || uScale == SCALE_TRUNCATED_LOG) return logarithm(max(value, 0.0));
    return uScale == SCALE_SQRT ? sign(value) * sqrt(abs(value)) : value;
}
float positionOf(float value) {
    if (isUndefined(value)) return value;
    float x = straighten(value);
    bool upwards = uRange.y > uRange.x;
    if (isInfinite(x)) {
        if (uScale == SCALE_CYCLIC) return undefinedValue();
        return (x > 0.0) == upwards ? 1.0 : 0.0;
    }
    float t = (x - uRange.x) / (uRange.y - uRange.x);
    return uScale == SCALE_CYCLIC ? fract(t) : clamp(t, 0.0, 1.0);
}
vec4 paletteAt(float position) {
    if (isUndefined(position)) return uUndefinedColour;
    int last = textureSize(uPalette, 0).x - 1;
    float t = (uCyclicPalette ? fract(position) : clamp(position, 0.0, 1.0)) * float(last);
    if (uSteppedPalette) return texelFetch(uPalette, ivec2(int(t + 0.5), 0), 0);
    int cell = min(int(t), last - 1);
    return mix(texelFetch(uPalette, ivec2(cell, 0), 0),
               texelFetch(uPalette, ivec2(cell + 1, 0), 0), t - float(cell));
}
vec4 gradientAt(vec4 start, vec4 finish, float exponent, float fraction) {
    float t = isUndefined(fraction) ? 0.0 : clamp(fraction, 0.0, 1.0);
    vec4 c = clamp(start - t * (start - finish), 0.0, 1.0);
    if (exponent != 1.0)
        for (int k = 0; k < 3; ++k) c[k] = c[k] > 0.0 ? pow(c[k], exponent) : 0.0;
    return vec4(linearFromSrgb(c.rgb), c.a);
}
// A 4.3, eqs 14 and 15.
vec4 gradientColour(vec4 kept, vec4 image) {
    if (!escapedOf(kept)) {
        float step = uAttractedVaries ? fieldOf(ATTRACTION_STEP, kept, image) : 0.0;
        return gradientAt(uAttracted[0], uAttracted[1], uExponents.y, step / max(uIterations, 1.0));
    }
    float n = fieldOf(ESCAPE_STEP, kept, image);
    if (uSmoothing == 2)
        return gradientAt(uEscaped[0], uEscaped[1], uExponents.x,
                          log(1.0 + fieldOf(SMOOTH_ESCAPE, kept, image)) /
                              log(1.0 + max(uIterations, 1.0)));
    float excess = 0.0;
    if (uSmoothing == 1 && !isUndefined(kept.y) && kept.y > 0.0 && !isInfinite(kept.y))
        excess = uSquaredRadius / kept.y;
    return gradientAt(uEscaped[0], uEscaped[1], uExponents.x, (n + excess) / max(uIterations, 1.0));
}
vec4 versorColour(vec4 image) {
    vec4 v = versorOf(image);
    for (int k = 0; k < 4; ++k) v[k] = isUndefined(v[k]) ? 0.0 : v[k];
    vec3 parts = uDimension == 1   ? v.xxx
                 : uDimension == 2 ? vec3(v.xy, 0.0)
                 : uDimension == 3 ? v.xyz
                                   : v.yzw;
    return vec4(linearFromSrgb(clamp(0.5 * (parts + 1.0), 0.0, 1.0)), 1.0);
}
vec4 domainColour(float modulus, float angle) {
    if (isUndefined(modulus) || isUndefined(angle)) return uUndefinedColour;
    if (modulus == 0.0) return vec4(0.0, 0.0, 0.0, 1.0);
    if (isInfinite(modulus)) return vec4(1.0);
    vec4 c = paletteAt(angle / (2.0 * kPi));
    float ring = fract(log2(modulus)), ray = fract(angle * 6.0 / kPi);
    float light = mix(0.55, 1.0, ring) * mix(0.82, 1.0, ray);
    return vec4(linearFromSrgb(srgbFromLinear(c.rgb) * light), c.a);
}
vec4 colourOf(vec4 kept, vec4 image) {
    if (uRule == RULE_GRADIENT) return gradientColour(kept, image);
    if (uRule == RULE_VERSOR) return versorColour(image);
    if (uRule == RULE_PHASE) {
        float angle = argumentOf(image);
        return isUndefined(angle) ? uUndefinedColour : paletteAt(angle / (2.0 * kPi));
    }
    if (uRule == RULE_DOMAIN) return domainColour(modulusOf(image), argumentOf(image));
    if (uInterior >= 0 && fieldOf(uInterior, kept, image) != 0.0) return uInteriorColour;
    // A versor on a scale shows its first component.
    float value = uShown == VERSOR ? versorOf(image).x : fieldOf(uShown, kept, image);
    return paletteAt(positionOf(value));
}
// How many levels the value of a sample reaches.
int sideOf(ivec2 at) {
    vec4 image = texelFetch(uImage, at, 0);
    float value = uShown == VERSOR ? versorOf(image).x
                                   : fieldOf(uShown, texelFetch(uFields, at, 0), image);
    if (isUndefined(value)) return 0;
    int side = 0;
    for (int k = 0; k < uContourCount; ++k)
        if (value >= uContours[k]) ++side;
    return side;
}
// How much of a sample is covered by lines, which run between neighbours on different sides.
float lineAt(ivec2 at) {
    ivec2 last = textureSize(uFields, 0) - 1;
    int reach = int(ceil(uLineReach));
    float covered = 0.0;
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x) {
            ivec2 there = at + ivec2(x, y);
            if (any(lessThan(there, ivec2(0))) || any(greaterThan(there, last))) continue;
            float across = uLineReach - length(vec2(float(x) + 0.5, float(y)));
            float up = uLineReach - length(vec2(float(x), float(y) + 0.5));
            if (max(across, up) <= covered) continue;
            int side = sideOf(there);
            if (there.x < last.x && side != sideOf(there + ivec2(1, 0)))
                covered = max(covered, across);
            if (there.y < last.y && side != sideOf(there + ivec2(0, 1)))
                covered = max(covered, up);
        }
    return clamp(covered, 0.0, 1.0);
}
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 first = ivec2(pixel.x, uSize.y - 1 - pixel.y) * uSamples;
    if (uRule == RULE_RAW) {
        vec4 image = texelFetch(uImage, first, 0);
        outColour = uShown == VERSOR ? versorOf(image)
                                     : vec4(fieldOf(uShown, texelFetch(uFields, first, 0), image));
        return;
    }
    vec3 light = vec3(0.0);
    float line = 0.0;
    for (int y = 0; y < uSamples; ++y)
        for (int x = 0; x < uSamples; ++x) {
            ivec2 at = first + ivec2(x, y);
            vec4 c = colourOf(texelFetch(uFields, at, 0), texelFetch(uImage, at, 0));
            light += mix(uBackground, c.rgb, c.a);
            if (uContourCount > 0) line += lineAt(at);
        }
    float parts = float(uSamples * uSamples);
    light = mix(light / parts, uLineColour.rgb, uLineColour.a * line / parts);
    outColour = vec4(srgbFromLinear(light), 1.0);
}
)";

void define(std::string& text, const char* name, int value) {
    text += "#define " + std::string(name) + " " + std::to_string(value) + "\n";
}

}  // namespace

std::string colourShader() {
    std::string text = kShaderHead;
    const auto field = [&](const char* name, FieldName value) {
        define(text, name, static_cast<int>(value));
    };
    field("MEMBERSHIP", FieldName::membership);
    field("SOLID", FieldName::solid);
    field("ESCAPE_STEP", FieldName::escapeStep);
    field("SMOOTH_ESCAPE", FieldName::smoothEscape);
    field("SQUARED_NORM", FieldName::squaredNorm);
    field("ATTRACTION_STEP", FieldName::attractionStep);
    field("LOG_MODULUS", FieldName::logModulus);
    field("IMAGE_MODULUS", FieldName::imageModulus);
    field("VERSOR", FieldName::versor);
    field("ARGUMENT", FieldName::argument);
    field("MEAN_MEMBERSHIP", FieldName::meanMembership);
    field("STANDARD_ERROR", FieldName::standardError);
    define(text, "MOST_CONTOURS", kMostGpuContours);
    define(text, "SCALE_LOG", static_cast<int>(ScaleKind::log));
    define(text, "SCALE_TRUNCATED_LOG", static_cast<int>(ScaleKind::truncatedLog));
    define(text, "SCALE_SQRT", static_cast<int>(ScaleKind::sqrt));
    define(text, "SCALE_CYCLIC", static_cast<int>(ScaleKind::cyclic));
    define(text, "RULE_GRADIENT", static_cast<int>(ColourRule::gradient));
    define(text, "RULE_VERSOR", static_cast<int>(ColourRule::versor));
    define(text, "RULE_PHASE", static_cast<int>(ColourRule::phase));
    define(text, "RULE_DOMAIN", static_cast<int>(ColourRule::domain));
    define(text, "RULE_RAW", kRawRule);
    return text + kFieldText + kColourText;
}

}  // namespace versorium
