// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/mesh/limit_surface.h"
#include "core/mesh/loop_refinement.h"
#include "tests/core/mesh/cages.h"
#include "tests/core/mesh/meshes.h"

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <limits>
#include <map>

namespace trixel {
namespace {

using namespace test;
using testing::HasSubstr;

std::shared_ptr<const LimitSurface> limitOf(const TriangleMesh& cage,
                                            std::vector<Crease> creases = {})
{
    auto surface = creases.empty() ? LimitSurface::build(cage)
                                   : LimitSurface::build(cage, {std::move(creases), {}});
    EXPECT_TRUE(surface.has_value()) << (surface ? "" : surface.error().message);
    return surface.value_or(nullptr);
}

/// The (u,v) of each corner of the faces that a face of the cage is refined into, in their order.
std::vector<std::array<glm::dvec2, 3>> refinedCorners(int steps)
{
    std::vector<std::array<glm::dvec2, 3>> faces = {{glm::dvec2(0, 0), {1, 0}, {0, 1}}};
    for (int step = 0; step < steps; ++step) {
        std::vector<std::array<glm::dvec2, 3>> finer;
        for (const auto& [a, b, c] : faces) {
            const glm::dvec2 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
            finer.push_back({a, ab, ca});
            finer.push_back({ab, b, bc});
            finer.push_back({ca, bc, c});
            finer.push_back({bc, ca, ab});
        }
        faces = std::move(finer);
    }
    return faces;
}

/// The largest distance between the limit and the vertices of the cage refined so often.
struct Distance
{
    double any = 0; ///< from a vertex to its own place
    double off = 0; ///< along the normal alone
};

Distance offRefined(const TriangleMesh& cage, int steps)
{
    const auto limit = limitOf(cage);
    const Result<TriangleMesh> refined = loopRefined(cage, steps);
    const auto corners = refinedCorners(steps);
    LimitSurface::Evaluator evaluator(*limit);
    Distance worst;
    for (std::size_t f = 0; f < cage.faceCount(); ++f) {
        evaluator.moveTo(faceId(f));
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const auto expected = refined->corners(faceId(f * corners.size() + k));
            for (std::size_t c = 0; c < 3; ++c) {
                const LimitPoint found = evaluator.at(corners[k][c]);
                const glm::dvec3 apart = found.position - glm::dvec3(expected[c]);
                worst.any = std::max(worst.any, glm::length(apart));
                worst.off = std::max(worst.off, std::abs(glm::dot(apart, found.normal())));
            }
        }
    }
    return worst;
}

TEST(LimitSurface, aRegularPlaneStaysThePlaneAndItsDerivativesAreTheEdges)
{
    const TriangleMesh grid = gridMesh(6);
    const auto limit = limitOf(grid);
    int regular = 0;
    for (std::size_t f = 0; f < grid.faceCount(); ++f) {
        const auto corners = grid.corners(faceId(f));
        if (!limit->isRegular(faceId(f))) {
            continue;
        }
        ++regular;
        for (const glm::dvec2 uv : {glm::dvec2(0, 0), {1, 0}, {0, 1}, {0.2, 0.3}}) {
            const LimitPoint p = limit->at(faceId(f), uv);
            const glm::dvec3 expected(
                pointAt(corners, static_cast<float>(uv.x), static_cast<float>(uv.y)));
            EXPECT_LT(glm::distance(p.position, expected), 1e-6);
            EXPECT_LT(glm::distance(p.perU, glm::dvec3(corners[1] - corners[0])), 1e-12);
            EXPECT_LT(glm::distance(p.perV, glm::dvec3(corners[2] - corners[0])), 1e-12);
            EXPECT_EQ(p.normal(), glm::dvec3(0, 0, 1));
        }
    }
    EXPECT_EQ(regular, 2 * 4 * 4); // one ring of squares touches the border
}

TEST(LimitSurface, agreesWithDeepRefinementWhateverTheValence)
{
    for (const TriangleMesh& cage :
         {regularTetrahedron(), octahedron(), icosahedron(), hexagon(1)}) {
        EXPECT_LT(offRefined(cage, 5).any, 2e-7);
    }
    for (std::uint32_t valence = 3; valence <= 10; ++valence) {
        EXPECT_LT(offRefined(bipyramid(valence), 5).any, 2e-7) << valence;
        EXPECT_LT(offRefined(fan(valence), 5).any, 2e-7) << valence;
    }
}

TEST(LimitSurface, isCloseToDeepRefinementNextToVerticesOfAnyValence)
{
    for (std::uint32_t valence = 3; valence <= 10; ++valence) {
        TriangleMesh cage = bipyramid(valence);
        const Distance distance = offRefined(cage, 7);
        EXPECT_LT(distance.off, 4e-5) << valence;
        EXPECT_LT(distance.any, 4e-3) << valence;
    }
}

TEST(LimitSurface, derivativesAreThoseOfThePosition)
{
    constexpr double h = 1e-6;
    for (std::uint32_t valence = 3; valence <= 10; ++valence) {
        const TriangleMesh cage = bipyramid(valence);
        const auto limit = limitOf(cage);
        LimitSurface::Evaluator evaluator(*limit);
        for (std::size_t f = 0; f < 2; ++f) {
            evaluator.moveTo(faceId(f));
            for (const glm::dvec2 uv :
                 {glm::dvec2(0.3, 0.3), {0.71, 0.13}, {0.05, 0.9}, {0.02, 0.01}, {0.4, 0.01}}) {
                const LimitPoint p = evaluator.at(uv);
                EXPECT_EQ(p.position, evaluator.position(uv));
                const auto slope = [&](glm::dvec2 d) {
                    return (evaluator.position(uv + h * d) - evaluator.position(uv - h * d)) /
                           (2 * h);
                };
                // The library's derivatives of its approximation next to a vertex are approximate.
                const double bound = uv.x + uv.y < 1.0 / 32 ? 1e-2 : 1e-6;
                EXPECT_LT(glm::distance(p.perU, slope({1, 0})), bound) << valence;
                EXPECT_LT(glm::distance(p.perV, slope({0, 1})), bound) << valence;
            }
        }
    }
}

TEST(LimitSurface, facesAgreeAlongTheEdgesTheyShareInPositionAndNormal)
{
    for (const TriangleMesh& cage : {octahedron(), icosahedron(), bipyramid(7), bipyramid(9)}) {
        const auto limit = limitOf(cage);
        std::map<std::uint32_t, std::pair<std::size_t, std::size_t>> firstOf; // of each edge
        int shared = 0;
        for (std::size_t f = 0; f < cage.faceCount(); ++f) {
            for (std::size_t e = 0; e < 3; ++e) {
                const std::uint32_t edge = limit->edges(faceId(f))[e];
                const auto [other, isNew] = firstOf.try_emplace(edge, f, e);
                if (isNew) {
                    continue;
                }
                ++shared;
                constexpr glm::dvec2 corners[] = {{0, 0}, {1, 0}, {0, 1}};
                const auto along = [&](std::size_t face, std::size_t k, double t) {
                    return limit->at(faceId(face), glm::mix(corners[k], corners[(k + 1) % 3], t));
                };
                for (const double t : {0.0, 0.03, 0.25, 0.6, 0.99, 1.0}) {
                    const LimitPoint a = along(f, e, t);
                    const LimitPoint b = along(other->second.first, other->second.second, 1 - t);
                    EXPECT_LT(glm::distance(a.position, b.position), 1e-6);
                    EXPECT_GT(glm::dot(a.normal(), b.normal()), 1 - 1e-6);
                }
            }
        }
        EXPECT_EQ(shared, 3 * static_cast<int>(cage.faceCount()) / 2);
        EXPECT_EQ(limit->edgeCount(), 3 * cage.faceCount() / 2);
    }
}

TEST(LimitSurface, bordersDependOnTheBorderAloneAndCornersStay)
{
    const auto low = limitOf(hexagon(0));
    const auto high = limitOf(hexagon(5));
    for (std::size_t f = 0; f < 6; ++f) {
        for (const double t : {0.0, 0.3, 0.5, 0.9}) {
            const glm::dvec2 onBorder(1 - t, t); // V1 to V2
            const glm::dvec3 a = low->at(faceId(f), onBorder).position;
            const glm::dvec3 b = high->at(faceId(f), onBorder).position;
            EXPECT_LT(glm::distance(a, b), 1e-6);
            EXPECT_LT(std::abs(b.z), 1e-9);
        }
    }
    TriangleMesh lone;
    lone.positions = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}};
    lone.triangles = {{0, 1, 2}};
    const auto corner = limitOf(lone);
    EXPECT_LT(glm::distance(corner->at(faceId(0), {1, 0}).position, glm::dvec3(2, 0, 0)), 1e-6);
    EXPECT_LT(glm::distance(corner->at(faceId(0), {0, 1}).position, glm::dvec3(0, 3, 0)), 1e-6);
}

