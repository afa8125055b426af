// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/face_map.h"
#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/lattice/texel.h"
#include "core/texture/texel_store.h"
#include "core/texture/touched_rect.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace trixel {

/// Channels are filtered four at a time: one register of floats.
inline constexpr int kGroupChannels = 4;

/// Texels of one face at one level, ready to filter: texel `i` of the packed order begins at
/// values + stride * i and has four channels (those beyond the format's are 0).
struct LevelTexels
{
    const float* values = nullptr;
    std::uint32_t stride = kGroupChannels; ///< 0 where the face is constant

    const float* texel(TexelIndex index) const { return values + stride * indexOf(index); }
};

/// Every texel of a store as floats, and every coarser level of every face as the mean of four
/// without rounding between levels. A cache for filters: faces that share their bytes in the store
/// share them here, so an unpainted mesh costs one texel and tiled content one tile.
class FloatMips
{
public:
    FloatMips() = default;

    /// Fails only when cancelled.
    static Result<FloatMips> build(const TexelStore& store, Threads threads, Progress& progress);

    /// Takes over what changed. Cost follows the faces that were touched.
    void update(const TexelStore& store, std::span<const TouchedRect> rects);

    std::size_t faceCount() const { return m_chains.size(); }
    int channels() const { return m_channels; }
    /// Groups of four channels.
    int groups() const { return (m_channels + kGroupChannels - 1) / kGroupChannels; }

    Level level(FaceId face) const { return m_chains[face]->level; }
    bool isConstant(FaceId face) const { return m_chains[face]->constant; }

    /// \param group  in [0, groups())
    /// \param level  not above level(face) (checked)
    LevelTexels texels(FaceId face, Level level, int group = 0) const
    {
        const Chain& chain = *m_chains[face];
        check(level <= chain.level, "a level that the face has");
        const float* values = chain.values.get() + group * chain.groupSize;
        return chain.constant ? LevelTexels{values, 0}
                              : LevelTexels{values + chainBegin(chain.level, level)};
    }

    /// Mean of the whole face. \param group  in [0, groups())
    const float* average(FaceId face, int group = 0) const
    {
        return texels(face, Level(0), group).values;
    }

    /// Whether two faces share one set of values.
    bool share(FaceId a, FaceId b) const { return m_chains[a] == m_chains[b]; }

    std::size_t memoryBytes() const;

private:
    /// Levels from the base down to 0, one group of channels after the other.
    struct Chain
    {
        Level level;
        bool constant = true;
        std::size_t groupSize = 0; ///< floats
        std::unique_ptr<float[]> values;
    };

    static std::size_t chainBegin(Level base, Level level);
    static std::shared_ptr<const Chain> makeChain(const TexelFormat& format,
                                                  const FaceTexels& face);

    FaceMap<std::shared_ptr<const Chain>> m_chains;
    int m_channels = 0;
};

} // namespace trixel
