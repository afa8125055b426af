// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/triangle_mesh.h"

#include <string_view>

namespace trixel {

// One strict reader for each format; see `parseMesh` for what they promise.

/// Wavefront OBJ. Faces may refer to vertices that come later in the file, as long as the file has
/// them in the end. Texture and normal numbers are range-checked, their values are not read; lines,
/// points, groups, materials and free-form statements are skipped; unknown statements are refused.
/// A fourth number of a vertex (its weight) and colours are skipped.
Result<TriangleMesh> parseObj(std::string_view bytes, Progress& progress);

} // namespace trixel
