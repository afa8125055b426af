// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/filter/filter_method.h"
#include "core/image/color_space.h"
#include "core/mesh/surface.h"
#include "core/texture/texel_store.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace trixel {

/// What becomes of texels that find no paint within the distance.
enum class OutOfReach {
    Keep, ///< what they hold
    Fill  ///< a value, in all their channels
};

struct TransferOptions
{
    /// How far a texel looks for the other surface, in world units; positive, may be infinite.
    float maxDistance = 0;
    /// What averages the paint under a texel.
    MethodChoice method{"probes-2", std::nullopt};
    OutOfReach outOfReach = OutOfReach::Keep;
    /// For Fill: the bytes of one texel in the format of those that take paint (checked).
    std::vector<std::byte> fill = {};
    /// What the channels of the texels that take paint mean, one each: the paint is linear light
    /// then, and stored as that. Empty: its numbers pass as they are.
    std::vector<ColorSpace> colors = {};
    /// Faces that take paint, any order; empty for all. Others stay as they are.
    std::vector<FaceId> faces = {};
    Threads threads = Threads::all();
};

struct Transfer
{
    TexelStore texels;
    std::uint64_t reached = 0; ///< texels that found the other surface
    std::uint64_t total = 0;   ///< that looked for it
};

/// What the channels of both sides of a transfer mean.
struct TransferColors
{
    std::vector<ColorSpace> paint;  ///< for `transferScene`
    std::vector<ColorSpace> texels; ///< for `TransferOptions::colors`
};

/// As both sides say. Where one does not, its numbers are taken for what the other's are; where
/// neither does, both are empty: numbers pass as they are.
/// \param paint, texels  what each says (`channelColors`)
TransferColors transferColors(const std::optional<std::vector<ColorSpace>>& paint,
                              const TexelFormat& paintFormat,
                              const std::optional<std::vector<ColorSpace>>& texels,
                              const TexelFormat& texelFormat);

/// Paint that can be averaged.
struct TransferScene
{
    FilterScene paint;
    std::optional<std::uint16_t> opacity = {}; ///< the channel that the paint is weighed by
};

/// The paint of a surface as linear light, weighed where its format has an opacity (opacity.h).
/// \param colors  what its channels mean, one each (checked); empty: as they are
/// Fails when cancelled, and when a face cannot be read.
Result<TransferScene> transferScene(const Surface& from,
                                    const TexelStore& texels,
                                    const std::vector<ColorSpace>& colors,
                                    Threads threads,
                                    Progress& progress);

/// Brings paint from one surface to another, whatever their faces: every texel takes the value at
/// the point of `from` that is nearest to its centroid, averaged over its own footprint laid flat
/// there. Texels that find none within the distance keep what they hold, or take a value; channels
/// that the paint does not have keep theirs. Faces keep their levels; those that end up of one
/// value are constant.
/// \param paint   on `from` (checked)
/// \param texels  of `to` (checked)
/// Fails when cancelled, when memory runs out, and when a face cannot be read.
Result<Transfer> transferPaint(const Surface& from,
                               const TransferScene& paint,
                               const Surface& to,
                               const TexelStore& texels,
                               const TransferOptions& options,
                               Progress& progress);

/// How far texels spread over all faces have to the other surface, in world units: for telling
/// beforehand how many a distance will reach.
/// \param count  how many texels at most; fewer where there are no more
/// \param faces  of which, as in `TransferOptions`
/// \return       distances, in no order; none where either surface has no faces
std::vector<float> sampleDistances(const Surface& from,
                                   const Surface& to,
                                   const TexelStore& texels,
                                   std::size_t count,
                                   std::span<const FaceId> faces = {});

} // namespace trixel
