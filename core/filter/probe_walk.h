// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which faces the probes of lines fall on: straight over the mesh, both ways.
#pragma once

#include "core/filter/filter_scene.h"
#include "core/filter/probe_line.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>

namespace trixel {

/// Probes of many lines, structure of arrays, with room for whole registers beyond the last. A line
/// has consecutive places: those ahead from the centre on, then those back.
struct ProbeArrays
{
    static constexpr std::size_t kSize = 8192;
    static constexpr std::size_t kRoom = kSize + 64;

    alignas(64) double u[kRoom]; ///< in the face of the probe
    alignas(64) double v[kRoom];
    alignas(64) double scale[kRoom]; ///< resolution of the level to read: the face may be coarser
    alignas(64) const float* values[kRoom]; ///< vertices of that level, first group
    alignas(64) std::int32_t stride[kRoom]; ///< floats from vertex to vertex
    alignas(64) float place[kRoom];         ///< from the centre, in either direction, in supports
    alignas(64) float share[kRoom];         ///< of its step that lies on the surface
    alignas(64) float coarse[kRoom]; ///< weight of the level below; 0 where the face has but one
    FaceId face[kRoom];
};

/// Faces that a line may run through to a side; beyond them is as beyond a border.
inline constexpr int kMostSegments = 512;

/// Probes of one line among those of all.
struct ProbeRange
{
    std::size_t first = 0;
    std::size_t count = 0;
    int fine = 0;        ///< number of the finer level
    float coarse = 0;    ///< weight of the coarser level
    bool beyond = false; ///< whether the finer level is beyond some face's own
};

/// A vertex no further to the left of a line counts as right of it, as one on the line does; in
/// parts of the edge crossed before, across the line.
inline constexpr double kSideRounding = 1e-12;

/// Places the probes of one line, with care for borders. A probe stands for the step around it;
/// where a border cuts that, it moves to the middle of what is left and counts for as much.
/// \param range  of the line's probes, of which there may be perSide() to either side: `count` is
///               set, to at least one, and `beyond` where it is so
void placeProbes(const FilterScene& scene,
                 const ProbeLine& line,
                 ProbeRange& range,
                 ProbeArrays& probes);

} // namespace trixel
