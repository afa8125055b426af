// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/rectilinear_rows.h"

#include <algorithm>
#include <cmath>

namespace trixel {
namespace {

/// A place between two columns of every row.
struct Between
{
    int column = 0;      ///< the left one
    double fraction = 0; ///< to the right one

    /// Where row j runs there.
    double height(int row) const
    {
        const double left = RowTexel{column, row}.height();
        const double right = RowTexel{column + 1, row}.height();
        return left + fraction * (right - left);
    }
};

} // namespace

RowReader::RowReader(const FilterScene& scene, const SurfacePlace& centre, Level level, int group)
    : m_scene(scene)
    , m_centre(centre)
    , m_level(level)
    , m_group(group)
    , m_resolution(static_cast<int>(level.resolution()))
    , m_texels(scene.mips().texels(centre.face, level, group))
{
}

const float* RowReader::texelBeyond(RowTexel at) const
{
    const double third = at.isLower() ? 1.0 / 3.0 : 2.0 / 3.0;
    const glm::dvec2 centroid = glm::dvec2(at.i() + third, at.j() + third) / double(m_resolution);
    const SurfaceWalk walk = walkStraight(m_scene.surface(), m_centre, centroid - m_centre.uv);
    return texelUnder(m_scene, walk.end, m_level, m_group);
}

void addRectilinearBilinear(const FilterScene& scene,
                            const SurfacePlace& at,
                            Level level,
                            int group,
                            double weight,
                            TexelSum& sum)
{
    const RowReader reader(scene, at, std::min(level, scene.level(at.face)), group);
    const double x = (2 * at.uv.x + at.uv.y) * reader.resolution(); // in columns
    const double y = at.uv.y * reader.resolution();
    const double column = std::floor(x);
    const Between place{static_cast<int>(column), x - column};
    // The rows run at most a sixth from their middle, so the lower one is one of three.
    int row = static_cast<int>(std::floor(y - 0.5));
    if (y < place.height(row)) {
        --row;
    } else if (y >= place.height(row + 1)) {
        ++row;
    }
    const double low = place.height(row);
    const double up = (y - low) / (place.height(row + 1) - low);
    const double right = place.fraction;
    const int m = place.column;
    sum.add(reader.texel({m, row}), weight * (1 - right) * (1 - up));
    sum.add(reader.texel({m + 1, row}), weight * right * (1 - up));
    sum.add(reader.texel({m, row + 1}), weight * (1 - right) * up);
    sum.add(reader.texel({m + 1, row + 1}), weight * right * up);
}

std::uint32_t addTrilinear(const FilterScene& scene,
                           const SurfacePlace& at,
                           double level,
                           int group,
                           double weight,
                           TexelSum& sum)
{
    const double base = scene.level(at.face).log2();
    const double clamped = level > 0 ? std::min(level, base) : 0;
    const Level coarse(static_cast<int>(clamped));
    const double toFine = clamped - coarse.log2();
    addRectilinearBilinear(scene, at, coarse, group, weight * (1 - toFine), sum);
    if (toFine == 0) {
        return 4;
    }
    addRectilinearBilinear(scene, at, Level(coarse.log2() + 1), group, weight * toFine, sum);
    return 8;
}

} // namespace trixel
