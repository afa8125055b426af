// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/footprint/footprint.h"
#include "core/lattice/texel.h"
#include "core/mesh/bvh.h"
#include "core/texture/texel_store.h"

#include <optional>
#include <vector>

namespace trixel::ui {

/// What a filter is asked for a pixel.
struct PixelQuery
{
    FaceId face{};
    glm::vec2 uv{0}; ///< seen through the pixel's middle
    Footprint footprint;
};

/// The texel under the pointer, for the readout.
struct HoveredTexel
{
    SurfacePoint point;
    Level level; ///< of the face as shown (after the mip drop)
    TexelCoord texel;
    TexelIndex index{};
    PackedPixel pixel;
    std::vector<float> values; ///< one a channel, as stored
    Footprint footprint;
    FootprintEllipse ellipse;
    /// The pixel under the pointer; nothing where its middle is off the surface.
    std::optional<PixelQuery> pixelQuery;
};

/// Reads single texels of a store as shown, some levels coarser. Keeps the last face it reduced,
/// so that moving about in one face costs nothing.
class ShownTexels
{
public:
    /// Values of a texel, one a channel. \param level  the face's own, less the levels dropped
    std::vector<float>
    values(const TexelStore& store, FaceId face, int levelsDropped, TexelIndex index);

    /// To be called when texels changed.
    void forget() { m_reduced.reset(); }

private:
    struct Reduced
    {
        FaceId face{};
        int levelsDropped = 0;
        FaceTexels texels;
    };
    std::optional<Reduced> m_reduced;
};

/// All that the readout says about the texel at a point.
/// \param ray  through the pixel that shows it
HoveredTexel describeTexel(const TriangleMesh& mesh,
                           const TexelStore& store,
                           ShownTexels& shown,
                           const SurfacePoint& point,
                           const PixelRay& ray,
                           int levelsDropped);

} // namespace trixel::ui
