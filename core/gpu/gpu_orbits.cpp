// SPDX-License-Identifier: MIT
#include "gpu/gpu_orbits.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fields/ensemble.h"
#include "maps/critical.h"
#include "render/cpu/averaged_map.h"
#include "render/glsl/orbit_shader.h"

namespace versorium {
namespace {

constexpr const char* kAlongTheOrbit = "it looks at every iterate beside what is kept of an orbit";
constexpr const char* kNeedsSlopes = "it needs derivatives, which one step in 32 bits has not";
constexpr std::array<GpuField, 16> kFields = {{
    {FieldName::membership, true, ""},
    {FieldName::solid, true, ""},
    {FieldName::escapeStep, true, ""},
    {FieldName::smoothEscape, true, ""},
    {FieldName::squaredNorm, true, ""},
    {FieldName::attractionStep, true, ""},
    {FieldName::logModulus, true, ""},
    {FieldName::imageModulus, true, ""},
    {FieldName::versor, true, ""},
    {FieldName::argument, true, ""},
    {FieldName::distance, false, kNeedsSlopes},
    {FieldName::trap, false, kAlongTheOrbit},
    {FieldName::lyapunov, false, kNeedsSlopes},
    {FieldName::period, false, "cycles are told apart by more than 24 bits"},
    {FieldName::meanMembership, true, ""},
    {FieldName::standardError, true, ""},
}};

// A pixel must be this many units in the last place of what it is added to.
constexpr double kLeastPixel = 16.0 / (1 << 24);
// Coordinates below this are added to numbers of about this size in the first step anyway.
constexpr double kLeastCoordinate = 1.0 / 16;
constexpr std::size_t kMostShapeNumbers = 128;
constexpr std::size_t kMostShapeNodes = 2000;
constexpr int kOtherUniforms = 32;
// A trap is left some room for the rounding of 24 bits.
constexpr double kCaptureMargin = 1e-5;

Status refused(const std::string& why) { return Status::usage("the CPU draws this: " + why); }

// Numbers of an orbit as affine functions of the pixel, in double.
struct Affine {
    double middle = 0, right = 0, up = 0;
};

std::vector<Affine> affineNumbers(const Scene& scene, const OrbitProgram& program, double pixel) {
    const std::array<double, 3> middle = centreOf(scene);
    const auto& axes = program.slice.axes;
    std::vector<Affine> numbers(program.slice.origin.size());
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        numbers[k].middle = program.slice.at(k, middle.data());
        if (!axes.empty()) numbers[k].right = axes[0][k] * pixel;
        if (axes.size() > 1) numbers[k].up = axes[1][k] * pixel;
    }
    return numbers;
}

Status fineEnough(const std::vector<Affine>& numbers) {
    for (const Affine& number : numbers) {
        const double least = kLeastPixel * std::max(std::abs(number.middle), kLeastCoordinate);
        for (double step : {std::abs(number.right), std::abs(number.up)})
            if (step > 0 && step < least)
                return refused("32 bits are not enough here, its pixels lie too close together");
    }
    return {};
}

// A critical start that is the same everywhere, or moves affinely with the slice.
class CriticalStart {
  public:
    CriticalStart(const OrbitProgram& program, const std::vector<Affine>& numbers, Size size)
        : program_(program), numbers_(numbers), size_(size) {}

