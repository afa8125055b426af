// SPDX-License-Identifier: GPL-3.0-or-later
//
// Properties that the filters with the shared unfolding rule claim, on closed irregular meshes of
// mixed levels.
#include "tests/core/filter/filter_scenes.h"
#include "tests/core/filter/irregular_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace trixel;
using namespace trixel::test;

namespace {

class GaussianFilter : public ::testing::TestWithParam<std::string>
{
protected:
    std::unique_ptr<const FilterMethod> method() const
    {
        return makeMethod(*parseMethod(GetParam()));
    }
};

/// A footprint of any shape, up to `widest` edges of the face.
Query footprint(std::mt19937& random, FaceId face, glm::dvec2 uv, double widest)
{
    std::uniform_real_distribution<double> unit(0, 1);
    const double size = widest * std::exp2(-6 * unit(random));
    const double narrow = size * std::exp2(-5 * unit(random));
    const double angle = 6.283185307179586 * unit(random);
    const glm::dvec2 along(std::cos(angle), std::sin(angle));
    return {face,
            glm::vec2(uv),
            glm::vec2(size * along),
            glm::vec2(narrow * glm::dvec2(-along.y, along.x))};
}

Query anywhere(std::mt19937& random, std::size_t faces, double widest)
{
    std::uniform_real_distribution<double> unit(0, 1);
    const double u = unit(random);
    const glm::dvec2 uv(u, (1 - u) * unit(random));
    return footprint(random, faceId(random() % faces), uv, widest);
}

/// A query on an edge and the same asked of the face across. Points are multiples of 1/64, which
/// both faces can say exactly.
std::pair<Query, Query> acrossAnEdge(std::mt19937& random, const FilterSurface& surface)
{
    const FaceId face = faceId(random() % surface.faceCount());
    const LocalEdge edge = kLocalEdges[random() % 3];
    const double t = static_cast<double>(1 + random() % 63) / 64;
    const std::array<glm::dvec2, 3> along = {
        glm::dvec2(t, 0), glm::dvec2(1 - t, t), glm::dvec2(0, 1 - t)};
    const Query own = footprint(random, face, along[indexOf(edge)], 1.0);
    const auto crossing = *surface.crossing(face, edge);
    return {own,
            {crossing.face,
             glm::vec2(crossing.point(own.uv)),
             glm::vec2(crossing.vector(own.w1)),
             glm::vec2(crossing.vector(own.w2))}};
}

/// Fast enough for a few hundred questions, hard enough to matter.
FilterScene irregularScene(unsigned seed, const TexelFunction& value)
{
    const TriangleMesh mesh = irregularSphere(2, seed);
    return sceneOf(surfaceOf(mesh), storeOf(randomLevels(mesh.faceCount(), 2, 5, seed), value));
}

} // namespace

TEST(IrregularSphere, hasEveryValenceFromThreeToTen)
{
    std::set<std::size_t> valences;
    for (unsigned seed = 1; seed <= 3; ++seed) {
        const TriangleMesh mesh = irregularSphere(2, seed);
        const VertexRings rings(buildAdjacency(mesh.triangles));
        EXPECT_EQ(rings.ringCount(), mesh.positions.size());
        for (std::size_t r = 0; r < rings.ringCount(); ++r) {
            EXPECT_TRUE(rings.isClosed(static_cast<RingId>(r)));
            valences.insert(rings.corners(static_cast<RingId>(r)).size());
        }
    }
    EXPECT_EQ(valences, (std::set<std::size_t>{3, 4, 5, 6, 7, 8, 9, 10}));
}

TEST_P(GaussianFilter, givesTheSameFromBothSidesOfAnEdge)
{
    for (unsigned seed = 1; seed <= 3; ++seed) {
        const FilterScene scene = irregularScene(seed, noise(seed));
        std::mt19937 random(seed);
        std::vector<Query> here;
        std::vector<Query> there;
        for (int k = 0; k < 600; ++k) {
            const auto [own, across] = acrossAnEdge(random, scene.surface());
            here.push_back(own);
            there.push_back(across);
        }
        const auto a = ask(*method(), scene, here);
        const auto b = ask(*method(), scene, there);
        for (std::size_t i = 0; i < a.size(); ++i) {
            EXPECT_LE(difference(a[i], b[i]), 1e-5)
                << "seed " << seed << " face " << indexOf(here[i].face) << " at " << here[i].uv.x
                << ", " << here[i].uv.y << " w1 " << here[i].w1.x << ", " << here[i].w1.y;
        }
    }
}

