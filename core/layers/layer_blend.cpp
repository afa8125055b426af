// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layer_blend.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trixel {

namespace {

constexpr std::array<std::string_view, kLayerBlends.size()> kNames{"normal",
                                                                   "multiply",
                                                                   "screen",
                                                                   "overlay",
                                                                   "darken",
                                                                   "lighten",
                                                                   "add",
                                                                   "subtract",
                                                                   "difference"};

} // namespace

std::string_view nameOf(LayerBlend blend)
{
    return kNames[static_cast<std::size_t>(blend)];
}

std::optional<LayerBlend> layerBlendFromName(std::string_view name)
{
    const auto found = std::ranges::find(kNames, name);
    if (found == kNames.end()) {
        return std::nullopt;
    }
    return kLayerBlends[static_cast<std::size_t>(found - kNames.begin())];
}

float blended(LayerBlend blend, float below, float value)
{
    switch (blend) {
    case LayerBlend::Normal:
        return value;
    case LayerBlend::Multiply:
        return below * value;
    case LayerBlend::Screen:
        return below + value - below * value;
    case LayerBlend::Overlay:
        return below <= 0.5F ? 2.0F * below * value : 1.0F - 2.0F * (1.0F - below) * (1.0F - value);
    case LayerBlend::Darken:
        return std::min(below, value);
    case LayerBlend::Lighten:
        return std::max(below, value);
    case LayerBlend::Add:
        return below + value;
    case LayerBlend::Subtract:
        return below - value;
    case LayerBlend::Difference:
        return std::abs(below - value);
    }
    return value;
}

} // namespace trixel
