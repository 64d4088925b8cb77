// SPDX-License-Identifier: MIT
#include "dynamics/bifurcation_diagram.h"

#include <algorithm>
#include <cmath>

#include "fields/lanes_of_orbits.h"
#include "math/elementary.h"

namespace versorium {
namespace {

constexpr int kColumnsAtOnce = 32;

Status check(const OrbitProgram& program, const DiagramOptions& options, int first, int count,
             const BifurcationDiagram& diagram) {
    const auto good = [](double low, double high) {
        return low < high && std::abs(low) < 1e12 && std::abs(high) < 1e12;
    };
    if (program.slice.axes.size() != 1)
        return Status::usage("a bifurcation diagram runs over one parameter");
    if (!good(options.left, options.right) || !good(options.low, options.high))
        return Status::usage("the borders of a diagram must be finite, the lower ones first");
    if (options.component < 0 || options.component >= program.map->dimension)
        return Status::usage("the state has no such component");
    if (options.transient < 0 || options.transient > 10000000 || options.points < 1 ||
        options.points > 10000000)
        return Status::usage("the steps of a diagram must be 1 to 10000000");
    if (options.across < 1 || options.across > 16)
        return Status::usage("1 to 16 values of the parameter in each column are possible");
    if (diagram.visits.empty() || first < 0 || count < 0 || first + count > diagram.visits.width())
        return Status::usage("the diagram has no such columns");
    return {};
}

// A visit is shared by the two pixels whose centres it lies between.
void visit(Raster<float>& visits, int column, double place, float weight) {
    const double at = place - 0.5;
    const double row = std::floor(at);
    const auto share = static_cast<float>(at - row);
    const int above = static_cast<int>(row);
    if (above >= 0 && above < visits.height()) visits.at(column, above) += weight * (1 - share);
    if (above + 1 >= 0 && above + 1 < visits.height())
        visits.at(column, above + 1) += weight * share;
}

void fillColumns(const OrbitProgram& program, const DiagramOptions& options, int first, int count,
                 BifurcationDiagram& diagram, const Job& job) {
    const int width = diagram.visits.width(), height = diagram.visits.height();
    const int lanes = count * options.across;
    const auto parameter = [&](double column) {
        return options.left + (options.right - options.left) * column / width;
    };
    std::vector<double> at(static_cast<std::size_t>(lanes));
    for (int i = 0; i < lanes; ++i)
        at[static_cast<std::size_t>(i)] = parameter(first + (i + 0.5) / options.across);
    const double* coordinates[3] = {at.data(), nullptr, nullptr};
    OrbitLanes orbits(program, lanes, coordinates, {});
    const double square = program.escapeRadius * program.escapeRadius;
    std::vector<char> bounded(static_cast<std::size_t>(lanes), 1);
    for (int column = first; column < first + count; ++column)
        for (int row = 0; row < height; ++row) diagram.visits.at(column, row) = 0;
    const float weight = 1.0F / static_cast<float>(options.across);
    const double scale = height / (options.high - options.low);
    for (int n = 0; n < options.transient + options.points; ++n) {
        if (n % 256 == 0 && job.cancelled()) return;
        orbits.advance(1);
        const std::vector<double>& shown = orbits.state(options.component);
        for (std::size_t i = 0; i < bounded.size(); ++i) {
            if (!bounded[i]) continue;
            if (!(orbits.squaredNorm(i) <= square)) {
                bounded[i] = 0;
                continue;
            }
            if (n < options.transient) continue;
            const double place = (options.high - shown[i]) * scale;
            if (place > -1 && place < height + 1)
                visit(diagram.visits, first + static_cast<int>(i) / options.across, place, weight);
        }
    }
    // The period at the middle of each column, by the field of that name.
    OrbitProgram long_ = program;
    long_.iterations = options.transient;
    std::vector<double> middles;
    for (int column = first; column < first + count; ++column)
        middles.push_back(parameter(column + 0.5));
    const double* places[3] = {middles.data(), nullptr, nullptr};
    const FieldName fields[] = {FieldName::period, FieldName::membership};
    const auto values = evaluateFields(long_, count, places, fields);
    for (std::size_t i = 0; i < middles.size(); ++i)
        diagram.periods[static_cast<std::size_t>(first) + i] =
            values[1][i] == 0 ? -1 : static_cast<int>(values[0][i]);
}

}  // namespace

Status fillDiagram(const OrbitProgram& program, const DiagramOptions& options, int first, int count,
                   Job& job, BifurcationDiagram& diagram) {
    if (Status status = check(program, options, first, count, diagram); !status.ok()) return status;
    const auto groups = static_cast<std::size_t>((count + kColumnsAtOnce - 1) / kColumnsAtOnce);
    const bool finished = job.parallelFor(groups, [&](std::size_t group) {
        const int begin = first + static_cast<int>(group) * kColumnsAtOnce;
        fillColumns(program, options, begin, std::min(kColumnsAtOnce, first + count - begin),
                    diagram, job);
    });
    return finished && !job.cancelled() ? Status{} : Status::cancelled();
}

Raster<float> inkOf(const BifurcationDiagram& diagram, const DiagramOptions& options) {
    Raster<float> ink(diagram.visits.size(), 1);
    // 1 where the visits are spread evenly from bottom to top.
    const double even = static_cast<double>(diagram.visits.height()) / options.points;
    for (std::size_t i = 0; i < ink.values().size(); ++i)
        ink.values()[i] = static_cast<float>(
            1 - exp(-0.8 * even * static_cast<double>(diagram.visits.values()[i])));
    return ink;
}

}  // namespace versorium
