// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/triangle_mesh.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace trixel {

struct PtxCheckOptions
{
    /// The mesh to compare order, winding and adjacency with; without it, the mesh that the file
    /// carries, if it does.
    const TriangleMesh* mesh = nullptr;
    /// Of one kind of fault only so many are listed, then one line says how many more there are.
    std::size_t maxFaultsOfAKind = 10;
};

/// Reads the whole file and lists what is wrong with it, each fault a sentence; an empty list means
/// a sound file: every block of every level unzips, links between faces hold from both sides,
/// constant faces and flags tell the truth, reductions and averages follow from the texels (rounded
/// to nearest or, as the reference library does, down), the mesh, if any, has the same faces in the
/// same order and winding, and layers, if it names some, are those of the texels.
/// Fails where the path cannot be read (kind Path) or the file cannot be opened at all (Contents).
Result<std::vector<std::string>>
checkPtx(const std::filesystem::path& path, const PtxCheckOptions& options, Progress& progress);

} // namespace trixel
