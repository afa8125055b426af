// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/exact_kernel.h"
#include "tests/core/filter/golden_queries.h"
#include "tests/core/filter/irregular_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace trixel;
using namespace trixel::test;

namespace {

std::unique_ptr<const FilterMethod> exact()
{
    return makeMethod({"exact", std::nullopt});
}

/// A jittered grid of 2 n² faces in a plane, the order of each face's vertices at random.
TriangleMesh flatMesh(std::uint32_t n, unsigned seed)
{
    TriangleMesh mesh = gridMesh(n);
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> jitter(-0.3F, 0.3F);
    for (glm::vec3& p : mesh.positions) {
        const float x = jitter(random);
        p += glm::vec3(x, jitter(random), 0.0F) / static_cast<float>(n);
    }
    for (Triangle& t : mesh.triangles) {
        std::ranges::rotate(t, t.begin() + random() % 3);
    }
    return mesh;
}

/// Position in the plane of the mesh.
glm::dvec2 placeOf(const TriangleMesh& mesh, FaceId face, glm::dvec2 uv)
{
    const auto corners = mesh.corners(face);
    const glm::dvec2 a(corners[0]);
    return a + uv.x * (glm::dvec2(corners[1]) - a) + uv.y * (glm::dvec2(corners[2]) - a);
}

/// The Gaussian over every texel of a flat mesh, nothing left out, without any of the filter's own
/// arithmetic.
std::array<double, 3>
bruteForce(const TriangleMesh& mesh, const FilterScene& scene, const Query& query)
{
    const glm::dvec2 origin = placeOf(mesh, query.face, glm::dvec2(0));
    const glm::dvec2 centre = placeOf(mesh, query.face, query.uv);
    const glm::dvec2 a = placeOf(mesh, query.face, query.w1) - origin;
    const glm::dvec2 b = placeOf(mesh, query.face, query.w2) - origin;
    const long double s = std::exp2(scene.log2TexelSize(query.face, glm::dvec2(query.uv)));
    const long double xx = (a.x * a.x + b.x * b.x + s * s) / 4;
    const long double xy = (a.x * a.y + b.x * b.y) / 4;
    const long double yy = (a.y * a.y + b.y * b.y + s * s) / 4;
    const long double determinant = xx * yy - xy * xy;
    long double weights = 0;
    std::array<long double, 3> sums{};
    for (std::uint32_t f = 0; f < scene.faceCount(); ++f) {
        const FaceId face = faceId(f);
        const Level level = scene.level(face);
        const glm::dvec2 corner = placeOf(mesh, face, glm::dvec2(0));
        const glm::dvec2 u = placeOf(mesh, face, {1, 0}) - corner;
        const glm::dvec2 v = placeOf(mesh, face, {0, 1}) - corner;
        const long double area = (u.x * v.y - u.y * v.x) / level.texelCount();
        for (std::uint32_t t = 0; t < level.texelCount(); ++t) {
            const auto index = static_cast<TexelIndex>(t);
            const glm::dvec2 d =
                placeOf(mesh, face, centroid(level, texelAt(level, index))) - centre;
            const long double q =
                (yy * d.x * d.x - 2 * xy * d.x * d.y + xx * d.y * d.y) / determinant;
            const long double weight = std::exp(-q / 2) * area;
            weights += weight;
            const float* texel = scene.mips().texels(face, level).texel(index);
            for (std::size_t c = 0; c < 3; ++c) {
                sums[c] += weight * static_cast<long double>(texel[c]);
            }
        }
    }
    return {static_cast<double>(sums[0] / weights),
            static_cast<double>(sums[1] / weights),
            static_cast<double>(sums[2] / weights)};
}

/// Footprints of all widths and anisotropies, in edges of the face.
std::vector<Query> randomQueries(std::size_t faces, std::size_t count, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(0.0F, 1.0F);
    std::vector<Query> queries;
    while (queries.size() < count) {
        const FaceId face = faceId(random() % faces);
        glm::vec2 uv(unit(random), 0);
        uv.y = unit(random) * (1 - uv.x);
        const float size = std::exp2(-5 + 5 * unit(random));
        const float narrow = size * std::exp2(-4 * unit(random));
        const float angle = 6.2831853F * unit(random);
        const glm::vec2 along(std::cos(angle), std::sin(angle));
        queries.push_back({face, uv, size * along, narrow * glm::vec2(-along.y, along.x)});
    }
    return queries;
}

} // namespace

