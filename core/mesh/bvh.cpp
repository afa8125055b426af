// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/bvh.h"

#include "core/mesh/bvh_build.h"
#include "core/mesh/triangle_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <span>
#include <utility>

namespace trixel {

namespace {

/// A node to visit and a lower bound of what it can offer (a distance, squared or along the ray).
struct Visit
{
    std::uint32_t node = 0;
    double bound = 0;
};

/// Nodes left to visit. A path is at most kBvhMaxDepth long and leaves one sibling a step behind.
class VisitStack
{
public:
    void push(Visit visit) { m_visits[m_size++] = visit; }
    Visit pop() { return m_visits[--m_size]; }
    bool isEmpty() const { return m_size == 0; }

private:
    std::array<Visit, kBvhMaxDepth + 2> m_visits;
    std::size_t m_size = 0;
};

bool isFinite(glm::vec3 v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

double squaredDistance(const BvhNode& node, glm::dvec3 p)
{
    const glm::dvec3 outside =
        glm::max(glm::max(glm::dvec3(node.low) - p, p - glm::dvec3(node.high)), glm::dvec3(0));
    return glm::dot(outside, outside);
}

/// Squared distance to the corner of the box that is farthest away.
double farthestSquared(const BvhNode& node, glm::dvec3 p)
{
    const glm::dvec3 reach =
        glm::max(glm::abs(glm::dvec3(node.low) - p), glm::abs(glm::dvec3(node.high) - p));
    return glm::dot(reach, reach);
}

/// Rounding in the box test must not lose a face that lies in the box's wall.
constexpr double kSlack = 1e-12;

/// Where a ray enters a box, or nothing when it misses it or enters beyond `limit`.
class RayBox
{
public:
    RayBox(glm::dvec3 origin, glm::dvec3 direction)
        : m_origin(origin)
    {
        // A finite stand-in for 1/0: a wall that contains the ray gives 0 instead of NaN.
        for (int k = 0; k < 3; ++k) {
            m_inverse[k] = direction[k] == 0 ? 1e200 : 1.0 / direction[k];
        }
    }

    std::optional<double> entry(const BvhNode& node, double limit) const
    {
        const glm::dvec3 a = (glm::dvec3(node.low) - m_origin) * m_inverse;
        const glm::dvec3 b = (glm::dvec3(node.high) - m_origin) * m_inverse;
        const glm::dvec3 in = glm::min(a, b);
        const glm::dvec3 out = glm::max(a, b);
        const double from = std::max({in.x, in.y, in.z, 0.0});
        const double to = std::min({out.x, out.y, out.z});
        if (from * (1 - kSlack) <= to * (1 + kSlack) && from * (1 - kSlack) <= limit) {
            return from * (1 - kSlack);
        }
        return std::nullopt;
    }

private:
    glm::dvec3 m_origin;
    glm::dvec3 m_inverse{0};
};

} // namespace

Bvh::Bvh(const TriangleMesh& mesh, Threads threads)
    : m_mesh(&mesh)
{
    BvhTree tree = buildBvh(mesh, threads);
    m_nodes = std::move(tree.nodes);
    m_faces = std::move(tree.faces);
}

std::optional<SurfacePoint> Bvh::raycast(const Ray& ray) const
{
    if (m_nodes.empty() || !isFinite(ray.origin) || !isFinite(ray.direction) ||
        ray.direction == glm::vec3(0)) {
        return std::nullopt;
    }
    const RayBox box(ray.origin, ray.direction);
    const RayShear shear(ray.origin, ray.direction);
    RayShear::Hit best{std::numeric_limits<double>::infinity(), {}};
    FaceId bestFace{};
    VisitStack stack;
    if (const auto entry = box.entry(m_nodes.front(), best.t)) {
        stack.push({0, *entry});
    }
    while (!stack.isEmpty()) {
        const Visit visit = stack.pop();
        if (visit.bound > best.t) {
            continue;
        }
        const BvhNode& node = m_nodes[visit.node];
        if (!node.isLeaf()) {
            const auto left = box.entry(m_nodes[node.first], best.t);
            const auto right = box.entry(m_nodes[node.first + 1], best.t);
            const bool leftFirst = left && (!right || *left <= *right);
            // The nearer child is pushed last, to be visited first.
            if (leftFirst && right) {
                stack.push({node.first + 1, *right});
            }
            if (left) {
                stack.push({node.first, *left});
            }
            if (!leftFirst && right) {
                stack.push({node.first + 1, *right});
            }
            continue;
        }
        for (const FaceId face : std::span(m_faces).subspan(node.first, node.count)) {
            const auto hit = shear.meet(m_mesh->corners(face));
            if (hit && (hit->t < best.t || (hit->t == best.t && face < bestFace))) {
                best = *hit;
                bestFace = face;
            }
        }
    }
    if (!std::isfinite(best.t)) {
        return std::nullopt;
    }
    const glm::vec2 uv = insideTriangle(best.uv);
    return SurfacePoint{bestFace, uv, pointAt(m_mesh->corners(bestFace), uv.x, uv.y)};
}

void Bvh::facesWithin(glm::vec3 centre, float radius, std::vector<FaceId>& faces) const
{
    if (m_nodes.empty() || !isFinite(centre) || !(radius >= 0)) {
        return;
    }
    const std::size_t before = faces.size();
    const glm::dvec3 p(centre);
    const double limit = double{radius} * radius;
    VisitStack stack;
    stack.push({0, squaredDistance(m_nodes.front(), p)});
    while (!stack.isEmpty()) {
        const Visit visit = stack.pop();
        if (visit.bound > limit * (1 + kSlack)) {
            continue;
        }
        const BvhNode& node = m_nodes[visit.node];
        if (!node.isLeaf()) {
            for (const std::uint32_t child : {node.first + 1, node.first}) {
                stack.push({child, squaredDistance(m_nodes[child], p)});
            }
            continue;
        }
        const bool allInside = farthestSquared(node, p) <= limit;
        for (const FaceId face : std::span(m_faces).subspan(node.first, node.count)) {
            if (allInside || nearestOnTriangle(m_mesh->corners(face), p).distanceSquared <= limit) {
                faces.push_back(face);
            }
        }
    }
    std::sort(faces.begin() + static_cast<std::ptrdiff_t>(before), faces.end());
}

std::optional<SurfacePoint> Bvh::closestPoint(glm::vec3 position, float maxDistance) const
{
    if (m_nodes.empty() || !isFinite(position) || !(maxDistance >= 0)) {
        return std::nullopt;
    }
    const glm::dvec3 p(position);
    NearestOnTriangle best{{}, double{maxDistance} * maxDistance};
    std::optional<FaceId> bestFace;
    VisitStack stack;
    stack.push({0, squaredDistance(m_nodes.front(), p)});
    while (!stack.isEmpty()) {
        const Visit visit = stack.pop();
        if (visit.bound > best.distanceSquared * (1 + kSlack)) {
            continue;
        }
        const BvhNode& node = m_nodes[visit.node];
        if (!node.isLeaf()) {
            Visit nearer{node.first, squaredDistance(m_nodes[node.first], p)};
            Visit farther{node.first + 1, squaredDistance(m_nodes[node.first + 1], p)};
            if (farther.bound < nearer.bound) {
                std::swap(nearer, farther);
            }
            stack.push(farther);
            stack.push(nearer);
            continue;
        }
        for (const FaceId face : std::span(m_faces).subspan(node.first, node.count)) {
            const NearestOnTriangle found = nearestOnTriangle(m_mesh->corners(face), p);
            const bool nearer = found.distanceSquared < best.distanceSquared;
            const bool tied =
                found.distanceSquared == best.distanceSquared && (!bestFace || face < *bestFace);
            if (nearer || tied) {
                best = found;
                bestFace = face;
            }
        }
    }
    if (!bestFace) {
        return std::nullopt;
    }
    const glm::vec2 uv = insideTriangle(best.uv);
    return SurfacePoint{*bestFace, uv, pointAt(m_mesh->corners(*bestFace), uv.x, uv.y)};
}

std::size_t Bvh::memoryBytes() const
{
    return m_nodes.size() * sizeof(BvhNode) + m_faces.size() * sizeof(FaceId);
}

} // namespace trixel
