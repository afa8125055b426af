// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/error_scale.h"
#include "core/mesh/limit_bends.h"
#include "core/mesh/limit_patterns.h"

#include <vector>

namespace trixel {

/// How every face is to be cut, and what error that leaves.
struct RatePlan
{
    std::vector<CutRates> faces;
    double error = 0; ///< the most that faces in view are off by, in the scale's units
};

/// The least rates that keep every face in view within the error. Edges have one rate for all
/// their faces.
/// \param mostTriangles  beyond which the error grows until they are fewer
RatePlan planRates(const LimitBends& bends,
                   const ErrorScale& scale,
                   double error,
                   std::size_t mostTriangles);

} // namespace trixel
