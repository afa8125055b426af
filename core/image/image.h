// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/color_space.h"
#include "core/texture/texel_format.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace trixel {

/// A picture in memory: rows from the top, pixels from the left, channels interleaved, all of one
/// type; colours are not multiplied by opacity. Copies share their pixels.
class Image
{
public:
    /// No pixels at all; only a placeholder.
    Image() = default;

    /// Pixels of zeros.
    /// \param width, height  at least 1 (checked)
    /// \param colors         one for each channel (checked)
    Image(int width, int height, const TexelFormat& format, std::vector<ColorSpace> colors);

    /// Pixels that someone else made. \param pixels  width * height * texelBytes of them
    static Image adopt(int width,
                       int height,
                       const TexelFormat& format,
                       std::vector<ColorSpace> colors,
                       std::shared_ptr<std::byte> pixels);

    bool isEmpty() const { return m_width == 0; }
    int width() const { return m_width; }
    int height() const { return m_height; }
    const TexelFormat& format() const { return m_format; }
    const std::vector<ColorSpace>& colors() const { return m_colors; }
    /// The same pixels, understood in another way. \param colors  one for each channel (checked)
    Image declared(std::vector<ColorSpace> colors) const;

    std::size_t byteCount() const
    {
        return static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_height) *
               m_format.texelBytes();
    }
    std::span<const std::byte> pixels() const { return {m_pixels.get(), byteCount()}; }
    /// To be written to; nobody else shares the pixels (checked).
    std::span<std::byte> writable();

    /// One row. \param y  below height (checked)
    std::span<const std::byte> row(int y) const;
    std::span<std::byte> writableRow(int y);

private:
    int m_width = 0;
    int m_height = 0;
    TexelFormat m_format;
    std::vector<ColorSpace> m_colors;
    std::shared_ptr<std::byte> m_pixels;
};

} // namespace trixel
