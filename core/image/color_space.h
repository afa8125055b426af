// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the numbers of a channel mean. Whatever averages colours does it in linear light.
#pragma once

#include "core/texture/texel_format.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trixel {

/// Of one channel: no colour but data, averaged as they are; linear light; or linear light under
/// the curve of sRGB (IEC 61966-2-1). Raw and linear numbers convert to each other unchanged.
enum class ColorSpace : std::uint8_t { Raw, Linear, SRgb };

/// "raw", "linear", "srgb": as files, the command line and the window write them.
std::string_view nameOf(ColorSpace space);
std::optional<ColorSpace> colorSpaceFromName(std::string_view name);

/// One for each channel, as "srgb,srgb,srgb,raw" and back; nothing for other text.
std::string toText(const std::vector<ColorSpace>& spaces);
std::optional<std::vector<ColorSpace>> colorSpacesFromText(std::string_view text);

/// A stored number as linear light. Beyond [0,1] the curve goes on, below 0 as a straight line.
float toLinear(ColorSpace space, float stored);
/// The other way; NaN stays NaN.
float fromLinear(ColorSpace space, float linear);

/// All channels of a texel or pixel in one space, but for its opacity, which is raw.
std::vector<ColorSpace>
uniformColors(ColorSpace space, std::uint16_t channels, const std::optional<std::uint16_t>& alpha);

/// What channels mean where nothing says it: sRGB for integers, linear light for the others.
std::vector<ColorSpace> usualColors(const TexelFormat& format);

} // namespace trixel
