// SPDX-License-Identifier: MIT
#include "render/glsl/shader.h"

#include <algorithm>

#include "maps/bound.h"
#include "trace/glsl.h"

namespace versorium {

const char* const kShaderHead = R"(#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler3D;
)";

namespace {

// Functions with the meaning that the CPU's have (math/power.h, shape/field.h).
constexpr const char* kLibrary = R"(
uniform sampler2D uRoots;
uniform int uListSize[2];
uniform sampler3D uGrid;
uniform vec3 uGridMinimum;
uniform vec3 uGridMaximum;
uniform bool uOutsideAddsDistance;
uniform ivec3 uOverride[4];
uniform int uOverrideCount;

float overrideValue[4];

float v_log(float x) {
    return x > 0.0 ? log(x) : uintBitsToFloat(x == 0.0 ? 0xff800000u : 0x7fc00000u);
}
float v_pow(float x, float y) {
    if (y == 0.0) return 1.0;
    if (x == 0.0) return y > 0.0 ? 0.0 : uintBitsToFloat(0x7f800000u);
    return x > 0.0 ? pow(x, y) : uintBitsToFloat(0x7fc00000u);
}
float v_atan2(float y, float x) {
    return x == 0.0 && y == 0.0 ? 0.0 : atan(y, x);
}
// GLSL ES promises 11 bits of a sine: the series about 0, after whole quarters of a turn are gone.
float v_quarter(float x, float quarter) {
    if (!(abs(x) < 1024.0)) return quarter == 0.0 ? sin(x) : cos(x);
    float n = floor(x * 0.636619772 + 0.5);
    float r = ((x - n * 1.5703125) - n * 4.837512969970703e-4) - n * 7.549790126e-8;
    float s = r * r;
    float sine = r + r * s * (-0.16666667 + s * (8.3333333e-3 + s * (-1.98412698e-4 + s * 2.7557319e-6)));
    float cosine = 1.0 + s * (-0.5 + s * (4.1666667e-2 + s * (-1.38888889e-3 + s * (2.48015873e-5 - s * 2.75573192e-7))));
    float turns = n + quarter - 4.0 * floor(0.25 * (n + quarter));
    float value = turns == 1.0 || turns == 3.0 ? cosine : sine;
    return turns < 2.0 ? value : -value;
}
float v_sin(float x) {
    return v_quarter(x, 0.0);
}
float v_cos(float x) {
    return v_quarter(x, 1.0);
}
vec2 complexProduct(vec2 a, vec2 b) {
    return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}
vec4 quaternionProduct(vec4 a, vec4 b) {
    return vec4(a.x * b.x - a.y * b.y - a.z * b.z - a.w * b.w,
                a.x * b.y + a.y * b.x + a.z * b.w - a.w * b.z,
                a.x * b.z - a.y * b.w + a.z * b.x + a.w * b.y,
                a.x * b.w + a.y * b.z - a.z * b.y + a.w * b.x);
}
bool isWhole(float e) {
    return floor(abs(e)) == abs(e) && abs(e) <= 256.0;
}
vec2 complexPower(vec2 z, float e) {
    if (!isWhole(e)) {
        float modulus = v_pow(length(z), e);
        float turn = e * v_atan2(z.y, z.x);
        return modulus * vec2(v_cos(turn), v_sin(turn));
    }
    vec2 result = vec2(1.0, 0.0);
    for (int left = int(abs(e)); left > 0; left >>= 1) {
        if ((left & 1) == 1) result = complexProduct(result, z);
        z = complexProduct(z, z);
    }
    return e < 0.0 ? vec2(result.x, -result.y) / dot(result, result) : result;
}
vec4 quaternionPower(vec4 q, float e) {
    if (!isWhole(e)) {
        float modulus = v_pow(length(q), e);
        float size = length(q.yzw);
        float turn = e * v_atan2(size, q.x);
        float scale = size == 0.0 ? 0.0 : modulus * v_sin(turn) / size;
        return vec4(modulus * v_cos(turn), scale * q.yzw);
    }
    vec4 result = vec4(1.0, 0.0, 0.0, 0.0);
    for (int left = int(abs(e)); left > 0; left >>= 1) {
        if ((left & 1) == 1) result = quaternionProduct(result, q);
        q = quaternionProduct(q, q);
    }
    return e < 0.0 ? vec4(result.x, -result.yzw) / dot(result, result) : result;
}
)";

constexpr const char* kLists = R"(
int listSize(int list) {
    return uListSize[list];
}
float listItem(int list, int item, int component) {
    for (int k = 0; k < uOverrideCount; ++k)
        if (uOverride[k] == ivec3(list, item, component)) return overrideValue[k];
    if (component == 4) return texelFetch(uRoots, ivec2(item, 2 * list + 1), 0).x;
    return texelFetch(uRoots, ivec2(item, 2 * list), 0)[component];
}
)";

// One list may be drawn anew for each member.
constexpr const char* kMemberLists = R"(
uniform int uDrawnList;

