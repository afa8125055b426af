// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texture/vertex_block.h"
#include "core/texture/vertex_touch.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace trixel {

/// Which vertices of which faces' blocks change with touched texels, as few runs.
class TouchedVertices final : private VertexTouch
{
public:
    using VertexTouch::LevelOf;
    using VertexTouch::VertexTouch;

    /// \param base  level whose texels the rectangle counts, not below the face's
    void touch(Level base, const TouchedRect& rect) { VertexTouch::touch(rect.face, base, rect); }

    /// All that was touched, by face and place, and begins again. Runs at most `gap` apart are one.
    std::vector<VertexRun> take(std::uint32_t gap);

private:
    struct Run
    {
        std::uint32_t first = 0, end = 0;
    };

    void add(FaceId face, Level level, LatticePoint at, std::uint32_t count);
    void
    row(FaceId face, Level level, std::uint32_t j, std::uint32_t i0, std::uint32_t i1) override;
    void edge(FaceId face, LocalEdge edge, Level level, std::uint32_t k) override;
    void corner(FaceId face, std::uint8_t corner, Level ringBase, Level level) override;
    void derived(FaceId face,
                 LocalEdge edge,
                 Level base,
                 Level level,
                 std::uint32_t k0,
                 std::uint32_t k1) override;

    std::unordered_map<std::uint32_t, std::vector<Run>> m_runs; // of each face
};

} // namespace trixel
