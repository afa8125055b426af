// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/compose.h"
#include "core/paint/stroke.h"
#include "tests/core/layers/layers_fixture.h"
#include "tests/core/paint/paint_fixture.h"
#include "tests/core/test_meshes.h"

#include <gtest/gtest.h>

using namespace trixel;
using namespace trixel::test;

namespace {

std::shared_ptr<const Surface> sphere()
{
    return surfaceOf(sphereMesh(1)); // 80 faces
}

/// A base painted at random and one layer that covers nothing.
LayerStack freshStack(TexelType type)
{
    std::mt19937 random(3);
    LayerStack stack(randomStack(random, formatOf(type, 3), 80, 0).base());
    stack.insert(0, {});
    return stack;
}

Brush softBrush(BlendMode blend)
{
    Brush brush;
    brush.radius = 0.6F;
    brush.hardness = 0.3F;
    brush.opacity = 0.8F;
    brush.flow = 0.5F;
    brush.blend = blend;
    brush.color = {0.9F, 0.2F, 0.4F, 1};
    return brush;
}

std::vector<StrokeSample> roundTheSphere()
{
    std::vector<StrokeSample> samples;
    for (std::size_t k = 0; k < 12; ++k) {
        samples.push_back({faceId(7 * k % 80), {0.3F, 0.4F}});
    }
    return samples;
}

/// Paints a stroke and keeps what is shown up to date on the way.
TexelPatch paint(const Brush& brush, const Ground& ground, LayerId layer, Layered& onto)
{
    Stroke stroke(sphere(), brush, ground, Threads{2});
    for (const StrokeSample& sample : roundTheSphere()) {
        const std::vector<TouchedRect> touched = stroke.add(sample, onto.layers.texels(layer));
        recompose(onto.layers, touched, onto.shown, Threads{2});
    }
    return stroke.finish(onto.layers.texels(layer));
}

LayerId only(const LayerStack& layers)
{
    return layers.layers().front().id;
}

} // namespace

TEST(LayerPaint, aStrokeOnALayerLooksLikeTheStrokeOnTheBase)
{
    for (const TexelType type : kTypes) {
        Layered layered = shownOf(freshStack(type));
        TexelStore plain = layered.layers.base();
        const TexelStore base = plain;
        paint(softBrush(BlendMode::Normal), Ground::layer(), only(layered.layers), layered);
        Stroke stroke(sphere(), softBrush(BlendMode::Normal), zeroFill(plain));
        for (const StrokeSample& sample : roundTheSphere()) {
            stroke.add(sample, plain);
        }
        EXPECT_TRUE(sameTexels(layered.layers.base(), base));
        for (const FaceId face : allFaces(plain)) {
            for (std::uint32_t k = 0; k < plain.face(face).level().texelCount(); ++k) {
                const auto a = decodedTexel(plain, face, k);
                const auto b = decodedTexel(layered.shown, face, k);
                for (std::size_t c = 0; c < 3; ++c) {
                    // The layer's coverage and both results are rounded.
                    ASSERT_NEAR(a[c], b[c], 3 * stepOf(type, 1)) << nameOf(type);
                }
            }
        }
    }
}

TEST(LayerPaint, erasingAllOfItShowsTheBaseToTheBit)
{
    for (const TexelType type : kTypes) {
        Layered layered = shownOf(freshStack(type));
        const LayerId layer = only(layered.layers);
        paint(softBrush(BlendMode::Normal), Ground::layer(), layer, layered);
        EXPECT_FALSE(sameTexels(layered.shown, layered.layers.base()));
        Brush eraser = softBrush(BlendMode::Erase);
        eraser.radius = 3;
        eraser.hardness = 1;
        eraser.opacity = eraser.flow = 1;
        eraser.paintThrough = true;
        paint(eraser, Ground::layer(), layer, layered);
        EXPECT_TRUE(sameTexels(layered.shown, layered.layers.base())) << nameOf(type);
        EXPECT_TRUE(sameTexels(shownOf(layered.layers).shown, layered.layers.base()));
    }
}

TEST(LayerPaint, erasingWhereNothingIsPaintedChangesNothing)
{
    Layered layered = shownOf(freshStack(TexelType::UInt8));
    const TexelPatch patch =
        paint(softBrush(BlendMode::Erase), Ground::layer(), only(layered.layers), layered);
    EXPECT_TRUE(patch.isEmpty());
    for (const FaceId face : allFaces(layered.shown)) {
        EXPECT_TRUE(layered.layers.layers().front().texels.face(face).isConstant());
    }
}

