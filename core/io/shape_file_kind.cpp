// SPDX-License-Identifier: MIT
#include "io/shape_file_kind.h"

#include "io/grid_files.h"
#include "io/known_formats.h"
#include "io/mesh_files.h"

namespace versorium {

ShapeFileKind shapeFileKindOf(std::span<const unsigned char> bytes, std::string_view name) {
    if (looksLikePicture(bytes)) return ShapeFileKind::picture;
    if (looksLikeGrid(bytes)) return ShapeFileKind::grid;
    if (looksLikeMesh(bytes)) return ShapeFileKind::mesh;
    if (namesPicture(name)) return ShapeFileKind::picture;
    if (namesGrid(name)) return ShapeFileKind::grid;
    return ShapeFileKind::mesh;
}

}  // namespace versorium
