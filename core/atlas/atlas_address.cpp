// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/atlas_address.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace trixel {

namespace {

constexpr std::uint32_t kHeader = 4;
constexpr std::uint32_t kLevelNumbers = 3;
constexpr std::uint32_t kGridNumbers = 6;
constexpr std::uint32_t kLevels = Level::kMax + 1;

AtlasTap tapAt(const AtlasPlace& place, AtlasPixel pixel, double weight)
{
    return {place.page, {place.origin.x + pixel.x, place.origin.y + pixel.y}, weight};
}

} // namespace

AtlasTap nearestTap(const AtlasLayout& layout, FaceId face, Level level, glm::dvec2 uv)
{
    const TexelCoord texel = texelAt(level, uv);
    const AtlasPixel pixel = layout.tile(level).pixel({texel.i, texel.j, texel.half});
    return tapAt(layout.place(face, level), pixel, 1);
}

std::array<AtlasTap, 8>
bilinearTaps(const AtlasLayout& layout, FaceId face, Level level, glm::dvec2 uv)
{
    check(layout.options().border == AtlasBorder::Bilinear, "borders to interpolate in");
    const AtlasTile tile = layout.tile(level);
    const AtlasPlace place = layout.place(face, level);
    std::array<AtlasTap, 8> taps;
    std::size_t count = 0;
    for (const TexelHalf half : {TexelHalf::Lower, TexelHalf::Upper}) {
        const glm::dvec2 at = tile.position(uv, half) - 0.5;
        const glm::dvec2 first = glm::floor(at);
        const glm::dvec2 part = at - first;
        for (std::uint32_t k = 0; k < 4; ++k) {
            const AtlasPixel pixel{static_cast<std::uint32_t>(first.x) + k % 2,
                                   static_cast<std::uint32_t>(first.y) + k / 2};
            const double weight =
                (k % 2 == 1 ? part.x : 1 - part.x) * (k / 2 == 1 ? part.y : 1 - part.y);
            taps[count++] = tapAt(place, pixel, 0.5 * weight);
        }
    }
    return taps;
}

std::vector<AtlasTap>
trilinearTaps(const AtlasLayout& layout, FaceId face, double level, glm::dvec2 uv)
{
    check(layout.options().mips, "coarser levels to blend with");
    const double base = layout.level(face).log2();
    const double clamped = level > 0 ? std::min(level, base) : 0; // NaN is 0 too
    const Level coarse(static_cast<int>(clamped));
    const double toFine = clamped - coarse.log2();
    std::vector<AtlasTap> taps;
    const auto add = [&](Level at, double weight) {
        for (AtlasTap tap : bilinearTaps(layout, face, at, uv)) {
            tap.weight *= weight;
            taps.push_back(tap);
        }
    };
    add(coarse, 1 - toFine);
    if (toFine > 0) {
        add(Level(coarse.log2() + 1), toFine);
    }
    return taps;
}

std::vector<std::uint32_t> atlasTable(const AtlasLayout& layout)
{
    std::uint32_t grids = 0;
    for (std::uint32_t n = 0; n < kLevels; ++n) {
        grids += static_cast<std::uint32_t>(layout.grids(Level(static_cast<int>(n))).size());
    }
    const std::uint32_t gridsBegin = kHeader + kLevelNumbers * kLevels;
    const std::uint32_t facesBegin = gridsBegin + kGridNumbers * grids;
    std::vector<std::uint32_t> table{layout.options().border == AtlasBorder::None ? 0U : 1U,
                                     layout.options().mips ? 1U : 0U,
                                     gridsBegin,
                                     facesBegin};
    table.reserve(facesBegin + layout.faceCount());
    std::uint32_t first = 0;
    for (std::uint32_t n = 0; n < kLevels; ++n) {
        const Level level(static_cast<int>(n));
        const auto count = static_cast<std::uint32_t>(layout.grids(level).size());
        table.insert(table.end(), {first, count, layout.finerFaces(level)});
        first += count;
    }
    for (std::uint32_t n = 0; n < kLevels; ++n) {
        for (const AtlasGrid& grid : layout.grids(Level(static_cast<int>(n)))) {
            table.insert(
                table.end(),
                {grid.first, grid.count, grid.perRow, grid.page, grid.origin.x, grid.origin.y});
        }
    }
    for (std::size_t f = 0; f < layout.faceCount(); ++f) {
        const FaceId face = faceId(f);
        table.push_back(layout.rank(face) * 16 +
                        static_cast<std::uint32_t>(layout.level(face).log2()));
    }
    return table;
}

} // namespace trixel