TEST(LimitSurface, creasesStayInPlaceAndSharp)
{
    // A square that is folded along its middle, from vertex 1 to vertex 4.
    TriangleMesh cage;
    cage.positions = {{-1, 0, 1}, {0, 0, 0}, {1, 0, 1}, {-1, 1, 1}, {0, 1, 0}, {1, 1, 1}};
    cage.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
    const auto normals = [&](const LimitSurface& limit) {
        // Faces 0 and 3 share the fold.
        return glm::dot(limit.at(faceId(0), {0.5, 0.5}).normal(),
                        limit.at(faceId(3), {0, 0.5}).normal());
    };
    const auto round = limitOf(cage);
    EXPECT_GT(round->at(faceId(0), {0.5, 0.5}).position.z, 0.05);
    EXPECT_GT(normals(*round), 1 - 1e-6);

    const auto sharp = limitOf(cage, {{1, 4, kSharp}});
    for (const double t : {0.0, 0.3, 0.7}) {
        EXPECT_LT(std::abs(sharp->at(faceId(0), {1 - t, t}).position.z), 1e-9);
    }
    EXPECT_LT(normals(*sharp), 0.5);

    const auto half = limitOf(cage, {{4, 1, 1.5F}});
    const double height = half->at(faceId(0), {0.5, 0.5}).position.z;
    EXPECT_GT(height, 1e-3);
    EXPECT_LT(height, 0.5 * round->at(faceId(0), {0.5, 0.5}).position.z);
}