    // Puts the start in the place of the first numbers.
    Status put(std::vector<Affine>& into) const {
        const auto dimension = static_cast<std::size_t>(program_.map->dimension);
        bool moves = false;
        for (std::size_t k = dimension; k < numbers_.size(); ++k)
            moves = moves || ((numbers_[k].right != 0 || numbers_[k].up != 0) &&
                              movesCritical(*program_.map, static_cast<int>(k - dimension)));
        if (moves && program_.map->criticalPoints == 0)
            return refused("its critical points are solved for at each pixel");
        Point middle;
        if (!at(0, 0, middle)) return refused("the map has no such critical point here");
        const double x = 0.5 * size_.width, y = 0.5 * size_.height;
        Point right{}, up{};
        if (moves) {
            Point ends[4];
            const double places[4][2] = {{x, 0}, {-x, 0}, {0, y}, {0, -y}};
            for (int i = 0; i < 4; ++i)
                if (!at(places[i][0], places[i][1], ends[i]))
                    return refused("the map has no such critical point here");
            for (std::size_t k = 0; k < dimension; ++k) {
                right[k] = (ends[0][k] - ends[1][k]) / (2 * x);
                up[k] = (ends[2][k] - ends[3][k]) / (2 * y);
            }
            // Straightness is seen at places that were not used to find the slopes.
            const double others[4][2] = {{0.3 * x, 0.7 * y}, {-x, y}, {0.9 * x, -0.4 * y}, {x, 0}};
            for (const auto& place : others) {
                Point there;
                if (!at(place[0], place[1], there))
                    return refused("the map has no such critical point here");
                for (std::size_t k = 0; k < dimension; ++k) {
                    const double straight = middle[k] + place[0] * right[k] + place[1] * up[k];
                    if (!(std::abs(straight - there[k]) <= 1e-12 * (1 + std::abs(straight))))
                        return refused("its critical points do not move in straight lines");
                }
            }
        }
        for (std::size_t k = 0; k < dimension; ++k) into[k] = {middle[k], right[k], up[k]};
        return {};
    }

  private:
    using Point = std::array<double, kMostDimension>;

    bool at(double x, double y, Point& point) const {
        const auto value = [&](std::size_t k) {
            return numbers_[k].middle + x * numbers_[k].right + y * numbers_[k].up;
        };
        const auto dimension = static_cast<std::size_t>(program_.map->dimension);
        const auto parameters = static_cast<std::size_t>(program_.map->parameters);
        std::vector<double> values(parameters + 1);
        for (std::size_t k = 0; k < parameters; ++k) values[k] = value(dimension + k);
        Environment<double> environment;
        for (std::size_t k = 0; k < program_.lists.size(); ++k)
            environment.lists[k] = &program_.lists[k];
        environment.field = program_.field.get();
        environment.overrideCount = static_cast<int>(program_.overrides.size());
        for (std::size_t k = 0; k < program_.overrides.size(); ++k) {
            const auto& number = program_.overrides[k];
            environment.overrides[k] = {number.list, number.item, number.component,
                                        value(dimension + parameters + k)};
        }
        return criticalPoint(*program_.map, *program_.critical, values.data(), environment,
                             point.data());
    }

    const OrbitProgram& program_;
    const std::vector<Affine>& numbers_;
    Size size_;
};

Status checkLists(const OrbitProgram& program, const GpuLimits& limits) {
    for (const BoundList& list : program.lists)
        if (list.size() > static_cast<std::size_t>(limits.textureSize))
            return refused("a list has more roots than fit into a texture");
    return {};
}

// Whether an ensemble can be counted here.
Status checkMembers(const OrbitProgram& program) {
    const Ensemble& ensemble = *program.ensemble;
    if (ensemble.count > static_cast<std::uint64_t>(kMostGpuMembers))
        return refused("it has more members than 24 bits count");
    if (program.onlyLastTested) return refused("only the last point of each orbit is tested");
    if (!program.critical) return {};
    bool moves = ensemble.list >= 0;
    for (std::size_t number : drawnNumbers(ensemble)) {
        const auto parameter = static_cast<int>(number) - program.map->dimension;
        moves = moves || (parameter >= 0 && movesCritical(*program.map, parameter));
    }
    return moves ? refused("its critical points move with what is drawn at random") : Status{};
}

}  // namespace

const GpuField& gpuField(FieldName field) {
    const auto found = std::find_if(kFields.begin(), kFields.end(),
                                    [&](const GpuField& own) { return own.field == field; });
    assert(found != kFields.end());
    return *found;
}

