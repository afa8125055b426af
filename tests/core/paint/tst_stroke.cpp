// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/paint/stroke.h"
#include "tests/core/paint/paint_fixture.h"
#include "tests/core/test_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace trixel;
using test::coverageStore;
using test::sameToTheBit;
using test::surfaceOf;
using test::valueAt;
using test::whiteBrush;
using test::zeroFill;

namespace {

using Samples = std::vector<StrokeSample>;

FaceMap<Level> uniform(std::size_t faces, int level)
{
    return FaceMap<Level>(faces, Level(level));
}

/// A sample on the grid mesh of one cell: any point of the unit square.
StrokeSample onSquare(float x, float y, float pressure = 1)
{
    if (x + y <= 1) {
        return {faceId(0), {x, y}, pressure};
    }
    return {faceId(1), {1 - x, 1 - y}, pressure};
}

Samples randomSamples(std::mt19937& random, std::size_t faces, int count)
{
    std::uniform_real_distribution<float> part(0, 1);
    Samples samples;
    for (int k = 0; k < count; ++k) {
        const float u = part(random);
        samples.push_back(
            {faceId(random() % faces), {u, (1 - u) * part(random)}, part(random), 0.01 * k});
    }
    return samples;
}

TexelPatch paint(const std::shared_ptr<const Surface>& surface,
                 const Brush& brush,
                 std::span<const StrokeSample> samples,
                 TexelStore& store)
{
    Stroke stroke(surface, brush, zeroFill(store));
    for (const StrokeSample& sample : samples) {
        stroke.add(sample, store);
    }
    return stroke.finish(store);
}

float largest(const TexelStore& store)
{
    float value = 0;
    for (std::uint32_t k = 0; k < store.faceCount(); ++k) {
        for (std::uint32_t t = 0; t < store.face(faceId(k)).level().texelCount(); ++t) {
            value = std::max(value, valueAt(store, faceId(k), TexelIndex{t}));
        }
    }
    return value;
}

} // namespace

TEST(Stroke, opacityCapsHoweverOftenAStrokeCrossesItself)
{
    const auto surface = surfaceOf(test::gridMesh(1));
    Brush brush = whiteBrush(0.2F);
    brush.opacity = 0.35F;
    brush.flow = 0.6F;
    TexelStore store = coverageStore(uniform(2, 5));
    Samples samples;
    for (int k = 0; k < 40; ++k) {
        samples.push_back(onSquare(k % 2 == 0 ? 0.2F : 0.8F, 0.5F));
    }
    paint(surface, brush, samples, store);
    EXPECT_EQ(largest(store), 0.35F); // reached, and never passed
}

TEST(Stroke, flowBuildsUpDabByDab)
{
    const auto surface = surfaceOf(test::gridMesh(1));
    Brush brush = whiteBrush(0.5F);
    brush.hardness = 1;
    brush.flow = 0.25F;
    brush.opacity = 0.8F;
    brush.spacing = 0.01F; // 0.01 units apart
    TexelStore store = coverageStore(uniform(2, 2));
    Stroke stroke(surface, brush, zeroFill(store));
    stroke.add(onSquare(0.5F, 0.5F), store);
    const float once = largest(store);
    EXPECT_NEAR(once, 0.8F * 0.25F, 1e-6F);
    stroke.add(onSquare(0.511F, 0.5F), store); // one dab more
    EXPECT_NEAR(largest(store), 0.8F * (1 - 0.75F * 0.75F), 1e-6F);
    stroke.add(onSquare(0.521F, 0.5F), store); // and one more
    EXPECT_NEAR(largest(store), 0.8F * (1 - std::pow(0.75F, 3.0F)), 1e-6F);
}

