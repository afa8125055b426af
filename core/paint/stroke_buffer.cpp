// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/paint/stroke_buffer.h"

#include <algorithm>
#include <cstring>

namespace trixel {

StrokeFace::StrokeFace(FaceId face, const FaceTexels& before)
    : m_id(face)
    , m_level(before.level())
    , m_tileSide(std::min(before.level().resolution(), kTileSide))
    , m_texelBytes(static_cast<std::uint32_t>(before.texelBytes()))
    , m_rows(tilesPerRow())
{
    if (before.isConstant()) {
        m_constant = before;
        for (std::uint32_t k = 0; k < m_tileSide; ++k) {
            m_constantRow.insert(m_constantRow.end(), before.bytes().begin(), before.bytes().end());
        }
    }
}

StrokeTile& StrokeFace::reach(std::uint32_t tileX, std::uint32_t tileY, const FaceTexels& now)
{
    std::vector<StrokeTile>& row = m_rows[tileY];
    if (row.empty()) {
        row.resize(tilesPerRow());
    }
    StrokeTile& tile = row[tileX];
    if (tile.coverage) {
        return tile;
    }
    const std::size_t texels = std::size_t{m_tileSide} * m_tileSide;
    tile.coverage = std::make_unique<float[]>(texels); // all zero
    if (!wasConstant()) {
        const std::size_t rowBytes = std::size_t{m_tileSide} * m_texelBytes;
        tile.before = std::make_unique_for_overwrite<std::byte[]>(texels * m_texelBytes);
        for (std::uint32_t y = 0; y < m_tileSide; ++y) {
            const std::size_t texel =
                std::size_t{tileY * m_tileSide + y} * m_level.resolution() + tileX * m_tileSide;
            std::memcpy(tile.before.get() + y * rowBytes,
                        now.bytes().data() + texel * m_texelBytes,
                        rowBytes);
        }
    }
    return tile;
}

std::span<const std::byte> StrokeFace::before(const StrokeTile& tile,
                                              std::uint32_t x,
                                              std::uint32_t y,
                                              std::uint32_t count) const
{
    if (wasConstant()) {
        return std::span(m_constantRow).first(std::size_t{count} * m_texelBytes);
    }
    const std::size_t first = std::size_t{y} * m_tileSide + x;
    return {tile.before.get() + first * m_texelBytes, std::size_t{count} * m_texelBytes};
}

void StrokeFace::addRowChanges(std::uint32_t y,
                               const FaceTexels& now,
                               std::vector<TexelPatch::Run>& runs,
                               std::vector<std::byte>& values) const
{
    const std::vector<StrokeTile>& row = m_rows[y / m_tileSide];
    for (std::uint32_t tileX = 0; tileX < row.size(); ++tileX) {
        const StrokeTile& tile = row[tileX];
        if (!tile.coverage) {
            continue;
        }
        const std::uint32_t first = y * m_level.resolution() + tileX * m_tileSide;
        const std::span<const std::byte> old = before(tile, 0, y % m_tileSide, m_tileSide);
        for (std::uint32_t x = 0; x < m_tileSide; ++x) {
            const auto texel = old.subspan(std::size_t{x} * m_texelBytes, m_texelBytes);
            if (std::ranges::equal(texel, now.texel(first + x))) {
                continue;
            }
            if (!runs.empty() && runs.back().first + runs.back().count == first + x) {
                ++runs.back().count;
            } else {
                runs.push_back({first + x, 1});
            }
            values.insert(values.end(), texel.begin(), texel.end());
        }
    }
}

void StrokeFace::addTo(TexelPatch& patch, const FaceTexels& now) const
{
    if (wasConstant()) {
        // It is spread out only when a texel changes, and then goes back to one value as a whole.
        if (!now.isConstant()) {
            patch.addFace(m_id, m_constant);
        }
        return;
    }
    std::vector<TexelPatch::Run> runs;
    std::vector<std::byte> values;
    for (std::uint32_t tileY = 0; tileY < m_rows.size(); ++tileY) {
        for (std::uint32_t y = 0; y < m_tileSide && !m_rows[tileY].empty(); ++y) {
            addRowChanges(tileY * m_tileSide + y, now, runs, values);
        }
    }
    if (!runs.empty()) {
        patch.addTexels(m_id, runs, values);
    }
}

} // namespace trixel
