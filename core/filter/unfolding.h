// SPDX-License-Identifier: GPL-3.0-or-later
//
// The faces around a query, laid flat: which faces a footprint covers and where.
//
// The rule, shared by every filter that is judged by `exact`:
//   * Faces are laid isometrically (real edge lengths) into the plane of the face that was hit,
//     each across an edge of one already laid, and each once.
//   * An edge is crossed where the cut ellipse touches it. On a flat surface that reaches every
//     face under the ellipse that is seen from the centre.
//   * Distances are from the query's point in the metric of the footprint, in standard deviations.
//     The way to a face is as long as the most distant edge crossed on it, an edge being as far as
//     its nearest point.
//   * Shortest way first: of all faces that wait, the next is the one with the least key
//     d + 2⁻¹⁴ c, where d is the length of its way and c the distance to its centroid. Faces that
//     share the point all have d = 0, so they are laid before the others whichever of them was hit:
//     that makes the answer the same from both sides of an edge. Behind a vertex all faces have d
//     in common; c lets the two ways around it meet opposite the point. What a narrower cut reaches
//     is what a wider one lays first, so that filters of different cuts see the same faces in the
//     same places.
//   * Nothing folds back over what lies near: no face is laid nearer than the face it is laid from,
//     nor less than half as far as the edge it is laid across.
//   * A face that waits at several edges is laid where its key is least; where keys differ by less
//     than 1e-6 of themselves, which is what rounding and symmetry do, across the edge of the face
//     with the lowest id. No rule looks at vertex order.
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
    double distance = 0; ///< from the origin to its nearest point, in standard deviations
    double way = 0;      ///< d of the rule above

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
    /// A face that waits to be laid.
    struct Waiting
    {
        double key = 0;
        FaceId face{};
    };
    /// A face that was reached by this query: its stamp is the query's.
    struct Slot
    {
        std::uint32_t stamp = 0;
        FaceId face{};
        bool laid = false;
        std::uint32_t offer = 0; ///< the place in m_offers where it is to be laid
        FaceId parent{};         ///< across whose edge
        double key = 0;
    };
    static bool isLater(const Waiting& a, const Waiting& b);

    void lay(const PlacedFace& place);
    void offerNeighbours(const FilterSurface& surface,
                         const PlacedFace& place,
                         const EllipseFrame& frame,
                         double cut);
    void offer(const PlacedFace& place, FaceId parent, double key);

    Slot& slotOf(FaceId face);
    Slot& reach(FaceId face);
    bool isLaid(FaceId face);
    void growTable();

    std::vector<Slot> m_slots; ///< a hash table whose size follows the footprint, not the mesh
    std::uint32_t m_stamp = 0;
    std::size_t m_reached = 0;
    std::vector<PlacedFace> m_laid;
    std::vector<PlacedFace> m_offers;
    std::vector<Waiting> m_waiting; ///< a heap
};

} // namespace trixel
