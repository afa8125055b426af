// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/color_space.h"

#include <cmath>

namespace trixel {

std::string_view nameOf(ColorSpace space)
{
    switch (space) {
    case ColorSpace::Raw:
        return "raw";
    case ColorSpace::Linear:
        return "linear";
    case ColorSpace::SRgb:
        break;
    }
    return "srgb";
}

std::optional<ColorSpace> colorSpaceFromName(std::string_view name)
{
    for (const ColorSpace space : {ColorSpace::Raw, ColorSpace::Linear, ColorSpace::SRgb}) {
        if (name == nameOf(space)) {
            return space;
        }
    }
    return std::nullopt;
}

std::string toText(const std::vector<ColorSpace>& spaces)
{
    std::string text;
    for (const ColorSpace space : spaces) {
        text += text.empty() ? "" : ",";
        text += nameOf(space);
    }
    return text;
}

std::optional<std::vector<ColorSpace>> colorSpacesFromText(std::string_view text)
{
    std::vector<ColorSpace> spaces;
    while (true) {
        const std::size_t comma = text.find(',');
        const auto space = colorSpaceFromName(text.substr(0, comma));
        if (!space) {
            return std::nullopt;
        }
        spaces.push_back(*space);
        if (comma == std::string_view::npos) {
            return spaces;
        }
        text.remove_prefix(comma + 1);
    }
}

float toLinear(ColorSpace space, float stored)
{
    if (space != ColorSpace::SRgb) {
        return stored;
    }
    return stored <= 0.04045F ? stored / 12.92F : std::pow((stored + 0.055F) / 1.055F, 2.4F);
}

float fromLinear(ColorSpace space, float linear)
{
    if (space != ColorSpace::SRgb) {
        return linear;
    }
    return linear <= 0.0031308F ? linear * 12.92F : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
}

std::vector<ColorSpace>
uniformColors(ColorSpace space, std::uint16_t channels, const std::optional<std::uint16_t>& alpha)
{
    std::vector<ColorSpace> spaces(channels, space);
    if (alpha && *alpha < channels) {
        spaces[*alpha] = ColorSpace::Raw;
    }
    return spaces;
}

std::vector<ColorSpace> usualColors(const TexelFormat& format)
{
    const bool integers = format.type == TexelType::UInt8 || format.type == TexelType::UInt16;
    return uniformColors(
        integers ? ColorSpace::SRgb : ColorSpace::Linear, format.channels, format.alpha);
}

} // namespace trixel
