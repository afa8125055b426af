// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/mesh/bvh_node.h"
#include "core/mesh/triangle_mesh.h"

#include <vector>

namespace trixel {

/// No path from the root is longer than this, so that traversal needs a stack of fixed size.
inline constexpr int kBvhMaxDepth = 80;

/// Nodes (the root first; none for a mesh of no faces) and the faces in the order of the leaves.
struct BvhTree
{
    std::vector<BvhNode> nodes;
    std::vector<FaceId> faces;
};

/// Splits top-down where the surface-area heuristic, sampled at 16 places along the longest axis,
/// is least. The same mesh gives the same tree, whatever the number of threads.
BvhTree buildBvh(const TriangleMesh& mesh, Threads threads);

} // namespace trixel
