// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/float_chain.h"

#include "core/lattice/reduction.h"
#include "core/texture/touched_cells.h"

#include <algorithm>
#include <array>

namespace trixel {
namespace {

/// One texel of the coarser level by the rule of `finerPixels`.
void reduceTexel(Level fine, const float* source, std::uint32_t x, std::uint32_t y, float* target)
{
    const auto finer =
        finerPixels(fine, {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)});
    std::array<const float*, 4> from{};
    std::ranges::transform(finer, from.begin(), [&](PackedPixel pixel) {
        return source + kGroupChannels * indexOf(texelIndex(fine, pixel));
    });
    float* to = target + kGroupChannels * (std::size_t{y} * (fine.resolution() / 2) + x);
    for (int c = 0; c < kGroupChannels; ++c) {
        to[c] = 0.25F * ((from[0][c] + from[1][c]) + (from[2][c] + from[3][c]));
    }
}

void reduceGroup(Level fine, const float* source, float* target)
{
    const std::uint32_t resolution = fine.coarser().resolution();
    for (std::uint32_t y = 0; y < resolution; ++y) {
        for (std::uint32_t x = 0; x < resolution; ++x) {
            reduceTexel(fine, source, x, y, target);
        }
    }
}

/// Both texels of the cells; how many.
std::size_t reduceCells(Level fine, const float* source, const CellRect& cells, float* target)
{
    const std::uint32_t r = fine.coarser().resolution();
    std::size_t count = 0;
    for (std::uint32_t j = cells.j0; j <= cells.j1; ++j) {
        for (std::uint32_t i = cells.i0; i <= cells.i1 && i + j < r; ++i) {
            reduceTexel(fine, source, i, j, target);
            ++count;
            if (i + j + 1 < r) {
                reduceTexel(fine, source, r - 1 - j, r - 1 - i, target);
                ++count;
            }
        }
    }
    return count;
}

} // namespace

void fillCoarser(Level base, float* values)
{
    for (Level level = base; level > Level(0); level = level.coarser()) {
        float* coarser = values + kGroupChannels * std::size_t{level.texelCount()};
        reduceGroup(level, values, coarser);
        values = coarser;
    }
}

std::size_t updateCoarser(Level base, const TouchedRect& rect, float* values)
{
    std::size_t count = 0;
    TouchedCells cells(base, rect);
    for (Level level = base; level > Level(0); level = level.coarser()) {
        cells = cells.coarser();
        for (std::size_t k = 0; k < cells.count; ++k) {
            count += reduceCells(level,
                                 values + chainBegin(base, level),
                                 cells.rects[k],
                                 values + chainBegin(base, level.coarser()));
        }
    }
    return count;
}

} // namespace trixel
