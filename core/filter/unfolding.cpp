// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/unfolding.h"

#include "core/filter/shape_on_edge.h"

#include <algorithm>
#include <cmath>

namespace trixel {
namespace {

using Corners = std::array<glm::dvec2, 3>;

double cross(glm::dvec2 a, glm::dvec2 b)
{
    return a.x * b.y - a.y * b.x;
}

/// Squared distance from the origin to the segment from a to b, which differ.
double squaredDistance(glm::dvec2 a, glm::dvec2 b)
{
    const glm::dvec2 along = b - a;
    const double t = -glm::dot(a, along) / glm::dot(along, along);
    const glm::dvec2 nearest = a + std::max(0.0, std::min(t, 1.0)) * along;
    return glm::dot(nearest, nearest);
}

/// Distance from the origin to the triangle, which turns left.
/// \param toFirst  squared distance to the edge from corner 0 to corner 1
double distanceTo(const Corners& c, double toFirst)
{
    const double squared =
        std::min({toFirst, squaredDistance(c[1], c[2]), squaredDistance(c[2], c[0])});
    const double inside = std::min({cross(c[0], c[1]), cross(c[1], c[2]), cross(c[2], c[0])});
    return inside >= 0 ? 0.0 : std::sqrt(squared);
}

/// Where the rule of the header puts a face.
double keyOf(double way, const Corners& corners)
{
    constexpr double kCentroidShare = 1.0 / 16384;
    return way + kCentroidShare * glm::length(corners[0] + corners[1] + corners[2]) / 3;
}

} // namespace

std::span<const PlacedFace> Unfolding::unfold(const FilterSurface& surface,
                                              FaceId face,
                                              const QueryEllipse& ellipse,
                                              const EllipseFrame& frame,
                                              double cut,
                                              std::size_t mostFaces)
{
    const FaceShape& shape = surface.shape(face);
    const PlacedFace hit{face,
                         {frame.toUnit(-ellipse.centre),
                          frame.toUnit(shape.e1 - ellipse.centre),
                          frame.toUnit(shape.e2 - ellipse.centre)}};
    if (const auto laid = m_walk.lay(surface, hit, cut, mostFaces)) {
        return *laid;
    }
    layByRule(surface, hit, frame, cut, mostFaces);
    return m_laid;
}

void Unfolding::layByRule(const FilterSurface& surface,
                          const PlacedFace& hit,
                          const EllipseFrame& frame,
                          double cut,
                          std::size_t mostFaces)
{
    m_laid.clear();
    m_numbers.clear();
    m_reached.clear();
    m_waiting.clear();
    offer(FaceTable::kNone, {hit, 0, 0, 0, hit.face, false});
    while (!m_waiting.empty() && m_laid.size() < mostFaces) {
        std::ranges::pop_heap(m_waiting, isLater);
        const std::uint32_t next = m_waiting.back().number;
        m_waiting.pop_back();
        if (!m_reached[next].laid) {
            m_reached[next].laid = true;
            m_laid.push_back(m_reached[next].place);
            offerNeighbours(surface, next, frame, cut);
        }
    }
}

bool Unfolding::isLater(const Waiting& a, const Waiting& b)
{
    return a.key != b.key ? a.key > b.key : a.face > b.face;
}

void Unfolding::offerNeighbours(const FilterSurface& surface,
                                std::uint32_t number,
                                const EllipseFrame& frame,
                                double cut)
{
    const Reached from = m_reached[number];
    const FilterSurface::FaceSteps& steps = surface.steps(from.place.face);
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec2 start = from.place.corners[k];
        const glm::dvec2 end = from.place.corners[(k + 1) % 3];
        if (steps.across[k] == FilterSurface::FaceSteps::kBorder ||
            !comesWithin(start, end, cut * cut)) {
            continue;
        }
        const FaceId face = faceId(steps.across[k] >> 2U);
        const std::size_t edge = steps.across[k] & 3U;
        const std::uint32_t known = m_numbers.find(face);
        if (known != FaceTable::kNone && m_reached[known].laid) {
            continue;
        }
        // From lengths alone, not from how this face came to lie: narrow faces magnify errors.
        const glm::dvec2 beyond = frame.toUnit(
            vertexBeyond(surface.shape(face), edge, frame.toPlane(start), frame.toPlane(end)));
        const double toEdge = squaredDistance(start, end);
        const double distance = distanceTo({end, start, beyond}, toEdge);
        // Around a vertex distances are equal but for rounding.
        constexpr double kSlack = 1e-6;
        const double slack = kSlack * glm::length(end - start);
        if (distance < from.distance - slack ||
            4 * (distance + slack) * (distance + slack) < toEdge) {
            continue;
        }
        Reached offered{{face, {}}, 0, 0, distance, from.place.face, false};
        offered.place.corners[edge] = end;
        offered.place.corners[(edge + 1) % 3] = start;
        offered.place.corners[(edge + 2) % 3] = beyond;
        offered.way = std::max(from.way, std::sqrt(toEdge));
        offered.key = keyOf(offered.way, offered.place.corners);
        offer(known, offered);
    }
}

/// \param known  the face's number in m_reached, kNone where this is the first time
void Unfolding::offer(std::uint32_t known, const Reached& offered)
{
    constexpr double kEqual = 1e-6;
    const FaceId face = offered.place.face;
    if (known == FaceTable::kNone) {
        known = static_cast<std::uint32_t>(m_reached.size());
        m_numbers.findOrAdd(face, known);
        m_reached.push_back(offered);
    } else {
        Reached& before = m_reached[known];
        const bool nearer = offered.key < before.key;
        if (offered.key < before.key * (1 - kEqual) ||
            (offered.key <= before.key * (1 + kEqual) && offered.parent < before.parent)) {
            before = offered;
        }
        if (!nearer) {
            return;
        }
    }
    m_waiting.push_back({offered.key, face, known});
    std::ranges::push_heap(m_waiting, isLater);
}

} // namespace trixel
