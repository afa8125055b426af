// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <array>
#include <cstdint>

namespace trixel {

/// What a dab does to the texels under it.
enum class BlendMode : std::uint8_t {
    Normal, ///< moves towards the brush colour
    Erase   ///< moves towards the fill colour the texture started with
};

/// Everything the brush panel sets. Lengths are in world units.
struct Brush
{
    float radius = 0.05F;  ///< of a dab at full pressure; > 0
    float hardness = 0.5F; ///< [0,1]: part of the radius painted at full strength
    float opacity = 1.0F;  ///< [0,1]: the most that one stroke may cover
    float flow = 1.0F;     ///< [0,1]: what each dab adds towards the opacity
    float spacing = 0.1F;  ///< (0,4]: distance between dabs as a part of the diameter
    BlendMode blend = BlendMode::Normal;
    /// Value per channel, in [0,1] for integer textures; channels beyond the fourth take the last.
    std::array<float, 4> color{0, 0, 0, 1};
    bool pressureToSize = false;
    bool pressureToOpacity = false;
    /// Paint faces that face away from the hit point's normal too.
    bool paintThrough = false;

    bool operator==(const Brush&) const = default;
};

/// Fails with the first setting out of range, NaN included, by name and value.
Status validate(const Brush& brush);

} // namespace trixel
