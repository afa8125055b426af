// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/coarser_levels.h"

#include "core/base/check.h"
#include "core/lattice/reduction.h"
#include "core/texture/mips.h"
#include "core/texture/pinned_face.h"
#include "core/texture/touched_cells.h"

#include <algorithm>
#include <cstring>

namespace trixel {

namespace {

/// Makes one texel of the coarser level anew.
void reduceTexel(const TexelFormat& format,
                 const FaceTexels& fine,
                 PackedPixel coarse,
                 std::span<std::byte> target,
                 std::vector<std::byte>& four)
{
    const std::size_t bytes = format.texelBytes();
    const std::array<PackedPixel, 4> finer = finerPixels(fine.level(), coarse);
    // A face of level 1 holds its four texels in this order: it is reduced as any other.
    for (std::size_t k = 0; k < finer.size(); ++k) {
        const auto texel = fine.texel(indexOf(texelIndex(fine.level(), finer[k])));
        std::memcpy(four.data() + k * bytes, texel.data(), bytes);
    }
    const Level to = fine.level().coarser();
    reduceTexels(
        format, Level(1), four, target.subspan(indexOf(texelIndex(to, coarse)) * bytes, bytes));
}

void reduceCells(const TexelFormat& format,
                 const FaceTexels& fine,
                 FaceTexels& coarse,
                 const TouchedCells& cells)
{
    const Level level = coarse.level();
    const std::uint32_t last = level.resolution() - 1;
    const std::span<std::byte> target = coarse.writable();
    std::vector<std::byte> four(4 * format.texelBytes());
    for (std::size_t k = 0; k < cells.count; ++k) {
        const CellRect& rect = cells.rects[k];
        for (std::uint32_t j = rect.j0; j <= std::min(rect.j1, last); ++j) {
            for (std::uint32_t i = rect.i0; i <= std::min(rect.i1, last); ++i) {
                for (const TexelHalf half : {TexelHalf::Lower, TexelHalf::Upper}) {
                    const TexelCoord texel{
                        static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j), half};
                    if (isValid(level, texel)) {
                        reduceTexel(format, fine, packedPixel(level, texel), target, four);
                    }
                }
            }
        }
    }
}

} // namespace

CoarserLevels CoarserLevels::of(const TexelFormat& format, const FaceTexels& face)
{
    CoarserLevels levels;
    levels.m_base = face.level();
    levels.m_constant = face.isConstant();
    levels.m_levels.resize(static_cast<std::size_t>(face.level().log2()));
    for (std::size_t k = levels.m_levels.size(); k-- > 0;) {
        const bool first = k + 1 == levels.m_levels.size();
        levels.m_levels[k] = reduced(format, first ? face : levels.m_levels[k + 1]);
    }
    return levels;
}

const FaceTexels& CoarserLevels::at(Level level) const
{
    check(level < m_base, "a coarser level");
    return m_levels[static_cast<std::size_t>(level.log2())];
}

bool CoarserLevels::canFollow(const FaceTexels& face, const TouchedRect& rect) const
{
    return face.level() == m_base && !rect.wholeFace && !face.isConstant() && !m_constant;
}

void CoarserLevels::update(const TexelFormat& format,
                           const FaceTexels& face,
                           const TouchedRect& rect)
{
    check(canFollow(face, rect), "a change that can be followed");
    TouchedCells cells(m_base, rect);
    for (std::size_t k = m_levels.size(); k-- > 0;) {
        cells = cells.coarser();
        reduceCells(format, k + 1 == m_levels.size() ? face : m_levels[k + 1], m_levels[k], cells);
    }
}

FaceTexels sampledAt(Level level, const FaceTexels& face)
{
    check(level <= face.level(), "a level that the face has");
    if (face.isConstant()) {
        return face.atLevel(level);
    }
    const PinnedFace pin(face);
    const std::size_t bytes = face.texelBytes();
    std::vector<std::byte> texels(bytes * level.texelCount());
    for (std::uint32_t k = 0; k < level.texelCount(); ++k) {
        const TexelCoord coarse = texelAt(level, static_cast<TexelIndex>(k));
        const TexelCoord middle = texelAt(face.level(), centroid(level, coarse));
        const auto texel = pin->texel(indexOf(texelIndex(face.level(), middle)));
        std::memcpy(texels.data() + k * bytes, texel.data(), bytes);
    }
    return FaceTexels::full(level, bytes, texels);
}

} // namespace trixel
