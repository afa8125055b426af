// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/unfolding.h"

#include <algorithm>

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

using Corners = std::array<glm::dvec2, 3>;

/// Distance from the origin to the triangle, which turns left.
double distanceTo(const Corners& c)
{
    const double squared = std::min(
        {squaredDistance(c[0], c[1]), squaredDistance(c[1], c[2]), squaredDistance(c[2], c[0])});
    const double inside = std::min({cross(c[0], c[1]), cross(c[1], c[2]), cross(c[2], c[0])});
    return inside >= 0 ? 0.0 : std::sqrt(squared);
}

Corners cornersOf(const PlacedFace& place)
{
    return {place.corner(0), place.corner(1), place.corner(2)};
}

Corners toUnit(const EllipseFrame& frame, const Corners& c)
{
    return {frame.toUnit(c[0]), frame.toUnit(c[1]), frame.toUnit(c[2])};
}

/// Where the rule of the header puts a face.
double keyOf(double way, const Corners& unit)
{
    constexpr double kCentroidShare = 1.0 / 16384;
    return way + kCentroidShare * glm::length(unit[0] + unit[1] + unit[2]) / 3;
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
    return {face, start - turned(own), turned(shape.e1), turned(shape.e2)};
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
    m_reached = 0;
    if (++m_stamp == 0) {
        std::ranges::fill(m_slots, Slot{});
        m_stamp = 1;
    }
    const FaceShape& shape = surface.shape(face);
    lay({face, -ellipse.centre, shape.e1, shape.e2});
    offerNeighbours(surface, m_laid.back(), frame, cut);
    while (!m_waiting.empty() && m_laid.size() < mostFaces) {
        std::ranges::pop_heap(m_waiting, isLater);
        const FaceId next = m_waiting.back().face;
        m_waiting.pop_back();
        const Slot& slot = slotOf(next);
        if (!slot.laid) {
            const PlacedFace place = m_offers[slot.offer];
            lay(place);
            offerNeighbours(surface, place, frame, cut);
        }
    }
    return m_laid;
}

bool Unfolding::isLater(const Waiting& a, const Waiting& b)
{
    return a.key != b.key ? a.key > b.key : a.face > b.face;
}

void Unfolding::lay(const PlacedFace& place)
{
    reach(place.face).laid = true;
    m_laid.push_back(place);
}

void Unfolding::offerNeighbours(const FilterSurface& surface,
                                const PlacedFace& place,
                                const EllipseFrame& frame,
                                double cut)
{
    const Corners corners = cornersOf(place);
    const Corners unit = toUnit(frame, corners);
    for (const LocalEdge edge : kLocalEdges) {
        const std::size_t k = indexOf(edge);
        const std::size_t next = (k + 1) % 3;
        const auto across = surface.adjacency().neighbour(place.face, edge);
        if (!across || isLaid(across->face)) {
            continue;
        }
        const double toEdge = squaredDistance(unit[k], unit[next]);
        if (toEdge > cut * cut) {
            continue;
        }
        // The neighbour runs along the edge the other way.
        PlacedFace neighbour = laidOnto(
            across->face, surface.shape(across->face), across->edge, corners[next], corners[k]);
        const Corners neighbourUnit = toUnit(frame, cornersOf(neighbour));
        neighbour.distance = distanceTo(neighbourUnit);
        // Around a vertex distances are equal but for rounding.
        constexpr double kSlack = 1e-6;
        const double slack = kSlack * glm::length(unit[next] - unit[k]);
        if (neighbour.distance < place.distance - slack ||
            4 * (neighbour.distance + slack) * (neighbour.distance + slack) < toEdge) {
            continue;
        }
        neighbour.way = std::max(place.way, std::sqrt(toEdge));
        offer(neighbour, place.face, keyOf(neighbour.way, neighbourUnit));
    }
}

void Unfolding::offer(const PlacedFace& place, FaceId parent, double key)
{
    constexpr double kEqual = 1e-6;
    const std::size_t before = m_reached;
    Slot& slot = reach(place.face);
    const bool isNew = m_reached != before;
    const bool nearer = isNew || key < slot.key;
    const bool better = isNew || key < slot.key * (1 - kEqual) ||
                        (key <= slot.key * (1 + kEqual) && parent < slot.parent);
    if (nearer) {
        m_waiting.push_back({key, place.face});
        std::ranges::push_heap(m_waiting, isLater);
    }
    if (better) {
        slot.key = key;
        slot.parent = parent;
        slot.offer = static_cast<std::uint32_t>(m_offers.size());
        m_offers.push_back(place);
    }
}

bool Unfolding::isLaid(FaceId face)
{
    const Slot& slot = slotOf(face);
    return slot.stamp == m_stamp && slot.laid;
}

/// The face's slot, entered if it was not.
Unfolding::Slot& Unfolding::reach(FaceId face)
{
    if (4 * m_reached >= 3 * m_slots.size()) {
        growTable();
    }
    Slot& slot = slotOf(face);
    if (slot.stamp != m_stamp) {
        slot = Slot{m_stamp, face, false, 0, FaceId{}, 0};
        ++m_reached;
    }
    return slot;
}

/// The face's slot, or the free one where it belongs.
Unfolding::Slot& Unfolding::slotOf(FaceId face)
{
    const std::size_t mask = m_slots.size() - 1; // a power of two
    std::size_t slot = (indexOf(face) * 0x9E3779B97F4A7C15ULL >> 32U) & mask;
    while (m_slots[slot].stamp == m_stamp && m_slots[slot].face != face) {
        slot = (slot + 1) & mask;
    }
    return m_slots[slot];
}

void Unfolding::growTable()
{
    std::vector<Slot> before(2 * m_slots.size());
    before.swap(m_slots);
    for (const Slot& slot : before) {
        if (slot.stamp == m_stamp) {
            slotOf(slot.face) = slot;
        }
    }
}

} // namespace trixel
