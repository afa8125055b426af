// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/atlas_layout.h"

#include "core/atlas/atlas_packer.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace trixel {

namespace {

constexpr std::size_t kMostPages = 65535;

std::size_t numberOf(Level level)
{
    return static_cast<std::size_t>(level.log2());
}

/// A width with which one page would come out about square; the largest where there will be more.
std::uint32_t pageWidth(const AtlasLayout& layout, std::uint32_t largest)
{
    double area = 0;
    for (int n = 0; n <= layout.finest().log2(); ++n) {
        const double side = layout.tile(Level(n)).side();
        area += side * side * layout.tileCount(Level(n));
    }
    const std::uint32_t tile = layout.tile(layout.finest()).side();
    const double square = std::ceil(std::sqrt(area) / tile) * tile;
    return square >= largest ? largest : static_cast<std::uint32_t>(square);
}

} // namespace

Result<AtlasLayout> AtlasLayout::plan(const FaceMap<Level>& levels, const AtlasOptions& options)
{
    AtlasLayout layout;
    layout.m_options = options;
    layout.m_levels = levels;
    layout.m_ranks = FaceMap<std::uint32_t>(levels.size());
    for (std::size_t f = 0; f < levels.size(); ++f) {
        layout.m_finest = std::max(layout.m_finest, levels[faceId(f)]);
        for (int n = 0; n < levels[faceId(f)].log2(); ++n) {
            ++layout.m_finer[static_cast<std::size_t>(n)];
        }
    }
    if (const std::uint32_t side = layout.tile(layout.m_finest).side();
        side > options.largestPage && levels.size() > 0) {
        const auto first = std::ranges::find(levels.values(), layout.m_finest);
        return contentsError("face " + std::to_string(first - levels.values().begin()) +
                             " needs pages of " + std::to_string(side) + " pixels, more than the " +
                             std::to_string(options.largestPage) + " allowed");
    }
    std::array<std::uint32_t, Level::kMax + 1> next = layout.m_finer;
    layout.m_faces.resize(levels.size());
    for (std::size_t f = 0; f < levels.size(); ++f) {
        const std::uint32_t rank = next[numberOf(levels[faceId(f)])]++;
        layout.m_ranks[faceId(f)] = rank;
        layout.m_faces[rank] = faceId(f);
    }

    AtlasPacker packer(pageWidth(layout, options.largestPage),
                       options.largestPage,
                       options.packing == AtlasPacking::Shelves);
    for (int n = layout.m_finest.log2(); n >= 0 && levels.size() > 0; --n) {
        layout.m_grids[static_cast<std::size_t>(n)] =
            packer.place(layout.tileCount(Level(n)), layout.tile(Level(n)).side());
    }
    layout.m_pages = packer.pages();
    if (layout.m_pages.size() > kMostPages) {
        return contentsError("the atlas needs " + std::to_string(layout.m_pages.size()) +
                             " pages, more than " + std::to_string(kMostPages));
    }
    return layout;
}

std::uint32_t AtlasLayout::tileCount(Level level) const
{
    const std::uint32_t atLeast = level == Level() ? static_cast<std::uint32_t>(m_levels.size())
                                                   : m_finer[numberOf(level) - 1];
    return m_options.mips ? atLeast : atLeast - m_finer[numberOf(level)];
}

AtlasPlace AtlasLayout::place(FaceId face, Level level) const
{
    check(m_options.mips ? level <= m_levels[face] : level == m_levels[face],
          "a level that the atlas has of the face");
    const std::uint32_t rank = tileRank(face, level);
    const std::vector<AtlasGrid>& grids = m_grids[numberOf(level)];
    const auto after = std::ranges::upper_bound(grids, rank, {}, &AtlasGrid::first);
    const AtlasGrid& grid = *(after - 1);
    const std::uint32_t k = rank - grid.first;
    const std::uint32_t side = tile(level).side();
    return {grid.page,
            {grid.origin.x + k % grid.perRow * side, grid.origin.y + k / grid.perRow * side}};
}

std::uint64_t AtlasLayout::usefulTexels() const
{
    std::uint64_t texels = 0;
    for (int n = 0; n <= m_finest.log2(); ++n) {
        texels += std::uint64_t{tileCount(Level(n))} * Level(n).texelCount();
    }
    return texels;
}

std::uint64_t AtlasLayout::allocatedPixels() const
{
    std::uint64_t pixels = 0;
    for (const AtlasPage& page : m_pages) {
        pixels += std::uint64_t{page.width} * page.height;
    }
    return pixels;
}

double AtlasLayout::occupancy() const
{
    const std::uint64_t allocated = allocatedPixels();
    return allocated == 0 ? 1.0
                          : static_cast<double>(usefulTexels()) / static_cast<double>(allocated);
}

} // namespace trixel
