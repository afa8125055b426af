// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/paint/brush.h"
#include "render/overlay_pass.h"
#include "ui/viewport/hovered_texel.h"
#include "ui/viewport/seen_surface.h"

#include <glm/vec4.hpp>
#include <vector>

namespace trixel::ui {

/// A pixel's footprint is a pixel large on the screen: it is drawn so many times larger.
inline constexpr double kFootprintMagnification = 40.0;

inline constexpr glm::vec4 kEllipseColor{0.35F, 0.9F, 1.0F, 0.95F};
inline constexpr glm::vec4 kParallelogramColor{1.0F, 0.75F, 0.3F, 0.9F};
/// Of a footprint that was frozen to be compared with.
inline constexpr glm::vec4 kFrozenColor{1.0F, 0.55F, 0.95F, 0.95F};

/// The brush's reach around a point and, where it is not hard, the part painted at full strength;
/// both are drawn onto the surface nearby.
std::vector<render::Polyline>
brushRing(const SeenSurface& surface, const SurfacePoint& point, const Brush& brush);

/// Parallelogram and ellipse of a footprint in the plane of its face, magnified.
std::vector<render::Polyline> footprintLines(const SeenSurface& surface, const HoveredTexel& texel);

/// The edges of the hovered texel.
render::Polyline texelOutline(const SeenSurface& surface, const HoveredTexel& texel);

/// The edges of a held texel, thick, and three ticks that point at its corners from outside.
/// \param perPixel  world length of a logical pixel there
std::vector<render::Polyline>
heldTexelLines(const SeenSurface& surface, const HoveredTexel& texel, float perPixel);

} // namespace trixel::ui
