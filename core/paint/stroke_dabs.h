// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/surface.h"
#include "core/paint/brush.h"
#include "core/paint/dab.h"
#include "core/paint/dab_reach.h"
#include "core/paint/ground.h"
#include "core/paint/stroke_path.h"
#include "core/paint/texel_blend.h"
#include "core/texture/texel_format.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace trixel {

/// A dab, and the faces it may paint in ascending order.
struct PlacedDab
{
    Dab dab;
    std::vector<FaceId> faces;
};

/// The first half of a stroke: turns samples into dabs at constant arc length and finds the faces
/// under each. What the dabs do to texels is up to who takes them: a `DabPainter`, or a preview.
class StrokeDabs
{
public:
    using Place = std::function<void(const Dab& dab, std::span<const FaceId> faces)>;

    /// The brush must be valid (checked).
    /// \param limit  of the surface, by `limitToPaintOn`, to paint on instead; null for the cage
    StrokeDabs(std::shared_ptr<const Surface> surface,
               const Brush& brush,
               std::shared_ptr<const LimitMesh> limit = {});

    const TriangleMesh& mesh() const { return m_surface->mesh(); }

    /// Calls `place` for each dab that a sample completes. Samples with a face out of range or a
    /// position that is not finite are ignored.
    void add(const StrokeSample& sample, const Place& place);

    /// The next sample starts a new path, with no dabs on the way to it.
    void lift() { m_path.lift(); }

private:
    glm::vec3 limitNormal(FaceId face, glm::vec2 uv) const;
    glm::vec3 positionOf(FaceId face, glm::vec2 uv) const;
    void placeDab(const StrokeSample& sample, const StrokePath::Point& point, const Place& place);

    std::shared_ptr<const Surface> m_surface;
    std::shared_ptr<const LimitMesh> m_limit;
    Brush m_brush;
    StrokePath m_path;
    DabReach m_reach;
    std::vector<FaceId> m_faces; ///< kept for its memory
};

/// What a brush moves texels towards, a number per channel: its colour, or the fill.
/// \param fill  the bytes of one texel, of which Erase makes use
std::vector<float>
strokeTarget(const Brush& brush, const TexelFormat& format, std::span<const std::byte> fill);

/// What a stroke makes of texels of a format. \param ground  on which they lie
TexelBlend strokeBlend(const Brush& brush, const TexelFormat& format, const Ground& ground);

} // namespace trixel
