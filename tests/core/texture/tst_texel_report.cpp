// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/mips.h"
#include "core/texture/reduced_texel.h"
#include "core/texture/texel_report.h"
#include "tests/core/test_meshes.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <gmock/gmock.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

using namespace trixel;
using nlohmann::json;
using testing::HasSubstr;

namespace {

/// Two triangles that share an edge, of levels 3 and 4, each texel its own.
struct Pair
{
    TexelFormat format;
    TriangleMesh mesh = test::gridMesh(1);
    Adjacency adjacency = buildAdjacency(mesh.triangles);
    TexelStore texels;

    explicit Pair(TexelFormat wanted = {}, std::uint32_t seed = 1)
        : format(wanted)
    {
        FaceMap<Level> levels(2);
        levels[faceId(0)] = Level(3);
        levels[faceId(1)] = Level(4);
        texels = TexelStore(format, levels, std::vector<std::byte>(format.texelBytes()));
        std::mt19937 random(seed);
        std::vector<float> values(format.channels);
        for (const FaceId face : {faceId(0), faceId(1)}) {
            const std::span<std::byte> bytes = texels.writable(face);
            for (std::size_t at = 0; at < bytes.size(); at += format.texelBytes()) {
                for (float& value : values) {
                    value = static_cast<float>(random()) / 4294967296.0F;
                }
                encode(format.type, values, bytes.subspan(at, format.texelBytes()));
            }
        }
    }
    WalkedSurface surface(int dropped = 0) const { return {adjacency, texels, dropped}; }

    void put(FaceId face, TexelCoord texel, const std::vector<float>& values)
    {
        const Level level = texels.face(face).level();
        const std::size_t at = indexOf(texelIndex(level, texel)) * format.texelBytes();
        encode(format.type, values, texels.writable(face).subspan(at, format.texelBytes()));
    }
};

constexpr TexelFormat kFloats{TexelType::Float, 3, std::nullopt};

} // namespace

TEST(ReducedTexel, isTheOneThatTheWholeFaceReducesTo)
{
    for (const TexelType type :
         {TexelType::UInt8, TexelType::UInt16, TexelType::Half, TexelType::Float}) {
        const Pair pair({type, 2, std::nullopt}, 3);
        const FaceTexels& face = pair.texels.face(faceId(1));
        for (int steps = 0; steps <= 6; ++steps) {
            const FaceTexels whole = reduced(pair.format, face, steps);
            std::vector<std::byte> one(pair.format.texelBytes());
            for (std::uint32_t k = 0; k < whole.level().texelCount(); ++k) {
                reducedTexel(pair.format, face, steps, static_cast<TexelIndex>(k), one);
                EXPECT_TRUE(std::ranges::equal(one, whole.texel(k))) << steps << ": " << k;
            }
        }
    }
}

TEST(TexelReport, saysWhereATexelLiesAndWhatItHolds)
{
    Pair pair;
    const TexelCoord texel{3, 1, TexelHalf::Upper};
    pair.put(faceId(0), texel, {200.0F / 255, 0, 1});
    const TexelReport report = describe(pair.surface(), {faceId(0), texel}, {0.46, 0.22});
    EXPECT_EQ(report.level, Level(3));
    EXPECT_EQ(indexOf(report.index), 38U);
    EXPECT_EQ(report.pixel, (PackedPixel{6, 4}));
    EXPECT_EQ(report.values, (std::vector<float>{200.0F / 255, 0, 1}));
    EXPECT_EQ(toHex(report), "c8 00 ff");
    const std::string text = toText(report);
    for (const char* line : {"Address: 0:3,1,upper\n",
                             "Face: 0\n",
                             "Level: 3 · 8 × 8\n",
                             "Texel: (3, 1) upper\n",
                             "Stored at: pixel 6, 4 · index 38\n",
                             "u v w: 0.46000  0.22000  0.32000\n",
                             "Stored: 200  0  255\n",
                             "Bytes: c8 00 ff\n",
                             "Edge 0: 0:3,2,lower\n",
                             "Edge 1: 0:3,1,lower\n",
                             "Edge 2: 0:4,1,lower\n"}) {
        EXPECT_THAT(text, HasSubstr(line));
    }
}

TEST(TexelReport, namesEveryTexelAcrossAMeshEdge)
{
    const Pair pair;
    const auto coarse =
        describe(pair.surface(), {faceId(0), {2, 5, TexelHalf::Lower}}, {0.3, 0.65});
    ASSERT_TRUE(coarse.neighbours[1]);
    EXPECT_EQ(coarse.neighbours[1]->count, 2U);
    EXPECT_EQ(coarse.neighbours[1]->face, faceId(1));
    EXPECT_THAT(toText(coarse), HasSubstr(" to 1:"));
    const auto fine = describe(pair.surface(), {faceId(1), {3, 12, TexelHalf::Lower}}, {0.2, 0.78});
    ASSERT_TRUE(fine.neighbours[1]);
    EXPECT_EQ(fine.neighbours[1]->count, 1U);
    EXPECT_THAT(toText(describe(pair.surface(), {faceId(0), {}}, {0, 0})),
                HasSubstr("Edge 0: border\n"));
}

