// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/mapping/projection.h"

#include <span>
#include <vector>

namespace trixel {

/// Of the faces those that a projection may reach, in their order: all others lie outside the
/// image's corners, behind the eye, or turn their back where only fronts are reached. What hides a
/// face is not asked. Costs a look at three corners a face, so that baking costs no more than what
/// it touches.
std::vector<FaceId> facesInReach(const Projection& projection,
                                 const TriangleMesh& mesh,
                                 std::span<const FaceId> faces,
                                 Threads threads);

} // namespace trixel
