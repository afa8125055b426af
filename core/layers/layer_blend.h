// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace trixel {

/// How the values of a layer meet those below, channel by channel, in the values as they are stored
/// (as brushes paint).
enum class LayerBlend : std::uint8_t {
    Normal,
    Multiply,
    Screen,
    Overlay,
    Darken,
    Lighten,
    Add,
    Subtract,
    Difference
};

inline constexpr std::array kLayerBlends{LayerBlend::Normal,
                                         LayerBlend::Multiply,
                                         LayerBlend::Screen,
                                         LayerBlend::Overlay,
                                         LayerBlend::Darken,
                                         LayerBlend::Lighten,
                                         LayerBlend::Add,
                                         LayerBlend::Subtract,
                                         LayerBlend::Difference};

/// "normal", "multiply", …: as files and the command line write them.
std::string_view nameOf(LayerBlend blend);
std::optional<LayerBlend> layerBlendFromName(std::string_view name);

/// What a value of a layer that covers all makes of the one below. Add, Subtract, Screen and the
/// like are made for values in [0,1]; others go through the same formulas.
/// Source: W3C, Compositing and Blending Level 1, section 9 (Add and Subtract: sum and difference).
float blended(LayerBlend blend, float below, float value);

} // namespace trixel
