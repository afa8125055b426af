// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/image.h"

#include "core/base/check.h"

#include <cstring>
#include <utility>

namespace trixel {

Image::Image(int width, int height, const TexelFormat& format, std::vector<ColorSpace> colors)
    : m_width(width)
    , m_height(height)
    , m_format(format)
    , m_colors(std::move(colors))
{
    check(width > 0 && height > 0, "an image of at least one pixel");
    check(m_colors.size() == format.channels, "a colour space for each channel");
    // As the widest type a channel may have, so that rows are aligned for it.
    const std::size_t words = (byteCount() + sizeof(std::uint64_t) - 1) / sizeof(std::uint64_t);
    const std::shared_ptr<std::uint64_t[]> memory(new std::uint64_t[words]());
    m_pixels = {memory, reinterpret_cast<std::byte*>(memory.get())};
}

Image Image::adopt(int width,
                   int height,
                   const TexelFormat& format,
                   std::vector<ColorSpace> colors,
                   std::shared_ptr<std::byte> pixels)
{
    check(width > 0 && height > 0, "an image of at least one pixel");
    check(colors.size() == format.channels, "a colour space for each channel");
    Image image;
    image.m_width = width;
    image.m_height = height;
    image.m_format = format;
    image.m_colors = std::move(colors);
    image.m_pixels = std::move(pixels);
    return image;
}

Image Image::declared(std::vector<ColorSpace> colors) const
{
    check(colors.size() == m_format.channels, "a colour space for each channel");
    Image image = *this;
    image.m_colors = std::move(colors);
    return image;
}

std::span<std::byte> Image::writable()
{
    check(m_pixels.use_count() == 1, "pixels that nobody shares");
    return {m_pixels.get(), byteCount()};
}

std::span<const std::byte> Image::row(int y) const
{
    check(y >= 0 && y < m_height, "a row of the image");
    const std::size_t bytes = static_cast<std::size_t>(m_width) * m_format.texelBytes();
    return pixels().subspan(static_cast<std::size_t>(y) * bytes, bytes);
}

std::span<std::byte> Image::writableRow(int y)
{
    const std::span<const std::byte> bytes = std::as_const(*this).row(y);
    return writable().subspan(static_cast<std::size_t>(bytes.data() - m_pixels.get()),
                              bytes.size());
}

} // namespace trixel
