// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ids.h"
#include "core/paint/stroke.h"
#include "core/texture/face_texels.h"
#include "core/texture/texel_patch.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace trixel {

/// A square of the packed square that a stroke has reached: how far each of its texels is covered,
/// and what it held before the stroke.
class StrokeTile
{
public:
    bool isReached() const { return m_memory != nullptr; }

    /// [0,1] per texel, row-major.
    std::span<float> coverage() const { return {m_memory.get(), m_texels}; }

    /// Stored texels, row-major; none on a face that was constant.
    std::byte* before() const { return reinterpret_cast<std::byte*>(m_memory.get() + m_texels); }

    /// Nothing covered yet. \param beforeBytes  room for the texels before the stroke
    void reach(std::uint32_t texels, std::size_t beforeBytes);

private:
    std::unique_ptr<float[]> m_memory; ///< coverage, then what was before
    std::uint32_t m_texels = 0;
};

/// What a stroke remembers of one face it has reached: tiles where it has been, so that a face of
/// sixteen million texels costs what was touched. Rows of tiles are independent of each other and
/// may be worked on by different threads.
class StrokeFace
{
public:
    static constexpr std::uint32_t kTileSide = 32;
    /// The most texels that `before` can give at a time.
    static constexpr std::uint32_t kRunTexels = 64;

    /// \param before  the face as it was before the stroke
    StrokeFace(FaceId face, const FaceTexels& before);

    FaceId id() const { return m_id; }
    Level level() const { return m_level; }
    bool wasConstant() const { return !m_constantRun.empty(); }

    /// Texels along the side of a tile: 32, or the resolution of a smaller face.
    std::uint32_t tileSide() const { return m_tileSide; }
    std::uint32_t tilesPerRow() const { return m_level.resolution() / m_tileSide; }

    /// A tile, made and filled in on the first call. \param now  the face in the store, where this
    /// tile's texels are still as they were before the stroke
    StrokeTile& reach(std::uint32_t tileX, std::uint32_t tileY, const FaceTexels& now);

    /// Texels as they were before the stroke. \param first  within the tile, row-major
    /// \param count  up to kRunTexels
    std::span<const std::byte>
    before(const StrokeTile& tile, std::uint32_t first, std::uint32_t count) const;

    /// Adds what the stroke changed, if anything. \param now  the face in the store after it
    void addTo(TexelPatch& patch, const FaceTexels& now) const;

    /// What changed since the painter was last asked; of no width when nothing did.
    TouchedRect touched;

private:
    std::span<const StrokeTile> tileRow(std::uint32_t tileY) const;
    void addRowChanges(std::uint32_t y,
                       const FaceTexels& now,
                       std::vector<TexelPatch::Run>& runs,
                       std::vector<std::byte>& values) const;

    FaceId m_id{};
    Level m_level;
    std::uint32_t m_tileSide = 1;
    std::uint32_t m_texelBytes = 0;
    FaceTexels m_constant;                             ///< only if the face was constant
    std::vector<std::byte> m_constantRun;              ///< its value, kRunTexels long; else empty
    StrokeTile m_onlyTile;                             ///< of a face that has one
    std::vector<std::unique_ptr<StrokeTile[]>> m_rows; ///< of a face that has more
};

} // namespace trixel