TEST_P(GaussianFilter, keepsAConstant)
{
    const float value = 0.7F;
    const FilterScene scene = irregularScene(1, [=](FaceId, glm::dvec2, int) { return value; });
    std::mt19937 random(1);
    std::vector<Query> queries;
    for (int k = 0; k < 500; ++k) {
        queries.push_back(anywhere(random, scene.faceCount(), 2.0));
    }
    const double ulp = static_cast<double>(std::nextafter(value, 1.0F) - value);
    for (const Answer& answer : ask(*method(), scene, queries)) {
        EXPECT_LE(std::abs(answer.value[0] - static_cast<double>(value)), 2 * ulp);
    }
}

TEST_P(GaussianFilter, doesNotSeeTheOrderOfVertices)
{
    const TriangleMesh mesh = irregularSphere(1, 4);
    TriangleMesh turned = mesh;
    for (std::size_t f = 0; f < turned.faceCount(); ++f) {
        std::ranges::rotate(turned.triangles[f], turned.triangles[f].begin() + 1);
    }
    // A formula of the place, so that texels are the same whatever the vertex order.
    const auto wavesOn = [](const TriangleMesh& on) {
        return [&on](FaceId face, glm::dvec2 uv, int c) {
            const glm::vec3 p = pointAt(on.corners(face), float(uv.x), float(uv.y));
            return 0.5F + 0.5F * std::sin(20.0F * p[c] + 9.0F * p[(c + 1) % 3]);
        };
    };
    const FaceMap<Level> levels = randomLevels(mesh.faceCount(), 2, 5, 4);
    const FilterScene scene = sceneOf(surfaceOf(mesh), storeOf(levels, wavesOn(mesh)));
    const FilterScene other = sceneOf(surfaceOf(turned), storeOf(levels, wavesOn(turned)));
    std::mt19937 random(4);
    std::vector<Query> queries;
    std::vector<Query> same;
    for (int k = 0; k < 500; ++k) {
        const Query q = anywhere(random, mesh.faceCount(), 1.0);
        // V1 is the new V0: (u,v) becomes (v,w).
        queries.push_back(q);
        same.push_back({q.face,
                        {q.uv.y, 1 - q.uv.x - q.uv.y},
                        {q.w1.y, -q.w1.x - q.w1.y},
                        {q.w2.y, -q.w2.x - q.w2.y}});
    }
    const auto a = ask(*method(), scene, queries);
    const auto b = ask(*method(), other, same);
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_LE(difference(a[i], b[i]), 2e-6) << "query " << i;
    }
}

TEST_P(GaussianFilter, doesNotSeeHowTheFootprintIsSpanned)
{
    const FilterScene scene = irregularScene(2, noise(2));
    std::mt19937 random(2);
    std::vector<Query> queries;
    std::vector<Query> swapped;
    std::vector<Query> negated;
    std::vector<Query> rotated;
    for (int k = 0; k < 300; ++k) {
        const Query q = anywhere(random, scene.faceCount(), 1.0);
        queries.push_back(q);
        swapped.push_back({q.face, q.uv, q.w2, q.w1});
        negated.push_back({q.face, q.uv, q.w1, -q.w2});
        rotated.push_back({q.face, q.uv, 0.6F * q.w1 + 0.8F * q.w2, 0.6F * q.w2 - 0.8F * q.w1});
    }
    const auto answers = ask(*method(), scene, queries);
    for (const auto& others : {swapped, negated, rotated}) {
        const auto same = ask(*method(), scene, others);
        for (std::size_t i = 0; i < answers.size(); ++i) {
            EXPECT_LE(difference(answers[i], same[i]), 1e-5);
        }
    }
}

TEST_P(GaussianFilter, answersEveryQueryWithANumber)
{
    const FilterScene scene = irregularScene(3, noise(3));
    const float huge = std::numeric_limits<float>::max();
    const float inf = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::array<float, 12> hostile = {
        0, 1e-45F, 1e-38F, 1e-20F, 1e-6F, 1e-3F, 1, 1e4F, 1e10F, huge, inf, nan};
    std::mt19937 random(3);
    std::vector<Query> queries;
    for (int k = 0; k < 200; ++k) {
        const auto pick = [&] {
            return hostile[random() % hostile.size()] * (random() % 2 == 0 ? 1.0F : -1.0F);
        };
        Query q = anywhere(random, scene.faceCount(), 1.0);
        q.w1 = {pick(), pick()};
        q.w2 = {pick(), pick()};
        if (random() % 4 == 0) {
            q.uv = {pick(), pick()};
        }
        queries.push_back(q);
    }
    for (const Answer& answer : ask(*method(), scene, queries)) {
        for (const double value : answer.value) {
            EXPECT_GE(value, 0.0);
            EXPECT_LE(value, 1.0);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Methods,
    GaussianFilter,
    ::testing::Values("exact", "ewa", "ewa:2", "ewa-blended", "ewa-blended:0.7", "ewa-base"));
