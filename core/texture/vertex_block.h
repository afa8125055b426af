// SPDX-License-Identifier: GPL-3.0-or-later
//
// The order in which the vertices of one face lie on a graphics card: those of level 0, then those
// of every finer level, so that a coarser block is the beginning of a finer one.
#pragma once

#include "core/texture/conforming_pyramid.h"

#include <cstdint>

namespace trixel {

/// Vertices of all levels below one.
constexpr std::uint32_t vertexBlockBegin(Level level)
{
    return static_cast<std::uint32_t>(ConformingPyramid::levelBegin(level) / kGroupChannels);
}

/// Vertices of level 0 to `most`: 3, 9, 24, 69, 222, 783, …
constexpr std::uint32_t vertexBlockSize(Level most)
{
    return static_cast<std::uint32_t>(ConformingPyramid::groupSize(most) / kGroupChannels);
}

/// The level that a vertex of a block belongs to.
constexpr Level vertexBlockLevel(std::uint32_t vertex)
{
    int n = 0;
    while (n < Level::kMax && vertexBlockBegin(Level(n + 1)) <= vertex) {
        ++n;
    }
    return Level(n);
}

/// Consecutive vertices of a face's block.
struct VertexRun
{
    FaceId face{};
    std::uint32_t first = 0;
    std::uint32_t count = 0;

    bool operator==(const VertexRun&) const = default;
};

} // namespace trixel
