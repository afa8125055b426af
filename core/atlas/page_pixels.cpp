// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/page_pixels.h"

#include <algorithm>
#include <cmath>

namespace trixel {

std::vector<Image> emptyPages(std::span<const AtlasPage> pages,
                              const TexelFormat& format,
                              const std::vector<ColorSpace>& colors)
{
    std::vector<Image> images;
    for (const AtlasPage& page : pages) {
        images.emplace_back(
            static_cast<int>(page.width), static_cast<int>(page.height), format, colors);
    }
    return images;
}

std::span<const std::byte> pixelOf(const Image& page, AtlasPixel pixel)
{
    const std::size_t bytes = page.format().texelBytes();
    check(pixel.x < static_cast<std::uint32_t>(page.width()), "a pixel of the page");
    return page.row(static_cast<int>(pixel.y)).subspan(pixel.x * bytes, bytes);
}

void bilinear(const Image& page, glm::dvec2 place, std::span<float> value)
{
    std::vector<float> scratch(value.size());
    bilinear(page, place, value, scratch);
}

void bilinear(const Image& page, glm::dvec2 place, std::span<float> value, std::span<float> scratch)
{
    check(value.size() == page.format().channels && scratch.size() == value.size() &&
              !page.isEmpty(),
          "a pixel to interpolate");
    const auto whole = [](double at, int count) {
        return static_cast<std::uint32_t>(std::clamp(at, 0.0, count - 1.0));
    };
    const double x = std::floor(place.x - 0.5);
    const double y = std::floor(place.y - 0.5);
    const double across = place.x - 0.5 - x;
    const double down = place.y - 0.5 - y;
    std::ranges::fill(value, 0.0F);
    for (int k = 0; k < 4; ++k) {
        const double weight = (k % 2 == 1 ? across : 1 - across) * (k / 2 == 1 ? down : 1 - down);
        if (weight == 0) {
            continue; // whatever is there, be it NaN
        }
        const AtlasPixel pixel{whole(x + k % 2, page.width()), whole(y + k / 2, page.height())};
        decode(page.format().type, pixelOf(page, pixel), scratch);
        for (std::size_t c = 0; c < value.size(); ++c) {
            value[c] += static_cast<float>(weight) * scratch[c];
        }
    }
}

} // namespace trixel
