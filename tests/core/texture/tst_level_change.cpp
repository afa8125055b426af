// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/texel.h"
#include "core/texture/level_change.h"
#include "core/texture/mips.h"
#include "core/texture/refinement.h"
#include "tests/core/test_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace trixel {
namespace {

std::vector<std::byte> encoded(const TexelFormat& format, std::span<const float> values)
{
    std::vector<std::byte> bytes(values.size() * byteSize(format.type));
    encode(format.type, values, bytes);
    return bytes;
}

std::vector<float> decoded(const TexelFormat& format, const FaceTexels& face)
{
    std::vector<float> values(face.bytes().size() / byteSize(format.type));
    decode(format.type, face.bytes(), values);
    return values;
}

/// Faces of random levels, every fifth constant, the rest noise.
TexelStore noiseStore(const Adjacency& adjacency, const TexelFormat& format, std::uint32_t seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> value(0, 1);
    const auto count = static_cast<std::uint32_t>(adjacency.faceCount());
    const std::vector<float> grey(format.channels, 0.5F);
    TexelStore store(count, format, Level(2), encoded(format, grey));
    for (std::uint32_t f = 0; f < count; ++f) {
        const Level level(static_cast<int>(random() % 5));
        std::vector<float> values(std::size_t{level.texelCount()} * format.channels);
        std::ranges::generate(values, [&] { return value(random); });
        store.exchange(faceId(f),
                       f % 5 == 4
                           ? FaceTexels::constant(level, encoded(format, grey))
                           : FaceTexels::full(level, format.texelBytes(), encoded(format, values)));
    }
    return store;
}

std::vector<FaceId> allFaces(const TexelStore& store)
{
    std::vector<FaceId> faces;
    for (std::uint32_t f = 0; f < store.faceCount(); ++f) {
        faces.push_back(faceId(f));
    }
    return faces;
}

TexelPatch
change(TexelStore& store, const Adjacency& adjacency, LevelChange by, unsigned threads = 2)
{
    NoProgress progress;
    const FaceMap<Level> levels = changedLevels(store, allFaces(store), by);
    return changeLevels(store, adjacency, levels, Threads{threads}, progress).value();
}

const Adjacency& sphere()
{
    static const Adjacency adjacency = buildAdjacency(test::sphereMesh(2).triangles);
    return adjacency;
}

constexpr LevelChange kDouble{LevelChange::Kind::Double, Level(0)};
constexpr LevelChange kHalve{LevelChange::Kind::Halve, Level(0)};

class LevelChangeOf : public testing::TestWithParam<TexelType>
{
protected:
    TexelFormat format{GetParam(), 5, std::nullopt};
};

INSTANTIATE_TEST_SUITE_P(
    Types,
    LevelChangeOf,
    testing::Values(TexelType::UInt8, TexelType::UInt16, TexelType::Half, TexelType::Float),
    [](const auto& type) { return std::string(nameOf(type.param)); });

TEST_P(LevelChangeOf, doublingThenHalvingKeepsThePaint)
{
    const TexelStore before = noiseStore(sphere(), format, 1);
    TexelStore store = before;
    change(store, sphere(), kDouble);
    change(store, sphere(), kHalve);
    // Integers come back to the bit; others within the rounding of their four children.
    const bool integers = format.type == TexelType::UInt8 || format.type == TexelType::UInt16;
    const float bound = integers ? 0.0F : format.type == TexelType::Half ? 1.1F / 1024 : 3e-7F;
    for (std::uint32_t f = 0; f < store.faceCount(); ++f) {
        ASSERT_EQ(store.face(faceId(f)).level(), before.face(faceId(f)).level());
        const auto now = decoded(format, store.face(faceId(f)));
        const auto was = decoded(format, before.face(faceId(f)));
        ASSERT_EQ(now.size(), was.size());
        for (std::size_t k = 0; k < now.size(); ++k) {
            ASSERT_NEAR(now[k], was[k], bound) << "face " << f;
        }
    }
}

TEST_P(LevelChangeOf, finerTexelsStayWithinTheRangeAboutThem)
{
    TexelStore store = noiseStore(sphere(), format, 2);
    float least = 1;
    float most = 0;
    for (const FaceId face : allFaces(store)) {
        for (const float value : decoded(format, store.face(face))) {
            least = std::min(least, value);
            most = std::max(most, value);
        }
    }
    change(store, sphere(), kDouble);
    for (const FaceId face : allFaces(store)) {
        for (const float value : decoded(format, store.face(face))) {
            EXPECT_GE(value, least);
            EXPECT_LE(value, most);
        }
    }
}

TEST_P(LevelChangeOf, constantFacesStayConstantAndUndoBringsBackTheBits)
{
    const TexelStore before = noiseStore(sphere(), format, 3);
    for (const LevelChange by : {kDouble, kHalve, LevelChange{LevelChange::Kind::Set, Level(3)}}) {
        TexelStore store = before;
        TexelPatch patch = change(store, sphere(), by);
        for (const FaceId face : allFaces(store)) {
            EXPECT_EQ(store.face(face).level(), by.appliedTo(before.face(face).level()));
            EXPECT_EQ(store.face(face).isConstant(), before.face(face).isConstant());
        }
        const TexelStore after = store;
        patch.swap(store);
        for (const FaceId face : allFaces(store)) {
            EXPECT_EQ(store.face(face), before.face(face));
        }
        patch.swap(store);
        for (const FaceId face : allFaces(store)) {
            EXPECT_EQ(store.face(face), after.face(face));
        }
    }
}

/// What no rounding of the four one by one does, whichever way it takes halves.
TEST(LevelChange, integerChildrenSumToFourTimesTheirParent)
{
    std::mt19937 random(8);
    std::uniform_int_distribution<int> anyValue(0, 255);
    const TexelFormat format{TexelType::UInt8, 1, std::nullopt};
    int moved = 0;
    for (int k = 0; k < 2000; ++k) {
        const int parent = anyValue(random);
        const auto stored = static_cast<std::byte>(parent);
        const FaceTexels face = FaceTexels::full(Level(0), 1, std::span(&stored, 1));
        std::array<float, 3 * kGroupChannels> averages{};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            averages[corner * kGroupChannels] = static_cast<float>(anyValue(random)) / 255;
        }
        const LevelVertices vertices{averages.data(), kGroupChannels};
        int sum = 0;
        const FaceTexels finer = refined(format, face, std::span(&vertices, 1));
        for (const std::byte child : finer.bytes()) {
            sum += std::to_integer<int>(child);
            moved += child != stored ? 1 : 0;
        }
        ASSERT_EQ(sum, 4 * parent);
        ASSERT_EQ(reduced(format, finer), face);
    }
    EXPECT_GT(moved, 2000); // four equal children would keep the sum as well
}