TEST(Stroke, pressureSetsTheCapAndLighterDabsTakeNothingBack)
{
    const auto surface = surfaceOf(test::gridMesh(1));
    Brush brush = whiteBrush(0.4F);
    brush.pressureToOpacity = true;
    brush.hardness = 1;
    TexelStore store = coverageStore(uniform(2, 4));
    // One dab at the first sample, one 0.08 of the 0.1 further on: pressure 0.35.
    paint(surface, brush, Samples{onSquare(0.5F, 0.5F, 0.75F), onSquare(0.6F, 0.5F, 0.25F)}, store);
    EXPECT_EQ(largest(store), 0.75F);
    float smallest = 1;
    std::size_t strong = 0;
    for (std::uint32_t t = 0; t < 512; ++t) {
        const float value = valueAt(store, faceId(t / 256), TexelIndex{t % 256});
        smallest = value > 0 ? std::min(smallest, value) : smallest;
        strong += value == 0.75F ? 1 : 0;
    }
    EXPECT_NEAR(smallest, 0.35F, 1e-6F); // where only the light dab came
    // The first dab's disc keeps its strength.
    EXPECT_NEAR(static_cast<double>(strong), 3.14159 * 0.16 * 512, 12);
}

TEST(Stroke, pressureSetsTheSizeAndNonePaintsNothing)
{
    const auto surface = surfaceOf(test::gridMesh(1));
    Brush brush = whiteBrush(0.4F);
    brush.pressureToSize = true;
    brush.hardness = 1;
    TexelStore half = coverageStore(uniform(2, 6));
    paint(surface, brush, Samples{onSquare(0.5F, 0.5F, 0.5F)}, half);
    TexelStore small = coverageStore(uniform(2, 6));
    Brush smaller = brush;
    smaller.radius = 0.2F;
    paint(surface, smaller, Samples{onSquare(0.5F, 0.5F, 1.0F)}, small);
    EXPECT_TRUE(sameToTheBit(half, small));
    EXPECT_GT(largest(half), 0);

    TexelStore none = coverageStore(uniform(2, 6));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const TexelPatch patch =
        paint(surface, brush, Samples{onSquare(0.5F, 0.5F, 0.0F), onSquare(0.6F, 0.5F, nan)}, none);
    EXPECT_TRUE(patch.isEmpty());
}

TEST(Stroke, eightBitTexturesDoNotDriftUnderManyWeakDabs)
{
    // The same stroke in float and in uint8, from the same start: rounding happens once.
    const auto surface = surfaceOf(test::sphereMesh(1));
    Brush brush = whiteBrush(0.5F);
    brush.flow = 0.02F;
    brush.spacing = 0.02F;
    brush.color = {0.9F, 0.1F, 0.4F, 1};
    std::mt19937 random(4);
    const Samples samples = randomSamples(random, 80, 8);
    const TexelFormat bytes{TexelType::UInt8, 3, std::nullopt};
    const TexelFormat floats{TexelType::Float, 3, std::nullopt};
    const std::array start{60.0F / 255, 200.0F / 255, 17.0F / 255};
    std::vector<std::byte> byteFill(3);
    std::vector<std::byte> floatFill(12);
    encode(TexelType::UInt8, start, byteFill);
    encode(TexelType::Float, start, floatFill);
    TexelStore a(80, bytes, Level(4), byteFill);
    TexelStore b(80, floats, Level(4), floatFill);
    paint(surface, brush, samples, a);
    paint(surface, brush, samples, b);
    std::size_t changed = 0;
    for (std::uint32_t k = 0; k < 80; ++k) {
        for (std::uint32_t t = 0; t < 256; ++t) {
            std::array<float, 3> value{};
            decode(TexelType::Float, b.face(faceId(k)).texel(t), value);
            std::array<std::byte, 3> rounded{};
            encode(TexelType::UInt8, value, rounded);
            ASSERT_TRUE(std::ranges::equal(rounded, a.face(faceId(k)).texel(t)));
            changed += std::ranges::equal(rounded, byteFill) ? 0 : 1;
        }
    }
    EXPECT_GT(changed, 1000U);
}

