// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/texel_family.h"

#include "core/lattice/reduction.h"

#include <algorithm>

namespace trixel {

namespace {

PackedRow row(std::uint32_t x, std::uint32_t y, std::uint32_t count)
{
    return {{static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)},
            static_cast<std::uint16_t>(count)};
}

} // namespace

TexelCoord ancestorOf(Level level, TexelCoord texel, Level coarse)
{
    check(isValid(level, texel), "a texel of the level");
    check(coarse <= level, "a level that is not finer");
    const int steps = level.log2() - coarse.log2();
    const int cells = 1 << steps;
    // Place within the coarse cell: its diagonal has the lower texel on one side, the upper on the
    // other.
    const int across = (texel.i & (cells - 1)) + (texel.j & (cells - 1));
    const int lastBelow = texel.half == TexelHalf::Lower ? cells - 1 : cells - 2;
    return {static_cast<std::uint16_t>(texel.i >> steps),
            static_cast<std::uint16_t>(texel.j >> steps),
            across <= lastBelow ? TexelHalf::Lower : TexelHalf::Upper};
}

TexelCoord parentOf(Level level, TexelCoord texel)
{
    check(level.log2() >= 1, "a level to go up from");
    return ancestorOf(level, texel, level.coarser());
}

std::array<TexelCoord, 4> childrenOf(Level level, TexelCoord texel)
{
    check(level.log2() < Level::kMax, "a level to go down from");
    const Level fine(level.log2() + 1);
    std::array<TexelCoord, 4> children;
    std::ranges::transform(finerPixels(fine, packedPixel(level, texel)),
                           children.begin(),
                           [fine](PackedPixel pixel) { return texelAt(fine, pixel); });
    return children;
}

std::vector<PackedRow> packedDescendants(Level level, TexelCoord texel, Level fine)
{
    check(isValid(level, texel), "a texel of the level");
    check(fine >= level, "a level that is not coarser");
    const int steps = fine.log2() - level.log2();
    const std::uint32_t cells = 1U << static_cast<unsigned>(steps);
    const std::uint32_t i = std::uint32_t{texel.i} << static_cast<unsigned>(steps);
    const std::uint32_t j = std::uint32_t{texel.j} << static_cast<unsigned>(steps);
    const std::uint32_t last = fine.resolution() - 1;
    std::vector<PackedRow> rows;
    rows.reserve(2 * cells - 1);
    if (texel.half == TexelHalf::Lower) {
        for (std::uint32_t b = 0; b < cells; ++b) {
            rows.push_back(row(i, j + b, cells - b));
        }
        for (std::uint32_t a = 0; a + 1 < cells; ++a) {
            const std::uint32_t count = cells - 1 - a;
            rows.push_back(row(last - j - (count - 1), last - i - a, count));
        }
    } else {
        for (std::uint32_t a = 0; a < cells; ++a) {
            rows.push_back(row(last - j - (cells - 1), last - i - a, a + 1));
        }
        for (std::uint32_t b = 1; b < cells; ++b) {
            rows.push_back(row(i + cells - b, j + b, b));
        }
    }
    return rows;
}

} // namespace trixel
