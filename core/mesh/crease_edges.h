// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/triangle_mesh.h"

#include <cstddef>
#include <optional>
#include <span>

namespace trixel {

/// The first of the creases whose vertices share no edge of the mesh; nothing where all do. Takes
/// time linear in the mesh.
/// \param creases  between vertices of the mesh
std::optional<std::size_t> firstOffEdges(const TriangleMesh& mesh, std::span<const Crease> creases);

} // namespace trixel
