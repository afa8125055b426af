// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the faces of a mesh lie in a packed atlas.
//
// Faces are ranked, finest first; a level's tiles follow each other by rank in grids, rectangles of
// so many tiles a row. So a tile's place needs of a face only its rank and level, and of a level
// its few grids: with the finest faces first, those that have a level are the first so many, whose
// count is the prefix sum of faces that are as fine or finer.
#pragma once

#include "core/atlas/atlas_tile.h"
#include "core/base/face_map.h"
#include "core/base/result.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace trixel {

/// How tiles of different sizes share a page.
enum class AtlasPacking : std::uint8_t {
    Bands,  ///< one grid a level, each below the one before; what a row lacks is lost
    Shelves ///< coarser tiles fill what rows of finer ones leave
};

struct AtlasOptions
{
    AtlasBorder border = AtlasBorder::Bilinear;
    AtlasPacking packing = AtlasPacking::Shelves;
    bool mips = false;                 ///< every face also at each coarser level
    std::uint32_t largestPage = 16384; ///< most pixels of a page along either side
};

struct AtlasPage
{
    std::uint32_t width = 0;
    std::uint32_t height = 0;

    bool operator==(const AtlasPage&) const = default;
};

/// Tiles of one level in rows, from the left and the top; the last row may be short.
struct AtlasGrid
{
    std::uint32_t first = 0; ///< rank among the level's tiles
    std::uint32_t count = 0;
    std::uint32_t perRow = 1;
    std::uint32_t page = 0;
    AtlasPixel origin;

    bool operator==(const AtlasGrid&) const = default;
};

/// Where a tile begins.
struct AtlasPlace
{
    std::uint32_t page = 0;
    AtlasPixel origin;

    bool operator==(const AtlasPlace&) const = default;
};

class AtlasLayout
{
public:
    /// Fails, naming a face, where a page cannot hold its tile, or where there would be more than
    /// 65,535 pages.
    static Result<AtlasLayout> plan(const FaceMap<Level>& levels, const AtlasOptions& options);

    const AtlasOptions& options() const { return m_options; }
    std::span<const AtlasPage> pages() const { return m_pages; }
    std::size_t faceCount() const { return m_levels.size(); }
    Level level(FaceId face) const { return m_levels[face]; }
    /// The finest level of any face.
    Level finest() const { return m_finest; }

    /// Among all faces: finer ones first, those of one level in order of their numbers.
    std::uint32_t rank(FaceId face) const { return m_ranks[face]; }
    /// The inverse.
    FaceId faceOfRank(std::uint32_t rank) const { return m_faces[rank]; }
    /// Faces that are finer than a level; with mips no tile of them is skipped.
    std::uint32_t finerFaces(Level level) const
    {
        return m_finer[static_cast<std::size_t>(level.log2())];
    }
    /// Rank of a face's tile among those of a level.
    std::uint32_t tileRank(FaceId face, Level level) const
    {
        return rank(face) - (m_options.mips ? 0 : finerFaces(level));
    }
    /// Tiles of a level.
    std::uint32_t tileCount(Level level) const;
    /// In order of rank.
    std::span<const AtlasGrid> grids(Level level) const
    {
        return m_grids[static_cast<std::size_t>(level.log2())];
    }
    AtlasTile tile(Level level) const { return {level, m_options.border}; }

    /// \param level  of the face; with mips any that is not finer (checked)
    AtlasPlace place(FaceId face, Level level) const;

    /// Texels of all tiles, borders not counted.
    std::uint64_t usefulTexels() const;
    /// Pixels of all pages.
    std::uint64_t allocatedPixels() const;
    /// The one in parts of the other; 1 where there are none.
    double occupancy() const;

private:
    AtlasOptions m_options;
    Level m_finest;
    FaceMap<Level> m_levels;
    FaceMap<std::uint32_t> m_ranks;
    std::vector<FaceId> m_faces;                          ///< by rank
    std::array<std::uint32_t, Level::kMax + 1> m_finer{}; ///< by level
    std::array<std::vector<AtlasGrid>, Level::kMax + 1> m_grids;
    std::vector<AtlasPage> m_pages;
};

} // namespace trixel