/// Averages of white are computed, and may come out a little above it.
TEST(LevelChange, whiteThatWasRoundedUpDoesNotTurnBlack)
{
    const TexelFormat format{TexelType::UInt8, 1, std::nullopt};
    const auto stored = static_cast<std::byte>(254);
    const FaceTexels face = FaceTexels::full(Level(0), 1, std::span(&stored, 1));
    for (const float above : {1.0F, 1.0000001F, 1.001F, 1.02F}) {
        std::array<float, 3 * kGroupChannels> averages{};
        averages[0] = averages[kGroupChannels] = above;
        averages[2 * kGroupChannels] = 250.0F / 255;
        const LevelVertices vertices{averages.data(), kGroupChannels};
        const FaceTexels finer = refined(format, face, std::span(&vertices, 1));
        for (const std::byte child : finer.bytes()) {
            EXPECT_GE(std::to_integer<int>(child), 250) << above;
        }
    }
}

TEST(LevelChange, halvingIsTheMeanOfFour)
{
    const TexelFormat format;
    const TexelStore before = noiseStore(sphere(), format, 4);
    TexelStore store = before;
    change(store, sphere(), kHalve);
    for (const FaceId face : allFaces(store)) {
        EXPECT_EQ(store.face(face), reduced(format, before.face(face), 1));
    }
}

/// A slope that runs over the whole mesh is finer afterwards, not in steps.
TEST(LevelChange, doublingASlopeGivesTheSlope)
{
    const TriangleMesh mesh = test::gridMesh(4);
    const Adjacency adjacency = buildAdjacency(mesh.triangles);
    const TexelFormat format{TexelType::Float, 1, std::nullopt};
    const float zero = 0;
    TexelStore store(static_cast<std::uint32_t>(mesh.faceCount()),
                     format,
                     Level(0),
                     std::as_bytes(std::span(&zero, 1)));
    const auto slopeAt = [&](FaceId face, Level level, std::size_t texel) {
        const glm::dvec2 uv = centroid(level, texelAt(level, static_cast<TexelIndex>(texel)));
        const glm::vec3 p =
            pointAt(mesh.corners(face), static_cast<float>(uv.x), static_cast<float>(uv.y));
        return 2 * p.x - 0.7F * p.y;
    };
    for (const FaceId face : allFaces(store)) {
        std::vector<float> values(Level(2).texelCount());
        for (std::size_t t = 0; t < values.size(); ++t) {
            values[t] = slopeAt(face, Level(2), t);
        }
        store.exchange(face, FaceTexels::full(Level(2), 4, std::as_bytes(std::span(values))));
    }
    change(store, adjacency, {LevelChange::Kind::Set, Level(4)});
    for (const FaceId face : allFaces(store)) {
        const auto values = decoded(format, store.face(face));
        const auto corners = mesh.corners(face);
        for (std::size_t t = 0; t < values.size(); ++t) {
            const glm::dvec2 uv = centroid(Level(4), texelAt(Level(4), static_cast<TexelIndex>(t)));
            const glm::vec3 p =
                pointAt(corners, static_cast<float>(uv.x), static_cast<float>(uv.y));
            // Averages at the border of the mesh see one side only.
            if (std::min({p.x, p.y, 1 - p.x, 1 - p.y}) > 0.15F) {
                EXPECT_NEAR(values[t], slopeAt(face, Level(4), t), 1e-5F);
            }
        }
    }
}

