// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/ptx.h"
#include "core/mesh/surface.h"
#include "core/texture/texel_store.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace trixel {

/// What is open: a surface and the texels painted on it.
struct Project
{
    std::shared_ptr<const Surface> surface;
    TexelStore texels;
    /// Metadata a .ptx brought along, kept when it is written again (the mesh keys apart).
    std::vector<PtxMetadata> metadata;
};

/// Opens a `.trixel` project. Errors name the file; a newer version is refused.
Result<Project> openProject(const std::filesystem::path& path, Progress& progress);
Status saveProject(const std::filesystem::path& path, const Project& project, Progress& progress);

/// Opens a `.ptx` that carries its mesh (the PtexFaceVert… metadata).
/// Fails with a sentence that asks for the mesh when it does not: see `openPtxOnMesh`.
Result<Project> openPtx(const std::filesystem::path& path, Progress& progress);

/// Opens a `.ptx` on a mesh given beside it; refuses one whose face count, order or winding
/// differs, naming the first face that shows it.
Result<Project>
openPtxOnMesh(const std::filesystem::path& path, TriangleMesh mesh, Progress& progress);

/// Writes the project's texels as .ptx with its mesh in the metadata. Bookmarked views stay behind.
Status exportPtx(const std::filesystem::path& path,
                 const Project& project,
                 const PtxWriteOptions& options,
                 Progress& progress);

} // namespace trixel
