// SPDX-License-Identifier: GPL-3.0-or-later
//
// The pixels of a hand-off atlas. What a program with plain bilinear filtering shows of it has no
// seams: samples of a shared edge are taken once, of the coarser of its two faces, and written to
// both; the finer one interpolates between them; and the pixel beyond a diagonal goes on straight
// from the three before it, so that the diagonal interpolates as straight as the other edges.
#pragma once

#include "core/atlas/handoff_layout.h"
#include "core/atlas/page_pixels.h"
#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/filter/filter_method.h"
#include "core/texture/texel_format.h"
#include "core/texture/texel_store.h"

#include <cstddef>
#include <span>
#include <vector>

namespace trixel {

/// Intervals for every face of a store: so many for each texel along an edge. A face that is one
/// value with all about it needs no more than one.
FaceMap<std::uint32_t> handOffIntervals(const TexelStore& store,
                                        const FilterSurface& surface,
                                        const HandOffOptions& options);

/// What the channels of hand-off pages mean, and those of the scene they are made of.
struct HandOffColors
{
    std::vector<ColorSpace> pages; ///< one a channel
    std::vector<ColorSpace> scene; ///< likewise; empty for the same

    /// A value of the scene as pages store it.
    float stored(std::size_t channel, float value) const
    {
        const ColorSpace to = pages[channel];
        const ColorSpace from = scene.empty() ? to : scene[channel];
        return to == from ? value : fromLinear(to, toLinear(from, value));
    }
};

/// Samples every face, and turns each so that its diagonal goes on straight within what the type
/// can hold, if it can.
/// \param scene   of the faces of the layout (checked), weighed where the format has an opacity
///                (opacity.h)
/// \param method  what a sample is: its value where the footprint is a point
/// \param format  of the pixels; as many channels as the scene has (checked)
/// \param colors  what they mean; one for each channel (checked)
/// Fails when cancelled and when memory runs out. Pixels that no face takes are 0.
Result<std::vector<Image>> handOffPages(HandOffLayout& layout,
                                        const FilterScene& scene,
                                        const FilterMethod& method,
                                        const TexelFormat& format,
                                        const HandOffColors& colors,
                                        Threads threads,
                                        Progress& progress);

/// What is said of an atlas before it is handed on.
struct HandOffReport
{
    /// Largest difference between what two faces show along their edge, bilinear, in any channel.
    double largestJump = 0;
};

/// Measures pages as a program would show them: at so many points along each shared edge. Fails
/// when cancelled and when memory runs out.
Result<HandOffReport> measureHandOff(const HandOffLayout& layout,
                                     std::span<const Image> pages,
                                     const Adjacency& adjacency,
                                     int pointsPerInterval,
                                     Threads threads,
                                     Progress& progress);

} // namespace trixel