TEST(Stroke, eraseGoesBackTowardsTheFill)
{
    const auto surface = surfaceOf(test::gridMesh(1));
    TexelStore store = coverageStore(uniform(2, 4));
    Brush brush = whiteBrush(3);
    brush.hardness = 1;
    paint(surface, brush, Samples{onSquare(0.5F, 0.5F)}, store);
    EXPECT_EQ(largest(store), 1.0F);
    brush.blend = BlendMode::Erase;
    brush.opacity = 0.25F;
    paint(surface, brush, Samples{onSquare(0.5F, 0.5F)}, store);
    EXPECT_EQ(largest(store), 0.75F);
    brush.opacity = 1;
    paint(surface, brush, Samples{onSquare(0.5F, 0.5F)}, store);
    EXPECT_EQ(largest(store), 0.0F);
}

TEST(Stroke, moreSamplesOnTheSameWayGiveTheSamePaint)
{
    const auto surface = surfaceOf(test::gridMesh(1));
    const Brush brush = whiteBrush(0.07F);
    TexelStore few = coverageStore(uniform(2, 6));
    TexelStore many = coverageStore(uniform(2, 6));
    paint(surface, brush, Samples{onSquare(0.1F, 0.2F), onSquare(0.9F, 0.6F)}, few);
    Samples dense;
    for (int k = 0; k <= 400; ++k) {
        const float part = static_cast<float>(k) / 400;
        dense.push_back(onSquare(0.1F + 0.8F * part, 0.2F + 0.4F * part));
    }
    paint(surface, brush, dense, many);
    for (std::uint32_t f = 0; f < 2; ++f) {
        for (std::uint32_t t = 0; t < 4096; ++t) {
            ASSERT_NEAR(valueAt(few, faceId(f), TexelIndex{t}),
                        valueAt(many, faceId(f), TexelIndex{t}),
                        2e-4F);
        }
    }
}

TEST(Stroke, snapshotsBetweenSamplesAndThreadsChangeNothing)
{
    const auto surface = surfaceOf(test::sphereMesh(2));
    std::mt19937 random(8);
    const Samples samples = randomSamples(random, 320, 4);
    Brush brush = whiteBrush(1.5F); // half the sphere: enough texels for several threads
    brush.spacing = 0.3F;
    const FaceMap<Level> levels = uniform(320, 6);
    TexelStore plain = coverageStore(levels);
    paint(surface, brush, samples, plain);

    TexelStore watched = coverageStore(levels);
    Stroke stroke(surface, brush, zeroFill(watched), Threads{7});
    std::vector<TexelStore> snapshots;
    for (const StrokeSample& sample : samples) {
        stroke.add(sample, watched);
        snapshots.push_back(watched);
    }
    stroke.finish(watched);
    EXPECT_TRUE(sameToTheBit(plain, watched));
    EXPECT_FALSE(sameToTheBit(snapshots.front(), watched));
}

TEST(Stroke, aLiftedStrokeLeavesTheGapUnpaintedAndStillCapsAsOne)
{
    const auto surface = surfaceOf(test::gridMesh(1));
    Brush brush = whiteBrush(0.1F);
    brush.opacity = 0.5F;
    TexelStore store = coverageStore(uniform(2, 6));
    const TexelStore before = store;
    Stroke stroke(surface, brush, zeroFill(store));
    stroke.add(onSquare(0.15F, 0.2F), store);
    stroke.lift();
    stroke.add(onSquare(0.85F, 0.2F), store);
    stroke.lift();
    stroke.add(onSquare(0.15F, 0.2F), store); // over the first dab again
    EXPECT_EQ(largest(store), 0.5F);
    test::forEachTexel(surface->mesh(), store, [&](FaceId face, TexelIndex texel, glm::dvec3 at) {
        if (at.x > 0.26 && at.x < 0.74) {
            ASSERT_EQ(valueAt(store, face, texel), 0.0F);
        }
    });
    TexelPatch patch = stroke.finish(store);
    patch.swap(store);
    EXPECT_TRUE(sameToTheBit(before, store));
}

