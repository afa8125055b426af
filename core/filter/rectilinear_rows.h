// SPDX-License-Identifier: GPL-3.0-or-later
//
// The texels of a face in rows: in x = u + v/2 the lower and upper texels of a row lie half a texel
// apart, by turns. What the row filters share.
#pragma once

#include "core/filter/filter_scene.h"
#include "core/filter/surface_walk.h"
#include "core/lattice/texel.h"

#include <array>
#include <cstdint>

namespace trixel {

/// Weighted sum of four channels. In double, so that the weights of a constant add up to it again.
struct TexelSum
{
    std::array<double, kGroupChannels> channels{};
    double weight = 0;

    /// A weight of 0 keeps even a NaN out.
    void add(const float* texel, double w)
    {
        if (w == 0) {
            return;
        }
        for (std::size_t c = 0; c < channels.size(); ++c) {
            channels[c] += w * static_cast<double>(texel[c]);
        }
        weight += w;
    }
    /// Divided by the weights. \param value  four channels
    void store(float* value) const
    {
        for (std::size_t c = 0; c < channels.size(); ++c) {
            value[c] = static_cast<float>(channels[c] / weight);
        }
    }
};

/// Position in the row lattice of a face at a level, in texels: row j holds at column m (x = m/2) a
/// lower texel where m - j is odd, an upper one where it is even. Rows and columns go on beyond the
/// face.
struct RowTexel
{
    int column = 0;
    int row = 0;

    bool isLower() const { return ((column - row) & 1) != 0; }
    /// Cell of the lattice.
    int i() const { return (column - row - (isLower() ? 1 : 2)) / 2; }
    int j() const { return row; }
    /// Height of the centroid in rows: a third above the row's foot, or two thirds.
    double height() const { return row + (isLower() ? 1.0 / 3.0 : 2.0 / 3.0); }
};

/// The texel under a point of the surface, at a level or the face's base where that is coarser.
inline const float*
texelUnder(const FilterScene& scene, const SurfacePlace& place, Level level, int group)
{
    const Level own = std::min(level, scene.level(place.face));
    return scene.mips()
        .texels(place.face, own, group)
        .texel(texelIndex(own, texelAt(own, place.uv)));
}

/// Reads texels by row and column, also beyond the face: those are found where a straight line from
/// the face's point leads over the surface.
class RowReader
{
public:
    /// \param level   not above the face's (checked)
    /// \param centre  where lines to texels beyond the face begin
    RowReader(const FilterScene& scene, const SurfacePlace& centre, Level level, int group);

    const float* texel(RowTexel at) const
    {
        const float* inside = texelInside(at);
        return inside != nullptr ? inside : texelBeyond(at);
    }

    /// Null where the texel is not of this face.
    const float* texelInside(RowTexel at) const
    {
        const int i = at.i();
        const int j = at.j();
        const bool lower = at.isLower();
        // Column and row of a cell beyond the edges u = 0 and v = 0 are negative.
        if (i < 0 || j < 0 || i + j + (lower ? 0 : 1) >= m_resolution) {
            return nullptr;
        }
        const int last = m_resolution - 1;
        const int x = lower ? i : last - j;
        const int y = lower ? j : last - i;
        return m_texels.texel(static_cast<TexelIndex>(x + y * m_resolution));
    }

    int resolution() const { return m_resolution; }

private:
    const float* texelBeyond(RowTexel at) const;

    const FilterScene& m_scene;
    SurfacePlace m_centre;
    Level m_level;
    int m_group;
    int m_resolution;
    LevelTexels m_texels;
};

/// Adds the rectilinear bilinear interpolation at a point, which costs four taps: linear along x
/// in two rows, then between them. Rows are followed at the true heights of their centroids, which
/// zigzag by a sixth of a texel: at the nominal y = j + 1/2 an affine texture would come out up to
/// that far off.
/// \param level  or the face's base where that is coarser
void addRectilinearBilinear(const FilterScene& scene,
                            const SurfacePlace& at,
                            Level level,
                            int group,
                            double weight,
                            TexelSum& sum);

/// The same in two levels, blended; costs 4 or 8 taps, which are returned.
/// \param level  any number; clamped to the levels of the face
std::uint32_t addTrilinear(const FilterScene& scene,
                           const SurfacePlace& at,
                           double level,
                           int group,
                           double weight,
                           TexelSum& sum);

} // namespace trixel
