// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/footprint/footprint.h"
#include "core/lattice/texel.h"
#include "core/mesh/surface.h"
#include "core/texture/texel_report.h"
#include "core/texture/texel_store.h"
#include "render/look.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace trixel::ui {

/// What a filter is asked for a pixel.
struct PixelQuery
{
    FaceId face{};
    glm::vec2 uv{0}; ///< seen through the pixel's middle
    Footprint footprint;
};

/// The texel looked at, as the view shows it, for the readout.
struct HoveredTexel
{
    SurfacePoint point;
    TexelReport report; ///< with position, and polygon where that is another number
    Level level;        ///< of the face as shown (after the mip drop)
    TexelCoord texel;
    TexelIndex index{};
    PackedPixel pixel;
    std::vector<float> values; ///< one a channel, as stored; none while its face is being read
    bool isHeld = false;       ///< and stays when the pointer goes elsewhere
    bool hasFootprint = false; ///< not for a point behind the camera: then the next two are empty
    Footprint footprint;
    FootprintEllipse ellipse;
    /// The pixel under the pointer; nothing where its middle is off the surface. Of a point that is
    /// held or that a panel points at: that point.
    std::optional<PixelQuery> pixelQuery;
};

/// Reads single texels of a store as shown, some levels coarser. Many levels coarser it keeps the
/// last face it reduced, so that moving about in one face costs nothing.
class ShownTexels
{
public:
    /// A face reduced.
    struct Reduced
    {
        FaceId face{};
        int levelsDropped = 0;
        FaceTexels texels;
    };

    /// Whether a texel is there at once: no file is to be read for it, and no large face reduced.
    bool has(const TexelStore& store, FaceId face, int levelsDropped) const;
    /// Does what `has` is short of, on any thread: reads the face, which stays in the memory that
    /// its copies share, and reduces it where single texels would take long.
    /// \return  none where reading was all
    static std::optional<Reduced>
    prepare(const TexelFormat& format, FaceId face, const FaceTexels& texels, int levelsDropped);
    /// Takes a face that is as the store has it.
    void keep(Reduced reduced) { m_reduced = std::move(reduced); }

    /// Values of a texel, one a channel. \param level  the face's own, less the levels dropped
    std::vector<float>
    values(const TexelStore& store, FaceId face, int levelsDropped, TexelIndex index);
    /// The same as bytes in the store's format.
    std::vector<std::byte>
    stored(const TexelStore& store, FaceId face, int levelsDropped, TexelIndex index);

    /// To be called when texels changed.
    void forget() { m_reduced.reset(); }

private:
    bool keeps(FaceId face, int levelsDropped) const
    {
        return m_reduced && m_reduced->face == face && m_reduced->levelsDropped == levelsDropped;
    }

    std::optional<Reduced> m_reduced;
};

/// What can be said of the texel at a point of a surface, whoever looks at it from where: its
/// values only where they are there at once (`ShownTexels::has`).
HoveredTexel describeTexel(const Surface& surface,
                           const TexelStore& store,
                           ShownTexels& shown,
                           const SurfacePoint& point,
                           int levelsDropped);

/// What a look makes of a texel's values: each channel between black and white, and the colour.
TexelDisplay
displayOf(const TexelFormat& format, std::span<const float> values, const render::Look& look);

/// Adds the footprint of the pixel that a ray goes through.
/// \param corners  of the face, or of one that touches a curved surface at the texel's point
void addFootprint(HoveredTexel& texel,
                  const std::array<glm::vec3, 3>& corners,
                  const PixelRay& ray);

} // namespace trixel::ui
