// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the card needs to rasterise dabs into squares. Plain data, no OpenGL.
#pragma once

#include "core/lattice/texel.h"
#include "core/paint/dab.h"
#include "render/paint_squares.h"

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace trixel::render {

/// One half of a face that the card is to draw, as its shaders read it: four texels of four words.
///
/// Centroids lie on a grid of the packed square, so the place of one and the steps to its
/// neighbours say where all are. The one given is that nearest to the first dab: few steps away
/// from what is painted, single precision is enough however large the face or far the origin.
struct PaintEntry
{
    glm::vec3 anchor{0};     ///< from the batch's origin to the anchor texel's centroid
    std::uint32_t dabs = 0;  ///< a bit for each of the batch's dabs that reaches the face
    glm::vec3 across{0};     ///< from a centroid to that of the next column
    std::uint32_t kind = 0;  ///< level; kUpper, kFirst
    glm::vec3 down{0};       ///< from a centroid to that of the next row
    std::uint32_t place = 0; ///< of the square in the sheet: column, row << 16
    std::uint32_t anchorPixel = 0;
    std::uint32_t low = 0;  ///< first pixel of the square that dabs may reach
    std::uint32_t high = 0; ///< the one after the last, in both directions
    std::uint32_t unused = 0;

    static constexpr std::uint32_t kUpper = 0x100;
    static constexpr std::uint32_t kFirst = 0x200; ///< nothing covers the square yet
};
static_assert(sizeof(PaintEntry) == 64);

/// A dab as the shaders read it.
struct PaintDab
{
    glm::vec3 centre{0}; ///< from the batch's origin
    float inverseRadius = 0;
    float cap = 0;
    float unused[3] = {0, 0, 0};
};
static_assert(sizeof(PaintDab) == 32);

/// Dabs that are drawn together, in their order, and the halves of faces under them.
class PaintBatch
{
public:
    static constexpr std::size_t kMostDabs = 32;

    /// \param dabs  one to kMostDabs (checked)
    explicit PaintBatch(std::span<const Dab> dabs);

    /// Adds both halves of a face.
    /// \param dabs   a bit for each dab that may paint it
    /// \param first  whether nothing covers the square yet: then all of it is drawn
    void add(const std::array<glm::vec3, 3>& corners,
             const PaintSquare& square,
             std::uint32_t dabs,
             bool first);

    /// What places are relative to: the first dab's centre.
    glm::dvec3 origin() const { return glm::dvec3(m_dabs.front().centre); }
    std::span<const PaintEntry> entries() const { return m_entries; }
    std::span<const PaintDab> dabs() const { return m_cardDabs; }

private:
    void addHalf(const std::array<glm::vec3, 3>& corners,
                 const PaintSquare& square,
                 TexelHalf half,
                 std::uint32_t dabs,
                 bool first);

    std::vector<Dab> m_dabs;
    std::vector<PaintDab> m_cardDabs;
    std::vector<PaintEntry> m_entries;
};

} // namespace trixel::render
