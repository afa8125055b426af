// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/surface_lines.h"

#include "core/lattice/texel.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

namespace trixel::ui {

namespace {

constexpr int kRingPoints = 72;
constexpr int kEllipsePoints = 48;
/// That a texel's side is drawn in on a curved surface.
constexpr int kCurvePieces = 8;
/// How far above and below its plane a ring looks for the surface, in radii.
constexpr float kReach = 0.7F;
/// Places, at half the radius, whose normals are averaged: a scan's own face is too rough.
constexpr int kNormalSamples = 8;
/// Hardness from which the inner ring would touch the outer one.
constexpr float kHard = 0.95F;

constexpr glm::vec4 kRingColor{1, 1, 1, 0.95F};
constexpr glm::vec4 kInnerColor{1, 1, 1, 0.5F};
constexpr glm::vec4 kTexelColor{1, 1, 1, 0.85F};
constexpr glm::vec4 kHeldColor{1, 1, 1, 1};
constexpr float kHeldWidth = 2.6F;
/// Ticks of a held texel: pixels from its corners to where they begin and end.
constexpr float kTickStart = 5;
constexpr float kTickEnd = 15;

/// A plane through a point: two directions within it, and its normal.
struct Frame
{
    glm::vec3 x{1, 0, 0};
    glm::vec3 y{0, 1, 0};
    glm::vec3 normal{0, 0, 1};

