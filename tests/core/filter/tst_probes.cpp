// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the methods on the conforming pyramid promise: `probes-1`, `probes-2` and `lattice-linear`.
#include "core/filter/filter_method.h"
#include "core/lattice/edge_transfer.h"
#include "tests/core/filter/random_scene.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

using namespace trixel;
using namespace trixel::test;

namespace {

const std::vector<MethodChoice> kChoices = {{"probes-1", 2},
                                            {"probes-1", 16},
                                            {"probes-2", 4},
                                            {"probes-2", 32},
                                            {"probes-2", 128},
                                            {"lattice-linear", std::nullopt}};

ResultArrays
answers(const MethodChoice& choice, const FilterScene& scene, const QueryArrays& queries)
{
    ResultArrays results(queries.size(), scene.channels());
    makeMethod(choice)->filter(scene, queries.queries(), results.results());
    return results;
}

double largestDifference(const ResultArrays& a, const ResultArrays& b)
{
    double largest = 0;
    for (std::size_t k = 0; k < a.values.size(); ++k) {
        largest = std::max(largest, double(std::abs(a.values[k] - b.values[k])));
    }
    return largest;
}

/// Vectors of a random footprint, longest about `edges` edges of a face, up to 2^thinnest as long
/// as wide.
std::pair<glm::dvec2, glm::dvec2> randomFootprint(Random& random, double edges, double thinnest = 6)
{
    const double length = edges * std::exp2(-8 * unit(random));
    const double other = length * std::exp2(-thinnest * unit(random));
    const double angle = 6.3 * unit(random);
    const glm::dvec2 along(std::cos(angle), std::sin(angle));
    return {length * along, other * glm::dvec2(-along.y, along.x)};
}

glm::dvec2 randomPoint(Random& random)
{
    glm::dvec2 uv(unit(random), unit(random));
    return uv.x + uv.y > 1 ? 1.0 - uv : uv;
}

} // namespace

class PyramidMethods : public testing::TestWithParam<MethodChoice>
{
};

INSTANTIATE_TEST_SUITE_P(All, PyramidMethods, testing::ValuesIn(kChoices), [](const auto& tested) {
    std::string name = toText(tested.param);
    std::ranges::replace_if(
        name, [](char c) { return std::isalnum(c) == 0; }, '_');
    return name;
});

TEST_P(PyramidMethods, answerTheSameFromBothSidesOfEveryEdge)
{
    double worst = 0;
    for (std::uint32_t seed = 1; seed <= 6; ++seed) {
        Random random(seed);
        const TriangleMesh mesh = randomClosedMesh(random);
        const FilterScene scene =
            sceneOf(mesh, noiseStore(random, randomLevels(random, mesh.faceCount(), 0, 6), 3));
        QueryArrays here;
        QueryArrays there;
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            for (const LocalEdge edge : kLocalEdges) {
                const auto crossing = scene.surface().crossing(faceId(f), edge);
                for (int sample = 0; sample < 8; ++sample) {
                    // A point that both sides have exactly; not a corner, where a line may pass the
                    // vertex on either side.
                    const double t = (1 + std::floor(unit(random) * 1023)) / 1024;
                    const auto [w1, w2] = randomFootprint(random, 3);
                    here.add(faceId(f), fromEdge(edge, {t, 0}), w1, w2);
                    there.add(crossing->face,
                              fromEdge(crossing->edge, {1 - t, 0}),
                              crossing->vector(w1),
                              crossing->vector(w2));
                }
            }
        }
        worst = std::max(
            worst,
            largestDifference(answers(GetParam(), scene, here), answers(GetParam(), scene, there)));
    }
    EXPECT_LE(worst, 1e-5);
}

TEST_P(PyramidMethods, doNotPopWhenTheWidthChanges)
{
    Random random(7);
    double worst = 0;
    for (const bool closed : {true, false}) {
        const TriangleMesh mesh = closed ? randomClosedMesh(random) : flatLattice(4);
        const FilterScene scene =
            sceneOf(mesh, noiseStore(random, randomLevels(random, mesh.faceCount(), 3, 6), 1));
        QueryArrays before;
        QueryArrays after;
        for (int k = 0; k < 20000; ++k) {
            const FaceId face =
                faceId(static_cast<std::size_t>(unit(random) * double(mesh.faceCount())));
            const glm::dvec2 uv = randomPoint(random);
            const auto [w1, w2] = randomFootprint(random, 1);
            before.add(face, uv, w1, w2);
            after.add(face, uv, 1.0002 * w1, 1.0002 * w2);
        }
        worst = std::max(worst,
                         largestDifference(answers(GetParam(), scene, before),
                                           answers(GetParam(), scene, after)));
    }
    EXPECT_LE(worst, 1e-3);
}

