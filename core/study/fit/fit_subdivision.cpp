// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/fit/fit_subdivision.h"

#include "core/mesh/loop_refinement.h"
#include "core/mesh/triangle_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trixel {
namespace {

/// The vertices that the four children of a face have and the face has not: a child in the middle
/// has three of them.
std::array<std::uint32_t, 3> middleChild(const TriangleMesh& finer, std::size_t parent)
{
    // Every child but the middle one has a vertex that no other child has.
    for (std::size_t k = 0; k < 4; ++k) {
        const Triangle& child = finer.triangles[4 * parent + k];
        const auto isShared = [&](std::uint32_t vertex) {
            int uses = 0;
            for (std::size_t other = 0; other < 4; ++other) {
                const Triangle& triangle = finer.triangles[4 * parent + other];
                uses += std::ranges::find(triangle, vertex) != triangle.end() ? 1 : 0;
            }
            return uses == 3;
        };
        if (std::ranges::all_of(child, isShared)) {
            return child;
        }
    }
    return finer.triangles[4 * parent];
}

/// The largest distance, in pixels, of the edges' middles (which lie on the limit surface once the
/// mesh is subdivided further) from the faces.
double largestGap(const TriangleMesh& mesh, const TriangleMesh& finer, const SceneViews& views)
{
    double largest = 0;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const auto corners = mesh.corners(faceId(f));
        for (const std::uint32_t vertex : middleChild(finer, f)) {
            const glm::dvec3 limit(finer.positions[vertex]);
            const double gap = std::sqrt(nearestOnTriangle(corners, limit).distanceSquared);
            largest = std::max(largest, gap / views.finestSpacing(limit));
        }
    }
    return largest;
}

} // namespace

std::vector<SubdivisionError> subdivisionErrors(const TriangleMesh& cage,
                                                const SceneViews& views,
                                                double most,
                                                std::size_t mostFaces)
{
    std::vector<SubdivisionError> errors;
    auto mesh = loopRefined(cage, 0);
    for (int steps = 0; mesh && steps < kMaxLoopSteps; ++steps) {
        if (4 * mesh->faceCount() > mostFaces) {
            break;
        }
        auto finer = loopRefined(cage, steps + 1);
        if (!finer) {
            break;
        }
        errors.push_back({steps, mesh->faceCount(), largestGap(*mesh, *finer, views)});
        if (errors.back().pixels <= most) {
            break;
        }
        mesh = std::move(finer);
    }
    return errors;
}

} // namespace trixel
