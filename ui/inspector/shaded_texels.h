// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRgb>

#include "core/lattice/texel.h"
#include "core/texture/face_texels.h"
#include "core/texture/touched_rect.h"
#include "render/look.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

namespace trixel::ui {

/// The premultiplied colour of a pixel that shows what `ShadedTexels::at` gave: a mark of the look
/// is a pattern, which differs from pixel to pixel. \param x, y  from the upper left of the
/// picture, in pixels of 1/96 inch
QRgb colorAt(QRgb shaded, int x, int y);
/// The same without the pattern's ink.
QRgb plainColor(QRgb shaded);
/// Whether it stands for a mark: no premultiplied colour is brighter than its opacity.
constexpr bool isMark(QRgb shaded)
{
    return (shaded & 0xff000000U) == 0 && shaded != 0;
}

/// Screen colours of one face's texels at one level, shaded when they are first looked at: what it
/// costs follows what is seen of a face, not its size. A cache beside the texels, which it does not
/// keep: holding them would make the next stroke copy them.
class ShadedTexels
{
public:
    ShadedTexels(const TexelFormat& format, const render::Look& look, Level level);

    const TexelFormat& format() const { return m_format; }
    const render::Look& look() const { return m_look; }
    Level level() const { return m_level; }

    /// Premultiplied colour of a texel, or which mark it has: see `colorAt`. Several threads may
    /// ask at once. \param texels  of the face that all calls are about, at that level (checked
    /// where shaded)
    QRgb at(const FaceTexels& texels, PackedPixel pixel)
    {
        const std::size_t tile =
            std::size_t{pixel.y} / kSide * m_tilesAcross + std::size_t{pixel.x} / kSide;
        const QRgb* colors = m_ready[tile].load(std::memory_order_acquire);
        if (colors == nullptr) [[unlikely]] {
            colors = shadeTile(texels, tile);
        }
        return colors[pixel.y % kSide * kSide + pixel.x % kSide];
    }

    /// Texels differ. Not while others ask.
    void forget();
    void forget(const TouchedRect& rect);
    std::size_t memoryBytes() const;

private:
    static constexpr std::size_t kSide = 32;

    const QRgb* shadeTile(const FaceTexels& texels, std::size_t tile);

    TexelFormat m_format;
    render::Look m_look;
    Level m_level;
    std::size_t m_tilesAcross;
    /// Where a square is shaded, its colours, which the vector below owns.
    std::vector<std::atomic<const QRgb*>> m_ready;
    std::vector<std::unique_ptr<QRgb[]>> m_tiles;
    std::mutex m_guard; ///< of m_tiles
};

} // namespace trixel::ui
