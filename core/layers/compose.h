// SPDX-License-Identifier: GPL-3.0-or-later
//
// What layers look like together. From the base up, every visible layer changes each channel of
// what lies below: below + coverage · opacity · (blended(below, value) - below), in float; the sum
// of all is encoded once. Faces on which no visible layer covers anything share the base's bytes.
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/layers/layer_stack.h"
#include "core/texture/touched_rect.h"

#include <span>

namespace trixel {

/// The texels that are shown, saved as a texture and exported, and the layers they come from.
struct Layered
{
    TexelStore shown;  ///< in a plain stack's place: the truth itself
    LayerStack layers; ///< plain when there is nothing but `shown`
};

/// Shows a stack from nothing. A stack without layers becomes a plain one, its base what is shown.
/// Fails when cancelled or when a face could not be read.
Result<Layered> composed(LayerStack layers, Threads threads, Progress& progress);

/// The same where `before` is at hand: faces whose layers are as they were, and equally set, keep
/// what they showed; cost follows the others, and a look at each face.
Result<Layered>
recomposed(LayerStack layers, const Layered& before, Threads threads, Progress& progress);

/// Brings what is shown up to date where a layer or the base was painted.
/// \param rects  each face once
/// \param shown  of the stack before the change; levels are those of the base (checked)
void recompose(const LayerStack& layers,
               std::span<const TouchedRect> rects,
               TexelStore& shown,
               Threads threads);

/// The same for whole faces, whose levels may have changed. \param faces  each once
void recompose(const LayerStack& layers,
               std::span<const FaceId> faces,
               TexelStore& shown,
               Threads threads);

} // namespace trixel
