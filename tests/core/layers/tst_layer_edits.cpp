// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layer_edits.h"
#include "core/mesh/surface.h"
#include "core/texture/level_change.h"
#include "tests/core/cancel_after.h"
#include "tests/core/layers/layers_fixture.h"
#include "tests/core/test_meshes.h"

#include <gtest/gtest.h>

#include <limits>

using namespace trixel;
using namespace trixel::test;

namespace {

LayerStack merged(const LayerStack& layers, LayerId layer, unsigned threads = 2)
{
    NoProgress progress;
    return mergedDown(layers, layer, Threads{threads}, progress).value();
}

/// What both show differs by rounding alone: of the layer that is new as well as of what is shown.
void expectLooksAlike(const LayerStack& a, const LayerStack& b, double steps)
{
    const TexelStore before = shownOf(a).shown;
    const TexelStore after = shownOf(b).shown;
    const TexelType type = before.format().type;
    for (const FaceId face : allFaces(before)) {
        for (std::uint32_t k = 0; k < before.face(face).level().texelCount(); ++k) {
            const auto x = decodedTexel(before, face, k);
            const auto y = decodedTexel(after, face, k);
            for (std::size_t c = 0; c < x.size(); ++c) {
                ASSERT_NEAR(x[c], y[c], steps * stepOf(type, 1))
                    << nameOf(type) << ", face " << indexOf(face) << ", texel " << k;
            }
        }
    }
}

/// Of a base and layers of given settings, painted at random.
LayerStack stackOf(std::mt19937& random, TexelType type, std::vector<LayerSettings> settings)
{
    LayerStack stack(randomStack(random, formatOf(type, 3), 40, 0).base());
    for (std::size_t k = 0; k < settings.size(); ++k) {
        paintAtRandom(random, stack.texels(stack.insert(k, settings[k])), 2);
    }
    return stack;
}

LayerId idAt(const LayerStack& layers, std::size_t place)
{
    return layers.layers()[place].id;
}

std::shared_ptr<const Surface> sphere()
{
    NoProgress progress;
    return *Surface::build(sphereMesh(0), progress); // 20 faces
}

LayerStack levelled(const LayerStack& layers, const FaceMap<Level>& levels, unsigned threads = 2)
{
    NoProgress progress;
    return withLevels(layers, sphere()->adjacency(), levels, Threads{threads}, progress).value();
}

} // namespace

TEST(MergedDown, ontoTheBaseLooksAsBeforeInEveryBlendMode)
{
    std::mt19937 random(1);
    for (const TexelType type : kTypes) {
        for (const LayerBlend blend : kLayerBlends) {
            LayerStack stack = stackOf(random, type, {{"", 0.6F, blend, true}});
            const bool staysInside = blend != LayerBlend::Add && blend != LayerBlend::Subtract;
            if (staysInside || type == TexelType::Float) { // integers cut off what does not
                paintAtRandom(random, stack.texels(stack.insert(1, {})), 2);
            }
            const LayerStack after = merged(stack, idAt(stack, 0));
            ASSERT_EQ(after.layers().size(), stack.layers().size() - 1);
            EXPECT_FALSE(after.has(idAt(stack, 0)));
            expectLooksAlike(stack, after, 2.5);
        }
    }
}

TEST(MergedDown, aNormalLayerOntoANormalOneLooksAsBefore)
{
    std::mt19937 random(2);
    for (const TexelType type : kTypes) {
        const LayerStack stack = stackOf(random,
                                         type,
                                         {{"", 0.9F, LayerBlend::Multiply, true},
                                          {"lower", 0.7F, LayerBlend::Normal, true},
                                          {"upper", 0.4F, LayerBlend::Normal, true},
                                          {"", 1, LayerBlend::Screen, true}});
        const LayerStack after = merged(stack, idAt(stack, 2));
        ASSERT_EQ(after.layers().size(), 3U);
        EXPECT_EQ(after.layers()[1].id, idAt(stack, 1));
        EXPECT_EQ(after.layers()[1].settings,
                  (LayerSettings{"lower", 1, LayerBlend::Normal, true}));
        expectLooksAlike(stack, after, 4);
    }
}

TEST(MergedDown, ontoALayerThatCoversAllLooksAsBeforeInEveryBlendMode)
{
    std::mt19937 random(3);
    for (const LayerBlend blend : kLayerBlends) {
        LayerStack stack = stackOf(random, TexelType::Float, {{}, {"", 0.8F, blend, true}});
        TexelStore& lower = stack.texels(idAt(stack, 0));
        for (const FaceId face : allFaces(lower)) {
            const auto red = encoded(TexelType::Float, std::array{0.7F, 0.2F, 0.4F, 1.0F});
            lower.exchange(face, FaceTexels::constant(lower.face(face).level(), red));
        }
        expectLooksAlike(stack, merged(stack, idAt(stack, 1)), 1);
    }
}

