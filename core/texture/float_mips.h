// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/lattice/texel.h"
#include "core/texture/float_chain.h"
#include "core/texture/shared_blocks.h"
#include "core/texture/texel_store.h"
#include "core/texture/touched_rect.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace trixel {

/// Every texel of a store as floats, and every coarser level of every face as the mean of four
/// without rounding between levels. A cache for filters: faces that share their bytes in the store
/// share them here, so an unpainted mesh costs one texel and tiled content one tile.
class FloatMips
{
public:
    FloatMips() = default;

    /// Fails only when cancelled.
    static Result<FloatMips> build(const TexelStore& store, Threads threads, Progress& progress);

    /// Takes over what changed: the touched texels and their parents, and whole faces where a rect
    /// says so or where the level or constancy changed. What others share is copied first.
    /// \return  texels that were set, all levels and groups
    std::size_t update(const TexelStore& store, std::span<const TouchedRect> rects);

    std::size_t faceCount() const { return m_chains.faceCount(); }
    int channels() const { return m_channels; }
    /// Groups of four channels.
    int groups() const { return (m_channels + kGroupChannels - 1) / kGroupChannels; }

    Level level(FaceId face) const { return m_chains.block(face).level; }
    bool isConstant(FaceId face) const { return m_chains.block(face).constant; }

    /// \param group  in [0, groups())
    /// \param level  not above level(face) (checked)
    LevelTexels texels(FaceId face, Level level, int group = 0) const
    {
        const SharedBlocks::Block& chain = m_chains.block(face);
        check(level <= chain.level, "a level that the face has");
        const float* values = chain.values.get() + static_cast<std::size_t>(group) *
                                                       chainSize(chain.level, chain.constant);
        return chain.constant ? LevelTexels{values, 0}
                              : LevelTexels{values + chainBegin(chain.level, level)};
    }

    /// Mean of the whole face. \param group  in [0, groups())
    const float* average(FaceId face, int group = 0) const
    {
        return texels(face, Level(0), group).values;
    }

    /// Whether two faces share one set of values.
    bool share(FaceId a, FaceId b) const { return valuesOf(a) == valuesOf(b); }
    /// The same for all faces that share one set of values, another for all others.
    std::uint32_t valuesOf(FaceId face) const { return m_chains.blockNumber(face); }
    /// Faces that share this face's values, itself among them.
    std::uint32_t sharers(FaceId face) const { return m_chains.block(face).users; }

    std::size_t memoryBytes() const { return m_chains.memoryBytes(); }

private:
    float* renew(const TexelStore& store, FaceId face);
    std::size_t updateRect(const TexelStore& store, const TouchedRect& rect);

    // Per face: levels from the base down to 0, one group of channels after the other.
    SharedBlocks m_chains;
    int m_channels = 0;
};

} // namespace trixel
