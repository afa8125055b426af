// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes with uvs and textures, as files that other programs open.
#pragma once

#include "core/base/face_map.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/triangle_mesh.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <vector>

namespace trixel {

/// Where the corners of a face lie in a texture: (0,0) is its lower left corner, (1,1) the upper
/// right one.
struct FaceUvs
{
    std::uint32_t texture = 0; ///< number among the textures
    std::array<glm::vec2, 3> corners{};
};

/// A mesh and the images it wears.
struct UvMesh
{
    const TriangleMesh& mesh;
    FaceMap<FaceUvs> uvs;
    std::vector<std::string> textures; ///< names of files beside the mesh
    bool hasOpacity = false;           ///< whether their last channel is that
};

/// Each writes a file with `commitFile`, faces in their order; errors name the file. Cancelled
/// leaves what was there.

/// Wavefront OBJ, vertices as they are and uvs for every corner, and a material for each texture in
/// the MTL file beside it.
Status writeObj(const std::filesystem::path& path,
                const std::filesystem::path& materials,
                const UvMesh& uvMesh,
                Progress& progress);

/// Binary PLY; every corner is a vertex of its own, with `s` and `t`. One texture (checked).
Status writePly(const std::filesystem::path& path, const UvMesh& uvMesh, Progress& progress);

/// glTF 2.0 in one file (.glb): a primitive for each texture, every corner a vertex with its normal
/// and uv, the textures embedded.
/// \param pngs  the contents of each texture, PNG files
/// Fails if it would exceed the 4 GiB that the format can count.
Status writeGlb(const std::filesystem::path& path,
                const UvMesh& uvMesh,
                std::span<const std::vector<std::byte>> pngs,
                Progress& progress);

} // namespace trixel
