// SPDX-License-Identifier: GPL-3.0-or-later
//
// A mesh in the metadata of a .ptx: the three keys that Ptex reserves for it, and Trixel's own.
#pragma once

#include "core/base/result.h"
#include "core/io/ptx.h"
#include "core/mesh/triangle_mesh.h"

#include <optional>
#include <span>
#include <vector>

namespace trixel {

inline constexpr const char* kVertexCountsKey = "PtexFaceVertCounts";
inline constexpr const char* kVertexIndicesKey = "PtexFaceVertIndices";
inline constexpr const char* kVertexPositionsKey = "PtexVertPositions";
inline constexpr const char* kProjectVersionKey = "TrixelProject";
inline constexpr const char* kSourceFacesKey = "TrixelSourceFaces";
/// The values of one texel before anything was painted.
inline constexpr const char* kFillKey = "TrixelFill";
/// Two vertices a crease, and how sharp each is; likewise of vertices.
inline constexpr const char* kCreasesKey = "TrixelCreases";
inline constexpr const char* kCreaseSharpnessKey = "TrixelCreaseSharpness";
inline constexpr const char* kSharpVerticesKey = "TrixelSharpVertices";
inline constexpr const char* kVertexSharpnessKey = "TrixelVertexSharpness";
/// Degrees; not there where an angle makes no crease.
inline constexpr const char* kCreaseAngleKey = "TrixelCreaseAngle";
/// s and t of each face's three corners, NaN for none.
inline constexpr const char* kCornerUvsKey = "TrixelCornerUvs";
/// The text of a cameras file: the project's bookmarked views.
inline constexpr const char* kViewsKey = "TrixelViews";

/// The version of projects without layers, and of those with some.
inline constexpr int kPlainVersion = 1;
inline constexpr int kLayersVersion = 2;
/// The newest version of project that can be opened.
inline constexpr int kProjectVersion = kLayersVersion;

/// Whether the three keys of a mesh are all there.
bool carriesMesh(std::span<const PtxMetadata> items);

/// The mesh, checked: three corners a face, as many faces as expected, indices of vertices that
/// exist, finite positions, creases along edges. Errors name the key and the first face, vertex or
/// crease at fault.
Result<TriangleMesh> meshOf(std::span<const PtxMetadata> items, std::uint32_t faceCount);

/// The items that keep a mesh.
std::vector<PtxMetadata> metadataOf(const TriangleMesh& mesh);

/// The version of the project, or nothing if the items do not make one.
std::optional<int> projectVersionOf(std::span<const PtxMetadata> items);

/// The items without those that keep the mesh and its creases, name layers and make a project.
std::vector<PtxMetadata> withoutMesh(std::vector<PtxMetadata> items);

} // namespace trixel
