// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/corner_normals.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace trixel {

namespace {

constexpr std::size_t kGrain = 4096;
/// Beyond so many faces around a vertex they are not averaged: the work grows as their square.
constexpr std::uint32_t kMostFaces = 256;

struct ShadedFace
{
    glm::vec3 normal{0}; ///< unit length; zero when degenerate
    std::array<float, 3> angles{};
};

float angleBetween(const glm::dvec3& a, const glm::dvec3& b)
{
    return static_cast<float>(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

ShadedFace shapeOf(const std::array<glm::vec3, 3>& c)
{
    const glm::dvec3 p0(c[0]);
    const glm::dvec3 p1(c[1]);
    const glm::dvec3 p2(c[2]);
    const glm::dvec3 cross = glm::cross(p1 - p0, p2 - p0);
    const double length = glm::length(cross);
    ShadedFace shape;
    if (length > 0 && std::isfinite(length)) {
        shape.normal = glm::vec3(cross / length);
        shape.angles = {angleBetween(p1 - p0, p2 - p0),
                        angleBetween(p2 - p1, p0 - p1),
                        angleBetween(p0 - p2, p1 - p2)};
    }
    return shape;
}

/// Corners (3 × face + corner) that meet at each vertex: those of vertex v are at
/// corners[first[v]] … corners[first[v + 1] - 1].
struct CornersOfVertices
{
    std::vector<std::uint32_t> first;
    std::vector<std::uint32_t> corners;

    explicit CornersOfVertices(const TriangleMesh& mesh)
        : first(mesh.positions.size() + 1, 0)
        , corners(mesh.faceCount() * 3)
    {
        for (const Triangle& t : mesh.triangles) {
            for (const std::uint32_t v : t) {
                ++first[v + 1];
            }
        }
        for (std::size_t v = 1; v < first.size(); ++v) {
            first[v] += first[v - 1];
        }
        std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            for (std::size_t k = 0; k < 3; ++k) {
                corners[next[mesh.triangles[f][k]]++] = static_cast<std::uint32_t>(3 * f + k);
            }
        }
    }
};

} // namespace

std::vector<glm::vec3> cornerNormals(const TriangleMesh& mesh, float creaseDegrees)
{
    const float crease = std::cos(creaseDegrees * std::numbers::pi_v<float> / 180.0F);
    std::vector<ShadedFace> shapes(mesh.faceCount());
    parallelFor(mesh.faceCount(), kGrain, Threads::all(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            shapes[f] = shapeOf(mesh.corners(faceId(f)));
        }
    });
    const CornersOfVertices around(mesh);
    std::vector<glm::vec3> normals(mesh.faceCount() * 3);
    const auto normalOf = [&](std::size_t corner) {
        const glm::vec3 own = shapes[corner / 3].normal;
        const std::uint32_t vertex = mesh.triangles[corner / 3][corner % 3];
        const bool degenerate = own == glm::vec3(0);
        const std::uint32_t first = around.first[vertex];
        const std::uint32_t last = around.first[vertex + 1];
        glm::vec3 sum(0);
        for (std::uint32_t k = first; k < last && last - first <= kMostFaces; ++k) {
            const ShadedFace& other = shapes[around.corners[k] / 3];
            if (degenerate || glm::dot(own, other.normal) >= crease) {
                sum += other.angles[around.corners[k] % 3] * other.normal;
            }
        }
        const float length = glm::length(sum);
        return length > 0 ? sum / length : degenerate ? glm::vec3(0, 0, 1) : own;
    };
    parallelFor(normals.size(), kGrain, Threads::all(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t corner = begin; corner < end; ++corner) {
            normals[corner] = normalOf(corner);
        }
    });
    return normals;
}

} // namespace trixel
