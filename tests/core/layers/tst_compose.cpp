// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/compose.h"
#include "core/texture/stored_faces.h"
#include "core/texture/texel_patch.h"
#include "tests/core/cancel_after.h"
#include "tests/core/layers/layers_fixture.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

using namespace trixel;
using namespace trixel::test;

namespace {

/// One face of one texel: the base and one layer over it.
LayerStack
single(TexelType type, std::vector<float> base, std::vector<float> layer, LayerSettings settings)
{
    const TexelFormat format = formatOf(type, static_cast<int>(base.size()));
    LayerStack stack(TexelStore(1, format, Level(0), encoded(type, base)));
    const LayerId id = stack.insert(0, std::move(settings));
    stack.texels(id).exchange(faceId(0), FaceTexels::constant(Level(0), encoded(type, layer)));
    return stack;
}

std::vector<float> shownTexel(const LayerStack& stack)
{
    return decodedTexel(shownOf(stack).shown, faceId(0), 0);
}

TouchedRect randomRect(std::mt19937& random, FaceId face, Level level)
{
    const std::size_t side = level.resolution();
    const std::size_t x = random() % side;
    const std::size_t y = random() % side;
    const auto some = [](std::size_t value) { return static_cast<std::uint16_t>(value); };
    return {face,
            some(x),
            some(y),
            some(1 + random() % (side - x)),
            some(1 + random() % (side - y)),
            false};
}

void paintRect(std::mt19937& random, TexelStore& store, const TouchedRect& rect)
{
    const TexelFormat& format = store.format();
    const std::uint32_t side = store.face(rect.face).level().resolution();
    const std::span<std::byte> texels = store.writable(rect.face);
    for (std::uint32_t y = rect.y; y < std::uint32_t{rect.y} + rect.height; ++y) {
        for (std::uint32_t x = rect.x; x < std::uint32_t{rect.x} + rect.width; ++x) {
            const auto value = encoded(format.type, randomTexel(random, format));
            std::ranges::copy(value, texels.begin() + (y * side + x) * format.texelBytes());
        }
    }
}

LayerId anyLayer(std::mt19937& random, const LayerStack& stack)
{
    const std::size_t k = random() % (stack.layers().size() + 1);
    return k == 0 ? kBaseLayer : stack.layers()[k - 1].id;
}

/// One change a user could make.
void editAtRandom(std::mt19937& random, LayerStack& stack)
{
    const auto count = stack.layers().size();
    const LayerId layer = count == 0 ? kBaseLayer : stack.layers()[random() % count].id;
    switch (count == 0 ? 0 : random() % 6) {
    case 0:
        if (stack.hasRoom() && count < 6) {
            paintAtRandom(
                random,
                stack.texels(stack.insert(random() % (count + 1), randomSettings(random))),
                2);
        }
        break;
    case 1:
        stack.move(layer, random() % count);
        break;
    case 2:
        stack.set(layer, randomSettings(random));
        break;
    case 3:
        stack.remove(layer);
        break;
    default: {
        TexelStore& store = stack.texels(anyLayer(random, stack));
        const FaceId face = faceId(random() % store.faceCount());
        store.exchange(face, randomFace(random, store.format(), store.face(face).level()));
    }
    }
}

/// Faces of three channels of bytes, of which one cannot be read.
class OneFails final : public FaceReader
{
public:
    explicit OneFails(FaceId fails)
        : m_fails(fails)
    {
    }
    Result<bool> read(FaceId face, Level /*level*/, std::span<std::byte> texels) const override
    {
        std::ranges::fill(texels, std::byte{77});
        texels[0] = std::byte{9};
        return face == m_fails ? Result<bool>(contentsError("torn")) : Result<bool>(true);
    }
    bool stores(FaceId /*face*/, Level /*level*/) const override { return false; }
    std::span<const std::byte> mean(FaceId /*face*/) const override { return m_mean; }

private:
    FaceId m_fails;
    std::array<std::byte, 3> m_mean{};
};

/// A base of 20 faces that lie in a file, the third torn, and a layer that covers some of them.
LayerStack storedStack(std::span<const FaceId> covered)
{
    const auto stored = StoredFaces::make(TexelFormat(), std::make_unique<OneFails>(faceId(3)));
    TexelStore base(20, TexelFormat(), Level(2), std::vector<std::byte>(3));
    for (const FaceId face : allFaces(base)) {
        base.exchange(face, stored->face(face, Level(2)));
    }
    LayerStack stack(std::move(base));
    TexelStore& layer = stack.texels(stack.insert(0, {}));
    for (const FaceId face : covered) {
        layer.writable(face)[3] = std::byte{128};
    }
    return stack;
}

} // namespace

