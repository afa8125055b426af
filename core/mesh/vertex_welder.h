// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace trixel {

/// Gives equal positions (bit for bit, but -0 equals +0) one vertex number, in the order in which
/// they first come.
class VertexWelder
{
public:
    VertexWelder();

    /// \param position  finite
    std::uint32_t add(glm::vec3 position);

    std::vector<glm::vec3> takePositions() { return std::move(m_positions); }

private:
    void grow();

    std::vector<glm::vec3> m_positions;
    std::vector<std::uint32_t> m_slots; // vertex numbers by hash, open addressing
};

} // namespace trixel
