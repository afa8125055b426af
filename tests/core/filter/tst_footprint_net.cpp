// SPDX-License-Identifier: GPL-3.0-or-later
//
// The faces about a footprint, laid flat as filters lay them, and what limits a footprint.
#include "core/filter/footprint_clamps.h"
#include "core/filter/footprint_net.h"
#include "core/filter/unfolding.h"
#include "tests/core/filter/random_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace trixel {
namespace {

using test::Random;
using test::unit;
using Kind = FootprintClamp::Kind;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Subject
{
    TriangleMesh mesh;
    Adjacency adjacency;
    TexelStore store;
};

TexelStore plainStore(const FaceMap<Level>& levels)
{
    const std::array<float, 1> zero{};
    return {TexelFormat{TexelType::Float, 1, std::nullopt}, levels, std::as_bytes(std::span(zero))};
}

Subject closedSubject(unsigned seed)
{
    Random random(seed);
    Subject subject;
    subject.mesh = test::randomClosedMesh(random, 2);
    subject.adjacency = buildAdjacency(subject.mesh.triangles);
    subject.store = plainStore(test::randomLevels(random, subject.mesh.faceCount(), 0, 5));
    return subject;
}

Subject flatSubject(std::uint32_t cells, int level)
{
    Subject subject;
    subject.mesh = test::flatLattice(cells);
    subject.adjacency = buildAdjacency(subject.mesh.triangles);
    subject.store = plainStore(FaceMap<Level>(subject.mesh.faceCount(), Level(level)));
    return subject;
}

FootprintNet
netOf(const Subject& subject, const PlacedFootprint& footprint, const NetLimits& limits = {})
{
    return footprintNet(subject.mesh, subject.adjacency, subject.store, footprint, limits);
}

PlacedFootprint randomFootprint(Random& random, const Subject& subject)
{
    double a = unit(random);
    double b = unit(random);
    if (a + b > 1) {
        a = 1 - a;
        b = 1 - b;
    }
    const double width = 0.8 * unit(random);
    const double angle = 6.3 * unit(random);
    return {faceId(static_cast<std::size_t>(unit(random) * double(subject.mesh.faceCount()))),
            {a, b},
            {width * glm::dvec2(std::cos(angle), std::sin(angle)),
             width * unit(random) * glm::dvec2(-std::sin(angle), std::cos(angle))}};
}

bool holds(const std::vector<FootprintClamp>& clamps, Kind kind)
{
    return std::ranges::find(clamps, kind, &FootprintClamp::kind) != clamps.end();
}

TEST(FootprintNet, laysFacesWhereFiltersOfTheWholeMeshLayThem)
{
    const Subject subject = closedSubject(3);
    const FilterScene scene = test::sceneOf(subject.mesh, subject.store);
    Random random(5);
    Unfolding unfolding;
    for (int k = 0; k < 40; ++k) {
        const PlacedFootprint footprint = randomFootprint(random, subject);
        const FootprintNet net = netOf(subject, footprint);
        const QueryEllipse ellipse = queryEllipse(
            scene, footprint.face, footprint.uv, footprint.footprint.w1, footprint.footprint.w2);
        EXPECT_NEAR(net.ellipse.majorSigma, ellipse.majorSigma, 1e-12);
        EXPECT_NEAR(net.ellipse.minorSigma, ellipse.minorSigma, 1e-12);
        EXPECT_NEAR(net.ellipse.log2Edge, ellipse.log2Edge, 1e-12);
        const EllipseFrame frame(ellipse);
        const auto places =
            unfolding.unfold(scene.surface(), footprint.face, ellipse, frame, NetLimits().cut);
        EXPECT_EQ(net.faces.front().face, footprint.face);
        for (const PlacedFace& place : places) {
            const auto at = net.indexOfFace(place.face);
            ASSERT_TRUE(at) << "face " << indexOf(place.face) << " of query " << k;
            for (std::size_t c = 0; c < 3; ++c) {
                EXPECT_NEAR(
                    glm::distance(net.faces[*at].corners[c], frame.toPlane(place.corners[c])),
                    0,
                    1e-6);
            }
        }
    }
}

TEST(FootprintNet, holdsTheNeighboursHoweverSmallTheFootprint)
{
    const Subject subject = closedSubject(4);
    const FaceId face = faceId(17);
    const FootprintNet net = netOf(subject, {face, {0.33, 0.33}, {{1e-9, 0}, {0, 1e-9}}});
    for (const LocalEdge edge : kLocalEdges) {
        const auto across = subject.adjacency.neighbour(face, edge);
        ASSERT_TRUE(across);
        const auto at = net.indexOfFace(across->face);
        ASSERT_TRUE(at);
        // They meet along the edge, turned the other way.
        const std::size_t own = indexOf(edge);
        const std::size_t other = indexOf(across->edge);
        const auto& hit = net.faces.front().corners;
        const auto& beside = net.faces[*at].corners;
        EXPECT_NEAR(glm::distance(hit[own], beside[(other + 1) % 3]), 0, 1e-6);
        EXPECT_NEAR(glm::distance(hit[(own + 1) % 3], beside[other]), 0, 1e-6);
    }
}

TEST(FootprintNet, edgesKeepTheirLengths)
{
    const Subject subject = closedSubject(6);
    Random random(8);
    for (int k = 0; k < 10; ++k) {
        for (const FootprintNet::Face& face :
             netOf(subject, randomFootprint(random, subject)).faces) {
            const auto world = subject.mesh.corners(face.face);
            for (std::size_t e = 0; e < 3; ++e) {
                EXPECT_NEAR(glm::distance(face.corners[e], face.corners[(e + 1) % 3]),
                            static_cast<double>(glm::distance(world[e], world[(e + 1) % 3])),
                            1e-5);
            }
        }
    }
}

TEST(FootprintNet, placesOfPointsAreThoseOfTheirFaces)
{
    const Subject subject = closedSubject(6);
    Random random(9);
    const FootprintNet net = netOf(subject, {faceId(5), {0.2, 0.3}, {{0.9, 0}, {0, 0.9}}});
    const auto centre = net.placeAt({0, 0});
    ASSERT_TRUE(centre);
    EXPECT_EQ(centre->face, 0U);
    EXPECT_NEAR(glm::distance(centre->uv, glm::dvec2(0.2, 0.3)), 0, 1e-9);
    for (std::size_t k = 0; k < net.faces.size(); ++k) {
        const glm::dvec2 uv(0.3, 0.4);
        const glm::dvec2 back = net.faces[k].uvOf(net.faces[k].pointOf(uv));
        EXPECT_NEAR(glm::distance(back, uv), 0, 1e-6);
    }
    EXPECT_FALSE(net.placeAt({1e6, 0}));
}

TEST(FootprintNet, axesAreThoseOfTheVectors)
{
    const Subject subject = flatSubject(6, 4);
    // Orthogonal vectors in the plane: the half axes are their halves.
    const double h = std::sqrt(0.75);
    const glm::dvec2 up(-0.5 / h, 1 / h); // (0, 1) of the plane in (u,v)
    const FootprintNet net = netOf(subject, {faceId(30), {1.0 / 3, 1.0 / 3}, {{0.5, 0}, 0.2 * up}});
    EXPECT_NEAR(glm::length(net.major), 0.25, 1e-6);
    EXPECT_NEAR(glm::length(net.minor), 0.1, 1e-6);
    EXPECT_NEAR(std::abs(net.major.x), 0.25, 1e-6);
    // The floor is half a texel of level 4.
    EXPECT_NEAR(glm::length(net.widenedMajor), std::hypot(0.25, 0.5 / 16), 1e-6);
    EXPECT_NEAR(glm::length(net.widenedMinor), std::hypot(0.1, 0.5 / 16), 1e-6);
}

TEST(FootprintNet, weightsOfExactMakeTheEllipseThatWasAskedFor)
{
    const Subject subject = flatSubject(6, 4);
    const auto scene =
        std::make_shared<const FilterScene>(test::sceneOf(subject.mesh, subject.store));
    NoProgress progress;
    auto meter = ContributionMeter::build(scene, Threads{1}, progress);
    const PlacedFootprint footprint{faceId(30), {0.3, 0.3}, {{0.4, 0}, {0.05, 0.2}}};
    QueryArrays query;
    query.add(footprint.face,
              glm::vec2(footprint.uv),
              glm::vec2(footprint.footprint.w1),
              glm::vec2(footprint.footprint.w2));
    const auto exact =
        meter->measure(*makeMethod({"exact", std::nullopt}), query.queries(), {}, progress);
    ASSERT_TRUE(exact);
    NetLimits limits;
    limits.cut = 6;
    const FootprintNet net = netOf(subject, footprint, limits);
    const auto ellipse = weightEllipse(net, *exact);
    ASSERT_TRUE(ellipse);
    EXPECT_NEAR(ellipse->placed, 1, 1e-5);
    EXPECT_NEAR(ellipse->majorSigma / net.ellipse.majorSigma, 1, 1e-3);
    EXPECT_NEAR(ellipse->minorSigma / net.ellipse.minorSigma, 1, 1e-3);
    EXPECT_NEAR(glm::length(ellipse->mean), 0, 1e-3 * net.ellipse.minorSigma);
    EXPECT_TRUE(clampsOf(footprint, net, false, ellipse).empty());
}

TEST(FootprintNet, faceCountIsLimitedToTheNearest)
{
    const Subject subject = flatSubject(20, 2);
    NetLimits limits;
    limits.mostFaces = 40;
    const FootprintNet net = netOf(subject, {faceId(400), {0.3, 0.3}, {{9, 0}, {0, 9}}}, limits);
    EXPECT_TRUE(net.isCut);
    EXPECT_LE(net.faces.size(), 43U);
    EXPECT_EQ(net.faces.front().face, faceId(400));
    for (const FootprintNet::Face& face : net.faces) {
        EXPECT_LT(glm::length(face.pointOf(glm::dvec2(1.0 / 3))), 4.5);
    }
}

TEST(FootprintNet, standsHostileFootprints)
{
    Subject subject = closedSubject(6);
    const Triangle narrow = subject.mesh.triangles[3]; // a face without area
    subject.mesh.positions[narrow[2]] = subject.mesh.positions[narrow[1]];
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double w : {0.0, 1e-300, 1e30, kInfinity, nan}) {
        for (const glm::dvec2 uv : {glm::dvec2(0.3), glm::dvec2(-3, 9), glm::dvec2(nan, 0)}) {
            const PlacedFootprint footprint{faceId(3), uv, {{w, 0}, {w, w}}};
            const FootprintNet net = netOf(subject, footprint);
            EXPECT_FALSE(net.faces.empty());
            EXPECT_TRUE(std::isfinite(glm::length(net.widenedMajor)));
            EXPECT_TRUE(std::isfinite(glm::length(net.major)));
            clampsOf(footprint, net, true);
        }
    }
}

