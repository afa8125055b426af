// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace trixel::render {

using Rgb = std::array<std::uint8_t, 3>;

/// Colour of a number on a scale from 0 (dark blue) to 1 (light yellow), for maps. Lightness grows
/// evenly along it (in Oklab), so that equal steps look equal, a print in grey still reads, and no
/// kind of colour blindness mistakes one end for the other. Numbers outside the scale get its ends.
Rgb mapColor(double position);

/// Different colours of the scale: position p has number round(p · (kMapColors - 1)).
inline constexpr std::size_t kMapColors = 1024;

/// Where there is no number.
inline constexpr Rgb kNoNumber{255, 0, 170};

} // namespace trixel::render
