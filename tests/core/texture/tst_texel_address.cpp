// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/texel_address.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

using namespace trixel;

namespace {

/// Three faces of levels 3, 0 and 1.
struct Surface
{
    Adjacency adjacency{3};
    TexelStore texels;

    Surface()
    {
        FaceMap<Level> levels(3);
        levels[faceId(0)] = Level(3);
        levels[faceId(2)] = Level(1);
        const std::array<std::byte, 1> black{};
        texels = TexelStore({TexelType::UInt8, 1, std::nullopt}, levels, black);
    }
    WalkedSurface walked(int dropped = 0) const { return {adjacency, texels, dropped}; }
};

std::string found(std::string_view text, int dropped = 0)
{
    const Surface surface;
    const auto place = parseTexelAddress(text, surface.walked(dropped));
    return place ? toText(*place) : place.error().message;
}

} // namespace

TEST(TexelAddress, everyWayToWriteATexelFindsIt)
{
    EXPECT_EQ(found("2"), "2:0,0,lower");
    EXPECT_EQ(found("0:3,4,lower"), "0:3,4,lower");
    EXPECT_EQ(found(" 0 : 3, 3, upper "), "0:3,3,upper");
    EXPECT_EQ(found("0@0.3,0.55"), "0:2,4,lower");
    EXPECT_EQ(found("2@1,0"), "2:1,0,lower");
    const Level level(3);
    for (std::uint32_t k = 0; k < level.texelCount(); ++k) {
        const TexelPlace place{faceId(0), texelAt(level, static_cast<TexelIndex>(k))};
        EXPECT_EQ(found("0:" + std::to_string(k)), toText(place));
        EXPECT_EQ(found(toText(place)), toText(place));
    }
}

TEST(TexelAddress, levelsAreThoseShown)
{
    EXPECT_EQ(found("0@0.3,0.55", 2), "0:0,1,lower");
    EXPECT_EQ(found("0:16", 2), "Expected an index from 0 to 3 in face 0, found '16'.");
}

TEST(TexelAddress, whatIsNotThereIsSaidInOneSentence)
{
    EXPECT_EQ(found(""), "Expected a face from 0 to 2, found ''.");
    EXPECT_EQ(found("3"), "Expected a face from 0 to 2, found '3'.");
    EXPECT_EQ(found("-1"), "Expected a face from 0 to 2, found '-1'.");
    EXPECT_EQ(found("99999999999"), "Expected a face from 0 to 2, found '99999999999'.");
    EXPECT_EQ(found("0:64"), "Expected an index from 0 to 63 in face 0, found '64'.");
    EXPECT_EQ(found("0:"), "Expected an index from 0 to 63 in face 0, found ''.");
    EXPECT_EQ(found("0:1,2"), "Expected i,j,lower or i,j,upper, found '1,2'.");
    EXPECT_EQ(found("0:1,2,middle"), "Expected i,j,lower or i,j,upper, found '1,2,middle'.");
    EXPECT_EQ(found("0:1,2,3,upper"), "Expected i,j,lower or i,j,upper, found '1,2,3,upper'.");
    EXPECT_EQ(found("0:5,3,lower"),
              "Expected lower texels with i + j of at most 7 in face 0, found '5,3,lower'.");
    EXPECT_EQ(found("0:4,3,upper"),
              "Expected upper texels with i + j of at most 6 in face 0, found '4,3,upper'.");
    EXPECT_EQ(found("1:0,0,upper"),
              "Expected a lower texel, the only one of face 1, found '0,0,upper'.");
    EXPECT_EQ(found("0@0.7,0.6"),
              "Expected u,v with u, v and 1 - u - v from 0 to 1, found '0.7,0.6'.");
    EXPECT_EQ(found("0@nan,0"), "Expected u,v with u, v and 1 - u - v from 0 to 1, found 'nan,0'.");
    EXPECT_EQ(found("0@0.5"), "Expected u,v with u, v and 1 - u - v from 0 to 1, found '0.5'.");
}

TEST(TexelAddress, aSurfaceOfNoFacesHasNoTexels)
{
    const Adjacency adjacency;
    const TexelStore texels;
    const auto place = parseTexelAddress("0", {adjacency, texels});
    ASSERT_FALSE(place);
    EXPECT_EQ(place.error().message, "Expected a face, but there are none, found '0'.");
}