TEST(Compose, showsWhatTheFormulasSayForAllTypesAndChannels)
{
    std::mt19937 random(1);
    for (const TexelType type : kTypes) {
        for (const int channels : {1, 2, 3, 4, 7}) {
            const LayerStack stack = randomStack(random, formatOf(type, channels), 40, 5);
            expectShows(stack, shownOf(stack).shown);
        }
    }
}

TEST(Compose, everyBlendModeAndOpacityMeetsTheValuesBelow)
{
    for (const LayerBlend blend : kLayerBlends) {
        const LayerStack stack = single(TexelType::Float,
                                        {0.25F, 0.75F, 0.5F},
                                        {0.5F, 0.5F, 1.0F, 0.5F},
                                        {"", 0.5F, blend, true});
        const std::vector<float> shown = shownTexel(stack);
        for (std::size_t c = 0; c < 3; ++c) {
            const float below = std::array{0.25F, 0.75F, 0.5F}[c];
            const float value = blended(blend, below, std::array{0.5F, 0.5F, 1.0F}[c]);
            EXPECT_FLOAT_EQ(shown[c], below + 0.25F * (value - below)) << nameOf(blend);
        }
    }
}

TEST(Compose, fullCoverageStoresTheValueItselfAndNoneLeavesTheBits)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(shownTexel(single(TexelType::Float, {1e20F}, {0.1F, 1}, {})), std::vector{0.1F});
    EXPECT_EQ(shownTexel(single(TexelType::Float, {nan}, {0.1F, 1}, {})), std::vector{0.1F});
    EXPECT_EQ(shownTexel(single(TexelType::Float, {0.3F}, {nan, 0}, {})), std::vector{0.3F});
    EXPECT_EQ(shownTexel(single(TexelType::Float, {0.3F}, {0.5F, nan}, {})), std::vector{0.3F});
    EXPECT_EQ(shownTexel(single(TexelType::Float, {0.3F}, {0.5F, 7}, {})), std::vector{0.5F});
    EXPECT_EQ(shownTexel(single(TexelType::Float, {0.3F}, {0.5F, -1}, {})), std::vector{0.3F});
}

TEST(Compose, uncoveredTexelsKeepTheirBitsBesideCoveredOnes)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    const std::array below{nan, 0.3F, 0.3F, 0.3F};
    const std::array over{0.1F, 0.0F, nan, 0.0F, inf, 0.0F, 0.5F, 1.0F}; // the last is covered
    for (const TexelType type : {TexelType::Half, TexelType::Float}) {
        const TexelFormat format = formatOf(type, 1);
        TexelStore base(1, format, Level(1), std::vector<std::byte>(byteSize(type)));
        auto before = encoded(type, below);
        before[0] |= std::byte{1}; // a NaN of its own
        base.exchange(faceId(0), FaceTexels::full(Level(1), byteSize(type), before));
        LayerStack stack(std::move(base));
        const LayerId id = stack.insert(0, {});
        stack.texels(id).exchange(
            faceId(0), FaceTexels::full(Level(1), 2 * byteSize(type), encoded(type, over)));
        const TexelStore shown = shownOf(stack).shown;
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_TRUE(std::ranges::equal(shown.face(faceId(0)).texel(k),
                                           stack.base().face(faceId(0)).texel(k)))
                << nameOf(type) << ", texel " << k;
        }
        EXPECT_EQ(decodedTexel(shown, faceId(0), 3), std::vector{0.5F});
    }
}

