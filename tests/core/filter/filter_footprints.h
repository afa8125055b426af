// SPDX-License-Identifier: GPL-3.0-or-later
//
// Queries for the scenes of test_scenes.h: at random, at the same point from both sides of an
// edge, and of the same scene with its faces' vertices in another order.
#pragma once

#include "core/filter/filter_method.h"
#include "core/footprint/footprint.h"
#include "core/lattice/edge_transfer.h"
#include "tests/core/filter/test_scenes.h"

#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <vector>

namespace trixel::test {

/// A footprint with axes of chosen lengths in the face's plane.
/// \param across      length of the shorter of W1 and W2, in the surface's units
/// \param anisotropy  the longer one, in shorter ones
/// \param angle       of the longer one to V0→V1, radians
inline Footprint
planeFootprint(const FaceShape& shape, double across, double anisotropy, double angle)
{
    const glm::dvec2 along(std::cos(angle), std::sin(angle));
    return {shape.toUv(across * anisotropy * along),
            shape.toUv(across * glm::dvec2(-along.y, along.x))};
}

/// A point of the face, uniform in it.
inline glm::dvec2 randomPoint(Dice& dice)
{
    const double a = dice.uniform();
    const double b = dice.uniform();
    return a + b > 1 ? glm::dvec2(1 - a, 1 - b) : glm::dvec2(a, b);
}

/// Sizes of random footprints, both drawn uniformly in the logarithm.
struct FootprintRange
{
    double leastAcross = 0.25; ///< in texels of the face's base level
    double mostAcross = 16;
    double mostAnisotropy = 16;
};

/// Edge of a base-level texel about the middle of a face.
inline double texelEdge(const TestScene& scene, FaceId face)
{
    return std::exp2(scene.filter.log2TexelSize(face, glm::dvec2(1.0 / 3)));
}

inline Footprint
randomFootprint(const TestScene& scene, FaceId face, Dice& dice, const FootprintRange& range)
{
    // Every fourth is a circle, the hard case for what has an axis.
    const double anisotropy = dice.below(4) == 0 ? 1.0 : dice.logBetween(1, range.mostAnisotropy);
    return planeFootprint(scene.surface->shape(face),
                          dice.logBetween(range.leastAcross, range.mostAcross) *
                              texelEdge(scene, face),
                          anisotropy,
                          dice.between(0, std::numbers::pi));
}

inline void add(QueryArrays& queries, FaceId face, glm::dvec2 uv, const Footprint& footprint)
{
    queries.add(face, glm::vec2(uv), glm::vec2(footprint.w1), glm::vec2(footprint.w2));
}

inline QueryArrays randomQueries(const TestScene& scene,
                                 std::size_t count,
                                 std::uint64_t seed,
                                 const FootprintRange& range = {})
{
    Dice dice(seed);
    QueryArrays queries;
    for (std::size_t k = 0; k < count; ++k) {
        const FaceId face = faceId(dice.below(scene.mesh.faceCount()));
        const glm::dvec2 uv = randomPoint(dice);
        add(queries, face, uv, randomFootprint(scene, face, dice, range));
    }
    return queries;
}

/// The same points and footprints asked from both sides of an edge, pair by pair.
struct EdgePairs
{
    QueryArrays here;
    QueryArrays there;
};

/// Pairs on random edges. The points are at 1/1024ths of the edge, which floats hold exactly, more
/// of them near its ends. Its ends are left out: where the angles about a vertex do not add up to a
/// full turn, a direction at the vertex is another one for every face.
inline EdgePairs edgePairs(const TestScene& scene,
                           std::size_t count,
                           std::uint64_t seed,
                           const FootprintRange& range = {})
{
    Dice dice(seed);
    EdgePairs pairs;
    while (pairs.here.size() < count) {
        const FaceId face = faceId(dice.below(scene.mesh.faceCount()));
        const auto edge = static_cast<LocalEdge>(dice.below(3));
        const double t =
            dice.below(4) == 0 ? std::exp2(-10.0 + dice.below(9)) : (1 + dice.below(63)) / 64.0;
        const Footprint footprint = randomFootprint(scene, face, dice, range);
        const auto crossing = scene.surface->crossing(face, edge);
        if (!crossing) {
            continue;
        }
        add(pairs.here, face, fromEdge(edge, {t, 0}), footprint);
        add(pairs.there,
            crossing->face,
            fromEdge(crossing->edge, {1 - t, 0}),
            {crossing->vector(footprint.w1), crossing->vector(footprint.w2)});
    }
    return pairs;
}

/// World position of a query's centre.
inline glm::dvec3 positionOf(const TestScene& scene, const QueryArrays& queries, std::size_t index)
{
    const auto corners = scene.mesh.corners(queries.face[index]);
    return glm::dvec3(corners[0]) + double{queries.u[index]} * glm::dvec3(corners[1] - corners[0]) +
           double{queries.v[index]} * glm::dvec3(corners[2] - corners[0]);
}

// The order of a face's vertices ------------------------------------------------------------------

/// Where a point lies when its face's vertices (V0, V1, V2) become (V1, V2, V0).
inline glm::dvec2 rotatedPoint(glm::dvec2 uv)
{
    return {uv.y, 1 - uv.x - uv.y};
}

inline glm::dvec2 rotatedVector(glm::dvec2 w)
{
    return {w.y, -w.x - w.y};
}

/// The scene with the vertices of every face moved on by 0, 1 or 2 places, texels along with them.
struct RotatedScene
{
    TestScene scene;
    std::vector<std::uint32_t> steps; ///< of each face

