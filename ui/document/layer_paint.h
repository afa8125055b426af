// SPDX-License-Identifier: GPL-3.0-or-later
//
// Paint on one layer of a project, and what has to follow it.
#pragma once

#include "core/layers/compose.h"
#include "core/paint/brush.h"
#include "core/paint/ground.h"
#include "core/texture/texel_patch.h"
#include "ui/document/change.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace trixel::ui {

/// What paint replaced, and where.
struct LayerPatch
{
    LayerId layer = kBaseLayer; ///< whose texels the patch is of; of a plain stack what is shown
    TexelPatch texels;
};

/// The texels that paint on a layer changes. \param shown  of the stack
TexelStore& paintedTexels(LayerStack& layers, LayerId layer, TexelStore& shown);

/// Brings what is shown, unless it is painted itself, up to date after paint. Where paint is the
/// first on a face of one value, only the texels it reached are put together.
/// \param rects  of the painted texels, each face once
/// \return       of what is shown
std::vector<TouchedRect>
showPaint(const LayerStack& layers, std::vector<TouchedRect> rects, TexelStore& shown);

/// The same where a stroke that has ended left faces of one colour, which look as before but take
/// less memory.
void showCollapsed(const LayerStack& layers, const LayerPatch& applied, TexelStore& shown);

/// What a patch touches. \param texels  that it is a patch of, levels as they are there
std::vector<TouchedRect> rectsOf(const TexelPatch& patch, const TexelStore& texels);

/// \param rects  each face once; where they are on all of the mesh everything may differ
Change changeOf(std::vector<TouchedRect> rects, const TexelStore& texels);

/// Every texel of the faces.
std::vector<TouchedRect> wholeFaces(const TexelStore& texels, std::span<const FaceId> faces);

/// The bytes of one texel that a fill leaves on a layer. \param format  of what is shown
std::vector<std::byte>
filledTexel(const TexelFormat& format, LayerId layer, const std::array<float, 4>& color);

/// What strokes on the layer are painted on. \param fill  what Erase moves the base towards
Ground groundOf(LayerId layer, const std::vector<std::byte>& fill);

/// Whether paint on the layer looks like the same paint on what is shown, rounding apart.
bool isPaintShown(const LayerStack& layers, LayerId layer, BlendMode blend);

/// Whether paint on the layer cannot be seen because the layer is hidden.
bool isHidden(const LayerStack& layers, LayerId layer);

/// The faces of which two stores of the same number of faces do not share the bytes.
/// \return  nothing where there are more than `most`
std::optional<std::vector<FaceId>>
facesApart(const TexelStore& a, const TexelStore& b, std::size_t most);

/// `TexelStore::releaseHeld` of all there is.
void releaseHeld(LayerStack& layers, TexelStore& shown);

} // namespace trixel::ui