TEST(Stroke, dabsStayOnTheSurfaceBetweenDistantSamples)
{
    const auto surface = surfaceOf(test::sphereMesh(3));
    const TriangleMesh& mesh = surface->mesh();
    TexelStore store = coverageStore(uniform(mesh.faceCount(), 3));
    const auto from = surface->bvh().closestPoint({1, 0, 0}, 1);
    const auto to = surface->bvh().closestPoint({0, 1, 0}, 1);
    const Brush brush = whiteBrush(0.1F);
    paint(surface, brush, Samples{{from->face, from->uv}, {to->face, to->uv}}, store);
    // The chord dips 0.29 below the sphere; the arc is painted nonetheless.
    std::size_t seen = 0;
    test::forEachTexel(mesh, store, [&](FaceId face, TexelIndex texel, glm::dvec3 at) {
        const bool between = at.x > 0.05 && at.y > 0.05;
        if (between && std::abs(at.z) < 0.04) {
            ++seen;
            ASSERT_GT(valueAt(store, face, texel), 0.9F);
        } else if (std::abs(at.z) > 0.11) {
            ASSERT_EQ(valueAt(store, face, texel), 0.0F);
        }
    });
    EXPECT_GT(seen, 500U);
}

TEST(Stroke, facesNotReallyTouchedStayConstantAndOutOfThePatch)
{
    const auto surface = surfaceOf(test::gridMesh(4));
    // Level 0: one centroid a face, and the dab is smaller than the way to it.
    TexelStore store = coverageStore(uniform(32, 0));
    const TexelPatch nothing =
        paint(surface, whiteBrush(0.01F), Samples{{faceId(5), {0.01F, 0.01F}}}, store);
    EXPECT_TRUE(nothing.isEmpty());
    EXPECT_TRUE(store.face(faceId(5)).isConstant());

    TexelStore fine = coverageStore(uniform(32, 5));
    const TexelPatch patch =
        paint(surface, whiteBrush(0.05F), Samples{{faceId(5), {0.3F, 0.3F}}}, fine);
    ASSERT_EQ(patch.faces().size(), 1U);
    EXPECT_EQ(patch.faces()[0], faceId(5));
    for (std::uint32_t k = 0; k < 32; ++k) {
        EXPECT_EQ(fine.face(faceId(k)).isConstant(), k != 5);
    }
}

TEST(Stroke, paintingTheColourThatIsThereChangesNothingAtAll)
{
    const auto surface = surfaceOf(test::gridMesh(2));
    TexelStore store = coverageStore(uniform(8, 4));
    Brush black = whiteBrush(0.4F);
    black.color = {0, 0, 0, 1};
    Stroke stroke(surface, black, zeroFill(store));
    EXPECT_TRUE(stroke.add({faceId(3), {0.3F, 0.3F}}, store).empty());
    EXPECT_TRUE(stroke.finish(store).isEmpty());
    for (std::uint32_t k = 0; k < 8; ++k) {
        EXPECT_TRUE(store.face(faceId(k)).isConstant());
    }
    // On a face that is spread out already, the patch is empty too.
    store.writable(faceId(3));
    EXPECT_TRUE(paint(surface, black, Samples{{faceId(3), {0.3F, 0.3F}}}, store).isEmpty());
}

