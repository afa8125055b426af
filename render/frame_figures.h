// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/filtering.h"

#include <cstdint>
#include <optional>

namespace trixel::render {

/// What one frame drew and took.
struct FrameFigures
{
    double processorMs = 0;       ///< of the thread that drew
    std::optional<double> cardMs; ///< of a frame before, where the card has a clock
    Filtering filtering = Filtering::Texels;
    int levelsDropped = 0;              ///< by which every face is shown coarser
    std::uint64_t faces = 0;            ///< sent to be drawn
    std::uint64_t triangles = 0;        ///< more than faces where a face is cut into several
    std::uint64_t texels = 0;           ///< of those faces, on the card
    std::uint64_t residentBytes = 0;    ///< of texels and what is derived from them, on the card
    std::uint64_t budgetBytes = 0;      ///< most of those; 0 where there is no bound
    std::optional<double> surfaceError; ///< pixels that a limit surface is off by at most
};

} // namespace trixel::render
