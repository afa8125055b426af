// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/atlas/atlas_layout.h"
#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/adjacency.h"
#include "core/texture/texel_store.h"

#include <cstddef>
#include <span>
#include <vector>

namespace trixel {

/// A texel of a face at a level.
struct AtlasSource
{
    FaceId face{};
    Level level;
    TexelCoord texel;

    bool operator==(const AtlasSource&) const = default;
};

/// The texels that an atlas stores, one level after the other from the finest down: each face at
/// the level asked for, or at its own where that is coarser. Refers to the adjacency.
class AtlasTexels
{
public:
    /// Begins at the finest level of the store, of which it is a snapshot.
    AtlasTexels(const TexelStore& store, const Adjacency& adjacency);

    Level level() const { return m_level; }
    const TexelFormat& format() const { return m_format; }

    /// Goes to the next coarser level, reducing as `reduced` does, where one channel is opacity
    /// with values that are weighed by it. \pre level() > 0 (checked)
    void coarsen(Threads threads);
    /// The same for long work. Fails when cancelled and when memory runs out; some faces are
    /// reduced then, others not.
    Status coarsen(Threads threads, Progress& progress);

    /// Takes a face's texels as they are now. \pre of the level that it has here (checked)
    void replace(FaceId face, FaceTexels texels);
    Level levelOf(FaceId face) const { return m_faces[indexOf(face)].level(); }

    /// The texel in a cell of a face's lattice at its own resolution or this level's, whichever is
    /// coarser; of a neighbour where the cell lies outside. Across an edge the neighbour is
    /// unfolded as `acrossEdge` does, and asked for its texel under the cell's centroid; beyond a
    /// border it is the nearest texel inside.
    AtlasSource source(FaceId face, LatticeCell cell) const;

    /// Writes the tile of a face, all pixels of it. Stored faces that it reads are not held.
    /// \param page    the first pixel of the tile
    /// \param stride  bytes from one row of the page to the next
    void fill(FaceId face, const AtlasTile& tile, std::byte* page, std::size_t stride) const;

private:
    class Neighbours;
    void fillBorder(Neighbours& neighbours,
                    FaceId face,
                    const AtlasTile& tile,
                    std::uint32_t row,
                    std::uint32_t begin,
                    std::uint32_t end,
                    std::byte* target) const;

    const Adjacency& m_adjacency;
    TexelFormat m_format;
    Level m_level;
    std::vector<FaceTexels> m_faces;
};

} // namespace trixel