TEST(MergedDown, whateverLiesUncoveredBelowLendsNothing)
{
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const TexelFormat format = formatOf(TexelType::Float, 1);
    for (const LayerBlend blend : kLayerBlends) {
        for (const float below : {kInfinity, -kInfinity, std::nanf("")}) {
            LayerStack stack(TexelStore(1, format, Level(0), encoded(format.type, {{0.25F}})));
            const LayerId lower = stack.insert(0, {});
            const LayerId upper = stack.insert(1, {"", 1, blend, true});
            const auto hold = [&](LayerId layer, std::array<float, 2> texel) {
                const auto bytes = encoded(format.type, texel);
                stack.texels(layer).exchange(faceId(0), FaceTexels::constant(Level(0), bytes));
            };
            hold(lower, {below, 0});
            hold(upper, {0.5F, 0.75F});
            const auto after = decodedTexel(merged(stack, upper).texels(lower), faceId(0), 0);
            EXPECT_EQ(after, (std::vector{0.5F, 0.75F})) << nameOf(blend) << ", " << below;
        }
    }
}

TEST(MergedDown, whatNothingCoversKeepsItsBytesAndOneValueStaysOne)
{
    std::mt19937 random(4);
    LayerStack stack = stackOf(random, TexelType::UInt8, {{}});
    const LayerId upper = stack.insert(1, {});
    const LayerId lower = idAt(stack, 0);
    const auto red = encoded(TexelType::UInt8, std::array{1.0F, 0.0F, 0.0F, 0.5F});
    for (const FaceId face : {faceId(3), faceId(4)}) {
        const Level level = stack.base().face(face).level();
        stack.texels(upper).exchange(face, FaceTexels::constant(level, red));
        stack.texels(lower).exchange(face, FaceTexels::constant(level, red));
    }
    const LayerStack after = merged(stack, upper);
    for (const FaceId face : allFaces(stack.base())) {
        const FaceTexels& now = after.texels(lower).face(face);
        const bool isMerged = face == faceId(3) || face == faceId(4);
        EXPECT_EQ(now.sharesBytesWith(stack.texels(lower).face(face)), !isMerged);
        EXPECT_TRUE(now.isConstant() || !isMerged);
    }
    EXPECT_TRUE(
        after.texels(lower).face(faceId(3)).sharesBytesWith(after.texels(lower).face(faceId(4))));
}

TEST(MergedDown, isTheSameForAnyNumberOfThreadsAndStopsWhenCancelled)
{
    std::mt19937 random(5);
    const LayerStack stack =
        stackOf(random, TexelType::Half, {{}, {"", 0.5F, LayerBlend::Overlay, true}});
    const LayerStack one = merged(stack, idAt(stack, 1), 1);
    for (const unsigned threads : {2U, 8U}) {
        const LayerStack many = merged(stack, idAt(stack, 1), threads);
        EXPECT_TRUE(sameTexels(one.texels(idAt(one, 0)), many.texels(idAt(many, 0))));
    }
    for (const std::size_t place : {0U, 1U}) {
        CancelAfter progress(0);
        const auto stopped = mergedDown(stack, idAt(stack, place), Threads{2}, progress);
        ASSERT_FALSE(stopped);
        EXPECT_EQ(stopped.error().kind, ErrorKind::Cancelled);
    }
}

TEST(MergedDown, aHiddenLayerIsNotMerged)
{
    std::mt19937 random(6);
    const LayerStack stack =
        stackOf(random, TexelType::UInt8, {{"", 1, LayerBlend::Normal, false}});
    EXPECT_DEATH(merged(stack, idAt(stack, 0)), "a layer that is shown");
}

TEST(WithLevels, givesAllLayersTheLevelsAndLeavesFacesThatKeepTheirs)
{
    std::mt19937 random(7);
    for (const TexelType type : kTypes) {
        const LayerStack stack = randomStack(random, formatOf(type, 3), 20, 3);
        FaceMap<Level> levels = levelsOf(stack.base());
        for (std::uint32_t f = 0; f < 20; f += 2) {
            levels[faceId(f)] = Level(static_cast<int>(random() % 6));
        }
        const LayerStack after = levelled(stack, levels);
        for (const Layer& layer : after.layers()) {
            EXPECT_EQ(levelsOf(layer.texels), levels);
            for (std::uint32_t f = 1; f < 20; f += 2) {
                const FaceTexels& before = stack.texels(layer.id).face(faceId(f));
                EXPECT_TRUE(layer.texels.face(faceId(f)).sharesBytesWith(before));
            }
        }
        EXPECT_EQ(levelsOf(after.base()), levels);
        TexelStore base = stack.base();
        NoProgress progress;
        ASSERT_TRUE(changeLevels(base, sphere()->adjacency(), levels, Threads{2}, progress));
        EXPECT_TRUE(sameTexels(after.base(), base));
    }
}

