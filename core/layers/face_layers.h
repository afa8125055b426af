// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layers/layer_stack.h"
#include "core/layers/texel_composer.h"

#include <span>
#include <vector>

namespace trixel {

/// The layers of a stack that show at all, bottom to top: visible and not fully transparent.
std::vector<const Layer*> shownLayers(const LayerStack& layers);

/// False for faces of one value that covers nothing; reads nothing.
bool mayCover(const Layer& layer, FaceId face);

/// What one face looks like is made of, in memory.
struct FaceLayers
{
    FaceTexels base;             ///< or what hides it
    std::vector<LayerFace> over; ///< those that may cover something, bottom to top
    bool isBase = true;          ///< nothing hides the base
    bool isDamaged = false;      ///< some of it could not be read

    /// Whether all of it is constant.
    bool isConstant() const;
};

/// \param shown  of the stack
FaceLayers layersOfFace(const TexelStore& base, std::span<const Layer* const> shown, FaceId face);

/// Leaves out layers that turn out to cover no texel of the face. Costs a look at each texel.
void dropUncovered(const TexelFormat& base, FaceLayers& face);

/// Whether two stacks show the same of a face for certain: the same paint, set alike. Reads
/// nothing.
bool showAlike(const TexelStore& base,
               std::span<const Layer* const> shown,
               const TexelStore& otherBase,
               std::span<const Layer* const> otherShown,
               FaceId face);

} // namespace trixel