TEST(LayerPaint, undoingAndRedoingStrokesOnAnyLayerShowsTheSameBits)
{
    for (const TexelType type : kTypes) {
        Layered layered = shownOf(freshStack(type));
        const LayerId lower = only(layered.layers);
        const LayerId upper = layered.layers.insert(1, {"", 0.7F, LayerBlend::Multiply, true});
        const auto fill = zeroFill(layered.shown);
        struct Step
        {
            LayerId layer;
            BlendMode blend;
            TexelPatch patch;
        };
        std::vector<Step> steps{{lower, BlendMode::Normal, {}},
                                {upper, BlendMode::Normal, {}},
                                {kBaseLayer, BlendMode::Erase, {}},
                                {lower, BlendMode::Erase, {}}};
        std::vector<TexelStore> states{layered.shown};
        for (Step& step : steps) {
            const Ground ground = step.layer == kBaseLayer ? Ground(fill) : Ground::layer();
            step.patch = paint(softBrush(step.blend), ground, step.layer, layered);
            EXPECT_TRUE(sameTexels(layered.shown, shownOf(layered.layers).shown));
            states.push_back(layered.shown);
        }
        const auto swapped = [&](std::size_t k) {
            steps[k].patch.swap(layered.layers.texels(steps[k].layer));
            recompose(layered.layers, steps[k].patch.faces(), layered.shown, Threads{2});
        };
        for (std::size_t k = steps.size(); k-- > 0;) {
            swapped(k);
            EXPECT_TRUE(sameTexels(layered.shown, states[k])) << nameOf(type) << ", undo " << k;
        }
        for (std::size_t k = 0; k < steps.size(); ++k) {
            swapped(k);
            EXPECT_TRUE(sameTexels(layered.shown, states[k + 1])) << nameOf(type) << ", redo " << k;
        }
    }
}

TEST(LayerPaint, aStrokeRoundsOnceHoweverManyItsDabs)
{
    // Thin paint of many dabs over paint: each step from the texels as they were.
    Layered layered = shownOf(freshStack(TexelType::UInt8));
    const LayerId layer = only(layered.layers);
    Layered exact = shownOf(freshStack(TexelType::Float));
    Brush brush = softBrush(BlendMode::Normal);
    paint(brush, Ground::layer(), layer, layered);
    paint(brush, Ground::layer(), only(exact.layers), exact);
    brush.flow = 0.02F;
    brush.spacing = 0.02F;
    brush.color = {0.1F, 0.9F, 0.3F, 1};
    paint(brush, Ground::layer(), layer, layered);
    paint(brush, Ground::layer(), only(exact.layers), exact);
    const TexelStore& rounded = layered.layers.texels(layer);
    const TexelStore& unrounded = exact.layers.texels(only(exact.layers));
    for (const FaceId face : allFaces(rounded)) {
        for (std::uint32_t k = 0; k < rounded.face(face).level().texelCount(); ++k) {
            const float a = decodedTexel(rounded, face, k).back();
            const float b = decodedTexel(unrounded, face, k).back();
            ASSERT_NEAR(a, b, 1.01F / 255); // of two strokes
        }
    }
}

TEST(LayerPaint, isTheSameForAnyNumberOfThreads)
{
    const auto surface = surfaceOf(gridMesh(1));
    const TexelFormat format = layerFormat(formatOf(TexelType::Half, 3));
    const TexelStore blank(2, format, Level(10), std::vector<std::byte>(format.texelBytes()));
    std::vector<TexelStore> results;
    for (const unsigned threads : {1U, 2U, 8U}) {
        results.push_back(blank);
        for (const BlendMode blend : {BlendMode::Normal, BlendMode::Erase}) {
            Brush brush = softBrush(blend);
            brush.spacing = 1;
            Stroke stroke(surface, brush, Ground::layer(), Threads{threads});
            stroke.add({faceId(0), {0.4F, 0.3F}}, results.back());
            stroke.add({faceId(1), {0.4F, 0.4F}}, results.back());
        }
    }
    EXPECT_FALSE(test::sameToTheBit(results[0], blank));
    EXPECT_TRUE(test::sameToTheBit(results[0], results[1]));
    EXPECT_TRUE(test::sameToTheBit(results[0], results[2]));
}

TEST(LayerPaint, texelsWithoutACoverageAreNoLayer)
{
    TexelStore store(80, formatOf(TexelType::UInt8, 3), Level(2), std::vector<std::byte>(3));
    Stroke stroke(sphere(), softBrush(BlendMode::Normal), Ground::layer());
    EXPECT_DEATH(stroke.add(roundTheSphere().front(), store), "texels of a layer");
}
