// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/bvh.h"
#include "core/mesh/bvh_build.h"
#include "core/mesh/triangle_geometry.h"
#include "tests/core/test_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

using namespace trixel;

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

class Points
{
public:
    explicit Points(std::uint32_t seed)
        : m_random(seed)
    {
    }
    float next(float reach)
    {
        return std::uniform_real_distribution<float>(-reach, reach)(m_random);
    }
    glm::vec3 point(float reach)
    {
        const float x = next(reach);
        const float y = next(reach);
        return {x, y, next(reach)};
    }

private:
    std::mt19937 m_random;
};

/// Distance to a triangle by Ericson's case analysis in long double; degenerate ones by edges.
long double bruteDistance(const std::array<glm::vec3, 3>& corners, glm::vec3 p)
{
    using V = glm::tvec3<long double>;
    const std::array<V, 3> c{V(corners[0]), V(corners[1]), V(corners[2])};
    const V q(p);
    long double best = std::numeric_limits<long double>::max();
    for (std::size_t k = 0; k < 3; ++k) {
        const V a = c[k];
        const V d = c[(k + 1) % 3] - a;
        const long double length = glm::dot(d, d);
        const long double t =
            length > 0 ? std::clamp(glm::dot(q - a, d) / length, 0.0L, 1.0L) : 0.0L;
        best = std::min(best, glm::length(q - a - t * d));
    }
    const V n = glm::cross(c[1] - c[0], c[2] - c[0]);
    bool inside = glm::dot(n, n) > 0;
    for (std::size_t k = 0; k < 3 && inside; ++k) {
        inside = glm::dot(glm::cross(c[(k + 1) % 3] - c[k], q - c[k]), n) >= 0;
    }
    return inside ? std::min(best, std::abs(glm::dot(q - c[0], n)) / glm::length(n)) : best;
}

/// t of a ray against a triangle by solving the linear system (Cramer), in long double.
std::optional<long double> bruteHit(const std::array<glm::vec3, 3>& corners, const Ray& ray)
{
    using V = glm::tvec3<long double>;
    const V a(corners[0]);
    const V e1 = V(corners[1]) - a;
    const V e2 = V(corners[2]) - a;
    const V d(ray.direction);
    const long double det = glm::dot(e1, glm::cross(d, e2));
    if (std::abs(det) < 1e-12L || isDegenerate(corners)) {
        return std::nullopt;
    }
    const V s = V(ray.origin) - a;
    const long double u = glm::dot(s, glm::cross(d, e2)) / det;
    const long double v = glm::dot(d, glm::cross(s, e1)) / det;
    const long double t = glm::dot(e2, glm::cross(s, e1)) / det;
    return u >= 0 && v >= 0 && u + v <= 1 && t >= 0 ? std::optional(t) : std::nullopt;
}

} // namespace

TEST(Bvh, facesWithinFindsWhatBruteForceFindsDegenerateFacesIncluded)
{
    const TriangleMesh mesh = test::soupMesh(3000, 1);
    const Bvh bvh(mesh);
    Points points(2);
    std::size_t degenerate = 0;
    for (int k = 0; k < 200; ++k) {
        const glm::vec3 centre = points.point(1.2F);
        const float radius = std::exp2(points.next(4.0F) - 3.0F);
        std::vector<FaceId> found;
        bvh.facesWithin(centre, radius, found);
        EXPECT_TRUE(std::ranges::is_sorted(found));
        EXPECT_EQ(std::ranges::adjacent_find(found), found.end());
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            const auto corners = mesh.corners(faceId(f));
            const long double distance = bruteDistance(corners, centre);
            const bool has = std::ranges::binary_search(found, faceId(f));
            degenerate += has && isDegenerate(corners) ? 1 : 0;
            if (std::abs(distance - radius) > 1e-9L) {
                EXPECT_EQ(has, distance < radius) << "face " << f;
            }
        }
    }
    EXPECT_GT(degenerate, 1000U);
}