TEST(FootprintClamps, eachIsToldWhereItAppliesAndNowhereElse)
{
    const Subject subject = flatSubject(6, 4);
    const auto clamps = [&](glm::dvec2 uv, glm::dvec2 w1, glm::dvec2 w2, bool screen = false) {
        const PlacedFootprint footprint{faceId(30), uv, {w1, w2}};
        return clampsOf(footprint, netOf(subject, footprint), screen);
    };
    const glm::dvec2 inside(0.3, 0.3);
    EXPECT_TRUE(clamps(inside, {0.5, 0}, {0, 0.5}).empty());

    EXPECT_TRUE(holds(clamps(inside, {kInfinity, 0}, {0, 1}), Kind::NotFinite));
    EXPECT_TRUE(holds(clamps(inside, {3000, 0}, {0, 1}), Kind::Shortened));
    EXPECT_FALSE(holds(clamps(inside, {64, 0}, {0, 1}), Kind::Grazing));
    EXPECT_TRUE(holds(clamps(inside, {64, 0}, {0, 1}, true), Kind::Grazing));
    EXPECT_TRUE(holds(clamps({0.9, 0.9}, {0.5, 0}, {0, 0.5}), Kind::CentreMoved));

    const auto small = clamps(inside, {0.01, 0}, {0, 0.01});
    ASSERT_TRUE(holds(small, Kind::Widened));
    EXPECT_NEAR(small.front().used, 0.5, 0.02); // half a texel
    EXPECT_TRUE(holds(small, Kind::FinestLevel));
    const auto wide = clamps(inside, {4, 0}, {0, 4});
    EXPECT_TRUE(holds(wide, Kind::CoarsestLevel));
    EXPECT_FALSE(holds(wide, Kind::Widened));
}

