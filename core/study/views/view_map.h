// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers for every pixel of a view: how well its footprint is conditioned, how far a filter is
// from the exact answer there.
#pragma once

#include "core/base/parallel.h"
#include "core/filter/filter_method.h"
#include "core/mesh/limit_surface.h"
#include "core/mesh/surface.h"

#include <span>
#include <string_view>

namespace trixel {

/// The method of the table that all others are judged by.
inline constexpr std::string_view kExactMethod = "exact";

/// Condition of each footprint on its face: the longer half axis of its ellipse over the shorter, 1
/// where it is round, infinite where it is a line.
/// \param conditions  one a query (checked)
void footprintConditions(const Surface& surface,
                         const FilterQueries& queries,
                         Threads threads,
                         std::span<float> conditions);

/// The same on the limit surface, as it lies at each query.
void footprintConditions(const LimitSurface& limit,
                         const FilterQueries& queries,
                         Threads threads,
                         std::span<float> conditions);

/// Largest difference of a channel between two methods, in parts of `range` (0 where that is 0);
/// NaN where one of them refuses the query, infinite where one alone answers with no number.
/// \param errors  one a query (checked)
void filterDifferences(const FilterScene& scene,
                       const FilterMethod& method,
                       const FilterMethod& reference,
                       double range,
                       const FilterQueries& queries,
                       Threads threads,
                       std::span<float> errors);

/// The same for answers that are there.
/// \param values, reference  one a channel, of one length (checked)
float differenceOf(std::span<const float> values, std::span<const float> reference, double range);

} // namespace trixel
