// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layer_blend.h"
#include "core/texture/texel_store.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace trixel {

/// Names a layer as long as its stack lives, wherever it is moved to.
enum class LayerId : std::uint32_t {};

/// What lies below all layers: opaque, always shown, without settings.
inline constexpr LayerId kBaseLayer{0};

/// What a user sets of a layer.
struct LayerSettings
{
    std::string name;     ///< UTF-8
    float opacity = 1.0F; ///< [0,1]
    LayerBlend blend = LayerBlend::Normal;
    bool isVisible = true;

    bool operator==(const LayerSettings&) const = default;
};

/// Paint over the base. Its texels hold the base's channels and then, as one channel more, their
/// *coverage*: how much of the texel the layer paints, 0 where nothing was. Values are not
/// multiplied with it. Faces have the levels of the base.
struct Layer
{
    LayerId id{};
    LayerSettings settings;
    TexelStore texels;
};

/// The format of layers over texels of a format: its channels and the coverage, which is last and
/// the opacity (`TexelFormat::alpha`).
TexelFormat layerFormat(const TexelFormat& base);

/// The bytes of a texel that covers nothing: all 0.
std::vector<std::byte> uncoveredTexel(const TexelFormat& base);

} // namespace trixel
