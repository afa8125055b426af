// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/unfolding.h"

#include <algorithm>
#include <bit>

namespace trixel {
namespace {

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
double distanceTo(const PlacedFace& place)
{
    const glm::dvec2 a = place.corner(0);
    const glm::dvec2 b = place.corner(1);
    const glm::dvec2 c = place.corner(2);
    const double squared =
        std::min({squaredDistance(a, b), squaredDistance(b, c), squaredDistance(c, a)});
    const double inside = std::min({cross(a, b), cross(b, c), cross(c, a)});
    return inside >= 0 ? 0.0 : std::sqrt(squared);
}

/// Where the rule of the header puts a face, rounded to 30 bits so that rounding errors do not
/// decide between equals.
double keyOf(const PlacedFace& place)
{
    constexpr double kCentroidShare = 1.0 / 65536;
    const glm::dvec2 centroid = place.origin + (place.e1 + place.e2) / 3.0;
    const double key = place.distance + kCentroidShare * glm::length(centroid);
    constexpr std::uint64_t kLowBits = (std::uint64_t{1} << 23U) - 1;
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(key);
    return std::bit_cast<double>((bits + kLowBits / 2 + 1) & ~kLowBits);
}

glm::dvec2 shapeCorner(const FaceShape& shape, std::size_t index)
{
    return index == 0 ? glm::dvec2(0) : index == 1 ? shape.e1 : shape.e2;
}

/// The face of that shape with the start of its edge at `start` and the edge's end at `end`.
PlacedFace
laidOnto(FaceId face, const FaceShape& shape, LocalEdge edge, glm::dvec2 start, glm::dvec2 end)
{
    const std::size_t k = indexOf(edge);
    const glm::dvec2 own = shapeCorner(shape, k);
    const glm::dvec2 from = shapeCorner(shape, (k + 1) % 3) - own;
    const glm::dvec2 to = end - start;
    // The turn from `from` to `to` as a complex factor; its size is 1 but for rounding and for
    // faces whose shape was replaced.
    const double squared = glm::dot(from, from);
    const glm::dvec2 turn(glm::dot(from, to) / squared, cross(from, to) / squared);
    const auto turned = [turn](glm::dvec2 p) {
        return glm::dvec2(turn.x * p.x - turn.y * p.y, turn.y * p.x + turn.x * p.y);
    };
    PlacedFace place{face, start - turned(own), turned(shape.e1), turned(shape.e2)};
    place.distance = distanceTo(place);
    return place;
}

} // namespace

Unfolding::Unfolding()
    : m_slots(64)
{
    m_laid.reserve(32);
    m_offers.reserve(32);
    m_waiting.reserve(32);
}

std::span<const PlacedFace> Unfolding::unfold(const FilterSurface& surface,
                                              FaceId face,
                                              const QueryEllipse& ellipse,
                                              const EllipseFrame& frame,
                                              double cut,
                                              std::size_t mostFaces)
{
    m_laid.clear();
    m_offers.clear();
    m_waiting.clear();
    if (++m_stamp == 0) {
        std::ranges::fill(m_slots, Slot{});
        m_stamp = 1;
    }
    const FaceShape& shape = surface.shape(face);
    lay({face, -ellipse.centre, shape.e1, shape.e2});
    offerNeighbours(surface, m_laid.back(), frame, cut);
    while (!m_waiting.empty() && m_laid.size() < mostFaces) {
        std::ranges::pop_heap(m_waiting, isLater);
        const Candidate next = m_waiting.back();
        m_waiting.pop_back();
        if (!isLaid(next.face)) {
            const PlacedFace place = m_offers[next.offer];
            lay(place);
            offerNeighbours(surface, place, frame, cut);
        }
    }
    return m_laid;
}

bool Unfolding::isLater(const Candidate& a, const Candidate& b)
{
    if (a.key != b.key) {
        return a.key > b.key;
    }
    return a.parent != b.parent ? a.parent > b.parent : a.face > b.face;
}

void Unfolding::lay(const PlacedFace& place)
{
    markLaid(place.face);
    m_laid.push_back(place);
}

void Unfolding::offerNeighbours(const FilterSurface& surface,
                                const PlacedFace& place,
                                const EllipseFrame& frame,
                                double cut)
{
    const std::array<glm::dvec2, 3> corners = {place.corner(0), place.corner(1), place.corner(2)};
    const std::array<glm::dvec2, 3> units = {
        frame.toUnit(corners[0]), frame.toUnit(corners[1]), frame.toUnit(corners[2])};
    for (const LocalEdge edge : kLocalEdges) {
        const std::size_t k = indexOf(edge);
        const std::size_t next = (k + 1) % 3;
        const auto across = surface.adjacency().neighbour(place.face, edge);
        if (!across || isLaid(across->face) || squaredDistance(units[k], units[next]) > cut * cut) {
            continue;
        }
        // The neighbour runs along the edge the other way.
        const PlacedFace neighbour = laidOnto(
            across->face, surface.shape(across->face), across->edge, corners[next], corners[k]);
        // Around a vertex distances are equal but for rounding.
        constexpr double kSlack = 1e-6;
        const double slack = kSlack * glm::length(corners[next] - corners[k]);
        if (neighbour.distance < place.distance - slack) {
            continue;
        }
        m_waiting.push_back({keyOf(neighbour),
                             place.face,
                             neighbour.face,
                             static_cast<std::uint32_t>(m_offers.size())});
        m_offers.push_back(neighbour);
        std::ranges::push_heap(m_waiting, isLater);
    }
}

bool Unfolding::isLaid(FaceId face) const
{
    return m_slots[slotOf(face)].stamp == m_stamp;
}

void Unfolding::markLaid(FaceId face)
{
    if (4 * m_laid.size() >= 3 * m_slots.size()) {
        growTable();
    }
    m_slots[slotOf(face)] = {m_stamp, face};
}

/// The face's slot, or the free one where it belongs.
std::size_t Unfolding::slotOf(FaceId face) const
{
    const std::size_t mask = m_slots.size() - 1; // a power of two
    std::size_t slot = (indexOf(face) * 0x9E3779B97F4A7C15ULL >> 32U) & mask;
    while (m_slots[slot].stamp == m_stamp && m_slots[slot].face != face) {
        slot = (slot + 1) & mask;
    }
    return slot;
}

void Unfolding::growTable()
{
    m_slots.assign(2 * m_slots.size(), Slot{});
    m_stamp = 1;
    for (const PlacedFace& place : m_laid) {
        m_slots[slotOf(place.face)] = {m_stamp, place.face};
    }
}

} // namespace trixel