TEST(FootprintClamps, capsOfMethodsAreSeenByTheirWeights)
{
    const Subject subject = flatSubject(8, 5);
    const auto scene =
        std::make_shared<const FilterScene>(test::sceneOf(subject.mesh, subject.store));
    NoProgress progress;
    auto meter = ContributionMeter::build(scene, Threads{1}, progress);
    const PlacedFootprint footprint{faceId(72), {0.3, 0.3}, {{1, 0}, {0, 0.05}}};
    const FootprintNet net = netOf(subject, footprint, {6, 400});
    QueryArrays query;
    query.add(footprint.face,
              glm::vec2(footprint.uv),
              glm::vec2(footprint.footprint.w1),
              glm::vec2(footprint.footprint.w2));
    const auto clamps = [&](const char* method) {
        const auto weights =
            meter->measure(*makeMethod(*parseMethod(method)), query.queries(), {}, progress);
        return clampsOf(footprint, net, false, weightEllipse(net, *weights));
    };
    EXPECT_TRUE(holds(clamps("probes-1:2"), Kind::MethodWidened));
    EXPECT_TRUE(holds(clamps("point"), Kind::MethodShortened));
    EXPECT_FALSE(holds(clamps("exact"), Kind::MethodWidened));
    EXPECT_FALSE(holds(clamps("exact"), Kind::MethodShortened));
}

} // namespace
} // namespace trixel