TEST(Bvh, closestPointIsAsNearAsBruteForceSays)
{
    const TriangleMesh mesh = test::soupMesh(2000, 3);
    const Bvh bvh(mesh);
    Points points(4);
    std::size_t degenerate = 0;
    for (int k = 0; k < 500; ++k) {
        const glm::vec3 p = points.point(1.5F);
        long double nearest = std::numeric_limits<long double>::max();
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            nearest = std::min(nearest, bruteDistance(mesh.corners(faceId(f)), p));
        }
        const auto found = bvh.closestPoint(p, kInfinity);
        ASSERT_TRUE(found);
        const auto corners = mesh.corners(found->face);
        degenerate += isDegenerate(corners) ? 1 : 0;
        EXPECT_NEAR(
            static_cast<double>(bruteDistance(corners, p)), static_cast<double>(nearest), 1e-9);
        EXPECT_NEAR(glm::length(found->position - p), static_cast<double>(nearest), 1e-6);
        EXPECT_GE(found->uv.x, 0.0F);
        EXPECT_GE(found->uv.y, 0.0F);
        EXPECT_LE(found->uv.x + found->uv.y, 1.0F);
        const auto reach = static_cast<float>(nearest);
        EXPECT_TRUE(bvh.closestPoint(p, reach * 1.0001F));
        EXPECT_FALSE(bvh.closestPoint(p, reach * 0.9999F));
    }
    EXPECT_GT(degenerate, 10U);
}

TEST(Bvh, raycastMeetsTheNearestFaceThatBruteForceMeets)
{
    const TriangleMesh mesh = test::soupMesh(2000, 5);
    const Bvh bvh(mesh);
    Points points(6);
    int hits = 0;
    for (int k = 0; k < 1000; ++k) {
        Ray ray{points.point(1.5F), points.point(1.0F)};
        if (k % 4 == 0) {
            ray.direction[k % 3] = 0; // along a plane of the boxes
        }
        if (k % 8 == 0) {
            ray.direction[(k + 1) % 3] = 0;
        }
        std::optional<long double> nearest;
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            const auto t = bruteHit(mesh.corners(faceId(f)), ray);
            nearest = t && (!nearest || *t < *nearest) ? t : nearest;
        }
        const auto found = bvh.raycast(ray);
        ASSERT_EQ(found.has_value(), nearest.has_value()) << "ray " << k;
        if (found) {
            ++hits;
            EXPECT_FALSE(isDegenerate(mesh.corners(found->face)));
            const glm::vec3 expected = ray.origin + static_cast<float>(*nearest) * ray.direction;
            EXPECT_NEAR(glm::length(found->position - expected), 0.0F, 2e-6F);
        }
    }
    EXPECT_GT(hits, 300);
}

TEST(Bvh, raysNeverSlipBetweenFacesThatShareAnEdge)
{
    TriangleMesh mesh = test::sphereMesh(3);
    for (glm::vec3& p : mesh.positions) {
        p = 3.7F * p + glm::vec3(100.1F, -57.3F, 11.9F);
    }
    const glm::vec3 centre(100.1F, -57.3F, 11.9F);
    const Bvh bvh(mesh);
    // Through every vertex and along every edge, from inside.
    for (const auto& [a, b, c] : mesh.triangles) {
        for (const float t : {0.0F, 0.25F, 0.5F, 0.9F}) {
            const glm::vec3 target =
                mesh.positions[a] + t * (mesh.positions[b] - mesh.positions[a]);
            EXPECT_TRUE(bvh.raycast({centre, target - centre}));
        }
        EXPECT_TRUE(bvh.raycast({centre, mesh.positions[c] - centre}));
    }
}

TEST(Bvh, raycastSeesBothSidesAndOnlyForwards)
{
    const TriangleMesh mesh = test::gridMesh(4);
    const Bvh bvh(mesh);
    EXPECT_TRUE(bvh.raycast({{0.3F, 0.3F, 1}, {0, 0, -1}}));
    EXPECT_TRUE(bvh.raycast({{0.3F, 0.3F, -1}, {0, 0, 1}}));
    EXPECT_FALSE(bvh.raycast({{0.3F, 0.3F, 1}, {0, 0, 1}}));
    EXPECT_FALSE(bvh.raycast({{1.3F, 0.3F, 1}, {0, 0, -1}}));
    const auto hit = bvh.raycast({{0.3F, 0.3F, 7}, {0, 0, -1e-20F}});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(glm::length(hit->position - glm::vec3(0.3F, 0.3F, 0)), 0.0F, 1e-6F);
}

