// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/channel_colors.h"
#include "core/io/new_project.h"
#include "core/io/project_metadata.h"
#include "core/io/project_part.h"
#include "core/layers/compose.h"
#include "tests/core/test_meshes.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

using namespace trixel;
using namespace trixel::test;

namespace {

Project numbered()
{
    NoProgress progress;
    const std::array<float, 4> fill = {0.25F, 0.5F, 0.75F, 1};
    Project project = *newProject(sphereMesh(1),
                                  planUniform(80, Level(2)),
                                  TexelFormat{TexelType::UInt8, 4, 3},
                                  fill,
                                  progress);
    for (std::size_t f = 0; f < 80; f += 2) {
        std::uint8_t next = static_cast<std::uint8_t>(f);
        for (std::byte& value : project.texels.writable(faceId(f))) {
            value = std::byte{next++};
        }
    }
    return project;
}

TEST(ProjectPart, facesKeepTheirOrderCornersAndTexels)
{
    const Project whole = numbered();
    const std::vector<FaceId> faces = {faceId(3), faceId(40), faceId(41), faceId(79)};
    NoProgress progress;
    const auto part = partOf(whole, {faces, {}}, Threads{1}, progress);
    ASSERT_TRUE(part);
    ASSERT_EQ(part->texels.faceCount(), 4U);
    const TriangleMesh& mesh = part->surface->mesh();
    for (std::size_t k = 0; k < faces.size(); ++k) {
        EXPECT_EQ(mesh.corners(faceId(k)), whole.surface->mesh().corners(faces[k]));
        EXPECT_EQ(part->texels.face(faceId(k)), whole.texels.face(faces[k]));
    }
    EXPECT_LE(mesh.positions.size(), 12U); // no others
}

TEST(ProjectPart, uvsCreasesAndSharpVerticesOfItsFacesComeAlong)
{
    NoProgress progress;
    TriangleMesh mesh = gridMesh(2); // face 0 is 0, 1, 3
    for (std::size_t k = 0; k < 3 * mesh.faceCount(); ++k) {
        mesh.cornerUvs.emplace_back(static_cast<float>(k), 0.5F);
    }
    mesh.sharpness.creases = {{0, 1, 2.5F}, {1, 3, kSharp}, {1, 2, kSharp}};
    mesh.sharpness.vertices = {{3, 1.5F}, {8, kSharp}};
    const Project whole = *newProject(mesh,
                                      planUniform(mesh.faceCount(), Level(0)),
                                      TexelFormat{TexelType::UInt8, 1, std::nullopt},
                                      std::array{0.5F},
                                      progress);
    const auto part = partOf(whole, {{faceId(0)}, {}}, Threads{1}, progress);
    ASSERT_TRUE(part);
    EXPECT_EQ(part->surface->mesh().triangles.at(0), (Triangle{0, 1, 2}));
    const auto last = partOf(whole, {{faceId(7)}, {}}, Threads{1}, progress);
    EXPECT_THAT(
        last->surface->mesh().cornerUvs,
        testing::ElementsAre(glm::vec2(21, 0.5F), glm::vec2(22, 0.5F), glm::vec2(23, 0.5F)));
    EXPECT_THAT(part->surface->mesh().sharpness.creases,
                testing::ElementsAre(Crease{0, 1, 2.5F}, Crease{1, 2, kSharp}));
    EXPECT_THAT(part->surface->mesh().sharpness.vertices,
                testing::ElementsAre(SharpVertex{2, 1.5F}));
}

TEST(ProjectPart, channelsArePickedInTheOrderAskedForAndOpacityStaysKnown)
{
    const Project whole = numbered();
    NoProgress progress;
    const auto part = partOf(whole, {{}, {3, 1}}, Threads{2}, progress);
    ASSERT_TRUE(part);
    EXPECT_EQ(part->texels.format(), (TexelFormat{TexelType::UInt8, 2, 0}));
    for (const std::size_t f : {0U, 1U, 6U}) {
        const FaceTexels& before = whole.texels.face(faceId(f));
        const FaceTexels& after = part->texels.face(faceId(f));
        EXPECT_EQ(after.isConstant(), before.isConstant());
        for (std::size_t k = 0; k < 16; ++k) {
            EXPECT_EQ(after.texel(k)[0], before.texel(k)[3]);
            EXPECT_EQ(after.texel(k)[1], before.texel(k)[1]);
        }
    }
    EXPECT_EQ(fillOf(*part).size(), 2U); // not that of four channels
}

TEST(ProjectPart, whatChannelsMeanGoesWithThem)
{
    using enum ColorSpace;
    Project whole = numbered();
    NoProgress progress;
    EXPECT_FALSE(channelColors(*partOf(whole, {{}, {3, 1}}, Threads{1}, progress)));
    declareChannelColors(whole, {Linear, SRgb, Linear, Raw});
    const auto pick = [&](const ProjectPart& part) {
        return channelColors(*partOf(whole, part, Threads{1}, progress)).value();
    };
    EXPECT_THAT(pick({{}, {3, 1}}), testing::ElementsAre(Raw, SRgb));
    EXPECT_THAT(pick({{}, {1, 0, 3, 2}}), testing::ElementsAre(SRgb, Linear, Raw, Linear));
    EXPECT_THAT(pick({{faceId(4)}, {}}), testing::ElementsAre(Linear, SRgb, Linear, Raw));
}

/// The numbered project as the base, and a layer over it, half of which is covered by a half.
Project layered()
{
    Project project = numbered();
    LayerStack layers(project.texels);
    const LayerId layer = layers.insert(0, {"Over", 0.5F});
    const TexelFormat format = layers.texels(layer).format();
    for (std::size_t f = 0; f < 80; f += 2) {
        std::uint8_t next = 0;
        for (std::byte& value : layers.texels(layer).writable(faceId(f))) {
            const std::size_t channel = next++ % 5U;
            value = std::byte{static_cast<std::uint8_t>(channel == 4 ? 128 : 10 * channel)};
        }
    }
    EXPECT_EQ(format.alpha, 4);
    NoProgress progress;
    Layered all = *composed(std::move(layers), Threads{1}, progress);
    project.texels = std::move(all.shown);
    project.layers = std::move(all.layers);
    return project;
}

TEST(ProjectPart, ofAProjectWithLayersIsWhatIsShownUnlessOneIsAskedFor)
{
    const Project whole = layered();
    NoProgress progress;
    const auto shown = partOf(whole, {{faceId(4)}, {}}, Threads{1}, progress);
    ASSERT_TRUE(shown);
    EXPECT_TRUE(shown->layers.isPlain());
    EXPECT_EQ(shown->texels.face(faceId(0)), whole.texels.face(faceId(4)));
    EXPECT_TRUE(partOf(whole, {}, Threads{1}, progress)->layers.isPlain());
    const auto base = partOf(whole, {{faceId(4)}, {}, kBaseLayer}, Threads{1}, progress);
    ASSERT_TRUE(base);
    EXPECT_EQ(base->texels.face(faceId(0)), whole.layers.base().face(faceId(4)));
    EXPECT_EQ(base->texels.format(), whole.texels.format());
    EXPECT_EQ(fillOf(*base), fillOf(whole));
}

TEST(ProjectPart, aLayerAloneHasItsChannelsAndWhatItPaintsAsOpacity)
{
    using enum ColorSpace;
    Project whole = layered();
    declareChannelColors(whole, {Linear, SRgb, Linear, Raw});
    const LayerId over = whole.layers.layers()[0].id;
    NoProgress progress;
    const auto layer = partOf(whole, {{}, {}, over}, Threads{2}, progress);
    ASSERT_TRUE(layer);
    EXPECT_TRUE(layer->layers.isPlain());
    EXPECT_EQ(layer->texels.format(), (TexelFormat{TexelType::UInt8, 5, 4}));
    EXPECT_EQ(layer->texels.face(faceId(2)).texel(3)[1], std::byte{10});
    EXPECT_EQ(layer->texels.face(faceId(2)).texel(3)[4], std::byte{64}); // half of 128
    EXPECT_TRUE(layer->texels.face(faceId(1)).isConstant());
    EXPECT_EQ(layer->texels.face(faceId(1)).texel(0)[4], std::byte{0});
    EXPECT_THAT(channelColors(*layer).value(),
                testing::ElementsAre(Linear, SRgb, Linear, Raw, Raw));
    for (const PtxMetadata& item : layer->metadata) {
        EXPECT_NE(item.key, kFillKey);
    }
    const auto coverage = partOf(whole, {{faceId(2)}, {4}, over}, Threads{1}, progress);
    ASSERT_TRUE(coverage);
    EXPECT_EQ(coverage->texels.format(), (TexelFormat{TexelType::UInt8, 1, 0}));
    EXPECT_EQ(coverage->texels.face(faceId(0)).texel(0)[0], std::byte{64});
}

TEST(ProjectPart, aPlainProjectIsItsBase)
{
    const Project whole = numbered();
    NoProgress progress;
    const auto base = partOf(whole, {{}, {}, kBaseLayer}, Threads{1}, progress);
    ASSERT_TRUE(base);
    EXPECT_EQ(base->texels.face(faceId(2)), whole.texels.face(faceId(2)));
    EXPECT_EQ(partOf(whole, {{}, {}, LayerId{1}}, Threads{1}, progress).error().message,
              "the layer is not one of the project's");
}

TEST(ProjectPart, whatDoesNotExistIsNamed)
{
    const Project whole = numbered();
    NoProgress progress;
    EXPECT_EQ(partOf(whole, {{faceId(80)}, {}}, Threads{1}, progress).error().message,
              "there is no face 80: 80 faces");
    EXPECT_EQ(partOf(whole, {{}, {4}}, Threads{1}, progress).error().message,
              "there is no channel 4: 4 channels");
}

} // namespace