TEST(Compose, aCoveredTexelHoldsTheValueItselfWhateverLiesBelow)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    const std::array below{nan, inf, 1e20F, 0.3F};
    const std::array over{0.1F, 1.0F, 0.1F, 1.0F, 0.1F, 1.0F, 0.2F, 1.0F};
    TexelStore base(1, formatOf(TexelType::Float, 1), Level(1), std::vector<std::byte>(4));
    base.exchange(faceId(0), FaceTexels::full(Level(1), 4, encoded(TexelType::Float, below)));
    LayerStack stack(std::move(base));
    stack.texels(stack.insert(0, {}))
        .exchange(faceId(0), FaceTexels::full(Level(1), 8, encoded(TexelType::Float, over)));
    const TexelStore shown = shownOf(stack).shown;
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_EQ(decodedTexel(shown, faceId(0), k), std::vector{over[2 * k]});
    }
}

TEST(Compose, aStackWithoutLayersBecomesPlain)
{
    std::mt19937 random(2);
    const LayerStack stack = randomStack(random, formatOf(TexelType::UInt8, 3), 10, 0);
    const Layered layered = shownOf(stack);
    EXPECT_TRUE(layered.layers.isPlain());
    EXPECT_EQ(layered.layers.base().faceCount(), 0U);
    EXPECT_TRUE(sameTexels(layered.shown, stack.base()));
}

TEST(Compose, facesThatNothingCoversShareTheBytesOfTheBase)
{
    std::mt19937 random(3);
    LayerStack stack(randomStack(random, formatOf(TexelType::UInt8, 3), 1000, 0).base());
    const LayerId painted = stack.insert(0, {});
    const LayerId hidden = stack.insert(1, {"", 1, LayerBlend::Normal, false});
    const LayerId clear = stack.insert(2, {"", 0, LayerBlend::Normal, true});
    paintAtRandom(random, stack.texels(hidden), 100);
    paintAtRandom(random, stack.texels(clear), 100);
    stack.texels(painted).writable(faceId(7)); // spread out, and still covers nothing
    stack.texels(painted).writable(faceId(8))[3] = std::byte{1};
    const TexelStore shown = shownOf(stack).shown;
    for (std::uint32_t f = 0; f < 1000; ++f) {
        EXPECT_EQ(shown.face(faceId(f)).sharesBytesWith(stack.base().face(faceId(f))), f != 8) << f;
        const bool sharesBlock = &shown.face(faceId(f)) == &stack.base().face(faceId(f));
        EXPECT_EQ(sharesBlock, f >= 256) << f;
    }
}

TEST(Compose, constantFacesStayConstantAndAFillHidesWhatLiesBelow)
{
    const std::vector<std::byte> grey(3, std::byte{128});
    LayerStack stack(TexelStore(4, formatOf(TexelType::UInt8, 3), Level(3), grey));
    stack.texels(kBaseLayer).writable(faceId(2))[0] = std::byte{1};
    const LayerId layer = stack.insert(0, {});
    const auto red = encoded(TexelType::UInt8, std::array{1.0F, 0.0F, 0.0F, 1.0F});
    const auto thin = encoded(TexelType::UInt8, std::array{1.0F, 0.0F, 0.0F, 0.5F});
    stack.texels(layer).exchange(faceId(0), FaceTexels::constant(Level(3), thin));
    stack.texels(layer).exchange(faceId(1), FaceTexels::constant(Level(3), red));
    stack.texels(layer).exchange(faceId(2), FaceTexels::constant(Level(3), red));
    const TexelStore shown = shownOf(stack).shown;
    for (std::uint32_t f = 0; f < 4; ++f) {
        EXPECT_TRUE(shown.face(faceId(f)).isConstant()) << f;
    }
    EXPECT_TRUE(shown.face(faceId(1)).sharesBytesWith(shown.face(faceId(2))));
    expectShows(stack, shown);
}