Status carriesFields(const GpuOrbits& orbits, const std::vector<FieldName>& fields) {
    const OrbitProgram& program = orbits.program;
    for (FieldName field : fields) {
        const GpuField& own = gpuField(field);
        const bool ofMany = field == FieldName::meanMembership || field == FieldName::standardError;
        if (ofMany && !orbits.counts())
            return refused("the field " + std::string(infoOf(field).name) +
                           ": the ensemble varies nothing");
        if (!ofMany && orbits.counts())
            return refused("the field " + std::string(infoOf(field).name) +
                           " beside the mean over an ensemble");
        if (!own.carried)
            return refused("the field " + std::string(infoOf(field).name) + ": " + own.why);
        if (field == FieldName::attractionStep && program.onlyLastTested)
            return refused("attraction_step beside an escape test of the last iterate only");
    }
    return {};
}

Expected<GpuOrbits> GpuOrbits::make(const Scene& scene, const OrbitProgram& program, Size size,
                                    const GpuLimits& limits) {
    if (size.width < 1 || size.height < 1 || size.width > limits.textureSize ||
        size.height > limits.textureSize)
        return refused("each side of the picture must be 1 to " +
                       std::to_string(limits.textureSize) + " pixels");
    if (Status status = checkLists(program, limits); !status.ok()) return status;
    GpuOrbits orbits;
    orbits.program = program;
    orbits.iterations = program.iterations;
    const double radius2 = program.escapeRadius * program.escapeRadius;
    orbits.bounded = !program.onlyLastTested && radius2 < 3e38;
    orbits.squaredRadius = orbits.bounded ? static_cast<float>(radius2) : 0.0F;
    if (showsEnsemble(scene)) {
        if (Status status = checkMembers(program); !status.ok()) return status;
        orbits.members = static_cast<int>(program.ensemble->count);
        const double capture = program.ensemble->capture * (1 - kCaptureMargin);
        if (!program.ensemble->solid) orbits.squaredCapture = static_cast<float>(capture * capture);
    }

    const std::vector<Affine> sliced =
        affineNumbers(scene, program, scene.slice.height / size.height);
    std::vector<Affine> numbers = sliced;
    if (program.critical) {
        // The slice's own state is not used, so its fineness does not matter.
        const CriticalStart start(program, sliced, size);
        if (Status status = start.put(numbers); !status.ok()) return status;
    }
    if (Status status = fineEnough(numbers); !status.ok()) return status;
    const auto count = static_cast<std::size_t>(program.map->dimension);
    const auto parameters = static_cast<std::size_t>(std::max(program.map->parameters, 1));
    orbits.numbers.assign(4 * (count + parameters + kMostOverrides), 0.0F);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        // A map without parameters has one place for them that stays empty.
        const bool override = k >= count + static_cast<std::size_t>(program.map->parameters);
        const std::size_t place =
            override ? k + parameters - static_cast<std::size_t>(program.map->parameters) : k;
        orbits.places.push_back(static_cast<int>(place));
        orbits.numbers[4 * place] = static_cast<float>(numbers[k].middle);
        orbits.numbers[4 * place + 1] = static_cast<float>(numbers[k].right);
        orbits.numbers[4 * place + 2] = static_cast<float>(numbers[k].up);
    }

    if (program.field && (program.field->alpha() || program.field->beta()))
        return refused("alpha or beta differs from place to place");
    OrbitShader shader = orbitShader(scene, program);
    orbits.shapeNumbers = std::move(shader.shapeNumbers);
    if (orbits.shapeNumbers.size() > kMostShapeNumbers || shader.shapeNodes > kMostShapeNodes)
        return refused("its shape has too many parts");
    if (program.field && !program.field->shape()) {
        const glm::ivec3 nodes = program.field->grid()->resolution;
        if (std::max({nodes.x, nodes.y, nodes.z}) > limits.gridSize)
            return refused("its grid is larger than a texture may be");
    }
    if (static_cast<int>(orbits.numbers.size() / 4 + orbits.shapeNumbers.size()) + kOtherUniforms >
        limits.uniformVectors)
        return refused("it takes more numbers than the GPU has room for");
    orbits.shaderText = std::move(shader.text);
    return orbits;
}

}  // namespace versorium
