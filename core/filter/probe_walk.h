// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which faces the probes of a line fall on: straight over the mesh, both ways.
#pragma once

#include "core/filter/filter_scene.h"
#include "core/filter/probe_line.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>

namespace trixel {

/// The probes of one line, structure of arrays with room for whole registers.
struct ProbeList
{
    /// Far more than kMostProbes; the odd size keeps the arrays in different sets of the cache.
    static constexpr std::size_t kRoom = 1024 + 64;

    std::size_t count = 0;
    int fine = 0;                ///< number of the finer level
    alignas(64) double u[kRoom]; ///< in the face of the probe
    alignas(64) double v[kRoom];
    alignas(64) double scale[kRoom]; ///< resolution of the level to read: the face may be coarser
    alignas(64) float place[kRoom];  ///< in steps from the centre, in either direction
    alignas(64) float share[kRoom];  ///< of its step that lies on the surface
    alignas(64) std::int32_t stride[kRoom]; ///< floats from vertex to vertex
    std::array<FaceId, kRoom> face;
    std::array<const float*, kRoom> values; ///< vertices of that level, first group

    /// Writes a probe at a place, counted or not.
    void put(std::size_t at,
             const ConformingPyramid::Finest& finest,
             FaceId on,
             glm::dvec2 uv,
             double steps,
             double part)
    {
        u[at] = uv.x;
        v[at] = uv.y;
        scale[at] = finest.level.resolution();
        place[at] = static_cast<float>(steps);
        share[at] = static_cast<float>(part);
        stride[at] = static_cast<std::int32_t>(finest.stride);
        face[at] = on;
        values[at] = finest.values;
    }
};

/// Faces that a line may run through to a side; beyond them is as beyond a border.
inline constexpr int kMostSegments = 512;

/// Lines that are walked by turns, so that they do not wait for each other's memory.
inline constexpr std::size_t kWalkedTogether = 6;

/// Fills the lists with the probes of lines. A probe stands for the step around it; where a border
/// cuts that, it moves to the middle of what is left and counts for as much.
/// \param lines  at most kWalkedTogether
/// \param lists  one a line, `fine` set
void placeProbes(const FilterScene& scene,
                 std::span<const ProbeLine> lines,
                 std::span<ProbeList* const> lists);

} // namespace trixel
