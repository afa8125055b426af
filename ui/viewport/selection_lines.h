// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/limit_mesh.h"
#include "core/mesh/surface.h"
#include "render/overlay_pass.h"

#include <span>
#include <vector>

namespace trixel::ui {

/// Most edges of an outline that are drawn, and most lines they are drawn as.
inline constexpr std::size_t kMostOutlineEdges = 16384;
inline constexpr std::size_t kMostOutlineLines = 1024;

/// The border of a set of faces: the edges that have a chosen face on one side only, joined to
/// lines. Where there are more than is drawn, the longest lines are kept.
/// \param faces  ascending, each once
/// \param limit  that the faces are seen on; null for the cage
std::vector<render::Polyline> selectionOutline(const Surface& surface,
                                               std::span<const FaceId> faces,
                                               const LimitMesh* limit = nullptr);

} // namespace trixel::ui
