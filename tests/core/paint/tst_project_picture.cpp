// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/texel.h"
#include "core/paint/project_picture.h"
#include "tests/core/paint/paint_fixture.h"
#include "tests/core/test_meshes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace trixel;

namespace {

/// From the world's square [0,1] x [0,1] onto a whole picture, seen along z.
glm::dmat4 overTheSquare()
{
    glm::dmat4 toClip(1);
    toClip[0][0] = 2;
    toClip[1][1] = 2;
    toClip[3] = {-1, -1, 0, 1};
    return toClip;
}

/// Red grows to the right, green downwards; opaque.
std::vector<float> ramps(int width, int height)
{
    std::vector<float> pixels;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const float right = (static_cast<float>(x) + 0.5F) / static_cast<float>(width);
            const float lower = (static_cast<float>(y) + 0.5F) / static_cast<float>(height);
            pixels.insert(pixels.end(), {right, lower, 0.5F, 1});
        }
    }
    return pixels;
}

} // namespace

TEST(ProjectPicture, rampsComeOutAsRamps)
{
    const std::vector<float> pixels = ramps(40, 30);
    const PictureProjection picture{overTheSquare(), 40, 30, pixels, 1};
    for (const glm::dvec3 at : {glm::dvec3(0.5, 0.5, 9), {0.2, 0.7, -3}, {0.9, 0.1, 0}}) {
        const glm::vec4 lands = projectedAt(picture, at);
        EXPECT_NEAR(lands.r, at.x, 1e-5);
        EXPECT_NEAR(lands.g, 1 - at.y, 1e-5);
        EXPECT_FLOAT_EQ(lands.a, 1);
    }
    EXPECT_EQ(projectedAt(picture, {1.01, 0.5, 0}), glm::vec4(0));
    EXPECT_EQ(projectedAt(picture, {0.5, -0.01, 0}), glm::vec4(0));
    EXPECT_EQ(projectedAt(picture, {std::nan(""), 0.5, 0}), glm::vec4(0));
}

TEST(ProjectPicture, whatLiesBehindTheCameraStaysFree)
{
    glm::dmat4 toClip = overTheSquare();
    toClip[2][3] = 1; // w = z
    toClip[3][3] = 0;
    const std::vector<float> pixels = ramps(4, 4);
    const PictureProjection picture{toClip, 4, 4, pixels, 1};
    EXPECT_GT(projectedAt(picture, {0.6, 0.6, 1}).a, 0);
    EXPECT_EQ(projectedAt(picture, {-0.6, -0.6, -1}), glm::vec4(0));
    EXPECT_EQ(projectedAt(picture, {0.5, 0.5, 0}), glm::vec4(0));
}

TEST(ProjectPicture, clearPixelsLendTheirColourToNobody)
{
    // Black and clear beside white: half way between it is white, half covered.
    const std::vector<float> pixels{0, 0, 0, 0, 1, 1, 1, 1};
    const PictureProjection picture{overTheSquare(), 2, 1, pixels, 0.5F};
    const glm::vec4 lands = projectedAt(picture, {0.5, 0.5, 0});
    EXPECT_FLOAT_EQ(lands.r, 1);
    EXPECT_FLOAT_EQ(lands.a, 0.25F);
}

TEST(ProjectPicture, everyTexelTakesWhatLandsOnItsCentroidAndThePatchBringsItBack)
{
    const TriangleMesh mesh = test::gridMesh(2);
    const TexelFormat format{TexelType::Float, 4, 3};
    const std::vector<float> grey{0.25F, 0.5F, 0.75F, 0.5F};
    std::vector<std::byte> texel(16);
    encode(format.type, grey, texel);
    const TexelStore before(8, format, Level(3), texel);
    TexelStore store = before;
    const std::vector<float> pixels = ramps(16, 16);
    const PictureProjection picture{overTheSquare(), 16, 16, pixels, 0.5F};
    const std::vector<FaceId> faces{faceId(0), faceId(1), faceId(5)};
    TexelPatch patch = projectPicture(store, mesh, faces, picture, Threads{2});
    EXPECT_EQ(patch.faces().size(), 3U);
    test::forEachTexel(mesh, store, [&](FaceId face, TexelIndex index, glm::dvec3 at) {
        std::vector<float> values(4);
        decode(format.type, store.face(face).texel(indexOf(index)), values);
        const bool isChosen = std::ranges::find(faces, face) != faces.end();
        const glm::vec4 lands = projectedAt(picture, at);
        for (std::size_t c = 0; c < 4; ++c) {
            const float target = c == 3 ? 1 : lands[static_cast<int>(c)];
            const float expected = isChosen ? grey[c] + 0.5F * (target - grey[c]) : grey[c];
            ASSERT_NEAR(values[c], expected, 1e-6);
        }
    });
    patch.swap(store);
    EXPECT_TRUE(test::sameToTheBit(store, before));
}
