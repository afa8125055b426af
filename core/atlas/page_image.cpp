// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/page_image.h"

#include <algorithm>
#include <cmath>

namespace trixel {

void PageImage::bilinear(glm::dvec2 place, std::span<float> value) const
{
    check(value.size() == format.channels && size.width > 0 && size.height > 0,
          "a pixel to interpolate");
    const auto whole = [](double at, std::uint32_t count) {
        return static_cast<std::uint32_t>(std::clamp(at, 0.0, count - 1.0));
    };
    const double x = std::floor(place.x - 0.5);
    const double y = std::floor(place.y - 0.5);
    const double across = place.x - 0.5 - x;
    const double down = place.y - 0.5 - y;
    std::ranges::fill(value, 0.0F);
    std::vector<float> one(value.size());
    for (int k = 0; k < 4; ++k) {
        const double weight = (k % 2 == 1 ? across : 1 - across) * (k / 2 == 1 ? down : 1 - down);
        if (weight == 0) {
            continue; // whatever is there, be it NaN
        }
        decode(format.type, at({whole(x + k % 2, size.width), whole(y + k / 2, size.height)}), one);
        for (std::size_t c = 0; c < value.size(); ++c) {
            value[c] += static_cast<float>(weight) * one[c];
        }
    }
}

} // namespace trixel
