// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mapping/image_tiles.h"
#include "core/mapping/mapping.h"
#include "core/texture/texel_patch.h"
#include "core/texture/texel_store.h"

#include <span>
#include <vector>

namespace trixel {

struct BakeOptions
{
    /// What the store's channels mean, one each; empty: as the image's, so that numbers pass.
    std::vector<ColorSpace> colors;
    float opacity = 1; ///< [0,1] of the whole image
    Threads threads = Threads::all();
};

/// Lays an image onto faces: each texel takes what the image holds at its centroid, over the
/// texel's own footprint, in linear light; what is transparent lets the paint below through.
/// Returns what was replaced, so that swapping it is undo; faces the image does not reach are left
/// out. The store changes only when all is made: it is as before when the call fails, which it does
/// when cancelled, when a face cannot be read from its file, and when the image reaches no texel.
/// The result does not depend on the number of threads.
/// \param faces  each once
Result<TexelPatch> bake(TexelStore& store,
                        std::span<const FaceId> faces,
                        const Mapping& mapping,
                        const ImageTiles& images,
                        const BakeOptions& options,
                        Progress& progress);

} // namespace trixel
