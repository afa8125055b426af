// SPDX-License-Identifier: GPL-3.0-or-later
//
// Changes of a stack's texels that are more than paint.
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/layers/layer_stack.h"
#include "core/mesh/adjacency.h"
#include "core/texture/texel_patch.h"

#include <cstddef>
#include <span>
#include <vector>

namespace trixel {

/// The stack with a layer merged into what lies below it, the base or a layer, which keeps its
/// place, name and blend mode; its opacity becomes part of its coverage. Looks as before, rounding
/// and what integers cut off apart, where the lower one is the base, where both are Normal, and
/// where a Normal lower one covers all: elsewhere the upper one has less to blend with. A hidden
/// layer is not merged (checked). Fails when cancelled and when a face could not be read.
/// Source: W3C, Compositing and Blending Level 1, sections 5 and 9.1.
Result<LayerStack>
mergedDown(LayerStack layers, LayerId layer, Threads threads, Progress& progress);

/// The stack at other levels: the base by `changeLevels`, layers likewise with their values
/// weighted by coverage, so that what covers nothing lends no colour. Fails as `changeLevels`.
Result<LayerStack> withLevels(LayerStack layers,
                              const Adjacency& adjacency,
                              const FaceMap<Level>& levels,
                              Threads threads,
                              Progress& progress);

/// The bytes of a layer's texel that covers all with a texel of the base: what fills of a layer
/// need.
std::vector<std::byte> coveringTexel(const TexelFormat& base, std::span<const std::byte> texel);

/// A layer's texels from what a patch would do to texels that are shown: full coverage where it
/// changes a texel, none elsewhere. \param patch  to come; keeps levels (checked)
TexelStore layerOfPatch(const TexelPatch& patch, const TexelStore& shown);

/// What brings texels that are shown to others, for `layerOfPatch`. \param texels  of the same
/// faces, format and levels
TexelPatch patchTo(const TexelStore& texels, const TexelStore& shown);

/// The texels of a layer alone for export: of the base as they are, of a layer its channels and
/// its coverage times its opacity as the format's opacity.
Result<TexelStore>
layerAlone(const LayerStack& layers, LayerId layer, Threads threads, Progress& progress);

} // namespace trixel