TEST(Exact, agreesWithTheGoldenColumns)
{
    const FilterScene scene = goldenScene();
    const GoldenQueries golden = goldenQueries();
    ASSERT_EQ(golden.queries.size(), 600U);
    const auto answers = ask(*exact(), scene, golden.queries);
    for (std::size_t i = 0; i < answers.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_LE(std::abs(answers[i].value[c] - golden.exact[i][c]), 1e-6)
                << "query " << i << " channel " << c;
        }
    }
}

TEST(Exact, agreesWithTheSumOverEveryTexelOfAFlatMesh)
{
    for (unsigned seed = 1; seed <= 3; ++seed) {
        const TriangleMesh mesh = flatMesh(5, seed);
        const FaceMap<Level> levels = randomLevels(mesh.faceCount(), 3, 5, seed);
        const FilterScene scene = sceneOf(surfaceOf(mesh), storeOf(levels, noise(seed)));
        const auto queries = randomQueries(mesh.faceCount(), 60, seed);
        const auto answers = ask(*exact(), scene, queries);
        for (std::size_t i = 0; i < queries.size(); ++i) {
            const auto expected = bruteForce(mesh, scene, queries[i]);
            for (std::size_t c = 0; c < 3; ++c) {
                // 6 sigma leave 1.5e-8 of the weight out, the answer is a float.
                EXPECT_NEAR(answers[i].value[c], expected[c], 2e-7) << "seed " << seed;
            }
        }
    }
}

TEST(Exact, findsTheNearestTexelWhereNoneLiesUnderTheFootprint)
{
    // A face of four texels amid finer ones: the floor there is far below a texel, and the nearest
    // lies up to hundreds of standard deviations away, where exp(-q/2) is long 0.
    for (const int finer : {5, 10}) {
        const TriangleMesh mesh = flatMesh(3, 1);
        FaceMap<Level> levels(mesh.faceCount(), Level(finer));
        levels[faceId(8)] = Level(1);
        const std::array<float, 3> around = {9, 9, 9};
        const TexelFormat format{TexelType::Float, 3, std::nullopt};
        TexelStore store(format, levels, std::as_bytes(std::span(around)));
        const std::array<float, 12> four = {1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4};
        store.exchange(faceId(8), FaceTexels::full(Level(1), 12, std::as_bytes(std::span(four))));
        const FilterScene scene = sceneOf(surfaceOf(mesh), store);
        for (std::uint32_t t = 0; t < 4; ++t) {
            const auto index = static_cast<TexelIndex>(t);
            const glm::dvec2 near = centroid(Level(1), texelAt(Level(1), index));
            const glm::dvec2 uv = near + 0.2 * (glm::dvec2(1.0 / 3) - near) + glm::dvec2(0.02, 0);
            const Answer answer = ask(*exact(), scene, {faceId(8), glm::vec2(uv), {}, {}});
            EXPECT_NEAR(answer.value[0], t + 1.0, 1e-5) << "level " << finer;
        }
        // Nearer to an edge than to the face's own centroids.
        for (const glm::vec2 uv : {glm::vec2(0.42F, 0.06F), glm::vec2(0.06F, 0.42F)}) {
            const Answer answer = ask(*exact(), scene, {faceId(8), uv, {}, {}});
            EXPECT_NEAR(answer.value[0], 9.0, 1e-5) << "level " << finer;
        }
    }
}

TEST(ExactKernel, weighsWhatIsNearThoughItsRowBeginsWhereWeightsVanish)
{
    // 64 columns one standard deviation apart, 50 below the centre, nearest at column 60: the first
    // weight is exp(-1898).
    const Level level(6);
    const std::vector<float> ones(std::size_t{level.texelCount()} * kGroupChannels, 1.0F);
    HalfLattice lattice(TexelHalf::Lower, level, {0, 0}, {64, 0}, {0, -64e3});
    lattice.origin = {-60, -50};
    const double offset = 48.0 * 48.0;
    ExactSums sums;
    addExactly({ones.data(), kGroupChannels}, lattice, 96, offset, 1, sums);
    long double expected = 0;
    for (int k = 0; k < 64; ++k) {
        expected += std::exp((offset - 2500.0L - (k - 60.0L) * (k - 60.0L)) / 2);
    }
    EXPECT_EQ(sums.taps, 64U);
    EXPECT_NEAR(sums.weight / static_cast<double>(expected), 1.0, 1e-12);
    EXPECT_NEAR(sums.values[0] / static_cast<double>(expected), 1.0, 1e-12);
}

