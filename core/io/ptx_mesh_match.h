// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/ptx_layout.h"
#include "core/mesh/adjacency.h"
#include "core/mesh/mesh_report.h"

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace trixel {

/// Compares what a .ptx says of its faces' neighbours with the mesh's own adjacency, and so its
/// order and winding of faces with the mesh's. A face that names no neighbours at all (one nobody
/// wrote) matches any, and where three or more faces share an edge the file may link any of them.
/// \param visit  called with a sentence for each face that differs, saying whether it looks like
///               another order, winding or first corner; returns whether to go on
void matchPtxWithMesh(std::span<const PtxFaceInfo> infos,
                      const Adjacency& adjacency,
                      std::span<const MeshReport::Edge> nonManifoldEdges,
                      const std::function<bool(std::string)>& visit);

} // namespace trixel
