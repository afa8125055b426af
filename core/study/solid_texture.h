// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/triangle_mesh.h"
#include "core/study/test_scene.h"
#include "core/texture/level_plan.h"
#include "core/texture/texel_store.h"

namespace trixel {

/// Texels for a mesh that has none, so that filters have something to be judged on: the stored
/// textures as a solid that the mesh is carved from. Red and green are the mean of the natural tile
/// seen along each axis, blue is one of two values by an odd or even number of axes along which the
/// hard-edged tile is dark. A texel of the tile is about as large as one of the mesh.
/// \param plan  one level a face of the mesh (checked)
/// Fails only when cancelled.
Result<TexelStore> solidTexture(const TriangleMesh& mesh,
                                const LevelPlan& plan,
                                const TestData& data,
                                Threads threads,
                                Progress& progress);

} // namespace trixel
