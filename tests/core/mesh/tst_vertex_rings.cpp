// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/vertex_rings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace trixel {
namespace {

/// Triangles around vertex 0, the first and last joined when closed.
std::vector<Triangle> fan(std::uint32_t faces, bool closed)
{
    std::vector<Triangle> triangles;
    for (std::uint32_t f = 0; f < faces; ++f) {
        const std::uint32_t next = closed && f + 1 == faces ? 1 : f + 2;
        triangles.push_back({0, f + 1, next});
    }
    return triangles;
}

TEST(VertexRings, everyCornerIsInExactlyOneRing)
{
    const VertexRings rings(buildAdjacency(fan(7, true)));
    std::size_t corners = 0;
    for (std::size_t r = 0; r < rings.ringCount(); ++r) {
        for (const Corner& corner : rings.corners(static_cast<RingId>(r))) {
            EXPECT_EQ(rings.ring(corner), static_cast<RingId>(r));
            ++corners;
        }
    }
    EXPECT_EQ(corners, 21U);
    EXPECT_EQ(rings.ringCount(), 8U);
}

TEST(VertexRings, aClosedRingRunsCounterClockwiseFromItsLowestFace)
{
    for (const std::uint32_t valence : {3U, 4U, 5U, 6U, 9U, 100U}) {
        const VertexRings rings(buildAdjacency(fan(valence, true)));
        const RingId ring = rings.ring({faceId(0), 0});
        EXPECT_TRUE(rings.isClosed(ring));
        ASSERT_EQ(rings.corners(ring).size(), valence);
        for (std::uint32_t f = 0; f < valence; ++f) {
            EXPECT_EQ(rings.corners(ring)[f], (Corner{faceId(f), 0}));
        }
    }
}

TEST(VertexRings, anOpenRingStartsAtTheBorder)
{
    const VertexRings rings(buildAdjacency(fan(4, false)));
    const RingId ring = rings.ring({faceId(2), 0});
    EXPECT_FALSE(rings.isClosed(ring));
    EXPECT_THAT(rings.corners(ring),
                testing::ElementsAre(Corner{faceId(0), 0},
                                     Corner{faceId(1), 0},
                                     Corner{faceId(2), 0},
                                     Corner{faceId(3), 0}));
}

TEST(VertexRings, fansThatOnlyTouchAtAVertexAreApart)
{
    const VertexRings rings(buildAdjacency(std::vector<Triangle>{{0, 1, 2}, {0, 3, 4}}));
    EXPECT_NE(rings.ring({faceId(0), 0}), rings.ring({faceId(1), 0}));
}

TEST(VertexRings, turningAFaceKeepsItsRings)
{
    std::vector<Triangle> triangles = fan(5, true);
    triangles[2] = {triangles[2][1], triangles[2][2], triangles[2][0]};
    const VertexRings rings(buildAdjacency(triangles));
    EXPECT_EQ(rings.ring({faceId(2), 2}), rings.ring({faceId(0), 0}));
    EXPECT_EQ(rings.corners(rings.ring({faceId(0), 0})).size(), 5U);
}

} // namespace
} // namespace trixel
