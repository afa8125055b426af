// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/display_atlas.h"
#include "tests/core/test_meshes.h"

#include <gtest/gtest.h>

using namespace trixel;
using namespace trixel::render;

namespace {

/// Paints one texel of a face and shows it.
bool painted(DisplayAtlas& atlas, TexelStore& store, FaceId face)
{
    const bool wasConstant = store.face(face).isConstant();
    store.writable(face)[0] = std::byte{255};
    TouchedRect rect;
    rect.face = face;
    rect.wholeFace = wasConstant;
    return atlas.touch(store, std::array{rect});
}

TEST(DisplayAtlas, paintNextToAFaceOfOneTexelLaysItOutAnew)
{
    const TriangleMesh mesh = test::gridMesh(6);
    TexelStore store(static_cast<std::uint32_t>(mesh.faceCount()),
                     TexelFormat{},
                     Level(3),
                     std::vector<std::byte>(3));
    store.writable(faceId(0))[0] = std::byte{1};
    const auto shape =
        std::make_shared<const FilterMesh>(mesh, buildAdjacency(mesh.triangles), store, nullptr);
    DisplayAtlas atlas;
    atlas.reset(shape, store, 0, 1U << 28U);
    EXPECT_TRUE(painted(atlas, store, faceId(0)));
    // Face 1 has a whole tile, being next to face 0; those on its other side have one texel, which
    // would be all that bilinear filtering has to go from the new paint to nothing.
    EXPECT_FALSE(painted(atlas, store, faceId(1)));
    atlas.reset(shape, store, 0, 1U << 28U);
    EXPECT_TRUE(painted(atlas, store, faceId(1)));
    EXPECT_FALSE(painted(atlas, store, faceId(71))); // a single texel itself
}

} // namespace
