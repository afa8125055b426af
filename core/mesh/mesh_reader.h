// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/triangle_mesh.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

namespace trixel {

enum class MeshFormat { Obj, Ply, Stl, Off };

/// By the file name's ending, whatever its case; nothing for others.
std::optional<MeshFormat> meshFormatOf(const std::filesystem::path& path);

/// Reads a mesh from a file, strictly: a file that is damaged anywhere is refused as a whole.
/// Polygons are cut into triangles and remember their source face; STL vertices are welded.
/// Errors name the file, the line or byte, what was expected and what was found.
Result<TriangleMesh> readMesh(const std::filesystem::path& path, Progress& progress);

/// The same from memory; errors name the line or byte only. Never reads outside `bytes`, never
/// allocates more than a small multiple of their size, takes time linear in it.
Result<TriangleMesh> parseMesh(MeshFormat format, std::string_view bytes, Progress& progress);

} // namespace trixel
