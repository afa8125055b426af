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
// Where all ways to a face lay it in the same place, no rule is needed: on a flat surface, and
// wherever no vertex lies under the ellipse, faces are laid as they come (`FlatWalk`). A narrower
// cut and the rule itself lay them there too.
// What it cannot do: where the angles about a vertex do not add up to a full turn, no plane holds
// all of its faces. As the point moves around the vertex, or the ellipse turns or changes its shape
// (also by the floor under its width, when it is small), the face behind the vertex changes sides,
// and the answer jumps by what that face weighs there times how much its texels differ. That is
// inherent in laying each face once. On closed meshes of valence 3 to 10 with levels 0 to 6 mixed,
// noise on them, 800 sweeps of the width up to two edges met 14 such jumps above 1e-3, the largest
// 1.3e-2; nothing else jumps (tst_popping).
#pragma once

#include "core/filter/face_table.h"
#include "core/filter/filter_surface.h"
#include "core/filter/flat_walk.h"
#include "core/filter/placed_face.h"
#include "core/filter/query_ellipse.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace trixel {

/// Lays faces and keeps its memory from one query to the next. One per thread.
class Unfolding
{
public:
    /// The faces under the ellipse of `cut` standard deviations, the hit face first; by the rule
    /// above, but in any order where every order lays them in the same places. Valid until the next
    /// call.
    /// \param mostFaces  at most so many, the nearest; at least 1
    std::span<const PlacedFace> unfold(const FilterSurface& surface,
                                       FaceId face,
                                       const QueryEllipse& ellipse,
                                       const EllipseFrame& frame,
                                       double cut,
                                       std::size_t mostFaces = SIZE_MAX);

private:
    /// A face that was reached and has still to be laid, or was.
    struct Reached
    {
        PlacedFace place; ///< where it is to be laid
        double key = 0;
        double way = 0;      ///< d of the rule
        double distance = 0; ///< from the origin to its nearest point
        FaceId parent{};     ///< across whose edge
        bool laid = false;
    };
    struct Waiting
    {
        double key = 0;
        FaceId face{};
        std::uint32_t number = 0; ///< in m_reached
    };
    static bool isLater(const Waiting& a, const Waiting& b);

    void layByRule(const FilterSurface& surface,
                   const PlacedFace& hit,
                   const EllipseFrame& frame,
                   double cut,
                   std::size_t mostFaces);
    void offerNeighbours(const FilterSurface& surface,
                         std::uint32_t number,
                         const EllipseFrame& frame,
                         double cut);
    void offer(std::uint32_t known, const Reached& offered);

    FlatWalk m_walk;
    std::vector<PlacedFace> m_laid;
    FaceTable m_numbers; ///< of faces in m_reached
    std::vector<Reached> m_reached;
    std::vector<Waiting> m_waiting; ///< a heap
};

} // namespace trixel
