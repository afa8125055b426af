// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ids.h"
#include "core/filter/probe_plan.h"

#include <cmath>
#include <cstddef>
#include <glm/vec2.hpp>

namespace trixel {

/// Probes in a straight row over the surface: at (k + ½) steps either way from a centre, each of
/// the weight exp(-c x²) - exp(-c), x = (k + ½) / support, times that of the row.
struct ProbeLine
{
    FaceId face{};
    glm::dvec2 centre{0}; ///< inside the face
    glm::dvec2 step{0};   ///< in (u,v) of the face; near nothing: one probe, at the centre
    double support = 1;   ///< in steps, positive
    double weight = 1;    ///< positive

    /// Probes to a side.
    int perSide() const { return std::max(1, static_cast<int>(std::ceil(support - 0.5))); }
};

/// Rows that a query may have.
inline constexpr std::size_t kMostLines = 3;

/// The rows of one query of the plans, at least one.
/// \param lines  room for kMostLines
/// \return       how many
inline std::size_t
linesOf(const ProbePlans& plans, std::size_t index, FaceId face, ProbeLine* lines)
{
    lines[0] = {face,
                {plans.u[index], plans.v[index]},
                {plans.stepU[index], plans.stepV[index]},
                plans.support[index],
                1.0};
    return 1;
}

} // namespace trixel
