// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/loop_refinement.h"

#include "core/mesh/loop_cage.h"

#include <algorithm>
#include <new>
#include <numeric>
#include <opensubdiv/far/primvarRefiner.h>
#include <string>

namespace trixel {

namespace {

namespace Far = OpenSubdiv::Far;

/// A position as the refiner blends it; in double, so that the order of the sums hardly shows.
struct Point
{
    double x = 0, y = 0, z = 0;

    void Clear() { x = y = z = 0; }
    void AddWithWeight(const Point& source, double weight)
    {
        x += weight * source.x;
        y += weight * source.y;
        z += weight * source.z;
    }
};

Status checkSize(const TriangleMesh& cage, int steps)
{
    if (steps < 0 || steps > kMaxLoopSteps) {
        return contentsError("refinement takes 0 to " + std::to_string(kMaxLoopSteps) +
                             " steps, not " + std::to_string(steps));
    }
    const std::size_t most = kMaxLoopFaces >> (2U * static_cast<unsigned>(steps));
    if (cage.faceCount() > most || cage.positions.size() > 3 * most) {
        return contentsError(std::to_string(steps) + " refinement steps take a cage of up to " +
                             std::to_string(most) + " faces, this one has " +
                             std::to_string(cage.faceCount()) + " and " +
                             std::to_string(cage.positions.size()) + " vertices");
    }
    return {};
}

/// The cage's connectivity, refined; nothing if OpenSubdiv refuses it.
LoopRefiner makeRefiner(const TriangleMesh& cage, int steps)
{
    LoopRefiner refiner = makeLoopRefiner(cage, cage.sharpness);
    if (refiner) {
        Far::TopologyRefiner::UniformOptions uniform(steps);
        uniform.fullTopologyInLastLevel = true; // the limit needs each vertex's surroundings
        refiner->RefineUniform(uniform);
    }
    return refiner;
}

std::vector<glm::vec3> limitPositions(const Far::TopologyRefiner& refiner,
                                      std::span<const glm::vec3> cagePositions)
{
    std::vector<Point> points(cagePositions.size());
    std::ranges::transform(cagePositions, points.begin(), [](const glm::vec3& p) {
        return Point{p.x, p.y, p.z};
    });
    const Far::PrimvarRefinerReal<double> primvars(refiner);
    for (int level = 1; level <= refiner.GetMaxLevel(); ++level) {
        std::vector<Point> finer(
            static_cast<std::size_t>(refiner.GetLevel(level).GetNumVertices()));
        primvars.Interpolate(level, points, finer);
        points = std::move(finer);
    }
    std::vector<Point> limit(points.size());
    primvars.Limit(points, limit);

    std::vector<glm::vec3> positions(limit.size());
    std::ranges::transform(
        limit, positions.begin(), [](const Point& p) { return glm::vec3(p.x, p.y, p.z); });
    return positions;
}

/// The finest faces, four by four in the order of their parents.
void addFinestFaces(const Far::TopologyRefiner& refiner, TriangleMesh& mesh)
{
    const int finest = refiner.GetMaxLevel();
    std::vector<int> faces(static_cast<std::size_t>(refiner.GetLevel(0).GetNumFaces()));
    std::iota(faces.begin(), faces.end(), 0);
    for (int level = 0; level < finest; ++level) {
        std::vector<int> finer;
        finer.reserve(4 * faces.size());
        for (const int face : faces) {
            const Far::ConstIndexArray children = refiner.GetLevel(level).GetFaceChildFaces(face);
            finer.insert(finer.end(), children.begin(), children.end());
        }
        faces = std::move(finer);
    }
    mesh.triangles.reserve(faces.size());
    mesh.sourceFaces.reserve(faces.size());
    for (const int face : faces) {
        const Far::ConstIndexArray v = refiner.GetLevel(finest).GetFaceVertices(face);
        mesh.triangles.push_back({static_cast<std::uint32_t>(v[0]),
                                  static_cast<std::uint32_t>(v[1]),
                                  static_cast<std::uint32_t>(v[2])});
        const std::size_t place = mesh.sourceFaces.size();
        mesh.sourceFaces.push_back(
            static_cast<std::uint32_t>(place >> (2U * static_cast<unsigned>(finest))));
    }
}

} // namespace

Result<TriangleMesh> loopRefined(const TriangleMesh& cage, int steps)
{
    if (Status status = checkSize(cage, steps); !status) {
        return tl::unexpected(status.error());
    }
    if (Status status = checkLoopCage(cage); !status) {
        return tl::unexpected(status.error());
    }
    if (Status status = checkSharpness(cage, cage.sharpness); !status) {
        return tl::unexpected(status.error());
    }
    try {
        const LoopRefiner refiner = makeRefiner(cage, steps);
        if (!refiner) {
            return contentsError("the cage's faces cannot be refined together");
        }
        TriangleMesh mesh;
        mesh.positions = limitPositions(*refiner, cage.positions);
        addFinestFaces(*refiner, mesh);
        return mesh;
    } catch (const std::bad_alloc&) {
        return contentsError("not enough memory to refine the cage");
    }
}

} // namespace trixel
