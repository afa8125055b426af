// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/footprint/face_plane.h"
#include "core/footprint/footprint.h"
#include "core/footprint/limit.h"
#include "core/footprint/svd2.h"

#include <algorithm>

namespace trixel {

FootprintEllipse ellipseOf(const Footprint& footprint, const std::array<glm::vec3, 3>& corners)
{
    // Longest W that is taken as it is; far beyond any filter, far from overflow.
    constexpr double kWidest = 1 << 20;
    const FacePlane plane(corners);
    if (!(plane.scale > 0) || !isFinite(plane.e1) || !isFinite(plane.e2)) {
        return {};
    }
    Footprint w = footprint;
    if (!isFinite(w.w1) || !isFinite(w.w2)) {
        w = roundFootprint(kWidest);
    }
    const double longest = std::max(largestComponent(w.w1), largestComponent(w.w2));
    if (longest > kWidest) {
        w.w1 *= kWidest / longest;
        w.w2 *= kWidest / longest;
    }
    // Plane frame: x along e1 (or e2 when V0 and V1 coincide), y across it within the face.
    const bool alongFirst = glm::length(plane.e1) > 0;
    const glm::dvec3 x = glm::normalize(alongFirst ? plane.e1 : plane.e2);
    const double area = glm::length(plane.normal);
    const glm::dvec2 t1(glm::dot(plane.e1, x), 0);
    const glm::dvec2 t2(glm::dot(plane.e2, x), t1.x > 0 ? area / t1.x : 0);

    // Half axes are the singular values of ½ T [W1 W2]: the square roots of the eigenvalues of
    // ¼ T (W1 W1ᵀ + W2 W2ᵀ) Tᵀ, without squaring and subtracting.
    const glm::dvec2 p1 = (t1 * w.w1.x + t2 * w.w1.y) / 2.0;
    const glm::dvec2 p2 = (t1 * w.w2.x + t2 * w.w2.y) / 2.0;
    const double det = t1.x * t2.y / 4 * differenceOfProducts(w.w1.x, w.w2.y, w.w2.x, w.w1.y);
    const Svd2 svd = svd2(p1, p2, det);

    FootprintEllipse ellipse;
    ellipse.majorLength = svd.major * plane.scale;
    ellipse.minorLength = svd.minor * plane.scale;
    ellipse.major = (w.w1 * svd.majorFrom.x + w.w2 * svd.majorFrom.y) / 2.0;
    // W v would lose the minor axis of a long ellipse to rounding; T is known and triangular.
    const glm::dvec2 minor = svd.minor * svd.minorTo;
    if (t2.y > 0) {
        const double v = minor.y / t2.y;
        ellipse.minor = {(minor.x - t2.x * v) / t1.x, v};
    }
    return ellipse;
}

} // namespace trixel
