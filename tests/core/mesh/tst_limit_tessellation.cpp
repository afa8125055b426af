// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/limit_mesh.h"
#include "core/mesh/limit_tessellation.h"
#include "core/mesh/loop_refinement.h"
#include "tests/core/cancel_after.h"
#include "tests/core/mesh/cages.h"
#include "tests/core/mesh/meshes.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <map>

namespace trixel {
namespace {

using namespace test;

std::shared_ptr<const LimitBends> bendsOf(const TriangleMesh& cage,
                                          std::vector<Crease> creases = {})
{
    NoProgress progress;
    return LimitBends::measure(LimitSurface::build(cage, {std::move(creases), {}}).value(),
                               Threads::all(),
                               progress)
        .value();
}

std::shared_ptr<const LimitTessellation> cut(const std::shared_ptr<const LimitBends>& bends,
                                             const LimitDemand& demand,
                                             std::shared_ptr<const LimitTessellation> before = {},
                                             Threads threads = Threads::all())
{
    NoProgress progress;
    return LimitTessellation::make(bends, demand, std::move(before), threads, progress).value();
}

/// A picture of 1000 × 700 pixels.
PictureView lookFrom(glm::dvec3 eye, glm::dvec3 target = glm::dvec3(0), double focalLength = 1100)
{
    return {glm::lookAt(eye, target, glm::dvec3(0.1, 1, 0.2)), focalLength, {500, 350}, 0.01};
}

std::optional<glm::dvec2> pixelOf(const PictureView& view, glm::dvec3 point)
{
    const glm::dvec3 p(view.toCamera * glm::dvec4(point, 1));
    if (-p.z < view.nearestDepth) {
        return std::nullopt;
    }
    const glm::dvec2 pixel = glm::dvec2(p) * view.focalLength / -p.z;
    const bool isInside =
        std::abs(pixel.x) < view.halfSize.x && std::abs(pixel.y) < view.halfSize.y;
    return isInside ? std::optional(pixel) : std::nullopt;
}

/// The most that points of triangles are off the points of their (u,v), in pixels and world units.
struct Off
{
    double pixels = 0;
    double world = 0;
    int seen = 0;
};

Off measuredError(const LimitTessellation& cut, const PictureView& view)
{
    constexpr int kSide = 4;
    Off off;
    LimitSurface::Evaluator evaluator(cut.surface());
    for (std::size_t k = 0; k < cut.triangles().size(); ++k) {
        const Triangle& t = cut.triangles()[k];
        const auto& v = cut.vertices();
        evaluator.moveTo(cut.faceOf(k));
        for (int j = 0; j <= kSide; ++j) {
            for (int i = 0; i + j <= kSide; ++i) {
                const double b = static_cast<double>(i) / kSide;
                const double c = static_cast<double>(j) / kSide;
                const double a = 1 - b - c;
                const glm::dvec2 uv = a * glm::dvec2(v[t[0]].uv) + b * glm::dvec2(v[t[1]].uv) +
                                      c * glm::dvec2(v[t[2]].uv);
                const glm::dvec3 flat = a * glm::dvec3(v[t[0]].position) +
                                        b * glm::dvec3(v[t[1]].position) +
                                        c * glm::dvec3(v[t[2]].position);
                const glm::dvec3 curved = evaluator.position(uv);
                off.world = std::max(off.world, glm::distance(flat, curved));
                const auto p = pixelOf(view, flat);
                const auto q = pixelOf(view, curved);
                if (p && q) {
                    ++off.seen;
                    off.pixels = std::max(off.pixels, glm::distance(*p, *q));
                }
            }
        }
    }
    return off;
}

TriangleMesh bumpy()
{
    TriangleMesh mesh = loopRefined(icosahedron(), 1).value();
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        mesh.positions[v] *= 1.0F + 0.3F * std::sin(static_cast<float>(7 * v));
    }
    mesh.sourceFaces.clear();
    return mesh;
}

std::vector<TriangleMesh> cages()
{
    std::vector<TriangleMesh> all = {
        regularTetrahedron(), octahedron(), icosahedron(), hexagon(1), bumpy()};
    for (const std::uint32_t valence : {3U, 5U, 7U, 10U}) {
        all.push_back(bipyramid(valence));
        all.push_back(fan(valence));
    }
    return all;
}

bool isCutFinest(const LimitTessellation& cut)
{
    bool some = false;
    for (std::size_t f = 0; f < cut.surface().faceCount(); ++f) {
        some = some || cut.rates(faceId(f)).inside == kMaxRate;
    }
    return some;
}

TEST(LimitTessellation, everyPointIsWithinTheStatedErrorOnTheScreen)
{
    for (const TriangleMesh& cage : cages()) {
        const auto bends = bendsOf(cage);
        for (const PictureView& view : {lookFrom({0, 0, 5}),
                                        lookFrom({2.2, 1, 0.3}),
                                        lookFrom({-40, 7, 3}),
                                        lookFrom({0.5, 0.3, 2.4}, {0.7, 0.4, 0})}) {
            for (const double error : {1.0, 4.0}) {
                const auto made = cut(bends, {ErrorScale::ofPicture(view), error});
                const Off off = measuredError(*made, view);
                EXPECT_TRUE(made->error() <= error || isCutFinest(*made));
                EXPECT_LE(off.pixels, made->error()) << cage.faceCount() << " faces";
                EXPECT_GT(off.seen, 0);
            }
        }
    }
}

TEST(LimitTessellation, everyPointIsWithinTheStatedErrorInTheWorld)
{
    for (const TriangleMesh& cage : cages()) {
        for (const double error : {0.05, 0.003}) {
            const auto made = cut(bendsOf(cage), {ErrorScale::ofWorld(), error});
            EXPECT_LE(made->error(), error);
            EXPECT_LE(measuredError(*made, lookFrom({0, 0, 5})).world, made->error())
                << cage.faceCount() << " faces";
        }
    }
}

TEST(LimitTessellation, takesNoManyTimesMoreThanItMust)
{
    // A quarter of the error takes four times the triangles.
    const auto bends = bendsOf(icosahedron());
    const auto few = cut(bends, {ErrorScale::ofPicture(lookFrom({0, 0, 5})), 2});
    const auto many = cut(bends, {ErrorScale::ofPicture(lookFrom({0, 0, 5})), 0.5});
    const double ratio = static_cast<double>(many->triangles().size()) /
                         static_cast<double>(few->triangles().size());
    EXPECT_GT(ratio, 2);
    EXPECT_LT(ratio, 8);
    EXPECT_GT(measuredError(*many, lookFrom({0, 0, 5})).pixels, 0.1);
    // What is flat, and what is far away, stays as it is.
    EXPECT_EQ(cut(bends, {ErrorScale::ofPicture(lookFrom({0, 0, 5000})), 0.5})->triangles().size(),
              20U);
    const auto plane = bendsOf(gridMesh(8));
    const auto flat = cut(plane, {ErrorScale::ofPicture(lookFrom({4, 4, 9}, {4, 4, 0})), 0.5});
    const FaceId inner = faceId(2 * (8 * 4 + 4));
    EXPECT_EQ(flat->rates(inner), CutRates());
}

TEST(LimitTessellation, facesOutOfViewStayWhole)
{
    const auto bends = bendsOf(bumpy());
    const PictureView away = lookFrom({0, 0, 5}, {0, 0, 10});
    const auto made = cut(bends, {ErrorScale::ofPicture(away), 0.5});
    EXPECT_EQ(made->triangles().size(), bends->faces().size());
    EXPECT_EQ(made->error(), 0);
}

/// Sides of triangles by the places of their ends, and how often each is run along.
using Sides = std::map<std::pair<std::array<float, 3>, std::array<float, 3>>, int>;

Sides sidesOf(const LimitTessellation& cut)
{
    const auto place = [&](std::uint32_t vertex) {
        const glm::vec3 p = cut.vertices()[vertex].position;
        return std::array{p.x, p.y, p.z};
    };
    Sides sides;
    for (const Triangle& t : cut.triangles()) {
        for (std::size_t k = 0; k < 3; ++k) {
            ++sides[{place(t[k]), place(t[(k + 1) % 3])}];
        }
    }
    return sides;
}

TEST(LimitTessellation, closedCagesHaveNoCracksToTheBit)
{
    int joined = 0; // faces whose rates differ
    for (const TriangleMesh& cage :
         {octahedron(), icosahedron(), bumpy(), bipyramid(7), bipyramid(10)}) {
        const auto bends = bendsOf(cage);
        for (const PictureView& view :
             {lookFrom({2.2, 1, 0.3}), lookFrom({0.5, 0.3, 2.4}, {0.7, 0.4, 0})}) {
            const auto made = cut(bends, {ErrorScale::ofPicture(view), 2});
            for (std::size_t f = 0; f < cage.faceCount(); ++f) {
                const CutRates& rates = made->rates(faceId(f));
                joined += rates.edges[0] != rates.edges[1] ? 1 : 0;
            }
            int open = 0;
            const Sides sides = sidesOf(*made);
            for (const auto& [side, times] : sides) {
                const auto back = sides.find({side.second, side.first});
                open += back == sides.end() || back->second != times ? 1 : 0;
            }
            EXPECT_EQ(open, 0);
        }
    }
    EXPECT_GT(joined, 20);
}

TEST(LimitTessellation, verticesLieOnTheLimitAtTheirUvWithItsNormal)
{
    const auto made = cut(bendsOf(bumpy()), {ErrorScale::ofWorld(), 0.01});
    for (const LimitVertex& v : made->vertices()) {
        const LimitPoint p = made->surface().at(faceId(v.face), glm::dvec2(v.uv));
        EXPECT_LT(glm::distance(glm::dvec3(v.position), p.position), 1e-6);
        EXPECT_TRUE(v.uv.x >= 0 && v.uv.y >= 0 && v.uv.x + v.uv.y <= 1.000001F);
    }
}

TEST(LimitTessellation, trianglesFaceAsTheirFacesDoAndCoverThem)
{
    const auto made = cut(bendsOf(icosahedron()), {ErrorScale::ofPicture(lookFrom({2, 1, 0})), 1});
    std::vector<double> area(20);
    for (std::size_t k = 0; k < made->triangles().size(); ++k) {
        const Triangle& t = made->triangles()[k];
        const auto& v = made->vertices();
        const glm::vec3 normal =
            glm::cross(v[t[1]].position - v[t[0]].position, v[t[2]].position - v[t[0]].position);
        EXPECT_GT(glm::dot(normal, v[t[0]].position), 0);
        const glm::vec2 a = v[t[1]].uv - v[t[0]].uv, b = v[t[2]].uv - v[t[0]].uv;
        area[indexOf(made->faceOf(k))] += double{a.x} * b.y - double{a.y} * b.x;
    }
    for (const double of : area) {
        EXPECT_NEAR(of, 1, 1e-5);
    }
}

TEST(LimitTessellation, whatCameBeforeAndTheThreadsChangeNoBit)
{
    const auto bends = bendsOf(bumpy());
    const LimitDemand near{ErrorScale::ofPicture(lookFrom({2.2, 1, 0.3}))};
    const LimitDemand nearer{ErrorScale::ofPicture(lookFrom({1.9, 1.1, 0.3}))};
    const auto before = cut(bends, near);
    const auto after = cut(bends, nearer, before);
    const auto fresh = cut(bends, nearer, {}, {1});
    EXPECT_TRUE(std::ranges::equal(after->vertices(), fresh->vertices()));
    EXPECT_TRUE(std::ranges::equal(after->triangles(), fresh->triangles()));
    EXPECT_FALSE(before->isAsDemanded(nearer));
    EXPECT_TRUE(after->isAsDemanded(nearer));
}

TEST(LimitTessellation, tooManyTrianglesBecomeFewerAndSayTheirError)
{
    const auto bends = bendsOf(icosahedron());
    LimitDemand demand{ErrorScale::ofPicture(lookFrom({0, 0, 3})), 0.01};
    demand.mostTriangles = 2000;
    const auto made = cut(bends, demand);
    EXPECT_LT(made->triangles().size(), 2000U);
    EXPECT_GT(made->error(), 0.01);
    EXPECT_LE(measuredError(*made, lookFrom({0, 0, 3})).pixels, made->error());
}

TEST(LimitTessellation, messyMeshesAreCutAsWell)
{
    for (unsigned seed = 0; seed < 40; ++seed) {
        TriangleMesh mesh = messyMesh(6, 4 + seed % 9, seed);
        std::erase_if(mesh.triangles, [](const Triangle& t) { return repeatsVertex(t); });
        if (mesh.triangles.empty()) {
            continue;
        }
        const auto made = cut(bendsOf(mesh), {ErrorScale::ofWorld(), 0.02});
        EXPECT_LE(measuredError(*made, lookFrom({0, 0, 5})).world, made->error());
        for (const LimitVertex& v : made->vertices()) {
            EXPECT_TRUE(std::isfinite(v.position.x + v.position.y + v.position.z));
        }
    }
}

TEST(LimitTessellation, creasesStayInTheCut)
{
    const std::vector<Crease> creases = {{0, 11}, {0, 5}, {0, 1}};
    const auto made = cut(bendsOf(icosahedron(), creases), {ErrorScale::ofWorld(), 0.004});
    EXPECT_LE(measuredError(*made, lookFrom({0, 0, 5})).world, made->error());
}

TEST(LimitTessellation, semiSharpCreasesAreWithinTheStatedErrorToo)
{
    for (const float sharpness : {0.3F, 1.0F, 2.0F, 2.7F, 3.5F, 5.0F, 7.0F, 9.0F, kSharp}) {
        const std::vector<Crease> creases = {
            {4, 5, sharpness}, {5, 7, sharpness}, {7, 6, sharpness}, {6, 4, sharpness}};
        const auto bends = bendsOf(cube(), creases);
        for (const double error : {0.05, 0.01, 0.002}) {
            const auto made = cut(bends, {ErrorScale::ofWorld(), error});
            EXPECT_TRUE(made->error() <= error || isCutFinest(*made));
            EXPECT_LE(measuredError(*made, lookFrom({0, 0, 5})).world, made->error())
                << sharpness << " at " << error;
        }
    }
}

TEST(LimitTessellation, canBeCancelled)
{
    const auto limit = LimitSurface::build(icosahedron()).value();
    CancelAfter none(0);
    EXPECT_EQ(LimitBends::measure(limit, {1}, none).error().kind, ErrorKind::Cancelled);
    const auto bends = bendsOf(icosahedron());
    CancelAfter again(0);
    EXPECT_EQ(LimitTessellation::make(bends, {}, {}, {1}, again).error().kind,
              ErrorKind::Cancelled);
}

TEST(LimitMesh, raysMeetTheCageFaceTheyAreSeenOn)
{
    const auto made = cut(bendsOf(bumpy()), {ErrorScale::ofWorld(), 0.001});
    const auto mesh = LimitMesh::build(made);
    const glm::vec3 eye(3, 2, 4);
    int hits = 0;
    for (std::size_t f = 0; f < 80; ++f) {
        for (const glm::vec2 uv : {glm::vec2(0.3F, 0.3F), {0.1F, 0.7F}, {0.6F, 0.2F}}) {
            const LimitPoint p = made->surface().at(faceId(f), glm::dvec2(uv));
            const auto hit = mesh->raycast({eye, glm::vec3(p.position) - eye});
            if (!hit) { // on the outline
                EXPECT_LT(std::abs(glm::dot(p.normal(), glm::dvec3(eye) - p.position)), 0.5);
                continue;
            }
            // Whatever is met first lies on the limit at its own (u,v), close to the ray.
            const glm::dvec3 there = made->surface().at(hit->face, glm::dvec2(hit->uv)).position;
            EXPECT_LT(glm::distance(there, glm::dvec3(hit->position)), 1e-6);
            if (glm::dot(p.normal(), glm::dvec3(eye) - p.position) > 0.3 &&
                hit->face == faceId(f)) {
                ++hits;
                EXPECT_LT(glm::distance(hit->uv, uv), 0.02F);
            }
        }
    }
    EXPECT_GT(hits, 50);
    EXPECT_FALSE(mesh->raycast({eye, eye}));
}

TEST(LimitMesh, findsFacesWithinAndTheNearestPoint)
{
    const auto made = cut(bendsOf(icosahedron()), {ErrorScale::ofWorld(), 0.001});
    const auto mesh = LimitMesh::build(made);
    const glm::dvec3 centre = made->surface().at(faceId(7), {1.0 / 3, 1.0 / 3}).position;
    std::vector<FaceId> faces;
    mesh->facesWithin(glm::vec3(centre), 0.05F, faces);
    EXPECT_THAT(faces, testing::ElementsAre(faceId(7)));
    faces.clear();
    mesh->facesWithin(glm::vec3(centre), 10.0F, faces);
    EXPECT_EQ(faces.size(), 20U);
    const auto nearest = mesh->closestPoint(glm::vec3(2.0 * centre), 10);
    ASSERT_TRUE(nearest);
    EXPECT_EQ(nearest->face, faceId(7));
    EXPECT_LT(glm::distance(glm::dvec3(nearest->position), centre), 0.02);
}

} // namespace
} // namespace trixel
