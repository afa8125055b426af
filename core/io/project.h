// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/ptx.h"
#include "core/io/ptx_stored_faces.h"
#include "core/layers/layer_stack.h"
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
    /// What is shown: of a project with layers, these together.
    TexelStore texels;
    /// Metadata a .ptx brought along, kept when it is written again (the mesh keys apart).
    std::vector<PtxMetadata> metadata;
    /// What reads the faces of a large file when they are asked for, and knows which could not be
    /// read; null when all texels were read at once.
    std::shared_ptr<StoredFaces> storedFaces = {};
    /// From which the limit surface has creases beside those of the mesh.
    CreaseAngle creaseAngle = {};
    /// What the texels come from; plain when there is nothing but them.
    LayerStack layers = {};
};

/// Opens a `.trixel` project. Errors name the file; a newer version is refused. Of large files only
/// the structure is read: see `OpenOptions` and stored_faces.h; those with layers are read whole.
Result<Project>
openProject(const std::filesystem::path& path, Progress& progress, const OpenOptions& options = {});
/// Writes a project with its layers, where it has some. Fails, as `exportPtx` does, if a face could
/// not be read from the file it lies in.
Status saveProject(const std::filesystem::path& path, const Project& project, Progress& progress);

/// Opens a `.ptx` that carries its mesh (the PtexFaceVert… metadata).
/// Fails with a sentence that asks for the mesh when it does not: see `openPtxOnMesh`.
Result<Project>
openPtx(const std::filesystem::path& path, Progress& progress, const OpenOptions& options = {});

/// Opens a `.ptx` on a mesh given beside it; refuses one whose face count, order or winding
/// differs, naming the first face that shows it.
Result<Project> openPtxOnMesh(const std::filesystem::path& path,
                              TriangleMesh mesh,
                              Progress& progress,
                              const OpenOptions& options = {});

/// Opens the texels of a `.ptx` without a mesh, in the same way; of a file with layers what these
/// look like together.
Result<OpenedTexels> openPtxTexels(const std::filesystem::path& path,
                                   Progress& progress,
                                   const OpenOptions& options = {});

/// Writes the project's texels, as they are shown, as .ptx with its mesh in the metadata. Layers
/// and bookmarked views stay behind.
Status exportPtx(const std::filesystem::path& path,
                 const Project& project,
                 const PtxWriteOptions& options,
                 Progress& progress);

} // namespace trixel
