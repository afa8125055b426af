// SPDX-License-Identifier: GPL-3.0-or-later
//
// Blend modes known at compile time: for inner loops that must not ask at every value.
#pragma once

#include "core/layers/layer_blend.h"

#include <cmath>
#include <type_traits>

namespace trixel {

/// See `blended` in layer_blend.h.
template <LayerBlend kBlend>
inline float blended(float below, float value)
{
    // Plain choices between values: loops over them run several at a time.
    switch (kBlend) {
    case LayerBlend::Normal:
        return value;
    case LayerBlend::Multiply:
        return below * value;
    case LayerBlend::Screen:
        return below + value - below * value;
    case LayerBlend::Overlay: {
        const float dark = 2.0F * below * value;
        const float light = 1.0F - 2.0F * (1.0F - below) * (1.0F - value);
        return below <= 0.5F ? dark : light;
    }
    case LayerBlend::Darken:
        return value < below ? value : below;
    case LayerBlend::Lighten:
        return below < value ? value : below;
    case LayerBlend::Add:
        return below + value;
    case LayerBlend::Subtract:
        return below - value;
    case LayerBlend::Difference:
        return std::abs(below - value);
    }
    return value;
}

/// Calls work(std::integral_constant<LayerBlend, blend>) and returns what it returns.
template <class Work>
auto withLayerBlend(LayerBlend blend, Work&& work)
{
    using enum LayerBlend;
    switch (blend) {
    case Normal:
        break;
    case Multiply:
        return work(std::integral_constant<LayerBlend, Multiply>{});
    case Screen:
        return work(std::integral_constant<LayerBlend, Screen>{});
    case Overlay:
        return work(std::integral_constant<LayerBlend, Overlay>{});
    case Darken:
        return work(std::integral_constant<LayerBlend, Darken>{});
    case Lighten:
        return work(std::integral_constant<LayerBlend, Lighten>{});
    case Add:
        return work(std::integral_constant<LayerBlend, Add>{});
    case Subtract:
        return work(std::integral_constant<LayerBlend, Subtract>{});
    case Difference:
        return work(std::integral_constant<LayerBlend, Difference>{});
    }
    return work(std::integral_constant<LayerBlend, Normal>{});
}

} // namespace trixel