TEST_P(PyramidMethods, keepAConstantAndAnAffineTexture)
{
    Random random(3);
    const TriangleMesh mesh = flatLattice(12);
    const auto affine = [&](FaceId face, glm::dvec2 uv, int channel) {
        const glm::vec3 p = pointAt(mesh.corners(face), float(uv.x), float(uv.y));
        return channel == 0 ? 0.7F : 0.05F * p.x - 0.03F * p.y + 0.2F;
    };
    const FilterScene scene =
        sceneOf(mesh, storeOf(FaceMap<Level>(mesh.faceCount(), Level(4)), 2, affine));
    QueryArrays queries;
    for (int k = 0; k < 2000; ++k) {
        const auto face = faceId(2 * 12 * 6 + 12); // in the middle
        const auto [w1, w2] = randomFootprint(random, 1);
        queries.add(face, randomPoint(random), w1, w2);
    }
    const ResultArrays results = answers(GetParam(), scene, queries);
    for (std::size_t k = 0; k < queries.size(); ++k) {
        const glm::dvec2 uv(queries.u[k], queries.v[k]);
        EXPECT_NEAR(results.values[k], 0.7F, 5e-7F);
        EXPECT_NEAR(results.values[queries.size() + k], affine(queries.face[k], uv, 1), 1e-5F);
    }
}

/// Mean over many places of what a footprint adds to the squares of coordinates: its covariance.
std::array<double, 3> covarianceOf(const MethodChoice& choice,
                                   const FilterScene& scene,
                                   const QueryArrays& queries,
                                   const TriangleMesh& mesh)
{
    const ResultArrays results = answers(choice, scene, queries);
    std::array<double, 3> covariance{};
    for (std::size_t k = 0; k < queries.size(); ++k) {
        const glm::vec3 p = pointAt(mesh.corners(queries.face[k]), queries.u[k], queries.v[k]);
        const std::array<float, 3> there = {p.x * p.x, p.x * p.y, p.y * p.y};
        for (std::size_t c = 0; c < 3; ++c) {
            covariance[c] += double(results.values[c * queries.size() + k] - there[c]) /
                             static_cast<double>(queries.size());
        }
    }
    return covariance;
}

TEST(TwoLevelProbes, haveTheCovarianceOfTheFootprint)
{
    Random random(29);
    TriangleMesh mesh = flatLattice(12);
    for (glm::vec3& position : mesh.positions) {
        position -= glm::vec3(9, 5.2F, 0); // so that squares about the middle are small
    }
    const auto squares = [&](FaceId face, glm::dvec2 uv, int channel) {
        const glm::vec3 p = pointAt(mesh.corners(face), float(uv.x), float(uv.y));
        return channel == 0 ? p.x * p.x : channel == 1 ? p.x * p.y : p.y * p.y;
    };
    const FilterScene scene =
        sceneOf(mesh, storeOf(FaceMap<Level>(mesh.faceCount(), Level(4)), 3, squares));
    for (const double anisotropy : {1.0, 1.02, 1.3, 2.0, 3.7, 6.0}) {
        // From a texel's floor to half a face.
        for (const double width : {0.01, 0.08, 0.15, 0.3, 0.5}) {
            QueryArrays queries;
            const double angle = 6.3 * unit(random);
            const glm::dvec2 along(std::cos(angle), std::sin(angle));
            const FaceShape shape;
            const glm::dvec2 w1 = shape.toUv(width * anisotropy * along);
            const glm::dvec2 w2 = shape.toUv(width * glm::dvec2(-along.y, along.x));
            for (int k = 0; k < 500; ++k) {
                queries.add(faceId(2 * 12 * 6 + 12), randomPoint(random), w1, w2);
            }
            const auto probes = covarianceOf({"probes-2", 128}, scene, queries, mesh);
            const auto exact = covarianceOf({"exact", std::nullopt}, scene, queries, mesh);
            const double bound = 0.03 * (exact[0] + exact[2]);
            for (std::size_t c = 0; c < 3; ++c) {
                EXPECT_NEAR(probes[c], exact[c], bound) << anisotropy << ' ' << width << ' ' << c;
            }
        }
    }
}

