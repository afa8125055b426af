// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/paint/stroke_buffer.h"

#include "core/base/check.h"

#include <algorithm>
#include <cstring>

namespace trixel {

void StrokeTile::reach(std::uint32_t texels, std::size_t beforeBytes)
{
    const std::size_t words = (beforeBytes + sizeof(float) - 1) / sizeof(float);
    m_memory = std::make_unique_for_overwrite<float[]>(texels + words);
    m_texels = texels;
    std::ranges::fill(coverage(), 0.0F);
}

StrokeFace::StrokeFace(FaceId face, const FaceTexels& before)
    : m_id(face)
    , m_level(before.level())
    , m_tileSide(std::min(before.level().resolution(), kTileSide))
    , m_texelBytes(static_cast<std::uint32_t>(before.texelBytes()))
{
    if (tilesPerRow() > 1) {
        m_rows.resize(tilesPerRow());
    }
    if (before.isConstant()) {
        m_constant = before;
        m_constantRun.resize(std::size_t{kRunTexels} * m_texelBytes);
        for (std::uint32_t k = 0; k < kRunTexels; ++k) {
            std::ranges::copy(before.bytes(), m_constantRun.begin() + k * m_texelBytes);
        }
    }
}

StrokeTile& StrokeFace::reach(std::uint32_t tileX, std::uint32_t tileY, const FaceTexels& now)
{
    StrokeTile* tile = &m_onlyTile;
    if (!m_rows.empty()) {
        if (!m_rows[tileY]) {
            m_rows[tileY] = std::make_unique<StrokeTile[]>(tilesPerRow());
        }
        tile = &m_rows[tileY][tileX];
    }
    if (tile->isReached()) {
        return *tile;
    }
    const std::uint32_t texels = m_tileSide * m_tileSide;
    tile->reach(texels, wasConstant() ? 0 : std::size_t{texels} * m_texelBytes);
    const std::size_t rowBytes = std::size_t{m_tileSide} * m_texelBytes;
    for (std::uint32_t y = 0; y < m_tileSide && !wasConstant(); ++y) {
        const std::size_t texel =
            std::size_t{tileY * m_tileSide + y} * m_level.resolution() + tileX * m_tileSide;
        std::memcpy(
            tile->before() + y * rowBytes, now.bytes().data() + texel * m_texelBytes, rowBytes);
    }
    return *tile;
}

std::span<const std::byte>
StrokeFace::before(const StrokeTile& tile, std::uint32_t first, std::uint32_t count) const
{
    check(count <= kRunTexels, "a run of texels");
    const std::size_t bytes = std::size_t{count} * m_texelBytes;
    if (wasConstant()) {
        return std::span(m_constantRun).first(bytes);
    }
    return {tile.before() + std::size_t{first} * m_texelBytes, bytes};
}

std::span<const StrokeTile> StrokeFace::tileRow(std::uint32_t tileY) const
{
    if (m_rows.empty()) {
        return {&m_onlyTile, 1};
    }
    const StrokeTile* row = m_rows[tileY].get();
    return {row, row == nullptr ? 0 : tilesPerRow()};
}

void StrokeFace::addRowChanges(std::uint32_t y,
                               const FaceTexels& now,
                               std::vector<TexelPatch::Run>& runs,
                               std::vector<std::byte>& values) const
{
    const std::span<const StrokeTile> row = tileRow(y / m_tileSide);
    for (std::uint32_t tileX = 0; tileX < row.size(); ++tileX) {
        if (!row[tileX].isReached()) {
            continue;
        }
        const std::uint32_t first = y * m_level.resolution() + tileX * m_tileSide;
        const std::span<const std::byte> old =
            before(row[tileX], (y % m_tileSide) * m_tileSide, m_tileSide);
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
    for (std::uint32_t y = 0; y < m_level.resolution(); ++y) {
        if (tileRow(y / m_tileSide).empty()) {
            y += m_tileSide - 1; // none of these rows was reached
            continue;
        }
        addRowChanges(y, now, runs, values);
    }
    if (!runs.empty()) {
        patch.addTexels(m_id, runs, values);
    }
}

} // namespace trixel
