// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layer_blend.h"

#include "core/layers/known_blend.h"

#include <algorithm>

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
    return withLayerBlend(
        blend, [&](auto known) { return blended<decltype(known)::value>(below, value); });
}

} // namespace trixel