/// A cube whose top has creases around it.
TriangleMesh creasedCube(float sharpness)
{
    TriangleMesh cage = cube();
    cage.sharpness.creases = {
        {4, 5, sharpness}, {5, 7, sharpness}, {7, 6, sharpness}, {6, 4, sharpness}};
    return cage;
}

TEST(LimitSurface, aCreasedCubeKeepsItsEdgeAndSemiSharpOnesLieBetween)
{
    // The middle of the edge from 4 to 5, of the top's face 2 and of the side's face 5.
    const auto middle = [](float sharpness) {
        return limitOf(creasedCube(sharpness))->at(faceId(2), {0.5, 0}).position;
    };
    const auto across = [](float sharpness) {
        const auto limit = limitOf(creasedCube(sharpness));
        return glm::dot(limit->at(faceId(2), {0.5, 0}).normal(),
                        limit->at(faceId(5), {0.5, 0.5}).normal());
    };
    EXPECT_NEAR(middle(kSharp).z, 1, 1e-6); // the edge's own curve stays in the top's plane
    EXPECT_LT(across(kSharp), 0.5);
    EXPECT_GT(across(0), 1 - 1e-6);
    double before = limitOf(cube())->at(faceId(2), {0.5, 0}).position.z;
    for (const float sharpness : {0.5F, 1.0F, 2.0F, 4.0F, 8.0F}) {
        const double height = middle(sharpness).z;
        EXPECT_GT(height, before) << sharpness;
        EXPECT_LT(height, 1) << sharpness;
        before = height;
    }
    EXPECT_EQ(middle(0).z, limitOf(cube())->at(faceId(2), {0.5, 0}).position.z);
}

