// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/filter/query_filter.h"
#include "core/filter/unfolding.h"

namespace trixel {

/// Texels that a query to the base level may read; beyond, it is refused.
inline constexpr std::uint64_t kMostExactTaps = std::uint64_t{1} << 26U;

/// Base-level texels of the faces that lie whole within the cut: a query reads at least so many.
std::uint64_t
texelsOfWholeFaces(const FilterScene& scene, std::span<const PlacedFace> places, double cut);

/// The Gaussian-weighted mean over the texel centroids of the base level within six standard
/// deviations, weights times texel area, in double. Where none is so near, the nearest count as in
/// an endless Gaussian.
/// \param value  untouched where the query is refused (taps == kRefusedTaps): it would need more
///               than kMostExactTaps
QueryCost exactAnswer(const FilterScene& scene,
                      Unfolding& unfolding,
                      const QueryEllipse& ellipse,
                      FaceId face,
                      int group,
                      GroupValue& value);

} // namespace trixel