TEST(Compose, repaintedRectanglesShowWhatComposingAllShows)
{
    std::mt19937 random(4);
    for (const TexelType type : kTypes) {
        LayerStack stack = randomStack(random, formatOf(type, 3), 60, 4);
        TexelStore shown = shownOf(stack).shown;
        for (int step = 0; step < 30; ++step) {
            TexelStore& store = stack.texels(anyLayer(random, stack));
            std::vector<TouchedRect> rects;
            for (std::size_t f = random() % 20; f < 60; f += 1 + random() % 20) {
                const FaceTexels& face = store.face(faceId(f));
                rects.push_back(randomRect(random, faceId(f), face.level()));
                rects.back().wholeFace = face.isConstant();
                paintRect(random, store, rects.back());
            }
            recompose(stack, rects, shown, Threads{2});
            ASSERT_TRUE(sameTexels(shown, shownOf(stack).shown)) << nameOf(type) << step;
        }
    }
}

TEST(Compose, facesOfOtherLevelsAreShownAnew)
{
    std::mt19937 random(5);
    LayerStack stack = randomStack(random, formatOf(TexelType::UInt8, 3), 20, 2);
    TexelStore shown = shownOf(stack).shown;
    const std::array faces{faceId(3), faceId(9)};
    for (const FaceId face : faces) {
        for (const LayerId layer : {kBaseLayer, stack.layers()[0].id, stack.layers()[1].id}) {
            TexelStore& store = stack.texels(layer);
            store.exchange(face, randomFace(random, store.format(), Level(5)));
        }
    }
    recompose(stack, faces, shown, Threads{2});
    EXPECT_TRUE(sameTexels(shown, shownOf(stack).shown));
}

TEST(Compose, takingBackAStrokeOnALayerBringsBackTheBitsAndTheSharing)
{
    std::mt19937 random(6);
    LayerStack stack = randomStack(random, formatOf(TexelType::Half, 3), 20, 0);
    const LayerId layer = stack.insert(0, {});
    Layered now = shownOf(stack);
    TexelStore& store = stack.texels(layer);
    TexelPatch patch;
    for (const FaceId face : {faceId(2), faceId(11)}) {
        patch.addFace(
            face,
            store.exchange(face, randomFace(random, store.format(), store.face(face).level())));
    }
    recompose(stack, patch.faces(), now.shown, Threads{2});
    EXPECT_TRUE(sameTexels(now.shown, shownOf(stack).shown));
    patch.swap(store);
    recompose(stack, patch.faces(), now.shown, Threads{2});
    for (std::uint32_t f = 0; f < 20; ++f) {
        EXPECT_TRUE(now.shown.face(faceId(f)).sharesBytesWith(stack.base().face(faceId(f)))) << f;
    }
}

TEST(Compose, recomposingFollowsEditsOfAllKinds)
{
    std::mt19937 random(7);
    for (const TexelType type : kTypes) {
        NoProgress progress;
        Layered now = shownOf(randomStack(random, formatOf(type, 2), 30, 3));
        for (int step = 0; step < 100; ++step) {
            LayerStack next = now.layers.isPlain() ? LayerStack(now.shown) : now.layers;
            for (unsigned k = 0; k <= random() % 3; ++k) {
                editAtRandom(random, next);
            }
            now = recomposed(next, now, Threads{2}, progress).value();
            ASSERT_EQ(now.layers.isPlain(), next.isPlain());
            ASSERT_TRUE(sameTexels(now.shown, shownOf(next).shown)) << nameOf(type) << step;
        }
    }
}

TEST(Compose, recomposingKeepsFacesThatNothingChangedAndBlocksOfTheBase)
{
    std::mt19937 random(8);
    LayerStack stack(randomStack(random, formatOf(TexelType::UInt8, 3), 600, 0).base());
    const LayerId a = stack.insert(0, {});
    const LayerId b = stack.insert(1, {});
    for (const auto& [layer, face] : {std::pair(a, 5), std::pair(b, 300)}) {
        TexelStore& store = stack.texels(layer);
        const FaceId at = faceId(static_cast<std::size_t>(face));
        store.exchange(
            at,
            FaceTexels::constant(store.face(at).level(),
                                 encoded(TexelType::UInt8, std::array{1.F, 0.F, 1.F, 1.F})));
    }
    const Layered before = shownOf(stack);
    LayerStack next = stack;
    next.set(b, {"", 1, LayerBlend::Normal, false});
    next.insert(0, {});
    NoProgress progress;
    const Layered after = recomposed(next, before, Threads{2}, progress).value();
    EXPECT_TRUE(after.shown.face(faceId(5)).sharesBytesWith(before.shown.face(faceId(5))));
    EXPECT_TRUE(after.shown.face(faceId(300)).sharesBytesWith(stack.base().face(faceId(300))));
    EXPECT_EQ(&after.shown.face(faceId(300)), &stack.base().face(faceId(300)));
}

