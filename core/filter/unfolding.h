// SPDX-License-Identifier: GPL-3.0-or-later
//
// The faces around a query, laid flat: which faces a footprint covers and where.
//
// The rule, shared by every filter that is judged by `exact`:
//   * Faces are laid isometrically (real edge lengths) into the plane of the face that was hit,
//     each across an edge of one already laid, and each once.
//   * An edge is crossed where the cut ellipse touches it. On a flat surface that reaches every
//     face under the ellipse that is seen from the centre.
//   * No face is laid nearer to the query's point than the face it is laid from, so that no chain
//   of
//     faces goes out and folds back over those that lie near.
//   * Nearest first: of all faces that wait, the next is the one with the least
//     d + 2⁻¹⁶ c, where d is the distance from the query's point to the nearest point of the face
//     as it would be laid and c that to its centroid. Faces that share the point all have d = 0, so
//     they are laid before the others whichever of them was hit: that makes the answer the same
//     from both sides of an edge. Behind a vertex all faces have d in common; c lets the two ways
//     around it meet opposite the point.
//   * Keys are compared to 30 bits; of equal ones the lower id of the face across whose edge it
//     would be laid goes first, then the lower id of the face. No rule looks at vertex order.
// What it cannot do: where the angles about a vertex do not add up to a full turn, no plane holds
// all of its faces, and as the point moves around the vertex the cut behind it jumps.
#pragma once

#include "core/filter/filter_surface.h"
#include "core/filter/query_ellipse.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>
#include <vector>

namespace trixel {

/// The ellipse of a query as the unit circle: offsets from the centre, in standard deviations along
/// its major and minor axis.
class EllipseFrame
{
public:
    explicit EllipseFrame(const QueryEllipse& ellipse)
        : EllipseFrame(ellipse.majorAxis, ellipse.majorSigma, ellipse.minorSigma)
    {
    }
    /// \param majorAxis  of unit length
    /// \param majorSigma, minorSigma  positive
    EllipseFrame(glm::dvec2 majorAxis, double majorSigma, double minorSigma)
        : m_major(majorAxis / majorSigma)
        , m_minor(glm::dvec2(-majorAxis.y, majorAxis.x) / minorSigma)
    {
    }

    /// Length 1 is one standard deviation. Turns left where the plane does.
    glm::dvec2 toUnit(glm::dvec2 offset) const
    {
        return {glm::dot(m_major, offset), glm::dot(m_minor, offset)};
    }

private:
    glm::dvec2 m_major, m_minor;
};

/// A face laid into the plane of the hit face, the query's centre at the origin: (u,v) lies at
/// origin + u e1 + v e2.
struct PlacedFace
{
    FaceId face{};
    glm::dvec2 origin{0};
    glm::dvec2 e1{0};
    glm::dvec2 e2{0};
    double distance = 0; ///< from the origin to the nearest point of the face

    glm::dvec2 corner(std::size_t index) const
    {
        return index == 0 ? origin : origin + (index == 1 ? e1 : e2);
    }
    /// Twice the area.
    double doubleArea() const { return e1.x * e2.y - e1.y * e2.x; }
};

/// Lays faces and keeps its memory from one query to the next. One per thread.
class Unfolding
{
public:
    Unfolding();

    /// The faces under the ellipse of `cut` standard deviations, the hit face first, then by the
    /// rule above. Valid until the next call.
    /// \param mostFaces  at most so many, the nearest; at least 1
    std::span<const PlacedFace> unfold(const FilterSurface& surface,
                                       FaceId face,
                                       const QueryEllipse& ellipse,
                                       const EllipseFrame& frame,
                                       double cut,
                                       std::size_t mostFaces = SIZE_MAX);

private:
    /// A face that waits to be laid, where m_offers[offer] says.
    struct Candidate
    {
        double key = 0;
        FaceId parent{};
        FaceId face{};
        std::uint32_t offer = 0;
    };
    static bool isLater(const Candidate& a, const Candidate& b);

    void lay(const PlacedFace& place);
    void offerNeighbours(const FilterSurface& surface,
                         const PlacedFace& place,
                         const EllipseFrame& frame,
                         double cut);

    bool isLaid(FaceId face) const;
    void markLaid(FaceId face);
    std::size_t slotOf(FaceId face) const;
    void growTable();

    /// A hash table of what was reached: its size follows the footprint, not the mesh. A slot
    /// counts where its stamp is that of this query.
    struct Slot
    {
        std::uint32_t stamp = 0;
        FaceId face{};
    };
    std::vector<Slot> m_slots;
    std::uint32_t m_stamp = 0;
    std::vector<PlacedFace> m_laid;
    std::vector<PlacedFace> m_offers;
    std::vector<Candidate> m_waiting; ///< a heap
};

} // namespace trixel