TEST_P(PyramidMethods, doNotCareForTheOrderOfAFacesVertices)
{
    Random random(11);
    TriangleMesh mesh = randomClosedMesh(random);
    const FaceMap<Level> levels = randomLevels(random, mesh.faceCount(), 0, 5);
    FaceMap<std::vector<float>> noise(mesh.faceCount());
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        noise[faceId(f)].resize(levels[faceId(f)].texelCount());
        std::ranges::generate(noise[faceId(f)], [&] { return float(unit(random)); });
    }
    std::vector<int> turns(mesh.faceCount());
    // (u,v) of the same point when every vertex moves `turn` places to the front.
    const auto turned = [](glm::dvec2 uv, int turn) {
        for (; turn > 0; --turn) {
            uv = {uv.y, 1 - uv.x - uv.y};
        }
        return uv;
    };
    const auto value = [&](FaceId face, glm::dvec2 uv, int) {
        const Level level = levels[face];
        const glm::dvec2 original = turned(uv, (3 - turns[indexOf(face)]) % 3);
        return noise[face][indexOf(texelIndex(level, texelAt(level, original)))];
    };
    const FilterScene straight = sceneOf(mesh, storeOf(levels, 1, value));
    QueryArrays before;
    QueryArrays after;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        turns[f] = static_cast<int>(unit(random) * 3);
        std::rotate(mesh.triangles[f].begin(),
                    mesh.triangles[f].begin() + turns[f],
                    mesh.triangles[f].end());
        for (int k = 0; k < 20; ++k) {
            const glm::dvec2 uv = glm::floor(randomPoint(random) * 256.0) / 256.0;
            const auto [w1, w2] = randomFootprint(random, 1);
            const glm::dvec2 zero = turned({0, 0}, turns[f]);
            before.add(faceId(f), uv, w1, w2);
            after.add(faceId(f),
                      turned(uv, turns[f]),
                      turned(w1, turns[f]) - zero,
                      turned(w2, turns[f]) - zero);
        }
    }
    const FilterScene rotated = sceneOf(mesh, storeOf(levels, 1, value));
    EXPECT_LE(largestDifference(answers(GetParam(), straight, before),
                                answers(GetParam(), rotated, after)),
              1e-6);
}

TEST_P(PyramidMethods, takeAnyVectorsThatSpanTheSameFootprint)
{
    Random random(13);
    const TriangleMesh mesh = randomClosedMesh(random);
    const FilterScene scene =
        sceneOf(mesh, noiseStore(random, randomLevels(random, mesh.faceCount(), 0, 6), 3));
    std::array<QueryArrays, 4> same;
    for (int k = 0; k < 3000; ++k) {
        const FaceId face =
            faceId(static_cast<std::size_t>(unit(random) * double(mesh.faceCount())));
        const glm::dvec2 uv = randomPoint(random);
        // Rounding the turned vectors changes their area in proportion to the anisotropy.
        const auto [w1, w2] = randomFootprint(random, 2, 3);
        const double angle = 6.3 * unit(random);
        same[0].add(face, uv, w1, w2);
        same[1].add(face, uv, w2, w1);
        same[2].add(face, uv, -w1, w2);
        same[3].add(face,
                    uv,
                    std::cos(angle) * w1 + std::sin(angle) * w2,
                    std::cos(angle) * w2 - std::sin(angle) * w1);
    }
    const ResultArrays first = answers(GetParam(), scene, same[0]);
    for (std::size_t k = 1; k < same.size(); ++k) {
        EXPECT_LE(largestDifference(first, answers(GetParam(), scene, same[k])), 1e-5) << k;
    }
}

