// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a project's layers are called and how they are set, in the metadata of a .ptx.
#pragma once

#include "core/base/result.h"
#include "core/io/ptx.h"
#include "core/layers/layer.h"
#include "core/texture/texel_format.h"

#include <cstddef>
#include <span>
#include <vector>

namespace trixel {

/// JSON, bottom to top: [{"name": "Lines", "opacity": 0.5, "blend": "multiply", "visible": true}].
/// Where it is, texels hold the base's channels and then each layer's (see layered_texels.h).
inline constexpr const char* kLayersKey = "TrixelLayers";

/// Bytes of a layer's name beyond which it is cut off when it is written.
inline constexpr std::size_t kMostLayerNameBytes = 1024;

/// What the items say of layers, bottom to top; nothing where they name none. Errors name the key
/// and the layer at fault, counted from 1.
Result<std::vector<LayerSettings>> layersOf(std::span<const PtxMetadata> items);

/// The item that keeps them; read back they are equal but for names that are too long or not UTF-8.
PtxMetadata metadataOf(std::span<const Layer> layers);

/// The base's format in a file whose texels hold it and layers. Fails, naming the key, where the
/// channels are not those of so many layers.
Result<TexelFormat> baseFormat(const TexelFormat& stored, std::size_t layers);

/// The format of what a file shows: the base's where the items name layers, else its own.
Result<TexelFormat> shownFormat(const TexelFormat& stored, std::span<const PtxMetadata> items);

} // namespace trixel
