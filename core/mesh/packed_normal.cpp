// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/packed_normal.h"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>

namespace trixel {

namespace {

float octahedral(float value)
{
    return std::clamp(value, -1.0F, 1.0F) * 32767.0F + 32768.0F;
}

} // namespace

std::uint32_t packNormal(glm::vec3 n)
{
    const float size = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
    glm::vec2 p = size > 0 ? glm::vec2(n.x, n.y) / size : glm::vec2(0);
    if (n.z < 0) {
        p = {(1 - std::abs(p.y)) * (p.x < 0 ? -1.0F : 1.0F),
             (1 - std::abs(p.x)) * (p.y < 0 ? -1.0F : 1.0F)};
    }
    const auto x = static_cast<std::uint32_t>(std::lround(octahedral(p.x)));
    const auto y = static_cast<std::uint32_t>(std::lround(octahedral(p.y)));
    return x | y << 16U;
}

} // namespace trixel
