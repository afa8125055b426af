// SPDX-License-Identifier: GPL-3.0-or-later
//
// Creases and sharp vertices of a mesh in the metadata of a .ptx.
#pragma once

#include "core/base/result.h"
#include "core/io/ptx.h"
#include "core/mesh/triangle_mesh.h"

#include <span>
#include <vector>

namespace trixel {

/// What the items say of a mesh, checked: as many sharpnesses as creases and vertices, of vertices
/// that exist and edges that the mesh has, in (0, kSharp]. Errors name the key and the first crease
/// or vertex at fault, counted from 0.
Result<Sharpness> sharpnessOf(std::span<const PtxMetadata> items, const TriangleMesh& mesh);

/// The items that keep it; none where nothing is sharp.
std::vector<PtxMetadata> metadataOf(const Sharpness& sharpness);

/// Fails, naming the key, where it is not one number in [0, 180].
Result<CreaseAngle> creaseAngleOf(std::span<const PtxMetadata> items);

} // namespace trixel
