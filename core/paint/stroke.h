// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ids.h"
#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/mesh/surface.h"
#include "core/paint/brush.h"
#include "core/paint/ground.h"
#include "core/texture/texel_patch.h"
#include "core/texture/texel_store.h"
#include "core/texture/touched_rect.h"

#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <vector>

namespace trixel {

class LimitMesh;

/// Where pointer or pen met the surface.
struct StrokeSample
{
    FaceId face{};
    glm::vec2 uv{0};
    float pressure = 1.0F; ///< [0,1]
    double time = 0.0;     ///< seconds since the stroke began

    bool operator==(const StrokeSample&) const = default;
};

/// One stroke in progress: turns samples into dabs at constant arc length and blends them into the
/// store. Opacity caps what the stroke covers, flow builds it up, whatever the number of dabs.
/// Cost follows the texels touched. The same samples give the same texels, whatever the number of
/// threads and however the samples are grouped into calls.
///
/// A dab is a sphere. What it adds to a texel depends only on where the texel's centroid lies in
/// it: coverage moves by flow times falloff towards the opacity (times the pressure where that sets
/// the opacity) and never back, and the texel becomes before + coverage (colour - before); of a
/// layer it becomes what `TexelMix` says. Faces of every level within the sphere are painted,
/// duplicates and degenerate ones too; without paint-through not those that face away from the dab.
/// A dab that reaches no texel's centroid paints nothing. A dab of no pressure paints nothing where
/// pressure sets size or opacity.
class Stroke
{
public:
    /// \param ground  what is painted on; the fill of a base is one texel of it
    /// \param limit  of the surface, by `limitToPaintOn`: dabs then reach texels by where these lie
    ///               on the limit surface; null for the surface itself
    /// The brush must be valid (checked).
    Stroke(std::shared_ptr<const Surface> surface,
           const Brush& brush,
           Ground ground,
           Threads threads = Threads::all(),
           std::shared_ptr<const LimitMesh> limit = {});
    ~Stroke();
    Stroke(Stroke&&) noexcept;
    Stroke& operator=(Stroke&&) noexcept;

    /// Adds a sample; paints the dabs it completes and says what they changed (each face once).
    /// Samples with a face out of range or a position that is not finite are ignored.
    std::vector<TouchedRect> add(const StrokeSample& sample, TexelStore& store);

    /// The pointer left the surface or came to another part of it: the next sample starts a new
    /// path, with no dabs on the way there. Opacity still caps, and undo still takes back, the
    /// whole stroke.
    void lift();

    /// Ends the stroke: a patch of exactly the texels it changed, as they were before. Faces
    /// that the stroke left of one colour store one value from now on.
    TexelPatch finish(TexelStore& store);

private:
    class State;
    std::unique_ptr<State> m_state;
};

/// Gives the faces one colour each; returns what they held.
TexelPatch
fillFaces(TexelStore& store, std::span<const FaceId> faces, std::span<const std::byte> texel);

} // namespace trixel
