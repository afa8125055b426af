// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace trixel {

/// One box of the hierarchy: 32 bytes, two to a cache line.
struct BvhNode
{
    glm::vec3 low{0};
    std::uint32_t first = 0; ///< leaf: first entry of the face list; inner: left child, right is +1
    glm::vec3 high{0};
    std::uint32_t count = 0; ///< faces of a leaf; 0 for an inner node

    bool isLeaf() const { return count > 0; }
};

} // namespace trixel
