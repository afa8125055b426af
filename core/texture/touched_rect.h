// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ids.h"

#include <cstdint>

namespace trixel {

/// Texels of one face that a change touched: a rectangle of the packed square, so that what is
/// derived from texels is brought up to date there only.
struct TouchedRect
{
    FaceId face{};
    std::uint16_t x = 0, y = 0, width = 0, height = 0;
    bool wholeFace = false; ///< the face was constant before: all of it is new
};

} // namespace trixel