    explicit Frame(glm::vec3 direction)
    {
        const float length = glm::length(direction);
        normal = length > 0 ? direction / length : normal;
        // The axis that is least along the normal gives a direction across it.
        const glm::vec3 other = std::abs(normal.x) < 0.6F ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
        x = glm::normalize(glm::cross(other, normal));
        y = glm::cross(normal, x);
    }
};

float angleOf(int k, int count)
{
    return static_cast<float>(k) / static_cast<float>(count) * 2 * std::numbers::pi_v<float>;
}

glm::vec3 onCircle(const Frame& frame, glm::vec3 centre, float radius, float angle)
{
    return centre + radius * (std::cos(angle) * frame.x + std::sin(angle) * frame.y);
}

/// The plane that the surface around a point lies in, roughly.
Frame frameAround(const SeenSurface& surface, const SurfacePoint& point, float radius)
{
    const glm::vec3 own = surface.normal(point.face, point.uv);
    const Frame rough(own);
    glm::vec3 sum = own;
    for (int k = 0; k < kNormalSamples; ++k) {
        const glm::vec3 place =
            onCircle(rough, point.position, radius / 2, angleOf(k, kNormalSamples));
        if (const auto near = surface.closestPoint(place, kReach * radius)) {
            const glm::vec3 normal = surface.normal(near->face, near->uv);
            sum += glm::dot(normal, own) > 0 ? normal : glm::vec3(0);
        }
    }
    return Frame(sum);
}

/// A circle seen along the normal, laid onto the surface where that is near.
render::Polyline
ring(const SeenSurface& surface, const SurfacePoint& point, const Frame& frame, float radius)
{
    render::Polyline line;
    line.closed = true;
    line.hiddenOpacity = 0.25F;
    for (int k = 0; k < kRingPoints; ++k) {
        const glm::vec3 on = onCircle(frame, point.position, radius, angleOf(k, kRingPoints));
        const glm::vec3 down = -frame.normal;
        const auto below = surface.raycast({on - kReach * radius * down, down});
        const bool isNear = below && glm::length(below->position - on) <= kReach * radius * 1.001F;
        line.points.push_back(isNear ? below->position : on);
    }
    return line;
}

/// Point of the face's plane at an offset in (u,v), magnified.
glm::vec3 magnified(const std::array<glm::vec3, 3>& c, glm::vec3 centre, glm::dvec2 offset)
{
    const glm::dvec3 e1 = glm::dvec3(c[1]) - glm::dvec3(c[0]);
    const glm::dvec3 e2 = glm::dvec3(c[2]) - glm::dvec3(c[0]);
    return centre + glm::vec3(kFootprintMagnification * (offset.x * e1 + offset.y * e2));
}

} // namespace

std::vector<render::Polyline>
brushRing(const SeenSurface& surface, const SurfacePoint& point, const Brush& brush)
{
    const Frame frame = frameAround(surface, point, brush.radius);
    std::vector<render::Polyline> lines;
    lines.push_back(ring(surface, point, frame, brush.radius));
    lines.back().color = kRingColor;
    lines.back().width = 1.6F;
    if (brush.hardness > 0 && brush.hardness < kHard) {
        lines.push_back(ring(surface, point, frame, brush.radius * brush.hardness));
        lines.back().color = kInnerColor;
        lines.back().width = 1.0F;
    }
    return lines;
}

std::vector<render::Polyline> footprintLines(const SeenSurface& surface, const HoveredTexel& texel)
{
    const auto faceCorners = surface.tangentFace(texel.point.face, texel.point.uv);
    const auto at = [&](glm::dvec2 offset) {
        return magnified(faceCorners, texel.point.position, offset);
    };
    const glm::dvec2 half1 = texel.footprint.w1 / 2.0;
    const glm::dvec2 half2 = texel.footprint.w2 / 2.0;
    render::Polyline parallelogram;
    parallelogram.points = {
        at(-half1 - half2), at(half1 - half2), at(half1 + half2), at(half2 - half1)};
    parallelogram.color = kParallelogramColor;
    render::Polyline ellipse;
    for (int k = 0; k < kEllipsePoints; ++k) {
        const double angle = angleOf(k, kEllipsePoints);
        ellipse.points.push_back(
            at(std::cos(angle) * texel.ellipse.major + std::sin(angle) * texel.ellipse.minor));
    }
    ellipse.color = kEllipseColor;
    for (render::Polyline* line : {&parallelogram, &ellipse}) {
        line->closed = true;
        line->width = 1.2F;
        line->hiddenOpacity = 0.3F;
    }
    return {parallelogram, ellipse};
}

std::array<glm::vec3, 3> cornersOf(const SeenSurface& surface, const HoveredTexel& texel)
{
    const auto uv = corners(texel.level, texel.texel);
    const auto at = [&](std::size_t k) {
        return surface.position(texel.point.face, glm::vec2(uv[k]));
    };
    return {at(0), at(1), at(2)};
}

render::Polyline texelOutline(const SeenSurface& surface, const HoveredTexel& texel)
{
    const auto uv = corners(texel.level, texel.texel);
    const int pieces = surface.isLimit() ? kCurvePieces : 1;
    render::Polyline line;
    for (std::size_t k = 0; k < uv.size(); ++k) {
        for (int p = 0; p < pieces; ++p) {
            const double t = static_cast<double>(p) / pieces;
            line.points.push_back(surface.position(
                texel.point.face, glm::vec2(glm::mix(uv[k], uv[(k + 1) % uv.size()], t))));
        }
    }
    line.closed = true;
    line.color = kTexelColor;
    line.width = 1.2F;
    return line;
}

std::vector<render::Polyline>
heldTexelLines(const SeenSurface& surface, const HoveredTexel& texel, float perPixel)
{
    render::Polyline outline = texelOutline(surface, texel);
    outline.color = kHeldColor;
    outline.width = kHeldWidth;
    outline.hiddenOpacity = 0.4F;
    const auto texelCorners = cornersOf(surface, texel);
    const glm::vec3 middle = (texelCorners[0] + texelCorners[1] + texelCorners[2]) / 3.0F;
    std::vector<render::Polyline> lines;
    for (const glm::vec3& corner : texelCorners) {
        const glm::vec3 way = corner - middle;
        const float length = glm::length(way);
        if (!(length > 0)) {
            continue; // a face without area has corners in one place
        }
        const glm::vec3 pixel = way * (perPixel / length);
        render::Polyline tick;
        tick.points = {corner + kTickStart * pixel, corner + kTickEnd * pixel};
        tick.color = kHeldColor;
        tick.width = kHeldWidth;
        tick.hiddenOpacity = outline.hiddenOpacity;
        lines.push_back(std::move(tick));
    }
    lines.push_back(std::move(outline));
    return lines;
}

} // namespace trixel::ui