TEST(Stroke, thePatchHoldsExactlyTheTexelsThatChanged)
{
    const auto surface = surfaceOf(test::gridMesh(2));
    TexelStore store = coverageStore(uniform(8, 6));
    std::mt19937 random(11);
    for (std::uint32_t k = 0; k < 8; ++k) {
        for (std::byte& b : store.writable(faceId(k))) {
            b = std::byte(random() % 64); // finite floats
        }
    }
    const TexelStore before = store;
    const Samples samples = randomSamples(random, 8, 5);
    const TexelPatch patch = paint(surface, whiteBrush(0.11F), samples, store);
    std::vector<FaceId> named(patch.faces().begin(), patch.faces().end());
    EXPECT_TRUE(patch.wholeFaces().empty());
    std::vector<std::vector<bool>> inPatch(8, std::vector<bool>(4096, false));
    for (const TexelPatch::Texels& part : patch.texels()) {
        for (const TexelPatch::Run& run : part.runs) {
            for (std::uint32_t t = run.first; t < run.first + run.count; ++t) {
                inPatch[indexOf(part.face)][t] = true;
            }
        }
    }
    std::size_t changed = 0;
    for (std::uint32_t k = 0; k < 8; ++k) {
        for (std::uint32_t t = 0; t < 4096; ++t) {
            const bool differs = !std::ranges::equal(before.face(faceId(k)).texel(t),
                                                     store.face(faceId(k)).texel(t));
            ASSERT_EQ(differs, inPatch[k][t]) << k << " " << t;
            changed += differs ? 1 : 0;
        }
    }
    EXPECT_GT(changed, 1000U);
}

TEST(Stroke, rectanglesNameWhatEachCallChanged)
{
    const auto surface = surfaceOf(test::sphereMesh(1));
    std::mt19937 random(12);
    TexelStore store = coverageStore(uniform(80, 5));
    Stroke stroke(surface, whiteBrush(0.2F), zeroFill(store));
    std::size_t whole = 0;
    for (const StrokeSample& sample : randomSamples(random, 80, 30)) {
        const TexelStore before = store;
        const std::vector<TouchedRect> rects = stroke.add(sample, store);
        EXPECT_EQ(std::ranges::adjacent_find(rects, std::greater_equal<>(), &TouchedRect::face),
                  rects.end()); // ascending, each once
        for (std::uint32_t k = 0; k < 80; ++k) {
            const auto rect = std::ranges::find(rects, faceId(k), &TouchedRect::face);
            const FaceTexels& was = before.face(faceId(k));
            const FaceTexels& is = store.face(faceId(k));
            if (rect == rects.end()) {
                ASSERT_TRUE(was.sharesBytesWith(is) || was == is);
                continue;
            }
            ASSERT_EQ(rect->wholeFace, was.isConstant());
            ASSERT_LE(rect->x + rect->width, 32);
            ASSERT_LE(rect->y + rect->height, 32);
            whole += rect->wholeFace ? 1 : 0;
            for (std::uint32_t t = 0; t < 1024; ++t) {
                const std::uint32_t x = t % 32;
                const std::uint32_t y = t / 32;
                const bool inside = x >= rect->x && x < std::uint32_t{rect->x} + rect->width &&
                                    y >= rect->y && y < std::uint32_t{rect->y} + rect->height;
                if (!inside) {
                    ASSERT_TRUE(std::ranges::equal(was.texel(t), is.texel(t)));
                }
            }
        }
    }
    EXPECT_GT(whole, 10U);
}

TEST(Stroke, undoAndRedoAreTheIdentityToTheBitOverRandomPrograms)
{
    for (const TexelType type : {TexelType::UInt8, TexelType::UInt16, TexelType::Half}) {
        const auto surface = surfaceOf(test::sphereMesh(1));
        const TexelFormat format{type, 3, std::nullopt};
        FaceMap<Level> levels(80);
        for (std::size_t k = 0; k < 80; ++k) {
            levels[faceId(k)] = Level(static_cast<int>(k % 7));
        }
        const std::vector<std::byte> fill(format.texelBytes());
        TexelStore store(format, levels, fill);
        std::mt19937 random(13);
        std::uniform_real_distribution<float> part(0, 1);
        std::vector<TexelStore> states{store};
        std::vector<TexelPatch> patches;
        for (int step = 0; step < 25; ++step) {
            if (step % 5 == 4) {
                const std::vector<FaceId> faces{faceId(random() % 80), faceId(random() % 80)};
                std::vector<std::byte> texel(format.texelBytes());
                encode(type, std::array{part(random), part(random), 0.5F}, texel);
                patches.push_back(fillFaces(store, faces, texel));
            } else {
                Brush brush = whiteBrush(0.05F + part(random) * 0.6F);
                brush.color = {part(random), part(random), part(random), 1};
                brush.flow = part(random);
                brush.hardness = part(random);
                brush.blend = step % 7 == 3 ? BlendMode::Erase : BlendMode::Normal;
                patches.push_back(paint(surface, brush, randomSamples(random, 80, 4), store));
            }
            states.push_back(store);
        }
        for (std::size_t k = patches.size(); k-- > 0;) {
            patches[k].swap(store);
            ASSERT_TRUE(sameToTheBit(store, states[k])) << "undo " << k;
        }
        EXPECT_TRUE(store.face(faceId(6)).isConstant());
        for (std::size_t k = 0; k < patches.size(); ++k) {
            patches[k].swap(store);
            ASSERT_TRUE(sameToTheBit(store, states[k + 1])) << "redo " << k;
        }
    }
}