TEST(LimitSurface, aSharpVertexStaysWhereItIs)
{
    TriangleMesh cage = icosahedron();
    const glm::dvec3 own(cage.positions[0]);
    const auto apart = [&](float sharpness) {
        cage.sharpness.vertices = {{0, sharpness}};
        return glm::distance(limitOf(cage)->at(faceId(0), {0, 0}).position, own);
    };
    EXPECT_LT(apart(kSharp), 1e-6);
    EXPECT_GT(apart(0), 0.1);
    EXPECT_GT(apart(1.5F), 1e-3);
    EXPECT_LT(apart(1.5F), apart(0));
}

TEST(LimitSurface, anotherSharpnessTakesThePlaceOfTheCagesOwn)
{
    const TriangleMesh cage = creasedCube(kSharp);
    const auto round = LimitSurface::build(cage, {}).value();
    EXPECT_EQ(round->at(faceId(2), {0.5, 0}).position,
              limitOf(cube())->at(faceId(2), {0.5, 0}).position);
}

TEST(LimitSurface, refinementKeepsTheSameCreases)
{
    for (const float sharpness : {kSharp, 2.0F}) {
        const TriangleMesh cage = creasedCube(sharpness);
        const auto limit = LimitSurface::build(cage).value();
        const TriangleMesh refined = loopRefined(cage, 4).value();
        const auto corners = refinedCorners(4);
        LimitSurface::Evaluator evaluator(*limit);
        for (std::size_t f = 0; f < cage.faceCount(); ++f) {
            evaluator.moveTo(faceId(f));
            for (std::size_t k = 0; k < corners.size(); ++k) {
                const auto expected = refined.corners(faceId(f * corners.size() + k));
                for (std::size_t c = 0; c < 3; ++c) {
                    EXPECT_LT(
                        glm::distance(evaluator.position(corners[k][c]), glm::dvec3(expected[c])),
                        1e-6);
                }
            }
        }
    }
}

TEST(LimitSurface, takesEdgesOfThreeFacesAndFacesThatTurnOver)
{
    TriangleMesh book;
    book.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
    book.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
    TriangleMesh turned = hexagon(1);
    std::swap(turned.triangles[2][1], turned.triangles[2][2]);
    for (const TriangleMesh& cage : {book, turned}) {
        const auto limit = limitOf(cage);
        ASSERT_TRUE(limit);
        for (std::size_t f = 0; f < cage.faceCount(); ++f) {
            const glm::dvec3 p = limit->at(faceId(f), {0.2, 0.3}).position;
            EXPECT_LT(glm::length(p), 2.0); // finite, and near the cage
        }
    }
    const glm::dvec3 spine = limitOf(book)->at(faceId(0), {0.5, 0}).position;
    EXPECT_LT(std::max(std::abs(spine.y), std::abs(spine.z)), 1e-9);
}

TEST(LimitSurface, messyMeshesGiveFinitePointsOrOneSentence)
{
    int built = 0;
    for (unsigned seed = 0; seed < 60; ++seed) {
        TriangleMesh mesh = messyMesh(6, 3 + seed % 9, seed);
        if (seed % 2 == 0) {
            std::erase_if(mesh.triangles, [](const Triangle& t) { return repeatsVertex(t); });
        }
        const auto limit = LimitSurface::build(mesh);
        if (!limit) {
            EXPECT_THAT(limit.error().message,
                        testing::AnyOf(HasSubstr("face "), HasSubstr("no faces")));
            continue;
        }
        ++built;
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            const LimitPoint p = (*limit)->at(faceId(f), {0.25, 0.5});
            EXPECT_LT(glm::length(p.position), 3.0);
            EXPECT_TRUE(std::isfinite(glm::length(p.perU) + glm::length(p.perV)));
        }
    }
    EXPECT_GT(built, 20);
}

