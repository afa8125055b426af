// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/unfolding.h"
#include "tests/core/filter/filter_scenes.h"
#include "tests/core/filter/irregular_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

using namespace trixel;
using namespace trixel::test;

namespace {

FilterScene coarseScene(const TriangleMesh& mesh)
{
    return sceneOf(surfaceOf(mesh), storeOf(FaceMap<Level>(mesh.faceCount(), Level(2)), noise(1)));
}

QueryEllipse ellipseAt(const FilterScene& scene, FaceId face, std::mt19937& random)
{
    std::uniform_real_distribution<double> unit(0, 1);
    const double u = unit(random);
    const double size = std::exp2(-3 * unit(random));
    const double narrow = size * std::exp2(-4 * unit(random));
    const double angle = 6.283185307179586 * unit(random);
    const glm::dvec2 along(std::cos(angle), std::sin(angle));
    return queryEllipse(scene,
                        face,
                        {u, (1 - u) * unit(random)},
                        size * along,
                        narrow * glm::dvec2(-along.y, along.x));
}

} // namespace

TEST(Unfolding, laysAFlatMeshAsItIs)
{
    const TriangleMesh mesh = gridMesh(6);
    const FilterScene scene = coarseScene(mesh);
    std::mt19937 random(1);
    Unfolding unfolding;
    for (int k = 0; k < 200; ++k) {
        const FaceId hit = faceId(random() % mesh.faceCount());
        const QueryEllipse ellipse = ellipseAt(scene, hit, random);
        const EllipseFrame frame(ellipse);
        const auto places = unfolding.unfold(scene.surface(), hit, ellipse, frame, 3);
        // The hit face's plane against the mesh's own: a shift, for V1 is on the x axis or against.
        const auto corners = mesh.corners(hit);
        const glm::dvec2 e1 = glm::dvec2(corners[1]) - glm::dvec2(corners[0]);
        const glm::dvec2 turn = e1 / glm::length(e1);
        std::map<FaceId, PlacedFace> laid;
        for (const PlacedFace& place : places) {
            EXPECT_TRUE(laid.emplace(place.face, place).second) << "each face once";
        }
        const glm::dvec2 centre = glm::dvec2(corners[0]) + ellipse.uv.x * e1 +
                                  ellipse.uv.y * (glm::dvec2(corners[2]) - glm::dvec2(corners[0]));
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            const auto own = mesh.corners(faceId(f));
            double nearest = 1e9;
            for (int i = 0; i <= 32; ++i) {
                for (int j = 0; i + j <= 32; ++j) {
                    const glm::dvec2 p(
                        pointAt(own, static_cast<float>(i) / 32, static_cast<float>(j) / 32));
                    const glm::dvec2 d = p - centre;
                    const glm::dvec2 inPlane(turn.x * d.x + turn.y * d.y,
                                             turn.x * d.y - turn.y * d.x);
                    nearest = std::min(nearest, glm::length(frame.toUnit(inPlane)));
                }
            }
            const auto found = laid.find(faceId(f));
            if (nearest < 3) {
                ASSERT_NE(found, laid.end()) << "under the ellipse";
            }
            if (found != laid.end()) {
                const glm::dvec2 d = glm::dvec2(own[0]) - centre;
                const glm::dvec2 expected(turn.x * d.x + turn.y * d.y, turn.x * d.y - turn.y * d.x);
                EXPECT_LE(glm::length(frame.toPlane(found->second.origin()) - expected), 1e-6);
            }
        }
    }
}