TEST(Stroke, samplesThatAreNowhereAreIgnored)
{
    const auto surface = surfaceOf(test::gridMesh(1));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    TexelStore store = coverageStore(uniform(2, 3));
    const Samples samples{{faceId(2), {0.3F, 0.3F}},
                          {faceId(0xFFFFFFFFU), {0.3F, 0.3F}},
                          {faceId(0), {nan, 0.3F}},
                          {faceId(0), {0.3F, std::numeric_limits<float>::infinity()}}};
    EXPECT_TRUE(paint(surface, whiteBrush(1), samples, store).isEmpty());
}

TEST(Stroke, aFaceOfTheHighestLevelCostsWhatIsTouched)
{
    const auto surface = surfaceOf(test::gridMesh(1));
    TexelStore store = coverageStore(uniform(2, 12));
    const std::uint32_t side = 4096;
    store.writable(faceId(0)); // 64 MiB, spread out beforehand
    const TexelPatch patch =
        paint(surface, whiteBrush(0.005F), Samples{onSquare(0.3F, 0.3F)}, store);
    ASSERT_EQ(patch.texels().size(), 1U);
    // The disc's texels (two a cell), their bytes and the runs of about 82 rows.
    const double texels = 3.14159265 * 0.005 * 0.005 * side * side * 2 / 2 * 2;
    EXPECT_NEAR(static_cast<double>(patch.texels()[0].values.size()) / 4, texels, 0.03 * texels);
    EXPECT_LT(patch.byteSize(), 64U * 1024U);
}

TEST(StrokeDeathTest, refusesABrushThatIsNotValid)
{
    const auto surface = surfaceOf(test::gridMesh(1));
    EXPECT_DEATH(Stroke(surface, whiteBrush(0), {}), "a valid brush");
    EXPECT_DEATH(Stroke(surface, whiteBrush(std::numeric_limits<float>::quiet_NaN()), {}),
                 "a valid brush");
}

TEST(FillFaces, makesFacesConstantOnceAndRemembersThem)
{
    TexelStore store = coverageStore(uniform(10, 3));
    store.writable(faceId(4))[0] = std::byte{1};
    const TexelStore before = store;
    std::vector<std::byte> one(4);
    encode(TexelType::Float, std::array{1.0F}, one);
    const std::vector<FaceId> faces{faceId(4), faceId(2), faceId(4)};
    TexelPatch patch = fillFaces(store, faces, one);
    EXPECT_EQ(patch.faces().size(), 2U);
    EXPECT_TRUE(store.face(faceId(4)).isConstant());
    EXPECT_EQ(valueAt(store, faceId(4), TexelIndex{63}), 1.0F);
    EXPECT_TRUE(store.face(faceId(2)).sharesBytesWith(store.face(faceId(4))));
    EXPECT_TRUE(fillFaces(store, faces, one).isEmpty()); // nothing left to change
    patch.swap(store);
    EXPECT_TRUE(sameToTheBit(store, before));
}
