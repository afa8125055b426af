// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/filter_queries.h"
#include "core/filter/filter_scene.h"

#include <cstdint>

namespace trixel {

/// Footprints at random points of a surface, as likely on equal areas: width ¼ to 64 base-level
/// texels there and anisotropy 1 to 64, both log-uniform, in any direction, W1 and W2 any conjugate
/// radii of the ellipse. The same seed gives the same footprints.
QueryArrays spreadQueries(const FilterScene& scene, int count, std::uint64_t seed);

} // namespace trixel
