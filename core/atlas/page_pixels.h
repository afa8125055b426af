// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pages of an atlas as images.
#pragma once

#include "core/atlas/atlas_layout.h"
#include "core/image/image.h"

#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace trixel {

/// Pages full of zeros. \param colors  one a channel (checked)
std::vector<Image> emptyPages(std::span<const AtlasPage> pages,
                              const TexelFormat& format,
                              const std::vector<ColorSpace>& colors);

/// The bytes of one pixel (checked to be on the page).
std::span<const std::byte> pixelOf(const Image& page, AtlasPixel pixel);

/// What hardware shows at a place of a page: the four nearest pixels, interpolated as they are
/// stored, those of the page's border repeated. Pixel centres are at 1/2.
/// \param value  a float a channel (checked)
void bilinear(const Image& page, glm::dvec2 place, std::span<float> value);
/// The same for loops. \param scratch  a float a channel (checked), overwritten
void bilinear(const Image& page,
              glm::dvec2 place,
              std::span<float> value,
              std::span<float> scratch);

} // namespace trixel
