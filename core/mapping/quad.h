// SPDX-License-Identifier: GPL-3.0-or-later
//
// A quadrilateral of an image: bilinear from the unit square, and back.
#pragma once

#include <glm/vec2.hpp>
#include <optional>

namespace trixel {

/// P(u,v) = P00 + u (P10 - P00) + v (P01 - P00) + u v (P11 - P01 - P10 + P00).
struct Quad
{
    glm::dvec2 p00{0, 0};
    glm::dvec2 p10{1, 0};
    glm::dvec2 p11{1, 1};
    glm::dvec2 p01{0, 1};
};

glm::dvec2 bilinear(const Quad& quad, glm::dvec2 uv);

/// The (u,v) that `bilinear` maps to a point; also outside the unit square, where the map goes on.
/// Solves the quadratic for v without cancellation (q = -½(b + sgn(b) √disc), roots c/q and q/a),
/// takes u from the longer of two differences, and polishes both with a Newton step.
///
/// Where two (u,v) lead to the point, the rule is fixed: the one inside the unit square; if both or
/// neither is, the one on the side of the fold where the map is most open, which is the corner with
/// the largest |∂P/∂u × ∂P/∂v| (the first of P00, P10, P11, P01 among equals). A convex quad has no
/// second one inside, a bow-tie may.
///
/// Nothing where no (u,v) leads there, where the quad has no area (largest corner area below 1e-12
/// of its size squared), or where a number is not finite.
std::optional<glm::dvec2> inverseBilinear(const Quad& quad, glm::dvec2 point);

} // namespace trixel
