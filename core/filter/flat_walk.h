// SPDX-License-Identifier: GPL-3.0-or-later
//
// The faces under an ellipse where it does not matter in which order they are laid.
#pragma once

#include "core/filter/face_table.h"
#include "core/filter/filter_surface.h"
#include "core/filter/placed_face.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace trixel {

/// Lays faces across every edge that a circle touches, nearer ones first by and large, and sees to
/// it that all edges fit: then every way to a face lays it in the same place, and no rule has to
/// choose between them. So it is on flat parts of a surface, and wherever no vertex lies under the
/// circle. Keeps its memory from one query to the next.
class FlatWalk
{
public:
    /// \param hit  the first face
    /// \return all faces under the circle of radius `cut` about the origin, `hit` first; valid
    /// until
    ///         the next call. Nothing where the order matters (an edge fits in one place and not in
    ///         another), where faces are so narrow that the places would not be exact, and beyond
    ///         `mostFaces`.
    std::optional<std::span<const PlacedFace>>
    lay(const FilterSurface& surface, const PlacedFace& hit, double cut, std::size_t mostFaces);

private:
    /// Edges of a face that have still to be looked at, bit k for edge k.
    using Edges = std::uint8_t;

    bool cross(const FilterSurface& surface, std::size_t number, std::size_t edge);
    void makeRoom();

    FaceTable m_numbers; ///< of faces that are laid
    // Longer than what is laid: the first m_count count.
    std::vector<PlacedFace> m_laid;
    std::vector<Edges> m_edges;
    std::size_t m_count = 0;
};

/// Whether the segment from a to b comes within the square root of `squared` of the origin.
inline bool comesWithin(glm::dvec2 a, glm::dvec2 b, double squared)
{
    if (glm::dot(a, a) <= squared || glm::dot(b, b) <= squared) {
        return true;
    }
    const glm::dvec2 along = b - a;
    const double length2 = glm::dot(along, along);
    const double foot = -glm::dot(a, along);
    const double height = a.x * along.y - a.y * along.x;
    return foot > 0 && foot < length2 && height * height <= squared * length2;
}

} // namespace trixel
