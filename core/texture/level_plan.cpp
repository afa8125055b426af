// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/level_plan.h"

#include "core/mesh/triangle_geometry.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace trixel {

namespace {

/// log2 of the root mean square edge length; minus infinity for a face of no extent.
double logLength(const TriangleMesh& mesh, FaceId face)
{
    return 0.5 * std::log2(meanSquareEdge(mesh.corners(face)));
}

std::vector<double> logLengths(const TriangleMesh& mesh)
{
    std::vector<double> lengths(mesh.faceCount());
    for (std::size_t k = 0; k < lengths.size(); ++k) {
        lengths[k] = logLength(mesh, faceId(k));
    }
    return lengths;
}

/// Log length from which on a face gets the level (1 or more) at a density: the one test that both
/// counting and choosing levels make.
double threshold(int level, double logDensity)
{
    return level - 0.5 - logDensity;
}

Level levelAt(double logLength, double logDensity)
{
    int level = 0;
    while (level < Level::kMax && logLength >= threshold(level + 1, logDensity)) {
        ++level;
    }
    return Level(level);
}

LevelPlan planAt(std::span<const double> lengths, double logDensity)
{
    LevelPlan plan{FaceMap<Level>(lengths.size()), 0};
    for (std::size_t k = 0; k < lengths.size(); ++k) {
        const Level level = levelAt(lengths[k], logDensity);
        plan.levels[faceId(k)] = level;
        plan.texels += level.texelCount();
    }
    return plan;
}

/// Texels of all faces at a density. \param sorted  log lengths, ascending
std::uint64_t texelsAt(std::span<const double> sorted, double logDensity)
{
    std::uint64_t texels = sorted.size();
    for (int level = 1; level <= Level::kMax; ++level) {
        const auto first = std::ranges::lower_bound(sorted, threshold(level, logDensity));
        const auto reaching = static_cast<std::uint64_t>(sorted.end() - first);
        texels += reaching * (Level(level).texelCount() - Level(level - 1).texelCount());
    }
    return texels;
}

} // namespace

LevelPlan planUniform(std::size_t faceCount, Level level)
{
    return {FaceMap<Level>(faceCount, level), std::uint64_t{faceCount} * level.texelCount()};
}

Result<LevelPlan> planByDensity(const TriangleMesh& mesh, double texelsPerUnit)
{
    if (!(texelsPerUnit > 0) || !std::isfinite(texelsPerUnit)) {
        return contentsError("density: expected a positive number of texels per unit, found " +
                             std::to_string(texelsPerUnit));
    }
    return planAt(logLengths(mesh), std::log2(texelsPerUnit));
}

Result<LevelPlan> planByTotal(const TriangleMesh& mesh, std::uint64_t total)
{
    if (total < mesh.faceCount()) {
        return contentsError("texels: expected at least one for each of the mesh's " +
                             std::to_string(mesh.faceCount()) + " faces, found " +
                             std::to_string(total));
    }
    const std::vector<double> lengths = logLengths(mesh);
    std::vector<double> sorted = lengths;
    std::ranges::sort(sorted);
    // Beyond these every face that has an extent is at level 0 or at the highest.
    double low = -400;
    double high = 400;
    if (texelsAt(sorted, high) <= total) {
        return planAt(lengths, high);
    }
    // Halved until no double lies between: `low` fits and nothing larger does.
    for (double middle = 0; low < middle && middle < high; middle = 0.5 * (low + high)) {
        (texelsAt(sorted, middle) <= total ? low : high) = middle;
    }
    return planAt(lengths, low);
}

} // namespace trixel
