// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a point of a face to pixels of the atlas: what a shader does (resources/shaders/atlas.glsl),
// here in double to test it against, and the numbers that it reads.
#pragma once

#include "core/atlas/atlas_layout.h"

#include <array>
#include <cstdint>
#include <vector>

namespace trixel {

/// One pixel that is read, and what it counts.
struct AtlasTap
{
    std::uint32_t page = 0;
    AtlasPixel pixel;
    double weight = 1;
};

/// The pixel of the texel that holds a point.
/// \param level  that the atlas has of the face (checked)
AtlasTap nearestTap(const AtlasLayout& layout, FaceId face, Level level, glm::dvec2 uv);

/// The pixels that bilinear interpolation reads, in each half's lattice; the value is the mean of
/// both, because lower texels of a face go on as upper ones of its neighbour. Weights add up to 1.
/// \param uv  inside the face
/// \pre the atlas has borders, and the level of the face (checked)
std::array<AtlasTap, 8>
bilinearTaps(const AtlasLayout& layout, FaceId face, Level level, glm::dvec2 uv);

/// The same in two levels, blended.
/// \param level  any number; clamped to the levels of the face
/// \pre the atlas has borders and mips (checked)
std::vector<AtlasTap>
trilinearTaps(const AtlasLayout& layout, FaceId face, double level, glm::dvec2 uv);

/// What a shader reads, as 32-bit numbers:
///   0…3    border (0 or 1), mips (0 or 1), where the grids begin, where the faces begin
///   4…     for each level from 0 to 12: its first grid, how many it has, finer faces
///   grids  for each: first rank, tiles, tiles a row, page, column, row
///   faces  for each: rank × 16 + level
std::vector<std::uint32_t> atlasTable(const AtlasLayout& layout);

} // namespace trixel
