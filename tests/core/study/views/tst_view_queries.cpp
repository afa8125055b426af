// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/views/view_queries.h"
#include "tests/core/mesh/cages.h"
#include "tests/core/test_meshes.h"

#include <gmock/gmock.h>
#include <set>

namespace trixel {
namespace {

std::shared_ptr<const Surface> surfaceOf(TriangleMesh mesh)
{
    NoProgress progress;
    return Surface::build(std::move(mesh), progress).value();
}

ViewQueries seen(const Surface& surface,
                 const ViewCamera& camera,
                 PixelSubset subset = {},
                 unsigned threads = 2)
{
    NoProgress progress;
    return viewQueries(surface, camera, subset, Threads{threads}, progress).value();
}

const ViewCamera kFront{"front", {0.5, 0.5, 2}, {0.5, 0.5, 0}, {0, 1, 0}, 40, 120, 80};

std::shared_ptr<const LimitMesh> limitOf(const Surface& surface)
{
    NoProgress progress;
    const auto bends =
        LimitBends::measure(LimitSurface::build(surface.mesh()).value(), Threads{2}, progress);
    const auto cut = LimitTessellation::make(
        *bends, {ErrorScale::ofWorld(), 1e-4}, nullptr, Threads{2}, progress);
    return LimitMesh::build(*cut);
}

TEST(ViewQueries, ofALimitSurfaceAreItsPointsAndItsDerivatives)
{
    const auto surface = surfaceOf(test::icosahedron());
    const auto limit = limitOf(*surface);
    const ViewCamera camera{"front", {0.3, 0.2, 6}, {0, 0, 0}, {0, 1, 0}, 40, 60, 60};
    NoProgress progress;
    const auto found = viewQueries(*limit, camera, {}, Threads{2}, progress);
    ASSERT_TRUE(found);
    ASSERT_GT(found->size(), 500U);
    EXPECT_LT(found->size(), seen(*surface, camera).size()); // it lies within the cage
    int checked = 0;
    for (std::size_t i = 0; i < found->size(); ++i) {
        const FaceId face = found->queries.face[i];
        const glm::dvec2 uv(found->queries.u[i], found->queries.v[i]);
        const LimitPoint point = limit->surface().at(face, uv);
        const auto at = camera.project(point.position);
        ASSERT_TRUE(at);
        EXPECT_NEAR(at->x, found->pixel[i] % 60 + 0.5, 0.05);
        const glm::dvec2 w1(found->queries.uw1[i], found->queries.vw1[i]);
        const double facing =
            glm::dot(point.normal(), glm::normalize(camera.position - point.position));
        if (facing < 0.3 || std::min({uv.x, uv.y, 1 - uv.x - uv.y}) < 0.05) {
            continue; // near its outline, and where derivatives are approximate
        }
        ++checked;
        constexpr double h = 1e-4;
        const auto pixel = [&](double part) {
            return *camera.project(limit->surface().at(face, uv + part * w1).position);
        };
        const glm::dvec2 step = (pixel(h) - pixel(-h)) / (2 * h);
        EXPECT_NEAR(step.x, 1, 1e-2);
        EXPECT_NEAR(step.y, 0, 1e-2);
    }
    EXPECT_GT(checked, 300);
}

TEST(ViewQueries, ofALimitSurfaceDoNotDependOnThreads)
{
    const auto surface = surfaceOf(test::icosahedron());
    const auto limit = limitOf(*surface);
    const ViewCamera camera{"front", {0.3, 0.2, 6}, {0, 0, 0}, {0, 1, 0}, 40, 60, 60};
    NoProgress progress;
    const auto one = viewQueries(*limit, camera, {2, 1}, Threads{1}, progress);
    const auto many = viewQueries(*limit, camera, {2, 1}, Threads{3}, progress);
    ASSERT_TRUE(one && many);
    EXPECT_EQ(one->pixel, many->pixel);
    EXPECT_EQ(one->queries.uw1, many->queries.uw1);
}

TEST(ViewQueries, pixelsAndTheirCentresAgree)
{
    const auto surface = surfaceOf(test::gridMesh(3));
    const ViewQueries found = seen(*surface, kFront);
    ASSERT_GT(found.size(), 1000U);
    EXPECT_EQ(found.asked, 120U * 80U);
    EXPECT_TRUE(std::ranges::is_sorted(found.pixel));
    for (std::size_t i = 0; i < found.size(); ++i) {
        const auto corners = surface->mesh().corners(found.queries.face[i]);
        const glm::vec3 point = pointAt(corners, found.queries.u[i], found.queries.v[i]);
        const auto at = kFront.project(glm::dvec3(point));
        ASSERT_TRUE(at);
        EXPECT_NEAR(at->x, found.pixel[i] % 120 + 0.5, 1e-3);
        EXPECT_NEAR(at->y, found.pixel[i] / 120 + 0.5, 1e-3);
    }
}

TEST(ViewQueries, footprintsReachFromPixelToPixel)
{
    const auto surface = surfaceOf(test::gridMesh(1));
    ViewCamera camera = kFront;
    camera.position = {2, 1.5, 2.5};
    const ViewQueries found = seen(*surface, camera);
    const ViewQueries& q = found;
    std::size_t pairs = 0;
    for (std::size_t i = 0; i + 1 < q.size(); ++i) {
        if (q.pixel[i + 1] != q.pixel[i] + 1 || q.queries.face[i] != q.queries.face[i + 1]) {
            continue;
        }
        ++pairs;
        const double du = q.queries.u[i + 1] - q.queries.u[i];
        const double mean = (q.queries.uw1[i] + q.queries.uw1[i + 1]) / 2;
        EXPECT_NEAR(du, mean, 1e-3 * std::abs(mean) + 1e-6);
    }
    EXPECT_GT(pairs, 500U);
}

TEST(ViewQueries, doNotDependOnThreads)
{
    const auto surface = surfaceOf(test::sphereMesh(3));
    const ViewCamera camera{"", {2, 2, 2}, {0, 0, 0}, {0, 1, 0}, 40, 320, 200};
    const ViewQueries one = seen(*surface, camera, {3, 7}, 1);
    const ViewQueries many = seen(*surface, camera, {3, 7}, 4);
    EXPECT_EQ(one.pixel, many.pixel);
    EXPECT_EQ(one.queries.face, many.queries.face);
    EXPECT_EQ(one.queries.u, many.queries.u);
    EXPECT_EQ(one.queries.vw2, many.queries.vw2);
}

TEST(ViewQueries, subsetTakesOnePixelOfEachBlock)
{
    const auto surface = surfaceOf(test::gridMesh(1));
    ViewCamera close = kFront;
    close.position.z = 0.2; // sees nothing but the square
    close.width = 101;      // blocks cut off at the sides
    close.height = 67;
    for (const int step : {1, 4, 9}) {
        const ViewQueries found = seen(*surface, close, {step, 3});
        const auto blocks = static_cast<std::size_t>((101 + step - 1) / step) *
                            static_cast<std::size_t>((67 + step - 1) / step);
        EXPECT_EQ(found.asked, blocks);
        EXPECT_EQ(found.size(), blocks);
        std::set<std::pair<std::uint32_t, std::uint32_t>> taken;
        for (const std::uint32_t pixel : found.pixel) {
            const auto size = static_cast<std::uint32_t>(step);
            EXPECT_LT(pixel, 101U * 67U);
            taken.insert({pixel % 101 / size, pixel / 101 / size});
        }
        EXPECT_EQ(taken.size(), blocks);
    }
    EXPECT_NE(seen(*surface, close, {9, 3}).pixel, seen(*surface, close, {9, 4}).pixel);
}

TEST(ViewQueries, aViewThatMissesTheMeshIsEmpty)
{
    const auto surface = surfaceOf(test::gridMesh(2));
    ViewCamera away = kFront;
    away.target = {0.5, 0.5, 4};
    const ViewQueries found = seen(*surface, away);
    EXPECT_EQ(found.size(), 0U);
    EXPECT_EQ(found.asked, 120U * 80U);
}

class Refuses final : public Progress
{
public:
    bool report(double fraction) override { return fraction < 0.3; }
};

TEST(ViewQueries, canBeCancelled)
{
    const auto surface = surfaceOf(test::gridMesh(2));
    ViewCamera large = kFront;
    large.height = 800;
    Refuses progress;
    const auto found = viewQueries(*surface, large, {4, 0}, Threads{2}, progress);
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().kind, ErrorKind::Cancelled);
}

const PixelSubset kHalf{2, 0};
const ViewCamera kHero{"hero", {0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 40, 200, 200};

TEST(Covered, meansNoPointIsSeenCloserThanByAListedCamera)
{
    const auto surface = surfaceOf(test::sphereMesh(3));
    const SceneViews views{{kHero}, {}};
    EXPECT_TRUE(isCovered(*surface, views, kHero, kHalf));
    ViewCamera closer = kHero;
    closer.position.z = 3.9;
    EXPECT_FALSE(isCovered(*surface, views, closer, kHalf));
    ViewCamera sharper = kHero;
    sharper.height = 210;
    sharper.width = 210;
    EXPECT_FALSE(isCovered(*surface, views, sharper, kHalf));
    ViewCamera elsewhere{"", {4, 0, 4}, {0, 0, 1}, {0, 1, 0}, 40, 200, 200};
    elsewhere.fovY = 8; // its middle, from 53 degrees to the side
    elsewhere.width = 30;
    elsewhere.height = 30;
    EXPECT_TRUE(isCovered(*surface, views, elsewhere, kHalf));
    elsewhere.height = 100;
    EXPECT_FALSE(isCovered(*surface, views, elsewhere, kHalf));
}

TEST(Covered, meansNothingIsSeenThatIsHiddenFromAllListedCameras)
{
    const auto surface = surfaceOf(test::sphereMesh(3));
    const SceneViews views{{kHero}, {}};
    ViewCamera behind = kHero;
    behind.position.z = -40;
    EXPECT_FALSE(isCovered(*surface, views, behind, kHalf));
    ViewCamera farther = kHero;
    farther.position.z = 40; // sees farther round it
    EXPECT_FALSE(isCovered(*surface, views, farther, kHalf));
    ViewCamera aside = kHero;
    aside.position = {12, 0, 36};
    EXPECT_FALSE(isCovered(*surface, views, aside, kHalf));

    SceneViews round = views; // every point is seen by one of four
    for (const glm::dvec3 place : {glm::dvec3(0, 40, -24), {-40, -24, -24}, {40, -24, -24}}) {
        ViewCamera camera = kHero;
        camera.position = place;
        camera.up = {0, 0, 1};
        camera.fovY = 4;
        round.cameras.push_back(camera);
    }
    EXPECT_TRUE(isCovered(*surface, round, aside, kHalf));
}

TEST(Covered, needsAPictureThatFramesThePoint)
{
    const auto surface = surfaceOf(test::gridMesh(3));
    ViewCamera half = kFront;
    half.target = {0, 0.5, 0};
    half.fovY = 20; // its right edge at about 0.5
    ViewCamera far = kFront;
    far.position.z = 40;
    far.fovY = 3;
    EXPECT_TRUE(isCovered(*surface, {{kFront}, {}}, far, kHalf));
    EXPECT_FALSE(isCovered(*surface, {{half}, {}}, far, kHalf));
}

TEST(Covered, viewsOfADistanceSeeEveryFaceFromThere)
{
    const auto surface = surfaceOf(test::sphereMesh(3));
    const SceneViews beyond{{}, {{"any", 3, 40, 200, 200}}};
    EXPECT_TRUE(isCovered(*surface, beyond, kHero, kHalf));
    ViewCamera behind = kHero;
    behind.position.z = -4;
    EXPECT_TRUE(isCovered(*surface, beyond, behind, kHalf));
    behind.position.z = -3.2;
    EXPECT_FALSE(isCovered(*surface, beyond, behind, kHalf));
}

} // namespace
} // namespace trixel