TEST(Unfolding, laysTheSameFacesInTheSamePlacesForEveryCut)
{
    std::size_t byRule = 0;
    for (unsigned seed = 1; seed <= 3; ++seed) {
        const TriangleMesh mesh = irregularSphere(2, seed);
        const FilterScene scene = coarseScene(mesh);
        std::mt19937 random(seed);
        Unfolding narrow;
        Unfolding wide;
        for (int k = 0; k < 300; ++k) {
            const FaceId hit = faceId(random() % mesh.faceCount());
            const QueryEllipse ellipse = ellipseAt(scene, hit, random);
            const EllipseFrame frame(ellipse);
            const auto first = narrow.unfold(scene.surface(), hit, ellipse, frame, 3);
            const auto all = wide.unfold(scene.surface(), hit, ellipse, frame, 6);
            ASSERT_LE(first.size(), all.size());
            std::map<FaceId, std::size_t> numbers;
            for (std::size_t n = 0; n < all.size(); ++n) {
                numbers[all[n].face] = n;
            }
            std::size_t last = 0;
            for (const PlacedFace& place : first) {
                ASSERT_TRUE(numbers.contains(place.face));
                const std::size_t n = numbers.at(place.face);
                last = std::max(last, n);
                for (std::size_t c = 0; c < 3; ++c) {
                    EXPECT_LE(glm::length(place.corners[c] - all[n].corners[c]), 1e-9);
                }
            }
            // Around so many faces of this mesh the rule has to choose.
            if (all.size() > 12) {
                EXPECT_EQ(last, first.size() - 1) << "the same ones first";
                ++byRule;
            }
        }
    }
    EXPECT_GT(byRule, 300U);
}

TEST(Unfolding, laysTheSameFromBothSidesOfAnEdgeThatIsAMirror)
{
    // Round footprints on a regular sphere: both ways around a vertex are equally long, and the
    // last digits of a float must not choose.
    const TriangleMesh mesh = sphereMesh(1);
    const FilterScene scene = coarseScene(mesh);
    const FilterSurface& surface = scene.surface();
    Unfolding here;
    Unfolding there;
    std::size_t compared = 0;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        for (int k = 1; k < 16; ++k) {
            const glm::dvec2 uv(k / 16.0, 0);
            const auto crossing = *surface.crossing(faceId(f), LocalEdge::E0);
            const FaceShape& shape = surface.shape(faceId(f));
            const glm::dvec2 w1(glm::vec2(shape.toUv({0.4, 0})));
            const glm::dvec2 w2(glm::vec2(shape.toUv({0, 0.4})));
            const QueryEllipse own = queryEllipse(scene, faceId(f), uv, w1, w2);
            const QueryEllipse other = queryEllipse(scene,
                                                    crossing.face,
                                                    glm::vec2(crossing.point(uv)),
                                                    glm::vec2(crossing.vector(w1)),
                                                    glm::vec2(crossing.vector(w2)));
            std::map<FaceId, double> expected;
            for (const PlacedFace& place :
                 here.unfold(surface, faceId(f), own, EllipseFrame(own), 4)) {
                expected[place.face] = glm::dot(place.origin(), place.e1());
            }
            for (const PlacedFace& place :
                 there.unfold(surface, crossing.face, other, EllipseFrame(other), 4)) {
                if (expected.contains(place.face)) { // others touch the cut and no more
                    EXPECT_NEAR(expected.at(place.face), glm::dot(place.origin(), place.e1()), 1e-5)
                        << "hit " << f << " place " << k;
                    ++compared;
                }
            }
        }
    }
    EXPECT_GT(compared, 10000U);
}

TEST(Unfolding, laysTheNearestFacesWhereNotAllMayBe)
{
    const TriangleMesh mesh = irregularSphere(2, 1);
    const FilterScene scene = coarseScene(mesh);
    const QueryEllipse ellipse = queryEllipse(scene, faceId(5), {0.3, 0.3}, {2, 0}, {0, 2});
    const EllipseFrame frame(ellipse);
    Unfolding unfolding;
    const auto all = unfolding.unfold(scene.surface(), faceId(5), ellipse, frame, 6);
    const std::vector<PlacedFace> everything(all.begin(), all.end());
    ASSERT_GT(everything.size(), 100U);
    const auto few = unfolding.unfold(scene.surface(), faceId(5), ellipse, frame, 6, 40);
    ASSERT_EQ(few.size(), 40U);
    for (std::size_t k = 0; k < few.size(); ++k) {
        EXPECT_EQ(few[k].face, everything[k].face);
    }
}
