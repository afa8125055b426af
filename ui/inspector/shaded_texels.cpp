// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/shaded_texels.h"

#include "core/base/check.h"

#include <algorithm>

namespace trixel::ui {

namespace {

QRgb premultiplied(const render::Rgba& color)
{
    return qPremultiply(qRgba(color[0], color[1], color[2], color[3]));
}

QRgb shaded(const TexelFormat& format,
            std::span<const std::byte> texel,
            const render::Look& look,
            const render::LookRule& rule,
            std::vector<float>& values)
{
    decode(format.type, texel, values);
    if (rule.marks) {
        const render::Mark mark = render::markOf(format, values, look);
        if (mark != render::Mark::None) {
            return static_cast<QRgb>(mark);
        }
    }
    return premultiplied(render::shade(rule, values));
}

} // namespace

QRgb colorAt(QRgb shaded, int x, int y)
{
    if (!isMark(shaded)) {
        return shaded;
    }
    const auto mark = static_cast<render::Mark>(shaded);
    return premultiplied(render::hasInk(mark, x, y) ? render::kMarkInk : render::markColor(mark));
}

QRgb plainColor(QRgb shaded)
{
    return isMark(shaded) ? premultiplied(render::markColor(static_cast<render::Mark>(shaded)))
                          : shaded;
}

ShadedTexels::ShadedTexels(const TexelFormat& format, const render::Look& look, Level level)
    : m_format(format)
    , m_look(look)
    , m_level(level)
    , m_tilesAcross((level.resolution() + kSide - 1) / kSide)
    , m_ready(m_tilesAcross * m_tilesAcross)
    , m_tiles(m_tilesAcross * m_tilesAcross)
{
}

void ShadedTexels::forget()
{
    for (std::size_t k = 0; k < m_tiles.size(); ++k) {
        m_ready[k].store(nullptr, std::memory_order_relaxed);
        m_tiles[k].reset();
    }
}

void ShadedTexels::forget(const TouchedRect& rect)
{
    if (rect.wholeFace) {
        forget();
        return;
    }
    if (rect.width == 0 || rect.height == 0) {
        return;
    }
    const auto lastTile = [this](std::size_t end) {
        return std::min((end - 1) / kSide, m_tilesAcross - 1);
    };
    for (std::size_t y = rect.y / kSide; y <= lastTile(std::size_t{rect.y} + rect.height); ++y) {
        for (std::size_t x = rect.x / kSide; x <= lastTile(std::size_t{rect.x} + rect.width); ++x) {
            m_ready[y * m_tilesAcross + x].store(nullptr, std::memory_order_relaxed);
        }
    }
}

std::size_t ShadedTexels::memoryBytes() const
{
    const auto made =
        std::ranges::count_if(m_tiles, [](const auto& tile) { return tile != nullptr; });
    return static_cast<std::size_t>(made) * kSide * kSide * sizeof(QRgb);
}

const QRgb* ShadedTexels::shadeTile(const FaceTexels& texels, std::size_t tile)
{
    check(texels.level() == m_level && texels.texelBytes() == m_format.texelBytes(),
          "the texels of this cache");
    auto colors = std::make_unique_for_overwrite<QRgb[]>(kSide * kSide);
    const render::LookRule rule = render::LookRule::of(m_format, m_look);
    std::vector<float> values(m_format.channels);
    const std::size_t resolution = m_level.resolution();
    const std::size_t left = tile % m_tilesAcross * kSide;
    const std::size_t top = tile / m_tilesAcross * kSide;
    if (texels.isConstant()) {
        std::fill_n(
            colors.get(), kSide * kSide, shaded(m_format, texels.texel(0), m_look, rule, values));
    } else {
        for (std::size_t y = top; y < std::min(top + kSide, resolution); ++y) {
            for (std::size_t x = left; x < std::min(left + kSide, resolution); ++x) {
                colors[(y - top) * kSide + x - left] =
                    shaded(m_format, texels.texel(y * resolution + x), m_look, rule, values);
            }
        }
    }
    const std::lock_guard lock(m_guard);
    // Another thread may have been as quick: readers go on with what that one made.
    if (const QRgb* made = m_ready[tile].load(std::memory_order_relaxed)) {
        return made;
    }
    m_tiles[tile] = std::move(colors);
    m_ready[tile].store(m_tiles[tile].get(), std::memory_order_release);
    return m_tiles[tile].get();
}

} // namespace trixel::ui
