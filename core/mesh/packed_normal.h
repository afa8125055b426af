// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace trixel {

/// A unit vector in 32 bits: its octahedral map, 16 bits each way.
std::uint32_t packNormal(glm::vec3 normal);

} // namespace trixel
