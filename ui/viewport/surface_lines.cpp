// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/surface_lines.h"

#include "core/lattice/texel.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace trixel::ui {

namespace {

constexpr int kRingPoints = 72;
constexpr int kEllipsePoints = 48;
/// How far a ring's point may move to meet the surface, in radii.
constexpr float kSnap = 0.7F;
/// Hardness from which the inner ring would touch the outer one.
constexpr float kHard = 0.95F;

constexpr glm::vec4 kRingColor{1, 1, 1, 0.95F};
constexpr glm::vec4 kInnerColor{1, 1, 1, 0.5F};
constexpr glm::vec4 kEllipseColor{0.35F, 0.9F, 1.0F, 0.95F};
constexpr glm::vec4 kParallelogramColor{1.0F, 0.75F, 0.3F, 0.9F};
constexpr glm::vec4 kTexelColor{1, 1, 1, 0.85F};

struct Frame
{
    glm::vec3 x{1, 0, 0};
    glm::vec3 y{0, 1, 0};
};

/// Two directions within the plane of a face.
Frame frameOf(const std::array<glm::vec3, 3>& c)
{
    const glm::vec3 cross = glm::cross(c[1] - c[0], c[2] - c[0]);
    const float area = glm::length(cross);
    const glm::vec3 normal = area > 0 ? cross / area : glm::vec3(0, 0, 1);
    // The axis that is least along the normal gives a direction across it.
    const glm::vec3 other = std::abs(normal.x) < 0.6F ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    Frame frame;
    frame.x = glm::normalize(glm::cross(other, normal));
    frame.y = glm::cross(normal, frame.x);
    return frame;
}

float angleOf(int k, int count)
{
    return static_cast<float>(k) / static_cast<float>(count) * 2 * std::numbers::pi_v<float>;
}

render::Polyline
ring(const Surface& surface, const SurfacePoint& point, const Frame& frame, float radius)
{
    render::Polyline line;
    line.closed = true;
    line.hiddenOpacity = 0.25F;
    for (int k = 0; k < kRingPoints; ++k) {
        const float angle = angleOf(k, kRingPoints);
        const glm::vec3 on =
            point.position + radius * (std::cos(angle) * frame.x + std::sin(angle) * frame.y);
        const auto near = surface.bvh().closestPoint(on, kSnap * radius);
        line.points.push_back(near ? near->position : on);
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
brushRing(const Surface& surface, const SurfacePoint& point, const Brush& brush)
{
    const Frame frame = frameOf(surface.mesh().corners(point.face));
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

std::vector<render::Polyline> footprintLines(const TriangleMesh& mesh, const HoveredTexel& texel)
{
    const auto faceCorners = mesh.corners(texel.point.face);
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

render::Polyline texelOutline(const TriangleMesh& mesh, const HoveredTexel& texel)
{
    const auto faceCorners = mesh.corners(texel.point.face);
    render::Polyline line;
    for (const glm::dvec2 uv : corners(texel.level, texel.texel)) {
        line.points.push_back(
            pointAt(faceCorners, static_cast<float>(uv.x), static_cast<float>(uv.y)));
    }
    line.closed = true;
    line.color = kTexelColor;
    line.width = 1.2F;
    return line;
}

} // namespace trixel::ui
