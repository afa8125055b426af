// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/flat_walk.h"

#include <cmath>

namespace trixel {
namespace {

constexpr unsigned kAllEdges = 7;
constexpr std::array<std::size_t, 5> kCorner = {0, 1, 2, 0, 1}; // as they follow each other

/// Places differ by rounding, in standard deviations.
bool isSame(glm::dvec2 a, glm::dvec2 b)
{
    constexpr double kRounding = 1e-7;
    return std::abs(a.x - b.x) < kRounding && std::abs(a.y - b.y) < kRounding;
}

} // namespace

std::optional<std::span<const PlacedFace>> FlatWalk::lay(const FilterSurface& surface,
                                                         const PlacedFace& hit,
                                                         double cut,
                                                         std::size_t mostFaces)
{
    const double cut2 = cut * cut;
    m_numbers.clear();
    m_count = 0;
    makeRoom();
    m_numbers.findOrAdd(hit.face, 0);
    m_laid[0] = hit;
    m_edges[0] = kAllEdges;
    m_count = 1;
    for (std::size_t n = 0; n < m_count; ++n) {
        makeRoom();
        const auto& corners = m_laid[n].corners;
        for (std::size_t k = 0; k < 3; ++k) {
            if ((m_edges[n] >> k & 1U) != 0 &&
                comesWithin(corners[k], corners[kCorner[k + 1]], cut2) && !cross(surface, n, k)) {
                return std::nullopt;
            }
        }
        if (m_count > mostFaces) {
            return std::nullopt;
        }
    }
    return std::span<const PlacedFace>(m_laid).first(m_count);
}

/// Lays the face across an edge, or sees whether it fits where it lies already.
bool FlatWalk::cross(const FilterSurface& surface, std::size_t number, std::size_t edge)
{
    // A vertex beyond an edge is placed by how the face itself came to lie; a narrow face says
    // little about what is far from it.
    constexpr double kFarthest = 64;
    const auto& corners = m_laid[number].corners;
    const FilterSurface::FaceSteps& steps = surface.steps(m_laid[number].face);
    const std::uint32_t across = steps.across[edge];
    if (across == FilterSurface::FaceSteps::kBorder) {
        return true;
    }
    const glm::dvec2 start = corners[edge];
    const glm::dvec2 end = corners[kCorner[edge + 1]];
    const FaceId face = faceId(across >> 2U);
    const std::size_t other = across & 3U; // as the neighbour numbers it, the other way
    const std::uint32_t known = m_numbers.findOrAdd(face, static_cast<std::uint32_t>(m_count));
    if (known != FaceTable::kNone) {
        const auto& there = m_laid[known].corners;
        m_edges[known] &= static_cast<Edges>(~(1U << other));
        return isSame(there[other], end) && isSame(there[kCorner[other + 1]], start);
    }
    const double along = steps.beyond[edge][0];
    const double away = steps.beyond[edge][1];
    if (!(std::abs(along) < kFarthest && std::abs(away) < kFarthest)) {
        return false;
    }
    __builtin_prefetch(&surface.steps(face));
    m_laid[m_count].face = face;
    auto& there = m_laid[m_count].corners;
    there[other] = end;
    there[kCorner[other + 1]] = start;
    there[kCorner[other + 2]] =
        start + along * (end - start) + away * (corners[kCorner[edge + 2]] - start);
    m_edges[m_count] = static_cast<Edges>(kAllEdges & ~(1U << other));
    ++m_count;
    return true;
}

/// For as many faces as one face can lay.
void FlatWalk::makeRoom()
{
    if (m_count + 3 > m_laid.size()) {
        m_laid.resize(2 * m_count + 64);
        m_edges.resize(m_laid.size());
    }
}

} // namespace trixel
