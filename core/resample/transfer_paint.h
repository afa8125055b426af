// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/filter/filter_method.h"
#include "core/mesh/surface.h"
#include "core/texture/texel_store.h"

#include <cstdint>

namespace trixel {

struct TransferOptions
{
    /// How far a texel looks for the other surface, in world units; positive, may be infinite.
    float maxDistance = 0;
    /// What averages the paint under a texel.
    MethodChoice method{"probes-2", std::nullopt};
    Threads threads = Threads::all();
};

struct Transfer
{
    TexelStore texels;
    std::uint64_t reached = 0; ///< texels that found the other surface
    std::uint64_t total = 0;
};

/// Brings paint from one surface to another, whatever their faces: every texel takes the value at
/// the point of `from` that is nearest to its centroid, averaged over its own footprint laid flat
/// there. Texels that find none within the distance keep what they hold; so do channels that the
/// paint does not have. Faces keep their levels; those that end up of one value are constant.
/// \param paint   on `from` (checked)
/// \param texels  of `to` (checked)
/// Fails when cancelled, and when a face cannot be read.
Result<Transfer> transferPaint(const Surface& from,
                               const FilterScene& paint,
                               const Surface& to,
                               const TexelStore& texels,
                               const TransferOptions& options,
                               Progress& progress);

} // namespace trixel