TEST(ExactKernel, sumsFacesOfFewTexelsAsItSumsRows)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-6, 6);
    for (int n = 0; n <= kFewExactLevel; ++n) {
        const Level level(n);
        std::vector<std::vector<float>> texels;
        FewExactFaces faces;
        faces.count = 13; // the last vector is not full
        ExactSums expected;
        constexpr double kCut = 5;
        constexpr double kOffset = 2;
        for (std::uint32_t f = 0; f < faces.count; ++f) {
            texels.emplace_back(std::size_t{level.texelCount()} * kGroupChannels);
            for (float& value : texels.back()) {
                value = static_cast<float>(place(random));
            }
            const glm::dvec2 origin(place(random), place(random));
            const glm::dvec2 e1(4 + place(random) / 3, place(random) / 3);
            const glm::dvec2 e2(place(random) / 3, 4 + place(random) / 3);
            faces.originX[f] = origin.x;
            faces.originY[f] = origin.y;
            faces.e1X[f] = e1.x;
            faces.e1Y[f] = e1.y;
            faces.e2X[f] = e2.x;
            faces.e2Y[f] = e2.y;
            faces.texels[f] = texels.back().data();
            faces.stride[f] = kGroupChannels;
            const double area = (e1.x * e2.y - e1.y * e2.x) / level.texelCount();
            for (const TexelHalf half : {TexelHalf::Lower, TexelHalf::Upper}) {
                addExactly({texels.back().data(), kGroupChannels},
                           HalfLattice(half, level, origin, e1, e2),
                           kCut,
                           kOffset,
                           area,
                           expected);
            }
        }
        ExactSums sums;
        addFewExactly(faces, n, kCut, kOffset, sums);
        EXPECT_EQ(sums.taps, expected.taps) << "level " << n;
        EXPECT_GT(sums.taps, 0U);
        EXPECT_NEAR(sums.weight / expected.weight, 1, 1e-13);
        for (std::size_t c = 0; c < kGroupChannels; ++c) {
            EXPECT_NEAR(sums.values[c], expected.values[c], 1e-12 * expected.weight);
        }
    }
}

TEST(Exact, keepsNaNsBeyondTheFootprintOut)
{
    const TriangleMesh mesh = flatMesh(2, 1);
    FaceMap<Level> levels(static_cast<std::uint32_t>(mesh.faceCount()), Level(5));
    const auto value = [](FaceId face, glm::dvec2 uv, int) {
        return face != faceId(0) || uv.x > 0.6 ? std::numeric_limits<float>::quiet_NaN() : 0.5F;
    };
    const FilterScene scene = sceneOf(surfaceOf(mesh), storeOf(levels, value));
    const Query query{faceId(0), {0.3F, 0.3F}, {0.02F, 0}, {0, 0.02F}};
    EXPECT_EQ(ask(*exact(), scene, query).value[0], 0.5);
    EXPECT_TRUE(std::isnan(ask(*exact(), scene, {faceId(0), {0.5F, 0.3F}, {}, {}}).value[0]));
}

TEST(Exact, refusesBeyondItsCapAndGivesTheAverage)
{
    const TriangleMesh mesh = gridMesh(24);
    const std::array<float, 3> grey = {0.25F, 0.5F, 0.75F};
    const TexelStore store({TexelType::Float, 3, std::nullopt},
                           FaceMap<Level>(mesh.faceCount(), Level(8)),
                           std::as_bytes(std::span(grey)));
    const FilterScene scene = sceneOf(surfaceOf(mesh), store);
    const Answer answer = ask(*exact(), scene, {faceId(1), {0.2F, 0.2F}, {30, 0}, {0, 30}});
    EXPECT_EQ(answer.taps, kRefusedTaps);
    EXPECT_EQ(answer.value[2], 0.75);
    const Answer small = ask(*exact(), scene, {faceId(1), {0.2F, 0.2F}, {0.01F, 0}, {0, 0.01F}});
    EXPECT_LT(small.taps, 100000U);
    EXPECT_NEAR(small.value[2], 0.75, 1e-7);
}

TEST(Exact, canBeAskedByAnyNumberOfThreads)
{
    const FilterScene scene = goldenScene();
    const GoldenQueries golden = goldenQueries();
    QueryArrays arrays;
    for (const Query& query : golden.queries) {
        arrays.add(query.face, query.uv, query.w1, query.w2);
    }
    ResultArrays one(arrays.size(), 3);
    ResultArrays many(arrays.size(), 3);
    exact()->filter(scene, arrays.queries(), one.results());
    filterParallel(*exact(), scene, arrays.queries(), many.results(), Threads{4});
    EXPECT_EQ(one.values, many.values);
    EXPECT_EQ(one.taps, many.taps);
}
