// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/texel_edges.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <vector>

using namespace trixel;

namespace {

std::vector<TexelCoord> texelsOf(Level level)
{
    std::vector<TexelCoord> texels;
    for (std::uint32_t k = 0; k < level.texelCount(); ++k) {
        texels.push_back(texelAt(level, static_cast<TexelIndex>(k)));
    }
    return texels;
}

struct Segment
{
    glm::dvec2 start, end;
};

Segment edgeOf(Level level, TexelCoord texel, LocalEdge edge)
{
    const auto points = corners(level, texel);
    return {points[indexOf(edge)], points[indexOf(nextEdge(edge))]};
}

} // namespace

TEST(TexelEdges, theTexelAcrossHasTheSameEdgeTheOtherWayRound)
{
    for (const Level level : {Level(1), Level(2), Level(4)}) {
        for (const TexelCoord texel : texelsOf(level)) {
            for (const LocalEdge edge : kLocalEdges) {
                const auto other = texelAcross(level, texel, edge);
                if (!other) {
                    continue;
                }
                ASSERT_TRUE(isValid(level, *other));
                const Segment own = edgeOf(level, texel, edge);
                const Segment theirs = edgeOf(level, *other, edge);
                EXPECT_LT(glm::distance(own.start, theirs.end), 1e-12);
                EXPECT_LT(glm::distance(own.end, theirs.start), 1e-12);
                EXPECT_EQ(texelAcross(level, *other, edge), texel);
            }
        }
    }
}

TEST(TexelEdges, nothingLiesAcrossExactlyWhereTheFaceEnds)
{
    for (const Level level : {Level(0), Level(1), Level(3)}) {
        std::array<std::uint32_t, 3> ends{};
        for (const TexelCoord texel : texelsOf(level)) {
            for (const LocalEdge edge : kLocalEdges) {
                const Segment own = edgeOf(level, texel, edge);
                const auto onBorder = [&](glm::dvec2 p) {
                    const double height[3] = {p.y, 1 - p.x - p.y, p.x};
                    return std::abs(height[indexOf(edge)]) < 1e-12;
                };
                const bool border = onBorder(own.start) && onBorder(own.end);
                EXPECT_EQ(texelAcross(level, texel, edge).has_value(), !border);
                ends[indexOf(edge)] += border ? 1 : 0;
            }
        }
        for (const std::uint32_t count : ends) {
            EXPECT_EQ(count, level.resolution());
        }
    }
}

TEST(TexelEdges, placesAlongAnEdgeRunFromItsStartToItsEnd)
{
    const Level level(3);
    const glm::dvec2 vertices[3] = {{0, 0}, {1, 0}, {0, 1}};
    for (const LocalEdge edge : kLocalEdges) {
        const glm::dvec2 start = vertices[indexOf(edge)];
        const glm::dvec2 along = vertices[indexOf(nextEdge(edge))] - start;
        for (std::uint32_t place = 0; place < level.resolution(); ++place) {
            const TexelCoord texel = texelAlong(level, edge, place);
            ASSERT_TRUE(isValid(level, texel));
            EXPECT_EQ(placeAlong(level, edge, texel), place);
            const Segment own = edgeOf(level, texel, edge);
            EXPECT_LT(glm::distance(own.start, start + along * (place / 8.0)), 1e-12);
            EXPECT_LT(glm::distance(own.end, start + along * ((place + 1) / 8.0)), 1e-12);
        }
    }
}
