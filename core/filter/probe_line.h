// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ids.h"
#include "core/filter/probe_plan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/vec2.hpp>

namespace trixel {

/// Probes in a straight row over the surface: at (k + ½) steps either way from a centre, with
/// weights in proportion to exp(-c x²) - exp(-c), x = (k + ½) / support.
struct ProbeLine
{
    FaceId face{};
    glm::dvec2 centre{0}; ///< inside the face
    glm::dvec2 step{0};   ///< in (u,v) of the face; near nothing: one probe, at the centre
    double support = 1;   ///< in steps, positive
    double share = 1;     ///< of the answer, positive

    /// Whether there is a line to walk.
    bool hasDirection() const { return step.x * step.x + step.y * step.y > 1e-30; }
    /// Probes to a side, at most half of kRoomPerLine.
    int perSide() const
    {
        constexpr int kMost = kRoomPerLine / 2;
        return support < kMost ? std::max(1, static_cast<int>(std::ceil(support - 0.5))) : kMost;
    }
};

/// Lines that a query may have.
inline constexpr std::size_t kMostLines = 2;

/// The lines of one query of the plans: one along the major axis, or one along either.
/// \param lines  room for kMostLines
/// \return       how many
inline std::size_t
linesOf(const ProbePlans& plans, std::size_t index, FaceId face, ProbeLine* lines)
{
    const glm::dvec2 centre(plans.u[index], plans.v[index]);
    const glm::dvec2 step(plans.stepU[index], plans.stepV[index]);
    const double share = plans.crossShare[index];
    lines[0] = {face, centre, step, plans.support[index], 1 - share};
    if (share == 0) {
        return 1;
    }
    const glm::dvec2 cross(plans.crossU[index], plans.crossV[index]);
    lines[1] = {face, centre, cross, plans.crossSupport[index], share};
    return 2;
}

} // namespace trixel
