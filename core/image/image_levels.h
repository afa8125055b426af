// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/image/image.h"

#include <vector>

namespace trixel {

/// The image at half its width and height, rounded down but not below 1: each pixel the mean, in
/// linear light, of the area that it covers. Colours are weighed by opacity where there is one;
/// where nothing is opaque, they are what hidden colours average.
Image halved(const Image& image, Threads threads);

/// The image and all its halves down to one pixel, each made from the one before it.
std::vector<Image> imageLevels(Image image, Threads threads);

} // namespace trixel