TEST_P(PyramidMethods, giveACircleNoDirection)
{
    Random random(31);
    const TriangleMesh mesh = randomClosedMesh(random);
    const FilterScene scene =
        sceneOf(mesh, noiseStore(random, randomLevels(random, mesh.faceCount(), 2, 6), 3));
    QueryArrays before;
    QueryArrays after;
    for (int k = 0; k < 4000; ++k) {
        const FaceId face =
            faceId(static_cast<std::size_t>(unit(random) * double(mesh.faceCount())));
        const glm::dvec2 uv = randomPoint(random);
        const double radius = std::exp2(-8 * unit(random));
        const double angle = 6.3 * unit(random);
        const auto turned = [&](double by) {
            const glm::dvec2 along(std::cos(by), std::sin(by));
            return std::pair(
                scene.surface().shape(face).toUv(radius * along),
                scene.surface().shape(face).toUv(radius * glm::dvec2(-along.y, along.x)));
        };
        const auto [w1, w2] = turned(0);
        const auto [w3, w4] = turned(angle);
        before.add(face, uv, w1, w2);
        after.add(face, uv, w3, w4);
    }
    EXPECT_LE(
        largestDifference(answers(GetParam(), scene, before), answers(GetParam(), scene, after)),
        1e-5);
}

TEST_P(PyramidMethods, stayFiniteAndAffordableWhateverTheQuery)
{
    Random random(17);
    const TriangleMesh mesh = randomClosedMesh(random);
    const FilterScene scene =
        sceneOf(mesh, noiseStore(random, randomLevels(random, mesh.faceCount(), 0, 6), 2));
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> special = {
        0.0F, -0.0F, 1e-45F, 1e-30F, 1e-10F, 1.0F, -1.0F, 1e3F, 1e10F, 1e30F, kInfinity, kNan};
    const auto any = [&] {
        return unit(random) < 0.5
                   ? special[static_cast<std::size_t>(unit(random) * double(special.size()))]
                   : std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    };
    QueryArrays queries;
    for (int k = 0; k < 20000; ++k) {
        const FaceId face =
            faceId(static_cast<std::size_t>(unit(random) * double(mesh.faceCount())));
        const float u = any();
        const float v = any();
        queries.add(face, {u, v}, {0, 0}, {0, 0});
        queries.uw1.back() = any();
        queries.vw1.back() = any();
        queries.uw2.back() = any();
        queries.vw2.back() = any();
    }
    const ResultArrays results = answers(GetParam(), scene, queries);
    for (const float value : results.values) {
        ASSERT_TRUE(value >= -1e-5F && value <= 1 + 1e-5F) << value;
    }
    EXPECT_LE(*std::ranges::max_element(results.taps), kMostTaps);
}

TEST_P(PyramidMethods, countABordersProbesOutSmoothly)
{
    // A border cuts the footprint: moving towards it must not make the answer jump.
    Random random(19);
    const TriangleMesh mesh = flatLattice(1);
    const FilterScene scene = sceneOf(mesh, noiseStore(random, FaceMap<Level>(2, Level(5)), 1));
    QueryArrays queries;
    for (int k = 0; k < 2000; ++k) {
        queries.add(faceId(0), {0.3, 0.4 * k / 2000}, {0.02, 0.9}, {0.05, 0.0});
    }
    const ResultArrays results = answers(GetParam(), scene, queries);
    for (std::size_t k = 1; k < queries.size(); ++k) {
        ASSERT_NEAR(results.values[k], results.values[k - 1], 5e-3F) << k;
    }
}

TEST_P(PyramidMethods, readNothingAtTheStartOfAFaceThatLiesElsewhere)
{
    // Differences are summed from a value under the footprint, not from where the face's begin.
    const TexelStore store =
        storeOf(FaceMap<Level>(2, Level(6)), 1, [](FaceId, glm::dvec2 uv, int) {
            constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
            return uv.x + uv.y < 0.05 ? kNone : 0.25F;
        });
    const FilterScene scene = sceneOf(flatLattice(1), store);
    QueryArrays queries;
    for (int k = 0; k < 7; ++k) {
        const double width = std::exp2(-k - 6);
        queries.add(faceId(0), {0.5, 0.4}, {0.5 * width, -width}, {width, 0.0});
    }
    for (const float value : answers(GetParam(), scene, queries).values) {
        EXPECT_EQ(value, 0.25F);
    }
}
