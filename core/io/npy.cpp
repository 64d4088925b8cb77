// SPDX-License-Identifier: MIT
#include "io/npy.h"

#include <string>

#include "io/byte_reader.h"

namespace versorium {

std::vector<unsigned char> writeNpy(const Raster<double>& raster) {
    std::string shape = std::to_string(raster.height()) + ", " + std::to_string(raster.width());
    if (raster.channels() > 1) shape += ", " + std::to_string(raster.channels());
    std::string head = "{'descr': '<f8', 'fortran_order': False, 'shape': (" + shape + "), }";
    // The data start at a multiple of 64; ten bytes stand before the head, a line feed ends it.
    head += std::string(64 - (10 + head.size() + 1) % 64, ' ') + '\n';
    std::vector<unsigned char> bytes{0x93, 'N', 'U', 'M', 'P', 'Y', 1, 0};
    appendLittleEndian(bytes, static_cast<std::uint16_t>(head.size()));
    bytes.insert(bytes.end(), head.begin(), head.end());
    bytes.reserve(bytes.size() + raster.values().size() * sizeof(double));
    for (double value : raster.values()) appendLittleEndian(bytes, value);
    return bytes;
}

}  // namespace versorium