TEST(Bvh, coincidentFacesAreAllFoundAndTheLowestIsHit)
{
    TriangleMesh mesh = test::gridMesh(2);
    const Triangle twice = mesh.triangles[3];
    for (int k = 0; k < 40; ++k) {
        mesh.triangles.push_back(twice);
    }
    const Bvh bvh(mesh);
    const auto corners = mesh.corners(faceId(3));
    const glm::vec3 middle = pointAt(corners, 0.3F, 0.3F);
    std::vector<FaceId> found;
    bvh.facesWithin(middle, 0.01F, found);
    EXPECT_EQ(found.size(), 41U);
    EXPECT_EQ(bvh.raycast({middle + glm::vec3(0, 0, 1), {0, 0, -1}})->face, faceId(3));
    EXPECT_EQ(bvh.closestPoint(middle, 1.0F)->face, faceId(3));
}

TEST(Bvh, valuesThatAreNotNumbersFindNothing)
{
    const TriangleMesh mesh = test::gridMesh(2);
    const Bvh bvh(mesh);
    std::vector<FaceId> found;
    bvh.facesWithin({kNan, 0, 0}, 1, found);
    bvh.facesWithin({0, 0, 0}, kNan, found);
    bvh.facesWithin({0, 0, 0}, -1, found);
    EXPECT_TRUE(found.empty());
    EXPECT_FALSE(bvh.closestPoint({kNan, 0, 0}, 1));
    EXPECT_FALSE(bvh.closestPoint({0, 0, 0}, kNan));
    EXPECT_FALSE(bvh.raycast({{0.1F, 0.1F, 1}, {0, 0, 0}}));
    EXPECT_FALSE(bvh.raycast({{0.1F, 0.1F, 1}, {0, kNan, -1}}));
    EXPECT_FALSE(bvh.raycast({{0.1F, 0.1F, kInfinity}, {0, 0, -1}}));
}

TEST(Bvh, anEmptyMeshFindsNothing)
{
    const TriangleMesh mesh;
    const Bvh bvh(mesh);
    std::vector<FaceId> found;
    bvh.facesWithin({0, 0, 0}, 1, found);
    EXPECT_TRUE(found.empty());
    EXPECT_FALSE(bvh.closestPoint({0, 0, 0}, kInfinity));
    EXPECT_FALSE(bvh.raycast({}));
}

TEST(Bvh, theTreeDoesNotDependOnThreadsAndItsDepthIsBounded)
{
    // Sizes that halve from face to face drive a heuristic split towards a list.
    TriangleMesh mesh = test::soupMesh(20000, 7);
    for (std::size_t k = 0; k < mesh.positions.size(); ++k) {
        mesh.positions[k] *= std::exp2(-static_cast<float>(k % 120));
    }
    const BvhTree one = buildBvh(mesh, Threads{1});
    const BvhTree four = buildBvh(mesh, Threads{4});
    ASSERT_EQ(one.nodes.size(), four.nodes.size());
    for (std::size_t k = 0; k < one.nodes.size(); ++k) {
        ASSERT_EQ(one.nodes[k].first, four.nodes[k].first);
        ASSERT_EQ(one.nodes[k].count, four.nodes[k].count);
    }
    EXPECT_EQ(one.faces, four.faces);

    std::vector<int> depth(one.nodes.size(), 0);
    std::size_t faces = 0;
    for (std::size_t k = 0; k < one.nodes.size(); ++k) {
        const BvhNode& node = one.nodes[k];
        faces += node.count;
        if (!node.isLeaf()) {
            ASSERT_GT(node.first, k); // children follow, so one pass is enough
            depth[node.first] = depth[node.first + 1] = depth[k] + 1;
        }
    }
    EXPECT_EQ(faces, mesh.faceCount());
    EXPECT_LE(*std::ranges::max_element(depth), kBvhMaxDepth);
}

TEST(Bvh, hugeCoordinatesAreSearchedToo)
{
    TriangleMesh mesh = test::gridMesh(16);
    for (glm::vec3& p : mesh.positions) {
        p = (p - glm::vec3(0.5F, 0.5F, 0)) * 3e38F * 2.0F;
    }
    const Bvh bvh(mesh);
    EXPECT_TRUE(bvh.raycast({{1e37F, 2e37F, 1e37F}, {0, 0, -1}}));
    EXPECT_TRUE(bvh.closestPoint({1e37F, 2e37F, 1e37F}, kInfinity));
}

TEST(Bvh, memoryIsAboutTwentyFiveBytesAFace)
{
    const TriangleMesh mesh = test::sphereMesh(5);
    const Bvh bvh(mesh);
    EXPECT_LT(bvh.memoryBytes(), 27 * mesh.faceCount());
}
