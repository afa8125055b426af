// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texture/float_chain.h"
#include "core/texture/texel_store.h"
#include "core/texture/touched_rect.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

namespace trixel {

/// The four channels of a store that someone wants; -1 stands for the constant 1.
using ChosenChannels = std::array<int, 4>;

/// The chosen channels of a face in memory (checked) as floats, all its levels: `chainSize` of
/// them.
void fillChain(const TexelFormat& format,
               const ChosenChannels& channels,
               const FaceTexels& face,
               float* values);

/// Texels of single faces as floats with all their coarser levels, to the bit what `FloatMips`
/// holds, made when first asked for and kept while there is room. One thread at a time.
class ChainCache
{
public:
    /// \param mostBytes  of chains that `trim` keeps
    ChainCache(const ChosenChannels& channels, std::size_t mostBytes);

    /// From now on faces still in their file are read only as finely as this, where the file keeps
    /// such a level: what it keeps may differ from what `reduced` makes. Finer ones that are asked
    /// for all the same are read in full.
    void readAt(Level finest) { m_finest = finest; }

    /// \param level  not above the face's (checked)
    /// \return  there until the next `trim`, `update` or `forget`
    LevelTexels texels(const TexelStore& store, FaceId face, Level level);

    /// Whether a face is kept.
    bool holds(FaceId face) const { return m_chains.contains(static_cast<std::uint32_t>(face)); }

    /// Takes over what changed in faces whose chains are kept: touched texels and their parents.
    /// \param store  as it is now
    void update(const TexelStore& store, std::span<const TouchedRect> rects);

    /// Gives up chains until they fit, those first that were asked for longest ago.
    void trim();
    void forget();

    const ChosenChannels& channels() const { return m_channels; }
    std::size_t bytes() const { return m_bytes; }

private:
    struct Chain
    {
        Level level; ///< the finest that is held
        bool constant = false;
        std::unique_ptr<float[]> values;
        std::size_t bytes = 0;
        std::list<std::uint32_t>::iterator order; ///< in m_order
    };

    Chain& chain(const TexelStore& store, std::uint32_t face);
    void fill(const TexelStore& store, std::uint32_t face, Level finest, Chain& chain);
    void give(std::uint32_t face);

    ChosenChannels m_channels;
    std::size_t m_mostBytes;
    std::size_t m_bytes = 0;
    std::unordered_map<std::uint32_t, Chain> m_chains;
    std::list<std::uint32_t> m_order; ///< last used first
    Level m_finest{Level::kMax};
    std::vector<std::unique_ptr<float[]>> m_replaced; ///< by finer ones, until the next `trim`
    /// Those asked for lately, by their last bits: a face is asked for many times in a row.
    struct Recent
    {
        std::uint32_t face = 0;
        const Chain* chain = nullptr;
    };
    std::array<Recent, 32> m_recent{};
};

/// A store and its chains, seen as `FloatMips` are.
class FaceMips
{
public:
    /// Refers to both. \param drop  levels by which every face counts as coarser (>= 0)
    FaceMips(const TexelStore& store, ChainCache& chains, int drop = 0)
        : m_store(store)
        , m_chains(chains)
        , m_drop(drop)
    {
    }

    const TexelStore& store() const { return m_store; }
    ChainCache& chains() const { return m_chains; }
    Level level(FaceId face) const { return m_store.face(face).level().coarser(m_drop); }
    int drop() const { return m_drop; }

    /// \return  there until the next `ChainCache::trim`
    LevelTexels texels(FaceId face, Level level, int /*group*/ = 0) const
    {
        return m_chains.texels(m_store, face, level);
    }

private:
    const TexelStore& m_store;
    ChainCache& m_chains;
    int m_drop;
};

} // namespace trixel
