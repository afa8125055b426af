// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which level each face gets before anything is painted.
#pragma once

#include "core/base/face_map.h"
#include "core/base/level.h"
#include "core/base/result.h"
#include "core/mesh/triangle_mesh.h"
#include "core/texture/texel_format.h"

#include <cstdint>

namespace trixel {

/// A level per face, and what it would cost with every texel stored.
struct LevelPlan
{
    FaceMap<Level> levels;
    std::uint64_t texels = 0; ///< 4^n summed over the faces

    std::uint64_t bytes(const TexelFormat& format) const { return texels * format.texelBytes(); }
};

/// Every face at one level.
LevelPlan planUniform(std::size_t faceCount, Level level);

/// Each face at the level whose texels along an edge, over the root mean square of its three edge
/// lengths, come nearest (as a ratio) to the density; within [0, Level::kMax]. Long thin faces thus
/// are not starved along their length. A face of no extent gets level 0.
/// \param texelsPerUnit  texels per world unit of length; fails unless positive and finite
Result<LevelPlan> planByDensity(const TriangleMesh& mesh, double texelsPerUnit);

/// The plan of the largest density whose texels do not exceed `total`. Fails when even one texel a
/// face exceeds it.
Result<LevelPlan> planByTotal(const TriangleMesh& mesh, std::uint64_t total);

} // namespace trixel
