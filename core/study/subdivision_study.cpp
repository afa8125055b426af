// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/bvh.h"
#include "core/mesh/loop_refinement.h"
#include "core/study/error_sums.h"
#include "core/study/small_studies.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <sstream>

namespace trixel {
namespace {

constexpr std::size_t kMostReferenceFaces = 400'000;
constexpr int kMostSteps = 5;
/// The reference is so many steps finer than the finest that is judged: its own distance from the
/// limit is a sixteenth of that one's.
constexpr int kFiner = 2;

double sizeOf(const TriangleMesh& mesh)
{
    glm::vec3 low(std::numeric_limits<float>::infinity());
    glm::vec3 high = -low;
    for (const glm::vec3& p : mesh.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return static_cast<double>(glm::distance(low, high));
}

int stepsFor(const TriangleMesh& cage)
{
    int steps = 0;
    std::size_t faces = cage.faceCount() << (2 * kFiner);
    while (steps < kMostSteps && faces * 4 <= kMostReferenceFaces) {
        faces *= 4;
        ++steps;
    }
    return steps;
}

/// Distances from points of the limit surface, which the reference's vertices are.
void judge(const TriangleMesh& mesh, const TriangleMesh& reference, double size, ErrorSums& errors)
{
    const Bvh bvh(mesh);
    std::vector<double> distances(reference.positions.size());
    parallelFor(distances.size(), 256, Threads::all(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const glm::vec3 p = reference.positions[k];
            const auto nearest = bvh.closestPoint(p, std::numeric_limits<float>::infinity());
            distances[k] = nearest ? static_cast<double>(glm::distance(p, nearest->position)) : 0;
        }
    });
    for (const double distance : distances) {
        errors.add(distance, 0, size);
    }
}

} // namespace

Result<Study> studySubdivision(const TriangleMesh& cage, StudyWatcher& watcher)
{
    const double size = cage.faceCount() > 0 ? sizeOf(cage) : 0;
    if (!(size > 0)) {
        return contentsError("there is nothing to subdivide: the mesh has no faces or no extent.");
    }
    Study study;
    study.name = "subdivision";
    study.title = "Loop subdivision: faces against distance from the limit surface";
    study.costTitle = "Faces";
    study.costUnit = "faces";
    study.subject = std::to_string(cage.faceCount()) + " faces";
    const int most = stepsFor(cage);
    std::ostringstream conditions;
    conditions << "distances are fractions of the bounding box's diagonal, at the limit points of "
               << most + kFiner << " steps";
    study.conditions = conditions.str();
    const auto reference = loopRefined(cage, most + kFiner);
    if (!reference) {
        return tl::unexpected(reference.error());
    }
    for (const bool onLimit : {true, false}) {
        for (int steps = 0; steps <= most; ++steps) {
            if (!watcher.report(((onLimit ? 0 : most + 1.0) + steps) / (2 * (most + 1.0)))) {
                return cancelled();
            }
            if (!onLimit && steps > 0) {
                continue;
            }
            // Without steps and limit it is the cage as it was modelled.
            const auto mesh = onLimit ? loopRefined(cage, steps) : Result<TriangleMesh>(cage);
            if (!mesh) {
                return tl::unexpected(mesh.error());
            }
            StudyPoint point;
            point.series = onLimit ? "vertices on the limit" : "cage as it is";
            point.variant =
                onLimit ? std::to_string(steps) + (steps == 1 ? " step" : " steps") : "";
            point.cost = static_cast<double>(mesh->faceCount());
            ErrorSums errors;
            judge(*mesh, *reference, size, errors);
            errors.tell(point);
            point.samples = errors.count();
            watcher.measured(point);
            study.points.push_back(std::move(point));
        }
    }
    markFront(study.points);
    return study;
}

} // namespace trixel
