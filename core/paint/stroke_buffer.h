// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ids.h"
#include "core/texture/face_texels.h"
#include "core/texture/texel_patch.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace trixel {

/// A square of the packed square that a stroke has reached: how far each of its texels is covered,
/// and what it held before the stroke.
struct StrokeTile
{
    std::unique_ptr<float[]> coverage;   ///< row-major; null while the stroke has not been here
    std::unique_ptr<std::byte[]> before; ///< stored texels, row-major; null on a constant face
};

/// What a stroke remembers of one face it has reached: tiles where it has been, so that a face of
/// sixteen million texels costs what was touched. Rows of tiles are independent of each other and
/// may be worked on by different threads.
class StrokeFace
{
public:
    static constexpr std::uint32_t kTileSide = 32;

    /// \param before  the face as it was before the stroke
    StrokeFace(FaceId face, const FaceTexels& before);

    FaceId id() const { return m_id; }
    Level level() const { return m_level; }
    bool wasConstant() const { return m_constant.texelBytes() > 0; }

    /// Texels along the side of a tile: 32, or the resolution of a smaller face.
    std::uint32_t tileSide() const { return m_tileSide; }
    std::uint32_t tilesPerRow() const { return m_level.resolution() / m_tileSide; }

    /// A tile, made and filled in on the first call. \param now  the face in the store, where this
    /// tile's texels are still as they were before the stroke
    StrokeTile& reach(std::uint32_t tileX, std::uint32_t tileY, const FaceTexels& now);

    /// Texels as they were before the stroke: `count` of a row of a tile from `x` on.
    std::span<const std::byte>
    before(const StrokeTile& tile, std::uint32_t x, std::uint32_t y, std::uint32_t count) const;

    /// Adds what the stroke changed, if anything. \param now  the face in the store after it
    void addTo(TexelPatch& patch, const FaceTexels& now) const;

private:
    void addRowChanges(std::uint32_t y,
                       const FaceTexels& now,
                       std::vector<TexelPatch::Run>& runs,
                       std::vector<std::byte>& values) const;

    FaceId m_id{};
    Level m_level;
    std::uint32_t m_tileSide = 1;
    std::uint32_t m_texelBytes = 0;
    FaceTexels m_constant;                ///< only if the face was constant
    std::vector<std::byte> m_constantRow; ///< its value, a tile's side long
    std::vector<std::vector<StrokeTile>> m_rows;
};

} // namespace trixel