TEST(LevelChange, doesNotDependOnThreadsAndLeavesOtherFacesAlone)
{
    const TexelFormat format;
    const TexelStore before = noiseStore(sphere(), format, 5);
    FaceMap<Level> levels = levelsOf(before);
    const std::vector<FaceId> some = {faceId(3), faceId(100), faceId(101), faceId(250)};
    levels = changedLevels(before, some, {LevelChange::Kind::Set, Level(4)});
    NoProgress progress;
    TexelStore one = before;
    TexelStore many = before;
    const TexelPatch patch = changeLevels(one, sphere(), levels, Threads{1}, progress).value();
    (void)changeLevels(many, sphere(), levels, Threads{4}, progress).value();
    for (const FaceId face : allFaces(before)) {
        EXPECT_EQ(one.face(face), many.face(face));
        if (std::ranges::find(some, face) == some.end()) {
            EXPECT_EQ(one.face(face), before.face(face));
        }
    }
    EXPECT_LE(patch.faces().size(), some.size());

    // Cut out of the mesh or with all of it, the averages are the same.
    TexelStore all = before;
    FaceMap<Level> everywhere =
        changedLevels(before, allFaces(before), {LevelChange::Kind::Double, Level(0)});
    FaceMap<Level> alone = levelsOf(before);
    const FaceId chosen = faceId(17);
    alone[chosen] = everywhere[chosen];
    TexelStore single = before;
    (void)changeLevels(all, sphere(), everywhere, Threads{2}, progress).value();
    (void)changeLevels(single, sphere(), alone, Threads{2}, progress).value();
    EXPECT_EQ(all.face(chosen), single.face(chosen));
}

TEST(LevelChange, aTexelThatIsNotANumberSpoilsOnlyWhatTouchesIt)
{
    const TexelFormat format{TexelType::Float, 1, std::nullopt};
    TexelStore store = noiseStore(sphere(), format, 6);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::vector<float> values(Level(2).texelCount(), 0.25F);
    values[5] = nan;
    store.exchange(faceId(0), FaceTexels::full(Level(2), 4, std::as_bytes(std::span(values))));
    change(store, sphere(), kDouble);
    const auto finer = decoded(format, store.face(faceId(0)));
    const auto spoilt = std::ranges::count_if(finer, [](float v) { return std::isnan(v); });
    EXPECT_EQ(spoilt, 4);
}

TEST(LevelChange, costCountsTexelsAndBytes)
{
    const TexelFormat format{TexelType::Half, 4, std::nullopt};
    const std::array<float, 4> grey{};
    TexelStore store(10, format, Level(3), encoded(format, grey));
    const std::vector<FaceId> two = {faceId(1), faceId(9)};
    const LevelCost cost = levelCost(store, changedLevels(store, two, kDouble));
    EXPECT_EQ(cost.texelsBefore, 640U);
    EXPECT_EQ(cost.texelsAfter, 640U + 2 * 192U);
    EXPECT_EQ(cost.bytesAfter, cost.texelsAfter * 8);
    EXPECT_EQ(cost.changedFaces, 2U);
}

class Refuses final : public Progress
{
public:
    bool report(double /*fraction*/) override { return false; }
};

TEST(LevelChange, cancelledItLeavesTheStoreAsItWas)
{
    const TexelFormat format;
    const TexelStore before = noiseStore(sphere(), format, 7);
    TexelStore store = before;
    Refuses progress;
    const auto levels = changedLevels(store, allFaces(store), kHalve);
    const auto patch = changeLevels(store, sphere(), levels, Threads{2}, progress);
    ASSERT_FALSE(patch);
    EXPECT_EQ(patch.error().kind, ErrorKind::Cancelled);
    for (const FaceId face : allFaces(store)) {
        EXPECT_EQ(store.face(face), before.face(face));
    }
}

TEST(LevelChange, stopsAtTheLowestAndTheHighestLevel)
{
    EXPECT_EQ(kHalve.appliedTo(Level(0)), Level(0));
    EXPECT_EQ(kDouble.appliedTo(Level(Level::kMax)), Level(Level::kMax));
}

} // namespace
} // namespace trixel
