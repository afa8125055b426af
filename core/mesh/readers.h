// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/triangle_mesh.h"

#include <string_view>

namespace trixel {

// One strict reader for each format; see `parseMesh` for what they promise.

/// Wavefront OBJ. Faces may refer to vertices that come later in the file, as long as the file has
/// them in the end. Texture numbers become `cornerUvs`, a value that is no number none; normal
/// numbers are range-checked, their values are not read; lines,
/// points, groups, materials, free-form statements and those that programs add for themselves are
/// skipped; what looks like a damaged vertex or face is refused. A fourth number of a vertex (its
/// weight) and colours are skipped. Creases and sharp vertices are read from tags (see
/// obj_tags.h).
Result<TriangleMesh> parseObj(std::string_view bytes, Progress& progress);

/// PLY 1.0, ascii or binary of either byte order. Needs an element "vertex" with x, y and z of any
/// type and an element "face" with a list "vertex_indices" or "vertex_index"; other elements and
/// properties are skipped. In ascii each row of an element is one line.
Result<TriangleMesh> parsePly(std::string_view bytes, Progress& progress);

/// STL, ascii or binary; binary where the size fits the count of facets, whatever the header says.
/// Corners of equal position become one vertex. Normals are not read. An ascii file may hold
/// several solids.
Result<TriangleMesh> parseStl(std::string_view bytes, Progress& progress);

/// OFF, COFF, NOFF, STOFF and their combinations, ascii or binary; one line a vertex or face.
/// The word may be missing, as the format allows.
Result<TriangleMesh> parseOff(std::string_view bytes, Progress& progress);

} // namespace trixel