int memberRow = 0;
int memberSize = 0;

int listSize(int list) {
    return list == uDrawnList ? memberSize : uListSize[list];
}
float listItem(int list, int item, int component) {
    // What is drawn is never set otherwise. Of roots in the plane the power lies in the same texel.
    if (list == uDrawnList) {
        if (component < 4) return texelFetch(uRoots, ivec2(item, memberRow), 0)[component];
        return D <= 2 ? texelFetch(uRoots, ivec2(item, memberRow), 0).z
                      : texelFetch(uRoots, ivec2(item, memberRow + 1), 0).x;
    }
    for (int k = 0; k < uOverrideCount; ++k)
        if (uOverride[k] == ivec3(list, item, component)) return overrideValue[k];
    if (component == 4) return texelFetch(uRoots, ivec2(item, 2 * list + 1), 0).x;
    return texelFetch(uRoots, ivec2(item, 2 * list), 0)[component];
}
)";

// The distance field as a stored grid; a planar one ignores z.
constexpr const char* kGridField = R"(
float fieldAt(vec3 p) {
    ivec3 nodes = textureSize(uGrid, 0);
    if (nodes.z == 1) p.z = 0.5 * (uGridMinimum.z + uGridMaximum.z);
    vec3 u = clamp((p - uGridMinimum) / (uGridMaximum - uGridMinimum), 0.0, 1.0) * vec3(nodes - 1);
    ivec3 cell = clamp(ivec3(floor(u)), ivec3(0), max(nodes - 2, 0));
    vec3 t = u - vec3(cell);
    ivec3 far = min(cell + 1, nodes - 1);
    float x00 = mix(texelFetch(uGrid, cell, 0).x, texelFetch(uGrid, ivec3(far.x, cell.yz), 0).x, t.x);
    float x10 = mix(texelFetch(uGrid, ivec3(cell.x, far.y, cell.z), 0).x,
                    texelFetch(uGrid, ivec3(far.xy, cell.z), 0).x, t.x);
    float x01 = mix(texelFetch(uGrid, ivec3(cell.xy, far.z), 0).x,
                    texelFetch(uGrid, ivec3(far.x, cell.y, far.z), 0).x, t.x);
    float x11 = mix(texelFetch(uGrid, ivec3(cell.x, far.yz), 0).x, texelFetch(uGrid, far, 0).x, t.x);
    float value = mix(mix(x00, x10, t.y), mix(x01, x11, t.y), t.z);
    vec3 beyond = max(vec3(0.0), max(uGridMinimum - p, p - uGridMaximum));
    return uOutsideAddsDistance ? value + length(beyond) : value;
}

)";

// What the iteration and the counting begin with. COUNT numbers fix an orbit: D of the state, P
// parameters, 4 overrides. uNumbers holds each number of an orbit at the
// middle of the picture, and what it grows by from pixel to pixel to the right and up. Comparisons
// with NaN are what optimisers get wrong, so its bits are looked at.
constexpr const char* kOrbit = R"(
uniform vec4 uNumbers[COUNT];
uniform vec2 uSize;
uniform int uIterations;
uniform bool uFirst;
uniform bool uBounded;
uniform float uSquaredRadius;
uniform sampler2D uFields;

layout(location = 0) out vec4 outFields;
layout(location = 1) out vec4 outState;
layout(location = 2) out vec4 outImage;

bool isUndefined(float x) {
    return (floatBitsToUint(x) & 0x7fffffffu) > 0x7f800000u;
}
bool within(float norm) {
    return !isUndefined(norm) && (!uBounded || norm <= uSquaredRadius);
}
float squaredNorm(float state[D]) {
    float sum = 0.0;
    for (int k = 0; k < D; ++k) sum += state[k] * state[k];
    return sum;
}
float number(int k, vec2 at) {
    return uNumbers[k].x + at.x * uNumbers[k].y + at.y * uNumbers[k].z;
}
)";

// One draw of the iteration: a number of steps from where the last draw ended.
constexpr const char* kIteration = R"(
uniform int uSteps;
uniform sampler2D uState;

