// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/level_blend.h"

#include <algorithm>
#include <cmath>

namespace trixel {

LevelBlend levelBlend(const QueryEllipse& ellipse, double wanted, double kernel, double band)
{
    const double base = std::exp2(2 * ellipse.log2Texel); // squared edge of a base texel
    const double inPoints = base * kTexelVariance;
    const double texel2 = (std::max(wanted, base * kernel - inPoints) + inPoints) / kernel;
    const double level = ellipse.log2Edge - std::log2(texel2) / 2;

    LevelBlend blend;
    blend.fine = static_cast<int>(std::clamp(std::ceil(level), 0.0, double{Level::kMax}));
    const double fine2 = std::exp2(2 * (ellipse.log2Edge - blend.fine));
    const double weight = std::clamp((texel2 / fine2 - 1) / 3, 0.0, blend.fine > 0 ? 1.0 : 0.0);
    const double narrowed = std::clamp((weight - 0.5) / band + 0.5, 0.0, 1.0);
    blend.coarseWeight = blend.fine > 0 ? static_cast<float>(narrowed) : 0.0F;
    blend.variance = kernel * fine2 * (1 + 3 * double{blend.coarseWeight}) - inPoints;
    return blend;
}

} // namespace trixel