TEST(TexelReport, droppedLevelsShowTheReducedTexel)
{
    const Pair pair;
    const TexelPlace place{faceId(1), {0, 1, TexelHalf::Upper}};
    const TexelReport report = describe(pair.surface(2), place, {0.2, 0.5});
    EXPECT_EQ(report.level, Level(2));
    EXPECT_EQ(report.levelsDropped, 2);
    const FaceTexels coarse = reduced(pair.format, pair.texels.face(faceId(1)), 2);
    EXPECT_TRUE(std::ranges::equal(report.stored,
                                   coarse.texel(indexOf(texelIndex(Level(2), place.texel)))));
    EXPECT_THAT(toText(report), HasSubstr("Level: 2 · 4 × 4 · 2 below the face's own\n"));
}

TEST(TexelReport, jsonHoldsEveryField)
{
    Pair pair({TexelType::UInt16, 4, std::uint16_t{3}});
    const TexelPlace place{faceId(0), {2, 5, TexelHalf::Lower}};
    pair.put(place.face, place.texel, {0, 1, 0.5F, 1});
    TexelReport report = describe(pair.surface(), place, {0.25, 0.625});
    report.polygon = 7;
    report.position = glm::vec3(1, 2.5F, -3);
    report.display = {{0, 1, 0.5F, 1}, {0, 255, 128, 255}};
    const json read = json::parse(toJson(report));
    EXPECT_EQ(read["address"], "0:2,5,lower");
    EXPECT_EQ(read["face"], 0);
    EXPECT_EQ(read["polygon"], 7);
    EXPECT_EQ(read["level"], 3);
    EXPECT_EQ(read["resolution"], 8);
    EXPECT_EQ(read["levelsDropped"], 0);
    EXPECT_EQ(read["i"], 2);
    EXPECT_EQ(read["j"], 5);
    EXPECT_EQ(read["half"], "lower");
    EXPECT_EQ(read["index"], 42);
    EXPECT_EQ(read["pixel"], (json{2, 5}));
    EXPECT_EQ(read["uvw"], (json{0.25, 0.625, 0.125}));
    EXPECT_EQ(read["position"], (json{1.0, 2.5, -3.0}));
    EXPECT_EQ(read["type"], "uint16");
    EXPECT_EQ(read["channels"], 4);
    EXPECT_EQ(read["alpha"], 3);
    EXPECT_EQ(read["stored"], (json{0, 65535, 32768, 65535}));
    EXPECT_EQ(read["bytes"], "0000 ffff 0080 ffff");
    EXPECT_EQ(read["display"]["rgba"], (json{0, 255, 128, 255}));
    ASSERT_EQ(read["neighbours"].size(), 3U);
    EXPECT_EQ(read["neighbours"][0]["first"], "0:2,4,upper");
    EXPECT_EQ(read["neighbours"][1]["face"], 1);
    EXPECT_EQ(read["neighbours"][1]["count"], 2);
    EXPECT_EQ(read["neighbours"][1]["level"], 4);
}

TEST(TexelReport, jsonNumbersAreReadBackToTheBit)
{
    Pair pair(kFloats);
    std::mt19937 random(17);
    const TexelPlace place{faceId(0), {}};
    for (int k = 0; k < 2000; ++k) {
        std::vector<float> values;
        while (values.size() < 3) {
            const float value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
            if (std::isfinite(value)) {
                values.push_back(value);
            }
        }
        pair.put(place.face, place.texel, values);
        const json read = json::parse(toJson(describe(pair.surface(), place, {0, 0})));
        EXPECT_EQ(read["stored"].get<std::vector<float>>(), values);
    }
}

TEST(TexelReport, whatIsNoNumberIsSaidInWords)
{
    Pair pair(kFloats);
    const float inf = std::numeric_limits<float>::infinity();
    pair.put(faceId(0), {}, {std::numeric_limits<float>::quiet_NaN(), inf, -inf});
    const TexelReport report = describe(pair.surface(), {faceId(0), {}}, {0, 0});
    EXPECT_EQ(json::parse(toJson(report))["stored"], (json{"nan", "inf", "-inf"}));
    EXPECT_THAT(toText(report), HasSubstr("Stored: nan  inf  -inf\n"));
    EXPECT_EQ(toHex(report), "0000c07f 0000807f 000080ff");
}

TEST(TexelReport, manyChannelsAreCutShortInTextAlone)
{
    const Pair pair({TexelType::Half, 20, std::nullopt});
    const TexelReport report = describe(pair.surface(), {faceId(0), {}}, {0, 0});
    EXPECT_THAT(toText(report), HasSubstr("… (20 channels)\n"));
    EXPECT_EQ(json::parse(toJson(report))["stored"].size(), 20U);
    EXPECT_EQ(toHex(report).size(), 20U * 5U - 1U);
}