    /// The queries as the rotated faces number them.
    QueryArrays rotated(const QueryArrays& queries) const
    {
        QueryArrays result;
        for (std::size_t k = 0; k < queries.size(); ++k) {
            glm::dvec2 uv(queries.u[k], queries.v[k]);
            Footprint footprint{{queries.uw1[k], queries.vw1[k]}, {queries.uw2[k], queries.vw2[k]}};
            for (std::uint32_t step = 0; step < steps[indexOf(queries.face[k])]; ++step) {
                uv = rotatedPoint(uv);
                footprint = {rotatedVector(footprint.w1), rotatedVector(footprint.w2)};
            }
            add(result, queries.face[k], uv, footprint);
        }
        return result;
    }
};

inline RotatedScene rotatedScene(const TestScene& scene, std::uint64_t seed)
{
    Dice dice(seed);
    RotatedScene rotated;
    TriangleMesh mesh = scene.mesh;
    TexelStore texels = scene.texels;
    const std::size_t bytes = texels.format().texelBytes();
    for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) {
        rotated.steps.push_back(dice.below(3));
        for (std::uint32_t step = 0; step < rotated.steps.back(); ++step) {
            const Triangle t = mesh.triangles[f];
            mesh.triangles[f] = {t[1], t[2], t[0]};
            const FaceTexels before = texels.face(faceId(f));
            const Level level = before.level();
            const auto after = texels.writable(faceId(f));
            for (std::uint32_t k = 0; k < level.texelCount(); ++k) {
                const auto from = static_cast<TexelIndex>(k);
                const glm::dvec2 uv = rotatedPoint(centroid(level, texelAt(level, from)));
                const TexelIndex to = texelIndex(level, texelAt(level, uv));
                std::memcpy(&after[indexOf(to) * bytes], before.texel(k).data(), bytes);
            }
        }
    }
    rotated.scene = makeScene(std::move(mesh), std::move(texels));
    return rotated;
}

// Results -----------------------------------------------------------------------------------------

inline ResultArrays
filtered(const FilterMethod& method, const FilterScene& scene, const QueryArrays& queries)
{
    ResultArrays results(queries.size(), scene.channels());
    method.filter(scene, queries.queries(), results.results());
    return results;
}

/// Every method of the table with its standard parameter.
inline std::unique_ptr<const FilterMethod> standardMethod(const MethodEntry& entry)
{
    return makeMethod({std::string(entry.name), std::nullopt});
}

} // namespace trixel::test