TEST(Compose, isTheSameForAnyNumberOfThreads)
{
    std::mt19937 random(9);
    LayerStack stack = randomStack(random, formatOf(TexelType::Float, 3), 300, 6);
    const std::array large{faceId(7)};
    for (const Layer& layer : std::vector(stack.layers().begin(), stack.layers().end())) {
        stack.texels(layer.id).exchange(large[0],
                                        randomFace(random, layer.texels.format(), Level(9)));
    }
    stack.texels(kBaseLayer)
        .exchange(large[0], randomFace(random, stack.base().format(), Level(9)));
    const TexelStore one = shownOf(stack, 1).shown;
    for (const unsigned threads : {2U, 8U}) {
        EXPECT_TRUE(sameTexels(one, shownOf(stack, threads).shown)) << threads;
        TexelStore shown = stack.base();
        recompose(stack, allFaces(shown), shown, Threads{threads});
        EXPECT_TRUE(sameTexels(one, shown)) << threads;
    }
}

TEST(Compose, stopsWhenCancelled)
{
    std::mt19937 random(10);
    const LayerStack stack = randomStack(random, formatOf(TexelType::UInt8, 3), 30'000, 1);
    for (const int reports : {0, 2}) {
        CancelAfter progress(reports);
        const auto result = composed(stack, Threads{2}, progress);
        ASSERT_FALSE(result);
        EXPECT_EQ(result.error().kind, ErrorKind::Cancelled);
    }
}

TEST(Compose, facesInAFileAreReadOnlyWhereSomethingCoversThem)
{
    const std::array covered{faceId(4), faceId(5)};
    const LayerStack stack = storedStack(covered);
    const TexelStore shown = shownOf(stack).shown;
    for (const FaceId face : allFaces(shown)) {
        const bool isCovered = face == covered[0] || face == covered[1];
        EXPECT_EQ(shown.face(face).isStored(), !isCovered);
        EXPECT_FALSE(stack.base().face(face).isLoaded()); // held no longer than it took
    }
    expectShows(stack, shown);
}

TEST(Compose, aFaceThatCouldNotBeReadIsNamedAndNeverPassesForPaint)
{
    const std::array covered{faceId(2), faceId(3)};
    const LayerStack stack = storedStack(covered);
    NoProgress progress;
    const auto refused = composed(stack, Threads{2}, progress);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message,
              "face 3 could not be read from its file; fill it before layers are put together "
              "there");
    TexelStore shown = stack.base();
    recompose(stack, covered, shown, Threads{2});
    EXPECT_FALSE(shown.face(faceId(2)).isDamaged());
    EXPECT_TRUE(shown.face(faceId(3)).isDamaged());
    EXPECT_TRUE(shown.face(faceId(3)).pinned().isDamaged());
    EXPECT_FALSE(shown.checkWhole());
}

TEST(Compose, oneValueAtAnotherLevelIsAnotherFace)
{
    const std::vector<std::byte> grey(3, std::byte{128});
    LayerStack stack(TexelStore(3, formatOf(TexelType::UInt8, 3), Level(3), grey));
    const LayerId layer = stack.insert(0, {});
    const auto thin = encoded(TexelType::UInt8, std::array{1.0F, 0.0F, 0.0F, 0.5F});
    stack.texels(layer).exchange(faceId(1), FaceTexels::constant(Level(3), thin));
    const Layered before = shownOf(stack);
    for (const LayerId id : {kBaseLayer, layer}) {
        TexelStore& store = stack.texels(id);
        store.exchange(faceId(1), store.face(faceId(1)).atLevel(Level(1)));
    }
    NoProgress progress;
    const Layered after = recomposed(stack, before, Threads{2}, progress).value();
    EXPECT_EQ(after.shown.face(faceId(1)).level(), Level(1));
}
