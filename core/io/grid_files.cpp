// SPDX-License-Identifier: MIT
#include "io/grid_files.h"

#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>

#include "io/byte_reader.h"

namespace versorium {
namespace {

// Of packGrid.
struct PackedHeader {
    std::int32_t counts[3] = {};
    std::int32_t unused = 0;
    double box[6] = {};
};

// The counts of a header and the bytes that they ask for; `nodes` is 0 when they make no sense.
struct Header {
    std::int64_t counts[3] = {1, 1, 1};
    std::size_t nodes = 0;

    std::string text(int axes) const {
        std::string result;
        for (int axis = 0; axis < axes; ++axis)
            result += (axis == 0 ? "" : " × ") + std::to_string(counts[axis]);
        return result;
    }
};

Header readHeader(std::span<const unsigned char> bytes, int axes) {
    ByteReader reader(bytes);
    Header header;
    bool good = true;
    std::uint64_t nodes = 1;
    for (int axis = 0; axis < axes; ++axis) {
        header.counts[axis] = reader.read<std::int32_t>();
        good = good && header.counts[axis] >= 2;
        // Stays below 2⁶²: a factor is below 2³¹, and what came before is capped.
        if (good) nodes *= static_cast<std::uint64_t>(header.counts[axis]);
        good = good && nodes <= kGridNodes;
    }
    if (good && !reader.failed()) header.nodes = static_cast<std::size_t>(nodes);
    return header;
}

std::size_t headerSize(int axes) { return static_cast<std::size_t>(axes) * 20; }

bool fits(const Header& header, int axes, std::size_t size) {
    return header.nodes > 0 && size >= headerSize(axes) &&
           (size - headerSize(axes)) / 8 == header.nodes && (size - headerSize(axes)) % 8 == 0;
}

Status readValues(ByteReader& reader, bool zFastest, Grid& grid) {
    const std::size_t nodes = grid.values.size();
    const auto nx = static_cast<std::size_t>(grid.resolution.x);
    const auto ny = static_cast<std::size_t>(grid.resolution.y);
    const auto nz = static_cast<std::size_t>(grid.resolution.z);
    for (std::size_t i = 0; i < nodes; ++i) {
        const double value = reader.read<double>();
        if (!std::isfinite(value))
            return Status::data("value " + std::to_string(i + 1) + " of " + std::to_string(nodes) +
                                " of the grid is not a finite number");
        const std::size_t place = zFastest ? i / (ny * nz) + nx * (i / nz % ny + ny * (i % nz)) : i;
        grid.values[place] = value;
    }
    return {};
}

Status readBox(ByteReader& reader, Grid& grid) {
    double centre[2], length[2];
    for (double& value : centre) value = reader.read<double>();
    for (double& value : length) value = reader.read<double>();
    for (int axis = 0; axis < 2; ++axis) {
        if (!(std::abs(centre[axis]) <= 1e100 && length[axis] >= 1e-100 && length[axis] <= 1e100))
            return Status::data(
                "the grid's box has a centre or length that is not usable: centre " +
                std::to_string(centre[axis]) + ", length " + std::to_string(length[axis]));
        grid.minimum[axis] = centre[axis] - length[axis] / 2;
        grid.maximum[axis] = centre[axis] + length[axis] / 2;
        if (!(grid.minimum[axis] < grid.maximum[axis]))
            return Status::data("the grid's box is too small for where it stands");
    }
    grid.minimum.z = grid.maximum.z = 0;
    return {};
}

}  // namespace

Expected<Grid> readGrid(std::span<const unsigned char> bytes, const GridFileOptions& options) {
    const Header spatial = readHeader(bytes, 3), plane = readHeader(bytes, 2);
    const bool isSpatial = fits(spatial, 3, bytes.size());
    if (!isSpatial && !fits(plane, 2, bytes.size()))
        return Status::data(
            "not a grid: the header claims " + spatial.text(3) + " nodes (or " + plane.text(2) +
            " as a 2D grid), which do not fit the file's " + std::to_string(bytes.size()) +
            " bytes; at least 2 nodes along each axis and exactly 8 bytes for each are needed");
    Grid grid;
    ByteReader reader(bytes);
    const Header& header = isSpatial ? spatial : plane;
    grid.resolution = {static_cast<int>(header.counts[0]), static_cast<int>(header.counts[1]),
                       isSpatial ? static_cast<int>(header.counts[2]) : 1};
    reader.skip(isSpatial ? 12 : 8);
    if (isSpatial) {
        reader.skip(48);
    } else if (const Status status = readBox(reader, grid); !status.ok()) {
        return status;
    }
    grid.values.resize(header.nodes);
    const Status status = readValues(reader, isSpatial && options.zFastest, grid);
    if (!status.ok()) return status;
    return grid;
}

bool looksLikeGrid(std::span<const unsigned char> bytes) {
    return fits(readHeader(bytes, 3), 3, bytes.size()) ||
           fits(readHeader(bytes, 2), 2, bytes.size());
}

std::vector<unsigned char> writeGrid(const Grid& grid, const GridFileOptions& options) {
    assert(grid.values.size() == static_cast<std::size_t>(grid.resolution.x) *
                                     static_cast<std::size_t>(grid.resolution.y) *
                                     static_cast<std::size_t>(grid.resolution.z));
    const int axes = grid.planar() ? 2 : 3;
    std::vector<unsigned char> bytes;
    bytes.reserve(headerSize(axes) + 8 * grid.values.size());
    for (int axis = 0; axis < axes; ++axis)
        appendLittleEndian(bytes, static_cast<std::int32_t>(grid.resolution[axis]));
    for (int axis = 0; axis < axes; ++axis)
        appendLittleEndian(bytes, (grid.minimum[axis] + grid.maximum[axis]) / 2);
    for (int axis = 0; axis < axes; ++axis)
        appendLittleEndian(bytes, grid.maximum[axis] - grid.minimum[axis]);
    if (!options.zFastest || axes == 2) {
        for (double value : grid.values) appendLittleEndian(bytes, value);
        return bytes;
    }
    for (int x = 0; x < grid.resolution.x; ++x)
        for (int y = 0; y < grid.resolution.y; ++y)
            for (int z = 0; z < grid.resolution.z; ++z) appendLittleEndian(bytes, grid.at(x, y, z));
    return bytes;
}

std::vector<unsigned char> packGrid(const Grid& grid) {
    const PackedHeader header{{grid.resolution.x, grid.resolution.y, grid.resolution.z},
                              0,
                              {grid.minimum.x, grid.minimum.y, grid.minimum.z, grid.maximum.x,
                               grid.maximum.y, grid.maximum.z}};
    std::vector<unsigned char> bytes(sizeof header + grid.values.size() * sizeof(double));
    std::memcpy(bytes.data(), &header, sizeof header);
    std::memcpy(bytes.data() + sizeof header, grid.values.data(),
                grid.values.size() * sizeof(double));
    return bytes;
}

Expected<Grid> unpackGrid(std::span<const unsigned char> bytes) {
    PackedHeader header;
    if (bytes.size() < sizeof header) return Status::data("this is no grid");
    std::memcpy(&header, bytes.data(), sizeof header);
    const std::size_t count = (bytes.size() - sizeof header) / sizeof(double);
    std::size_t wanted = 1;
    for (const std::int32_t nodes : header.counts) {
        if (nodes < 1 || wanted > kGridNodes / static_cast<std::size_t>(nodes))
            return Status::data("this is no grid");
        wanted *= static_cast<std::size_t>(nodes);
    }
    if (bytes.size() != sizeof header + wanted * sizeof(double))
        return Status::data("this is no grid, or a part of one");
    Grid grid;
    grid.resolution = {header.counts[0], header.counts[1], header.counts[2]};
    grid.minimum = {header.box[0], header.box[1], header.box[2]};
    grid.maximum = {header.box[3], header.box[4], header.box[5]};
    grid.values.resize(count);
    std::memcpy(grid.values.data(), bytes.data() + sizeof header, count * sizeof(double));
    return grid;
}

}  // namespace versorium
