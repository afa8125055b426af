// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where points land by each mapping, and how that changes, against differences of positions.
#include "core/mapping/projection.h"
#include "core/mapping/sphere.h"
#include "core/mapping/sphere_mapping.h"
#include "core/mapping/uv_mapping.h"
#include "core/mesh/surface.h"
#include "tests/core/test_meshes.h"

#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <gmock/gmock.h>

namespace trixel {
namespace {

using testing::HasSubstr;

/// The footprint against differences of places, at a face's middle.
void expectTrueFootprint(const Mapping& mapping, FaceId face, double tolerance = 1e-5)
{
    const glm::dvec2 middle(1.0 / 3);
    const ImagePlace place = mapping.at(face, middle, 1);
    constexpr double kStep = 1e-5;
    const ImagePlace u = mapping.at(face, middle + glm::dvec2(kStep, 0), 1);
    const ImagePlace v = mapping.at(face, middle + glm::dvec2(0, kStep), 1);
    if (!place.lands || !u.lands || !v.lands) {
        return;
    }
    const auto expectNear = [&](glm::dvec2 footprint, glm::dvec2 difference) {
        EXPECT_NEAR(footprint.x, difference.x / kStep, tolerance + 1e-3 * std::abs(footprint.x));
        EXPECT_NEAR(footprint.y, difference.y / kStep, tolerance + 1e-3 * std::abs(footprint.y));
    };
    expectNear(place.footprint.w1, u.st - place.st);
    expectNear(place.footprint.w2, v.st - place.st);
    const ImagePlace half = mapping.at(face, middle, 0.5);
    EXPECT_NEAR(half.footprint.w1.x, 0.5 * place.footprint.w1.x, 1e-12);
}

TriangleMesh gridWithUvs(std::uint32_t n, glm::vec2 scale = {1, 1}, glm::vec2 offset = {0, 0})
{
    TriangleMesh mesh = test::gridMesh(n);
    for (const Triangle& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) {
            mesh.cornerUvs.push_back(glm::vec2(mesh.positions[vertex]) * scale + offset);
        }
    }
    return mesh;
}

TEST(UvMappingTest, interpolatesTheMeshsOwnUvs)
{
    const TriangleMesh mesh = gridWithUvs(3, {2, -1}, {0.5F, 3});
    const UvMapping mapping(mesh);
    for (std::uint32_t k = 0; k < mesh.faceCount(); ++k) {
        const auto p = pointAt(mesh.corners(faceId(k)), 0.2F, 0.5F);
        const ImagePlace place = mapping.at(faceId(k), {0.2, 0.5}, 0.25);
        ASSERT_TRUE(place.lands);
        EXPECT_NEAR(place.st.x, 2 * p.x + 0.5, 1e-6);
        EXPECT_NEAR(place.st.y, 3 - p.y, 1e-6);
        expectTrueFootprint(mapping, faceId(k));
    }
}

TEST(UvMappingTest, facesWithoutUvsAreNotReached)
{
    TriangleMesh mesh = gridWithUvs(1);
    mesh.cornerUvs[1].x = NAN;
    const UvMapping mapping(mesh);
    EXPECT_FALSE(mapping.at(faceId(0), {0.2, 0.2}, 1).lands);
    EXPECT_TRUE(mapping.at(faceId(1), {0.2, 0.2}, 1).lands);
}

TEST(UvMappingTest, tilesAreNumberedTenInARow)
{
    EXPECT_EQ(udimTileAt({0.5, 0.5})->number(), 1001);
    EXPECT_EQ(udimTileAt({1.5, 0.5})->number(), 1002);
    EXPECT_EQ(udimTileAt({0.5, 1.5})->number(), 1011);
    EXPECT_EQ(udimTileAt({9.99, 2})->number(), 1030);
    EXPECT_FALSE(udimTileAt({10, 0}));
    EXPECT_FALSE(udimTileAt({-0.1, 0}));
    EXPECT_FALSE(udimTileAt({NAN, 0}));
    for (int number = 1001; number < 1100; ++number) {
        EXPECT_EQ(udimTile(number)->number(), number);
    }
    EXPECT_FALSE(udimTile(1000));
    EXPECT_FALSE(udimTile(10000));
}

std::string refusal(const TriangleMesh& mesh, const std::vector<UdimTile>& tiles, bool repeats)
{
    const Status status = checkUvs(mesh, tiles, repeats);
    return status ? "accepted" : status.error().message;
}

TEST(UvMappingTest, unusableUvsAreRefusedInASentence)
{
    const std::vector<UdimTile> single = {{0, 0}};
    EXPECT_EQ(refusal(test::gridMesh(1), single, false), "the mesh has no uvs");
    TriangleMesh without = gridWithUvs(1);
    without.cornerUvs.assign(6, glm::vec2(NAN));
    EXPECT_THAT(refusal(without, single, false), HasSubstr("no face has one"));
    EXPECT_THAT(refusal(gridWithUvs(2, {1, 0}), single, false), HasSubstr("without area"));
    EXPECT_EQ(refusal(gridWithUvs(2, {1, 1}, {1e-5F, 0}), single, false), "accepted");
    EXPECT_THAT(refusal(gridWithUvs(2, {1, 1}, {0.1F, 0}), single, false),
                HasSubstr("face 2 reaches (1.1, 0)"));
    EXPECT_THAT(refusal(gridWithUvs(2, {1, 1}, {0, -0.1F}), single, false), HasSubstr("-0.1"));
    EXPECT_EQ(refusal(gridWithUvs(2, {1, 1}, {0.1F, 0}), single, true), "accepted");
    EXPECT_EQ(refusal(gridWithUvs(2, {2, 1}), {{1, 0}, {0, 0}}, false), "accepted");
    EXPECT_THAT(refusal(gridWithUvs(2, {2, 2}), {{0, 0}, {1, 0}, {0, 1}}, false),
                HasSubstr("reach tile 1012 (face 6)"));
    EXPECT_THAT(refusal(gridWithUvs(2, {2, 2}, {-1, 0}), {{0, 0}, {1, 0}}, false),
                HasSubstr("leave all tiles: face 0"));
    EXPECT_THAT(refusal(gridWithUvs(2, {1e30F, 1}), {{0, 0}, {1, 0}}, false),
                HasSubstr("leave all tiles"));
}

TEST(ProjectionTest, aPlaneTakesItsImageStraight)
{
    const TriangleMesh mesh = test::sphereMesh(2);
    const auto plane = planarProjection({-1, -2, 5}, {4, 0, 1}, {0, 4, 0});
    ASSERT_TRUE(plane);
    const ProjectionMapping mapping(mesh, *plane, nullptr);
    for (std::uint32_t k = 0; k < mesh.faceCount(); ++k) {
        expectTrueFootprint(mapping, faceId(k));
    }
    // A point on the plane's own middle, wherever along its normal.
    TriangleMesh one;
    const glm::vec3 p = glm::vec3(-1, -2, 5) + 0.5F * glm::vec3(4, 0, 1) + glm::vec3(0, 2, 0) +
                        7.0F * glm::cross(glm::vec3(4, 0, 1), glm::vec3(0, 4, 0));
    one.positions = {p, p + glm::vec3(0.1F, 0, 0), p + glm::vec3(0, 0.1F, 0)};
    one.triangles = {{0, 1, 2}};
    const ImagePlace place = ProjectionMapping(one, *plane, nullptr).at(faceId(0), {0, 0}, 1);
    EXPECT_TRUE(place.lands);
    EXPECT_NEAR(place.st.x, 0.5, 1e-5);
    EXPECT_NEAR(place.st.y, 0.5, 1e-5);
}

TEST(ProjectionTest, aPlaneWithoutAreaIsRefused)
{
    EXPECT_FALSE(planarProjection({0, 0, 0}, {1, 2, 3}, {2, 4, 6}));
    EXPECT_FALSE(planarProjection({0, 0, 0}, {0, 0, 0}, {0, 1, 0}));
    EXPECT_FALSE(planarProjection({NAN, 0, 0}, {1, 0, 0}, {0, 1, 0}));
}

TEST(ProjectionTest, fourCornersAreTheImagesOwn)
{
    const std::array<glm::dvec3, 4> corners = {
        glm::dvec3(0.1, 0.1, 0), {0.9, 0.2, 0}, {0.8, 0.9, 0}, {0.2, 0.7, 0}};
    const auto quad = quadProjection(corners);
    ASSERT_TRUE(quad) << quad.error().message;
    TriangleMesh mesh;
    for (const glm::dvec3& corner : corners) {
        // Pulled a little inwards, where the image still is.
        const glm::dvec3 p = corner + 1e-6 * (glm::dvec3(0.5, 0.5, 0) - corner);
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(),
                              {glm::vec3(p),
                               glm::vec3(p) + glm::vec3(0.01F, 0, 3),
                               glm::vec3(p) + glm::vec3(0, 0.01F, 3)});
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    const ProjectionMapping mapping(mesh, *quad, nullptr);
    const glm::dvec2 expected[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (std::uint32_t k = 0; k < 4; ++k) {
        const ImagePlace place = mapping.at(faceId(k), {0, 0}, 1);
        ASSERT_TRUE(place.lands) << k;
        EXPECT_NEAR(place.st.x, expected[k].x, 1e-4);
        EXPECT_NEAR(place.st.y, expected[k].y, 1e-4);
    }
    const TriangleMesh grid = test::gridMesh(9);
    const ProjectionMapping over(grid, *quad, nullptr);
    int landed = 0;
    for (std::uint32_t k = 0; k < grid.faceCount(); ++k) {
        expectTrueFootprint(over, faceId(k));
        landed += over.at(faceId(k), {0.3, 0.3}, 1).lands ? 1 : 0;
    }
    EXPECT_GT(landed, 50);
    EXPECT_LT(landed, 120);
}

TEST(ProjectionTest, unusableQuadsAreRefusedInASentence)
{
    const auto refused = [](const std::array<glm::dvec3, 4>& corners) {
        const auto quad = quadProjection(corners);
        return quad ? std::string("accepted") : quad.error().message;
    };
    EXPECT_THAT(refused({glm::dvec3(0, 0, 0), {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}),
                HasSubstr("crosses itself"));
    EXPECT_THAT(refused({glm::dvec3(0, 0, 0), {1, 0, 0}, {0.3, 1, 0}, {0.8, 1.5, 0}}),
                HasSubstr("crosses itself"));
    EXPECT_THAT(refused({glm::dvec3(0, 0, 0), {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}),
                HasSubstr("on a line"));
    EXPECT_THAT(refused({glm::dvec3(1, 1, 1), {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}),
                HasSubstr("on a line"));
    EXPECT_THAT(refused({glm::dvec3(0, 0, 0), {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}),
                HasSubstr("on a line"));
    EXPECT_THAT(refused({glm::dvec3(0, 0, 0), {4, 0, 0}, {1, 1, 0}, {0, 4, 0}}),
                HasSubstr("bends inwards"));
    // A bow-tie whose halves cancel, seen from nowhere as an area.
    EXPECT_THAT(refused({glm::dvec3(0, 0, 0), {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}),
                HasSubstr("crosses itself"));
    EXPECT_THAT(refused({glm::dvec3(NAN, 0, 0), {4, 0, 0}, {1, 1, 0}, {0, 4, 0}}),
                testing::Ne("accepted"));
    EXPECT_EQ(refused({glm::dvec3(0, 0, 0), {0, 1, 0}, {1, 1, 0.1}, {1, 0, 0}}), "accepted");
    const auto flatRefused = [](const Quad& quad) {
        const Status usable = checkQuad(quad);
        return usable ? std::string("accepted") : usable.error().message;
    };
    EXPECT_THAT(flatRefused({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), HasSubstr("crosses itself"));
    EXPECT_THAT(flatRefused({{0, 0}, {1, 1}, {2, 2}, {3, 3}}), HasSubstr("four corners lie on"));
    EXPECT_THAT(flatRefused({{0, 0}, {INFINITY, 1}, {2, 2}, {3, 3}}), HasSubstr("is nowhere"));
}

glm::dmat4 cameraAt(glm::dvec3 position)
{
    return glm::perspective(0.8, 1.5, 0.1, 50.0) *
           glm::lookAt(position, glm::dvec3(0), glm::dvec3(0, 1, 0));
}

TEST(ProjectionTest, aCameraReachesWhatItSeesAndNothingElse)
{
    NoProgress progress;
    const auto surface = Surface::build(test::sphereMesh(3), progress).value();
    const TriangleMesh& mesh = surface->mesh();
    const glm::dvec3 eye(0.5, 1, 4);
    for (const bool isPerspective : {true, false}) {
        const glm::dmat4 view = glm::lookAt(eye, glm::dvec3(0), glm::dvec3(0, 1, 0));
        const auto camera = cameraProjection(
            isPerspective ? cameraAt(eye) : glm::ortho(-2.0, 2.0, -2.0, 2.0, 0.1, 50.0) * view);
        ASSERT_TRUE(camera);
        const ProjectionMapping mapping(mesh, *camera, &surface->bvh());
        for (std::uint32_t k = 0; k < mesh.faceCount(); ++k) {
            const auto corners = mesh.corners(faceId(k));
            const glm::dvec3 middle =
                (glm::dvec3(corners[0]) + glm::dvec3(corners[1]) + glm::dvec3(corners[2])) / 3.0;
            const glm::dvec3 normal(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
            const glm::dvec3 towards = isPerspective ? eye - middle : eye;
            const bool faces = glm::dot(normal, towards) > 0;
            const ImagePlace place = mapping.at(faceId(k), {1.0 / 3, 1.0 / 3}, 1);
            EXPECT_EQ(place.lands, faces) << k;
            expectTrueFootprint(mapping, faceId(k));
        }
    }
}

TEST(ProjectionTest, whatIsHiddenIsNotReachedUnlessAskedFor)
{
    // Two squares one behind the other, the nearer one half as large.
    TriangleMesh mesh = test::gridMesh(2);
    const TriangleMesh behind = mesh;
    for (glm::vec3& p : mesh.positions) {
        p = glm::vec3(0.25F, 0.25F, 1) + 0.5F * p;
    }
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), behind.positions.begin(), behind.positions.end());
    for (const Triangle& t : behind.triangles) {
        mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
    NoProgress progress;
    const auto surface = Surface::build(mesh, progress).value();
    auto plane = planarProjection({0, 0, 3}, {1, 0, 0}, {0, 1, 0});
    ASSERT_TRUE(plane);
    const auto reached = [&](bool visibleOnly) {
        plane->visibleOnly = visibleOnly;
        const ProjectionMapping mapping(surface->mesh(), *plane, &surface->bvh());
        std::size_t landed = 0;
        for (std::uint32_t k = 0; k < surface->mesh().faceCount(); ++k) {
            for (const glm::dvec2 uv : {glm::dvec2(0.1, 0.1), {0.8, 0.1}, {0.1, 0.8}}) {
                landed += mapping.at(faceId(k), uv, 1).lands ? 1U : 0U;
            }
        }
        return landed;
    };
    EXPECT_EQ(reached(false), 48U);
    // Of the 24 points behind, 6 lie within the middle half of both x and y.
    EXPECT_EQ(reached(true), 24U + 18U);
}

TEST(ProjectionTest, behindTheCameraNothingLands)
{
    const TriangleMesh mesh = test::sphereMesh(1);
    auto camera = cameraProjection(cameraAt({0.2, 0.1, 0.3})); // within the sphere
    ASSERT_TRUE(camera);
    camera->frontOnly = camera->visibleOnly = false;
    const ProjectionMapping mapping(mesh, *camera, nullptr);
    for (std::uint32_t k = 0; k < mesh.faceCount(); ++k) {
        const ImagePlace place = mapping.at(faceId(k), {1.0 / 3, 1.0 / 3}, 1);
        const auto c = mesh.corners(faceId(k));
        const glm::dvec3 middle = (glm::dvec3(c[0]) + glm::dvec3(c[1]) + glm::dvec3(c[2])) / 3.0;
        const bool ahead =
            glm::dot(middle - glm::dvec3(0.2, 0.1, 0.3), -glm::dvec3(0.2, 0.1, 0.3)) > 0;
        EXPECT_TRUE(ahead || !place.lands);
        EXPECT_TRUE(std::isfinite(place.footprint.w1.x));
    }
    EXPECT_FALSE(cameraProjection(glm::dmat4(0)));
}

TEST(SphereMappingTest, goesOnceRoundAndFromPoleToPole)
{
    const TriangleMesh mesh = test::sphereMesh(3);
    const SphereMapping mapping(mesh, {0, 0, 0}, glm::dmat3(1));
    for (std::uint32_t k = 0; k < mesh.faceCount(); ++k) {
        const auto c = mesh.corners(faceId(k));
        const glm::dvec3 p = (glm::dvec3(c[0]) + glm::dvec3(c[1]) + glm::dvec3(c[2])) / 3.0;
        const ImagePlace place = mapping.at(faceId(k), {1.0 / 3, 1.0 / 3}, 1);
        EXPECT_TRUE(place.lands);
        EXPECT_NEAR(place.st.x, sphereUv(p).x, 1e-7);
        EXPECT_NEAR(place.st.y, sphereUv(p).y, 1e-7);
        if (place.st.x > 0.02 && place.st.x < 0.98 && std::abs(place.st.y - 0.5) < 0.3) {
            expectTrueFootprint(mapping, faceId(k), 1e-4);
        }
        EXPECT_LE(std::hypot(place.footprint.w1.x, place.footprint.w2.x), 1 + 1e-9);
    }
}

TEST(SphereMappingTest, theSeamDoesNotWidenFootprints)
{
    // A face across the seam, which is at x = 0, z < 0.
    TriangleMesh mesh;
    mesh.positions = {{-0.1F, 0, -1}, {0.1F, 0, -1}, {0, 0.1F, -1}};
    mesh.triangles = {{1, 0, 2}};
    const SphereMapping mapping(mesh, {0, 0, 0}, glm::dmat3(1));
    for (const double u : {0.2, 0.5, 0.8}) {
        const ImagePlace place = mapping.at(faceId(0), {u, 0.1}, 0.25);
        EXPECT_LT(std::abs(place.footprint.w1.x), 0.02);
        EXPECT_GT(std::abs(place.footprint.w1.x), 0.004);
    }
}

} // namespace
} // namespace trixel
