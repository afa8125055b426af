// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mapping/projection.h"

#include "core/footprint/svd2.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace trixel {

namespace {

bool isFinite(const glm::dvec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// From the world to (x,y) in a plane of the origin and two vectors that span it; z along their
/// normal.
std::optional<glm::dmat4> intoPlane(glm::dvec3 origin, glm::dvec3 right, glm::dvec3 up)
{
    const glm::dvec3 normal = glm::cross(right, up);
    constexpr double kFlattest = 1e-12;
    if (!isFinite(origin) || !isFinite(normal) ||
        !(glm::length(normal) > kFlattest * glm::length(right) * glm::length(up))) {
        return std::nullopt;
    }
    const glm::dmat4 fromPlane(glm::dvec4(right, 0),
                               glm::dvec4(up, 0),
                               glm::dvec4(glm::normalize(normal), 0),
                               glm::dvec4(origin, 1));
    return glm::inverse(fromPlane);
}

double cornerArea(glm::dvec2 before, glm::dvec2 at, glm::dvec2 after)
{
    const glm::dvec2 in = at - before;
    const glm::dvec2 out = after - at;
    return differenceOfProducts(in.x, out.y, in.y, out.x);
}

} // namespace

Status checkQuad(const Quad& quad)
{
    const std::array<glm::dvec2, 4> p = {quad.p00, quad.p10, quad.p11, quad.p01};
    double size = 0;
    std::array<double, 4> areas{};
    for (std::size_t k = 0; k < 4; ++k) {
        const glm::dvec2 edge = p[(k + 1) % 4] - p[k];
        size = std::max(size, glm::dot(edge, edge));
        areas[k] = cornerArea(p[(k + 3) % 4], p[k], p[(k + 1) % 4]);
    }
    if (!std::isfinite(size)) {
        return contentsError("the quadrilateral has a corner that is nowhere");
    }
    constexpr double kFlattest = 1e-9;
    const auto isFlat = [&](double area) { return !(std::abs(area) > kFlattest * size); };
    if (std::all_of(areas.begin(), areas.end(), isFlat)) {
        return contentsError("the quadrilateral's four corners lie on a line");
    }
    const auto turns = [&](double sign) {
        return std::count_if(
            areas.begin(), areas.end(), [&](double a) { return !isFlat(a) && a * sign > 0; });
    };
    if (turns(1) == 2 && turns(-1) == 2) {
        return contentsError("the quadrilateral crosses itself: its corners are not in order");
    }
    if (turns(1) > 0 && turns(-1) > 0) {
        return contentsError("the quadrilateral bends inwards at a corner");
    }
    if (turns(1) + turns(-1) < 4) {
        return contentsError("three of the quadrilateral's corners lie on a line");
    }
    return {};
}

Result<Projection> planarProjection(glm::dvec3 origin, glm::dvec3 right, glm::dvec3 up)
{
    const auto toPlane = intoPlane(origin, right, up);
    if (!toPlane) {
        return contentsError("the plane's two directions lie on a line");
    }
    Projection projection;
    projection.toPlane = *toPlane;
    projection.eye = glm::dvec4(glm::normalize(glm::cross(right, up)), 0);
    return projection;
}

Result<Projection> quadProjection(const std::array<glm::dvec3, 4>& corners)
{
    // The diagonals' cross product is the area vector of any quadrilateral, flat or not.
    const glm::dvec3 a = corners[2] - corners[0];
    const glm::dvec3 b = corners[3] - corners[1];
    const glm::dvec3 area = glm::cross(a, b);
    const double size = std::max(glm::length(a), glm::length(b));
    if (!(size > 0) || !isFinite(area) || !(glm::length(area) > 1e-12 * size * size)) {
        // No direction sees anything of it: a line, or a bow-tie whose halves cancel.
        const glm::dvec3 right = corners[1] - corners[0];
        const glm::dvec3 other = corners[2] - corners[0];
        const bool line = !(glm::length(glm::cross(right, other)) >
                            1e-12 * glm::length(right) * glm::length(other));
        return contentsError(line ? "the quadrilateral's four corners lie on a line"
                                  : "the quadrilateral crosses itself: its corners are not in "
                                    "order");
    }
    const glm::dvec3 normal = glm::normalize(area);
    glm::dvec3 right = corners[1] - corners[0];
    right -= glm::dot(right, normal) * normal;
    if (!(glm::length(right) > 1e-12 * size)) {
        right = a - glm::dot(a, normal) * normal;
    }
    right = glm::normalize(right) * size;
    const auto toPlane = intoPlane(corners[0], right, glm::cross(normal, right));
    if (!toPlane) {
        return contentsError("the quadrilateral's four corners lie on a line");
    }
    Projection projection;
    projection.toPlane = *toPlane;
    projection.isRectangle = false;
    projection.eye = glm::dvec4(normal, 0);
    const auto inPlane = [&](std::size_t k) {
        return glm::dvec2(*toPlane * glm::dvec4(corners[k], 1));
    };
    projection.corners = {inPlane(0), inPlane(1), inPlane(2), inPlane(3)};
    if (const Status usable = checkQuad(projection.corners); !usable) {
        return tl::unexpected(usable.error());
    }
    return projection;
}

Result<Projection> cameraProjection(const glm::dmat4& toClip)
{
    const glm::dmat4 fromClip = glm::inverse(toClip);
    // The point that is at the same place of the picture from everywhere.
    const glm::dvec4 eye = fromClip * glm::dvec4(0, 0, -1, 0);
    const double largest =
        std::max({std::abs(eye.x), std::abs(eye.y), std::abs(eye.z), std::abs(eye.w)});
    if (!(largest > 0) || !std::isfinite(largest)) {
        return contentsError("the camera's matrix cannot be inverted");
    }
    Projection projection;
    // From -1…1 to 0…1, both ways.
    const glm::dmat4 toUnit(glm::dvec4(0.5, 0, 0, 0),
                            glm::dvec4(0, 0.5, 0, 0),
                            glm::dvec4(0, 0, 1, 0),
                            glm::dvec4(0.5, 0.5, 0, 1));
    projection.toPlane = toUnit * toClip;
    constexpr double kAfar = 1e-12;
    projection.eye = std::abs(eye.w) > kAfar * largest
                         ? glm::dvec4(glm::dvec3(eye) / eye.w, 1)
                         : glm::dvec4(glm::normalize(glm::dvec3(eye)), 0);
    projection.frontOnly = true;
    projection.visibleOnly = true;
    return projection;
}

Result<Projection> cameraQuadProjection(const glm::dmat4& toClip, const Quad& corners)
{
    auto projection = cameraProjection(toClip);
    if (const Status usable = checkQuad(corners); !usable) {
        return tl::unexpected(usable.error());
    }
    if (!projection) {
        return projection;
    }
    const auto inUnit = [](glm::dvec2 clip) { return 0.5 * (clip + 1.0); };
    projection->corners = {
        inUnit(corners.p00), inUnit(corners.p10), inUnit(corners.p11), inUnit(corners.p01)};
    projection->isRectangle = false;
    return projection;
}

} // namespace trixel
