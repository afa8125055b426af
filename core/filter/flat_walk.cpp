// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/flat_walk.h"

#include <cmath>

namespace trixel {
namespace {

constexpr unsigned kAllEdges = 7;

/// Places differ by rounding, in standard deviations.
bool isSame(glm::dvec2 a, glm::dvec2 b)
{
    constexpr double kRounding = 1e-7;
    return std::abs(a.x - b.x) < kRounding && std::abs(a.y - b.y) < kRounding;
}

} // namespace

bool FlatWalk::lay(const FilterSurface& surface,
                   const PlacedFace& hit,
                   double cut,
                   std::size_t mostFaces,
                   std::vector<PlacedFace>& laid)
{
    // A vertex beyond an edge is placed by how the face itself came to lie; a narrow face says
    // little about what is far from it.
    constexpr double kFarthest = 64;
    const double cut2 = cut * cut;
    laid.clear();
    m_edges.clear();
    m_numbers.clear();
    add(hit, kAllEdges, laid);
    for (std::size_t n = 0; n < laid.size(); ++n) {
        const PlacedFace place = laid[n];
        const FilterSurface::FaceSteps& steps = surface.steps(place.face);
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec2 start = place.corners[k];
            const glm::dvec2 end = place.corners[(k + 1) % 3];
            const std::uint32_t across = steps.across[k];
            if ((m_edges[n] >> k & 1U) == 0 || !comesWithin(start, end, cut2) ||
                across == FilterSurface::FaceSteps::kBorder) {
                continue;
            }
            const std::size_t edge = across & 3U; // as the neighbour numbers it, the other way
            const FaceId face = faceId(across >> 2U);
            const auto fresh = static_cast<std::uint32_t>(laid.size());
            const std::uint32_t known = m_numbers.findOrAdd(face, fresh);
            if (known != FaceTable::kNone) {
                const auto& there = laid[known].corners;
                if (!isSame(there[edge], end) || !isSame(there[(edge + 1) % 3], start)) {
                    return false;
                }
                m_edges[known] &= static_cast<std::uint8_t>(~(1U << edge));
                continue;
            }
            const auto& [alongShare, farShare] = steps.beyond[k];
            if (fresh == mostFaces ||
                !(std::abs(alongShare) < kFarthest && std::abs(farShare) < kFarthest)) {
                return false;
            }
            PlacedFace next;
            next.face = face;
            next.corners[edge] = end;
            next.corners[(edge + 1) % 3] = start;
            next.corners[(edge + 2) % 3] = start + alongShare * (end - start) +
                                           farShare * (place.corners[(k + 2) % 3] - start);
            __builtin_prefetch(&surface.steps(face));
            laid.push_back(next);
            m_edges.push_back(static_cast<std::uint8_t>(kAllEdges & ~(1U << edge)));
        }
    }
    return true;
}

void FlatWalk::add(const PlacedFace& place, unsigned edgesToCross, std::vector<PlacedFace>& laid)
{
    m_numbers.findOrAdd(place.face, static_cast<std::uint32_t>(laid.size()));
    laid.push_back(place);
    m_edges.push_back(static_cast<std::uint8_t>(edgesToCross));
}

} // namespace trixel