TEST(WithLevels, whatCoversNothingLendsNoColour)
{
    std::mt19937 random(8);
    for (const TexelType type : kTypes) {
        LayerStack stack(TexelStore(
            20, formatOf(type, 3), Level(3), std::vector<std::byte>(3 * byteSize(type))));
        TexelStore& layer = stack.texels(stack.insert(0, {}));
        // Red that is more or less covered, green that is not at all.
        for (const FaceId face : allFaces(layer)) {
            std::vector<float> values;
            for (std::uint32_t k = 0; k < Level(3).texelCount(); ++k) {
                const float coverage = static_cast<float>(random() % 3) / 2;
                const bool isCovered = coverage > 0;
                values.insert(values.end(),
                              {isCovered ? 1.0F : 0.0F, isCovered ? 0.0F : 1.0F, 0, coverage});
            }
            layer.exchange(
                face,
                FaceTexels::full(Level(3), layer.format().texelBytes(), encoded(type, values)));
        }
        for (const int level : {0, 1, 2, 4, 5}) {
            const LayerStack after = levelled(stack, FaceMap<Level>(20, Level(level)));
            const TexelStore& texels = after.layers()[0].texels;
            for (const FaceId face : allFaces(texels)) {
                for (std::uint32_t k = 0; k < Level(level).texelCount(); ++k) {
                    const auto value = decodedTexel(texels, face, k);
                    ASSERT_GE(value[3], 0.0F);
                    ASSERT_LE(value[3], 1.0F);
                    if (value[3] > 0) {
                        ASSERT_NEAR(value[0], 1.0F, 1e-3F) << nameOf(type) << ", level " << level;
                        ASSERT_NEAR(value[1], 0.0F, 1e-3F) << nameOf(type) << ", level " << level;
                    }
                }
            }
        }
    }
}

TEST(WithLevels, coarserTexelsHoldTheMeanOfPaintByItsCoverage)
{
    LayerStack stack(
        TexelStore(20, formatOf(TexelType::Float, 1), Level(1), std::vector<std::byte>(4)));
    TexelStore& layer = stack.texels(stack.insert(0, {}));
    const std::array values{1.0F, 0.5F, 0.0F, 1.0F, 7.0F, 0.0F, 0.25F, 0.5F}; // value, coverage
    layer.exchange(faceId(4), FaceTexels::full(Level(1), 8, encoded(TexelType::Float, values)));
    const LayerStack after = levelled(stack, FaceMap<Level>(20, Level(0)));
    const auto mean = decodedTexel(after.layers()[0].texels, faceId(4), 0);
    EXPECT_FLOAT_EQ(mean[1], 0.5F);
    EXPECT_FLOAT_EQ(mean[0], (0.5F + 0.125F) / 2);
    EXPECT_TRUE(after.layers()[0].texels.face(faceId(5)).isConstant());
}

TEST(WithLevels, finerAndBackIsThePaintAsBefore)
{
    std::mt19937 random(9);
    const LayerStack stack = randomStack(random, formatOf(TexelType::Float, 3), 20, 2);
    FaceMap<Level> levels = levelsOf(stack.base());
    const FaceMap<Level> before = levels;
    for (Level& level : levels.values()) {
        level = Level(level.log2() + 1);
    }
    const LayerStack after = levelled(levelled(stack, levels), before);
    for (const Layer& layer : stack.layers()) {
        const TexelStore& texels = after.texels(layer.id);
        for (const FaceId face : allFaces(texels)) {
            for (std::uint32_t k = 0; k < texels.face(face).level().texelCount(); ++k) {
                const auto x = decodedTexel(layer.texels, face, k);
                const auto y = decodedTexel(texels, face, k);
                ASSERT_NEAR(x.back(), y.back(), 1e-5F);
                for (std::size_t c = 0; c < x.size() && x.back() > 0.01F; ++c) {
                    ASSERT_NEAR(x[c], y[c], 1e-3F);
                }
            }
        }
    }
}

TEST(WithLevels, isTheSameForAnyNumberOfThreads)
{
    std::mt19937 random(10);
    const LayerStack stack = randomStack(random, formatOf(TexelType::Half, 3), 20, 2);
    const FaceMap<Level> levels(20, Level(4));
    const LayerStack one = levelled(stack, levels, 1);
    for (const unsigned threads : {2U, 8U}) {
        const LayerStack many = levelled(stack, levels, threads);
        for (const Layer& layer : one.layers()) {
            EXPECT_TRUE(sameTexels(layer.texels, many.texels(layer.id)));
        }
    }
}