vec4 packed4(float state[D]) {
    return vec4(state[0], D > 1 ? state[min(1, D - 1)] : 0.0, D > 2 ? state[min(2, D - 1)] : 0.0,
                D > 3 ? state[D - 1] : 0.0);
}
void main() {
    vec2 at = gl_FragCoord.xy - 0.5 * uSize;
    float state[D];
    float parameters[P];
    for (int k = 0; k < P; ++k) parameters[k] = number(D + k, at);
    for (int k = 0; k < 4; ++k) overrideValue[k] = number(D + P + k, at);
    float n = 0.0;
    float attraction = 0.0;
    float norm;
    if (uFirst) {
        for (int k = 0; k < D; ++k) state[k] = number(k, at);
        norm = squaredNorm(state);
    } else {
        vec4 fields = texelFetch(uFields, ivec2(gl_FragCoord.xy), 0);
        vec4 stored = texelFetch(uState, ivec2(gl_FragCoord.xy), 0);
        for (int k = 0; k < D; ++k) state[k] = stored[k];
        n = fields.x;
        norm = fields.y;
        attraction = fields.w;
    }
    bool alive = within(norm);
    outImage = vec4(0.0);
    for (int i = 0; i < uSteps; ++i) {
        bool counts = alive && n < float(uIterations);
        bool first = uFirst && i == 0;
        if (!counts && !first) break;
        float next[D];
        for (int k = 0; k < D; ++k) next[k] = state[k];
        mapStep(next, parameters);
        // The first image is a field of its own, also where the start lies outside already.
        if (first) outImage = packed4(next);
        if (!counts) break;
        for (int k = 0; k < D; ++k) state[k] = next[k];
        float before = norm;
        norm = squaredNorm(state);
        n += 1.0;
        alive = within(norm);
        float difference = norm - before;
        // Of an orbit that escapes the norm before takes this place.
        if (!alive) attraction = before;
        if (alive && attraction == 0.0 && difference * difference < ATTRACTION) attraction = n;
    }
    outFields = vec4(n, norm, alive ? 0.0 : 1.0, attraction);
    outState = packed4(state);
}
)";

// FIRST_ROW is that of the first member in uRoots.
constexpr const char* kCounting = R"(
uniform int uMember;
uniform int uMembers;
uniform float uSquaredCapture;
uniform bool uSolid;
uniform float uSquaredSolid;

void main() {
    vec2 at = gl_FragCoord.xy - 0.5 * uSize;
    float numbers[COUNT];
    for (int k = 0; k < COUNT; ++k) numbers[k] = number(k, at);
    float count = uFirst ? 0.0 : texelFetch(uFields, ivec2(gl_FragCoord.xy), 0).x;
    for (int m = 0; m < uMembers; ++m) {
        memberRow = FIRST_ROW + 3 * (uMember + m);
        memberSize = int(texelFetch(uRoots, ivec2(0, memberRow + 1), 0).y);
        // The same places every time: the values of the member before need no taking back.
        for (int k = 0; k < DRAWN; ++k) {
            vec2 drawn = texelFetch(uRoots, ivec2(k, memberRow + 2), 0).xy;
            numbers[int(drawn.y)] = drawn.x;
        }
        float state[D];
        float parameters[P];
        for (int k = 0; k < D; ++k) state[k] = numbers[k];
        for (int k = 0; k < P; ++k) parameters[k] = numbers[D + k];
        for (int k = 0; k < 4; ++k) overrideValue[k] = numbers[D + P + k];
        float norm = squaredNorm(state);
        for (int n = 0; n < uIterations; ++n) {
            if (!within(norm) || norm < uSquaredCapture) break;
            mapStep(state, parameters);
            norm = squaredNorm(state);
        }
        bool counts = uSolid ? !isUndefined(norm) && norm < uSquaredSolid : within(norm);
        if (counts) count += 1.0;
    }
    outFields = vec4(count, 0.0, 0.0, 0.0);
    outState = vec4(0.0);
    outImage = vec4(0.0);
}
)";

// The shape's numbers are uniforms, so that one program serves all shapes of the same form.
std::string shapeField(const Tape& shape) {
    const std::string step = glslStep(shape);
    const std::string count = std::to_string(std::max(shape.parameterSize, 1));
    std::string text = "uniform float uShape[" + count + "];\nvoid shapeStep";
    text += step.substr(step.find('('));
    return text +
           "float fieldAt(vec3 p) {\n"
           "    float at[3];\n"
           "    at[0] = p.x;\n"
           "    at[1] = p.y;\n"
           "    at[2] = p.z;\n"
           "    float numbers[" +
           count + "];\n    for (int k = 0; k < " + count +
           "; ++k) numbers[k] = uShape[k];\n"
           "    shapeStep(at, numbers);\n"
           "    return at[0];\n"
           "}\n";
}

std::string sizesOf(const Tape& tape) {
    return "#define D " + std::to_string(tape.stateSize) + "\n#define P " +
           std::to_string(std::max(tape.parameterSize, 1)) + "\n#define COUNT (D + P + 4)\n";
}

}  // namespace

std::string iterationShader(const Tape& tape, const Tape* shape, double attraction) {
    return kShaderHead + sizesOf(tape) + "#define ATTRACTION " + glslFloat(attraction) + "\n" +
           kLibrary + kLists + (shape ? shapeField(*shape) : std::string(kGridField)) +
           glslStep(tape) + kOrbit + kIteration;
}

std::string countingShader(const Tape& tape, const Tape* shape, int drawn) {
    return kShaderHead + sizesOf(tape) + "#define DRAWN " + std::to_string(drawn) +
           "\n#define FIRST_ROW " + std::to_string(2 * kMostLists) + "\n" + kLibrary +
           kMemberLists + (shape ? shapeField(*shape) : std::string(kGridField)) + glslStep(tape) +
           kOrbit + kCounting;
}

}  // namespace versorium