TEST(LimitSurface, hugeOffsetsLoseNoDigits)
{
    const TriangleMesh cage = icosahedron();
    TriangleMesh far = cage;
    for (glm::vec3& p : far.positions) {
        p = glm::round(p * 64.0F) / 64.0F + glm::vec3(65536, 0, 0);
    }
    TriangleMesh near = far;
    for (glm::vec3& p : near.positions) {
        p -= glm::vec3(65536, 0, 0);
    }
    const LimitPoint a = limitOf(far)->at(faceId(3), {0.3, 0.3});
    const LimitPoint b = limitOf(near)->at(faceId(3), {0.3, 0.3});
    EXPECT_LT(glm::distance(a.position - glm::dvec3(65536, 0, 0), b.position), 1e-6);
    EXPECT_LT(glm::distance(a.perU, b.perU), 1e-6);
}

TEST(LimitSurface, threadsGiveTheSameBits)
{
    const TriangleMesh cage = loopRefined(bipyramid(9), 2).value();
    const auto limit = limitOf(cage);
    std::vector<glm::dvec3> apart(cage.faceCount());
    parallelFor(cage.faceCount(), 1, {4}, [&](std::size_t begin, std::size_t end) {
        LimitSurface::Evaluator evaluator(*limit);
        for (std::size_t f = begin; f < end; ++f) {
            evaluator.moveTo(faceId(f));
            apart[f] = evaluator.position({0.3, 0.4});
        }
    });
    const auto again = limitOf(cage);
    for (std::size_t f = 0; f < cage.faceCount(); ++f) {
        EXPECT_EQ(apart[f], again->at(faceId(f), {0.3, 0.4}).position);
    }
}

std::string refusal(const TriangleMesh& cage, std::vector<Crease> creases = {})
{
    const auto limit = LimitSurface::build(cage, {std::move(creases), {}});
    return limit ? "built" : limit.error().message;
}

TEST(LimitSurface, refusesWhatHasNoLimitAndNamesIt)
{
    TriangleMesh beyond = regularTetrahedron();
    beyond.triangles[2][1] = 0xFFFFFFFF; // negative where the library reads it
    EXPECT_THAT(refusal(beyond), HasSubstr("face 2 has vertex 4294967295, the cage has 4"));
    TriangleMesh twice = regularTetrahedron();
    twice.triangles[1] = {3, 1, 3};
    EXPECT_THAT(refusal(twice), HasSubstr("face 1 has a corner twice"));
    TriangleMesh infinite = regularTetrahedron();
    infinite.positions[3].y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(refusal(infinite), HasSubstr("vertex 3"));
    EXPECT_THAT(refusal(TriangleMesh{}), HasSubstr("no faces"));
    EXPECT_THAT(refusal(fan(257)), HasSubstr("vertex 0 has 257 faces around it, at most 256"));
    EXPECT_THAT(refusal(regularTetrahedron(), {{0, 1, 2}, {1, 9, 2}}),
                HasSubstr("crease 2 has vertex 9"));
    EXPECT_THAT(refusal(regularTetrahedron(), {{0, 1, -1}}), HasSubstr("crease 1 has sharpness"));
    TriangleMesh sharp = regularTetrahedron();
    sharp.sharpness.vertices = {{3, kSharp}, {4, 1}};
    EXPECT_THAT(LimitSurface::build(sharp).error().message,
                HasSubstr("sharp vertex 2 has vertex 4"));
    EXPECT_THAT(loopRefined(sharp, 1).error().message, HasSubstr("sharp vertex 2 has vertex 4"));
}

TEST(LimitSurface, fansUpToTheValenceCapAreEvaluated)
{
    const auto limit = limitOf(fan(256));
    EXPECT_LT(glm::length(limit->at(faceId(0), {0.1, 0.1}).position), 1.0);
}

TEST(LimitSurface, aTangentFaceTouchesThePointWithItsDerivatives)
{
    const auto limit = limitOf(icosahedron());
    const glm::dvec2 uv(0.3, 0.5);
    const LimitPoint p = limit->at(faceId(4), uv);
    const auto face = p.tangentFace(uv);
    EXPECT_LT(glm::distance(glm::dvec3(pointAt(face, 0.3F, 0.5F)), p.position), 1e-6);
    EXPECT_LT(glm::distance(glm::dvec3(face[1] - face[0]), p.perU), 1e-6);
}

} // namespace
} // namespace trixel
