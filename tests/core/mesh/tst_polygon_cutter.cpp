// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/polygon_cutter.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <numeric>
#include <random>

namespace trixel {
namespace {

using Points = std::vector<glm::vec3>;

std::vector<Triangle> cut(const Points& points)
{
    std::vector<std::uint32_t> corners(points.size());
    std::iota(corners.begin(), corners.end(), 0U);
    std::vector<Triangle> triangles(points.size() - 2);
    cutPolygon(points, corners, triangles);
    return triangles;
}

double areaZ(const Points& p, const Triangle& t)
{
    const glm::dvec3 a(p[t[0]]);
    return glm::cross(glm::dvec3(p[t[1]]) - a, glm::dvec3(p[t[2]]) - a).z / 2;
}

double polygonAreaZ(const Points& p)
{
    double area = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const glm::dvec3 a(p[i]);
        const glm::dvec3 b(p[(i + 1) % p.size()]);
        area += (a.x * b.y - a.y * b.x) / 2;
    }
    return area;
}

// All triangles face up and fill the polygon: none is inverted, none overlaps.
void expectCovers(const Points& points)
{
    double area = 0;
    for (const Triangle& t : cut(points)) {
        EXPECT_GE(areaZ(points, t), 0) << t[0] << ' ' << t[1] << ' ' << t[2];
        area += std::abs(areaZ(points, t));
    }
    EXPECT_NEAR(area, polygonAreaZ(points), 1e-5 * area);
}

// Corners at rising angles round the origin, at any distance: simple, mostly concave.
Points starShape(unsigned seed, std::size_t count)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> distance(0.1, 1.0);
    Points points;
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = 2 * M_PI * static_cast<double>(i) / static_cast<double>(count);
        const double r = distance(random);
        points.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
    }
    return points;
}

TEST(PolygonCutterTest, convexPolygonsBecomeAFanFromTheirFirstCorner)
{
    EXPECT_THAT(cut({{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {1, 3, 0}, {-1, 1, 0}}),
                testing::ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}, Triangle{0, 3, 4}));
    EXPECT_THAT(cut({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}),
                testing::ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
}

TEST(PolygonCutterTest, concaveQuadsAreCutAtTheirReflexCorner)
{
    const Points dart{{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {0.5F, 1, 0}};
    for (std::ptrdiff_t turn = 0; turn < 4; ++turn) {
        Points turned = dart;
        std::rotate(turned.begin(), turned.begin() + turn, turned.end());
        expectCovers(turned);
    }
}

TEST(PolygonCutterTest, quadWithAStraightCornerHasNoFlatTriangle)
{
    const Points points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 2, 0}};
    for (const Triangle& t : cut(points)) {
        EXPECT_GT(areaZ(points, t), 0);
    }
}

TEST(PolygonCutterTest, concavePolygonsAreCoveredOnceWithoutInversion)
{
    for (unsigned seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        expectCovers(starShape(seed, 5 + seed % 60));
    }
}

TEST(PolygonCutterTest, everyPlaneAndWindingKeepsTheNormal)
{
    const Points flat = starShape(7, 23);
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {1.0F, -1.0F}) {
            Points points;
            for (const glm::vec3& p : flat) {
                glm::vec3 q(0);
                q[axis] = 0.25F * p.x; // tilted
                q[(axis + 1) % 3] = side * p.x;
                q[(axis + 2) % 3] = p.y;
                points.push_back(q);
            }
            for (const Triangle& t : cut(points)) {
                const glm::vec3 normal =
                    glm::cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
                EXPECT_GE(side * normal[axis], -1e-9F);
            }
        }
    }
}

TEST(PolygonCutterTest, bridgeToAHoleIsFollowed)
{
    // A square with a square hole, joined by a doubled edge.
    expectCovers({{0, 0, 0},
                  {4, 0, 0},
                  {4, 4, 0},
                  {0, 4, 0},
                  {0, 0, 0},
                  {1, 1, 0},
                  {1, 3, 0},
                  {3, 3, 0},
                  {3, 1, 0},
                  {1, 1, 0}});
}

TEST(PolygonCutterTest, polygonsWithoutSenseAreCutAllTheSame)
{
    for (const Points& points :
         {Points(6, glm::vec3(1)),                                       // one point
          Points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}, // a line
          Points{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}, {1, 3, 0}}, // crosses itself
          Points{{1e38F, 0, 0}, {-1e38F, 0, 0}, {0, 3e38F, 0}, {0, 0, 0}, {0, -3e38F, 1}}}) {
        for (const Triangle& t : cut(points)) {
            for (const std::uint32_t corner : t) {
                EXPECT_LT(corner, points.size());
            }
        }
    }
}

TEST(PolygonCutterTest, hugeCombTakesLinearTime)
{
    Points comb; // teeth whose every ear test meets many reflex corners
    const int teeth = 30'000;
    for (int i = 0; i < teeth; ++i) {
        comb.emplace_back(static_cast<float>(i), 0.0F, 0.0F);
        comb.emplace_back(static_cast<float>(i) + 0.5F, -1e6F, 0.0F);
    }
    comb.emplace_back(static_cast<float>(teeth), 0.0F, 0.0F);
    comb.emplace_back(static_cast<float>(teeth), 1.0F, 0.0F);
    comb.emplace_back(0.0F, 1.0F, 0.0F);
    EXPECT_EQ(cut(comb).size(), comb.size() - 2);
}

} // namespace
} // namespace trixel
