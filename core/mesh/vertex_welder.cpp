// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/vertex_welder.h"

#include <bit>

namespace trixel {
namespace {

constexpr std::uint32_t kEmpty = 0xFFFFFFFFU;

// Mixing with the constants of Vigna's splitmix64.
std::size_t hashOf(const glm::vec3& p)
{
    std::uint64_t h =
        std::uint64_t{std::bit_cast<std::uint32_t>(p.x)} << 32U | std::bit_cast<std::uint32_t>(p.y);
    h ^= std::uint64_t{std::bit_cast<std::uint32_t>(p.z)} * 0x9E3779B97F4A7C15U;
    h = (h ^ (h >> 30U)) * 0xBF58476D1CE4E5B9U;
    h = (h ^ (h >> 27U)) * 0x94D049BB133111EBU;
    return static_cast<std::size_t>(h ^ (h >> 31U));
}

} // namespace

VertexWelder::VertexWelder()
    : m_slots(1U << 10U, kEmpty)
{
}

std::uint32_t VertexWelder::add(glm::vec3 position)
{
    position += 0.0F; // -0 becomes +0
    const std::size_t mask = m_slots.size() - 1;
    for (std::size_t slot = hashOf(position) & mask;; slot = (slot + 1) & mask) {
        const std::uint32_t vertex = m_slots[slot];
        if (vertex == kEmpty) {
            const auto added = static_cast<std::uint32_t>(m_positions.size());
            m_slots[slot] = added;
            m_positions.push_back(position);
            if (2 * m_positions.size() > m_slots.size()) {
                grow();
            }
            return added;
        }
        if (m_positions[vertex] == position) {
            return vertex;
        }
    }
}

void VertexWelder::grow()
{
    std::vector<std::uint32_t> slots(4 * m_slots.size(), kEmpty);
    const std::size_t mask = slots.size() - 1;
    for (std::size_t v = 0; v < m_positions.size(); ++v) {
        std::size_t slot = hashOf(m_positions[v]) & mask;
        while (slots[slot] != kEmpty) {
            slot = (slot + 1) & mask;
        }
        slots[slot] = static_cast<std::uint32_t>(v);
    }
    m_slots = std::move(slots);
}

} // namespace trixel
