// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/polygon_cutter.h"

#include "core/base/check.h"
#include "core/base/parallel.h"
#include "core/mesh/ear_cutter.h"

#include <algorithm>
#include <atomic>
#include <glm/geometric.hpp>
#include <new>
#include <numeric>

namespace trixel {
namespace {

constexpr std::size_t kMaxFaces = std::size_t{1} << 30U;

glm::dvec3
doubledArea(std::span<const glm::vec3> positions, std::uint32_t a, std::uint32_t b, std::uint32_t c)
{
    const glm::dvec3 origin(positions[a]);
    return glm::cross(glm::dvec3(positions[b]) - origin, glm::dvec3(positions[c]) - origin);
}

// The diagonal 0–2 unless only 1–3 leaves both triangles facing the same way.
void cutQuad(std::span<const glm::vec3> positions,
             std::span<const std::uint32_t> q,
             std::span<Triangle> triangles)
{
    const double with02 = glm::dot(doubledArea(positions, q[0], q[1], q[2]),
                                   doubledArea(positions, q[0], q[2], q[3]));
    if (with02 <= 0 && glm::dot(doubledArea(positions, q[1], q[2], q[3]),
                                doubledArea(positions, q[1], q[3], q[0])) > 0) {
        triangles[0] = {q[0], q[1], q[3]};
        triangles[1] = {q[1], q[2], q[3]};
    } else {
        triangles[0] = {q[0], q[1], q[2]};
        triangles[1] = {q[0], q[2], q[3]};
    }
}

void cutPart(std::span<const glm::vec3> positions,
             const PolygonList& part,
             std::span<Triangle> triangles)
{
    std::size_t corner = 0;
    std::size_t triangle = 0;
    for (const std::uint32_t size : part.sizes()) {
        cutPolygon(positions,
                   std::span(part.corners()).subspan(corner, size),
                   triangles.subspan(triangle, size - 2));
        corner += size;
        triangle += size - 2;
    }
}

// Which polygon each triangle comes from, counting from `firstPolygon`.
void nameSources(const PolygonList& part,
                 std::size_t firstPolygon,
                 std::span<std::uint32_t> sources)
{
    auto source = static_cast<std::uint32_t>(firstPolygon);
    if (part.allTriangles()) {
        std::iota(sources.begin(), sources.end(), source);
        return;
    }
    std::size_t triangle = 0;
    for (const std::uint32_t size : part.sizes()) {
        std::fill_n(sources.begin() + static_cast<std::ptrdiff_t>(triangle), size - 2, source);
        triangle += size - 2;
        ++source;
    }
}

} // namespace

void cutPolygon(std::span<const glm::vec3> positions,
                std::span<const std::uint32_t> corners,
                std::span<Triangle> triangles)
{
    check(corners.size() >= 3 && triangles.size() == corners.size() - 2, "two corners more");
    if (corners.size() == 3) {
        triangles[0] = {corners[0], corners[1], corners[2]};
    } else if (corners.size() == 4) {
        cutQuad(positions, corners, triangles);
    } else {
        cutEars(positions, corners, triangles);
    }
}

Result<TriangleMesh> cutPolygons(std::vector<glm::vec3> positions, std::span<PolygonList> parts)
{
    std::vector<std::size_t> firstPolygons(parts.size() + 1, 0);
    std::vector<std::size_t> firstTriangles(parts.size() + 1, 0);
    bool allTriangles = true;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        firstPolygons[i + 1] = firstPolygons[i] + parts[i].count();
        firstTriangles[i + 1] = firstTriangles[i] + parts[i].triangleCount();
        allTriangles = allTriangles && parts[i].allTriangles();
    }
    if (firstTriangles.back() == 0) {
        return contentsError("expected at least one face, found none");
    }
    if (firstTriangles.back() >= kMaxFaces) {
        return contentsError("expected fewer than 2^30 triangles, found " +
                             std::to_string(firstTriangles.back()));
    }
    TriangleMesh mesh;
    mesh.positions = std::move(positions);
    if (allTriangles && parts.size() == 1) {
        mesh.triangles = std::move(parts.front().triangles());
        return mesh;
    }
    mesh.triangles.resize(firstTriangles.back());
    mesh.sourceFaces.resize(allTriangles ? 0 : firstTriangles.back());
    std::atomic<bool> outOfMemory{false};
    const auto cutOne = [&](std::size_t i) {
        const std::size_t size = parts[i].triangleCount();
        const auto triangles = std::span(mesh.triangles).subspan(firstTriangles[i], size);
        if (parts[i].allTriangles()) {
            std::copy_n(parts[i].triangles().begin(), size, triangles.begin());
        } else {
            cutPart(mesh.positions, parts[i], triangles);
        }
        if (!allTriangles) {
            nameSources(parts[i],
                        firstPolygons[i],
                        std::span(mesh.sourceFaces).subspan(firstTriangles[i], size));
        }
    };
    parallelFor(parts.size(), 1, Threads::all(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            try {
                cutOne(i);
            } catch (const std::bad_alloc&) { // must not leave its thread
                outOfMemory = true;
            }
        }
    });
    if (outOfMemory) {
        return contentsError("the mesh does not fit into memory");
    }
    return mesh;
}

} // namespace trixel