TEST(LayerOfPatch, coversWhatThePatchChangesAndShowsIt)
{
    std::mt19937 random(11);
    for (const TexelType type : kTypes) {
        const TexelStore before = randomStack(random, formatOf(type, 3), 30, 0).base();
        TexelStore after = before;
        paintAtRandom(random, after, 3);
        TexelPatch patch;
        for (const FaceId face : allFaces(before)) {
            const FaceTexels& next = after.face(face);
            if (next.isConstant() || indexOf(face) % 2 == 0) {
                patch.addFace(face, next);
                continue;
            }
            // All but the first and the last texel.
            const std::uint32_t count = next.level().texelCount();
            if (count > 2) {
                const TexelPatch::Run run{1, count - 2};
                const std::size_t bytes = next.texelBytes();
                patch.addTexels(face, {&run, 1}, next.bytes().subspan(bytes, (count - 2) * bytes));
            }
        }
        LayerStack stack(before);
        const LayerId layer = stack.insert(0, {}, layerOfPatch(patch, before));
        TexelStore expected = before;
        TexelPatch(patch).swap(expected);
        EXPECT_TRUE(sameTexels(shownOf(stack).shown, expected)) << nameOf(type);
        for (const FaceId face : allFaces(before)) {
            for (std::uint32_t k = 0; k < before.face(face).level().texelCount(); ++k) {
                const bool changes =
                    !std::ranges::equal(before.face(face).texel(k), expected.face(face).texel(k));
                ASSERT_EQ(decodedTexel(stack.texels(layer), face, k).back(), changes ? 1.0F : 0.0F);
            }
        }
    }
}

TEST(LayerOfPatch, facesThePatchLeavesStayOfOneValue)
{
    const std::vector<std::byte> grey(3, std::byte{128});
    const TexelStore before(300, TexelFormat(), Level(2), grey);
    TexelPatch patch;
    const std::vector<std::byte> red{std::byte{255}, std::byte{0}, std::byte{0}};
    patch.addFace(faceId(7), FaceTexels::constant(Level(2), red));
    patch.addFace(faceId(8), FaceTexels::constant(Level(2), grey));
    const TexelStore layer = layerOfPatch(patch, before);
    for (const FaceId face : allFaces(layer)) {
        EXPECT_TRUE(layer.face(face).isConstant());
        EXPECT_EQ(decodedTexel(layer, face, 0).back(), face == faceId(7) ? 1.0F : 0.0F);
    }
}

TEST(LayerAlone, isTheBaseAsItIsOrTheLayerWithItsOpacityInTheCoverage)
{
    std::mt19937 random(12);
    NoProgress progress;
    for (const TexelType type : kTypes) {
        const LayerStack stack =
            stackOf(random, type, {{"", 0.5F, LayerBlend::Multiply, false}, {}});
        EXPECT_TRUE(
            sameTexels(layerAlone(stack, kBaseLayer, Threads{2}, progress).value(), stack.base()));
        const LayerId full = idAt(stack, 1);
        EXPECT_TRUE(
            sameTexels(layerAlone(stack, full, Threads{2}, progress).value(), stack.texels(full)));
        const TexelStore& texels = stack.texels(idAt(stack, 0));
        const TexelStore thin = layerAlone(stack, idAt(stack, 0), Threads{2}, progress).value();
        EXPECT_EQ(thin.format(), layerFormat(stack.base().format()));
        for (const FaceId face : allFaces(thin)) {
            EXPECT_EQ(thin.face(face).isConstant(), texels.face(face).isConstant());
            for (std::uint32_t k = 0; k < thin.face(face).level().texelCount(); ++k) {
                const auto x = decodedTexel(texels, face, k);
                const auto y = decodedTexel(thin, face, k);
                ASSERT_TRUE(std::equal(x.begin(), x.end() - 1, y.begin()));
                ASSERT_NEAR(x.back() * 0.5F, y.back(), stepOf(type, 1));
            }
        }
    }
}

TEST(CoveringTexel, hidesWhatLiesBelowInAllTypes)
{
    for (const TexelType type : kTypes) {
        const auto texel = encoded(type, std::array{0.2F, 1.0F, 0.0F});
        LayerStack stack(
            TexelStore(1, formatOf(type, 3), Level(1), encoded(type, std::array{1.F, 1.F, 1.F})));
        const LayerId layer = stack.insert(0, {});
        stack.texels(layer).exchange(
            faceId(0), FaceTexels::constant(Level(1), coveringTexel(stack.base().format(), texel)));
        EXPECT_TRUE(std::ranges::equal(shownOf(stack).shown.face(faceId(0)).bytes(), texel));
    }
}
