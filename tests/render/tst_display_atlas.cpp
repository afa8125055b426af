// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/background_layout.h"
#include "render/display_atlas.h"
#include "tests/core/cancel_after.h"
#include "tests/core/test_meshes.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <new>
#include <thread>

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
    NoProgress progress;
    ASSERT_TRUE(atlas.reset(shape, store, 0, 1U << 28U, progress));
    EXPECT_TRUE(painted(atlas, store, faceId(0)));
    // Face 1 has a whole tile, being next to face 0; those on its other side have one texel, which
    // would be all that bilinear filtering has to go from the new paint to nothing.
    EXPECT_FALSE(painted(atlas, store, faceId(1)));
    ASSERT_TRUE(atlas.reset(shape, store, 0, 1U << 28U, progress));
    EXPECT_TRUE(painted(atlas, store, faceId(1)));
    EXPECT_FALSE(painted(atlas, store, faceId(71))); // a single texel itself
}

TEST(DisplayAtlas, layingOutEndsWhereverItIsCancelled)
{
    const TriangleMesh mesh = test::gridMesh(6);
    TexelStore store(static_cast<std::uint32_t>(mesh.faceCount()),
                     TexelFormat{},
                     Level(9),
                     std::vector<std::byte>(3));
    for (const std::uint32_t f : {0U, 30U, 71U}) {
        store.writable(faceId(f))[0] = std::byte{1};
    }
    const auto shape =
        std::make_shared<const FilterMesh>(mesh, buildAdjacency(mesh.triangles), store, nullptr);
    for (const int reports : {0, 5, 71, 72}) { // the last while faces are made coarser to fit
        CancelAfter progress(reports);
        DisplayAtlas atlas;
        const Status done = atlas.reset(shape, store, 0, 1, progress);
        ASSERT_FALSE(done) << reports;
        EXPECT_EQ(done.error().kind, ErrorKind::Cancelled);
    }
    NoProgress progress;
    DisplayAtlas atlas;
    EXPECT_TRUE(atlas.reset(shape, store, 0, 1, progress));
    EXPECT_TRUE(atlas.isReduced());
}

/// Of which nothing but its beginning matters.
struct NoLayout
{
    static bool hasWork() { return false; }
    static int take(const TexelStore& /*store*/, std::size_t /*bytes*/) { return 0; }
};
using Background = BackgroundLayout<NoLayout, int>;

TEST(BackgroundLayout, endsWhileItBegins)
{
    std::atomic<bool> hasBegun = false;
    bool wasStopped = false;
    {
        const Background making({}, [&](NoLayout&, const TexelStore&, const std::stop_token& stop) {
            hasBegun = true;
            const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
            while (!stop.stop_requested() && std::chrono::steady_clock::now() < end) {
                std::this_thread::yield();
            }
            wasStopped = stop.stop_requested();
            return false;
        });
        while (!hasBegun) {
            std::this_thread::yield();
        }
    }
    EXPECT_TRUE(wasStopped);
}

TEST(BackgroundLayout, tellsOfWantOfMemory)
{
    const Background making({}, [](NoLayout&, const TexelStore&, const std::stop_token&) -> bool {
        throw std::bad_alloc();
    });
    while (!making.hasFailed()) {
        std::this_thread::yield();
    }
    EXPECT_FALSE(making.isDone());
}

} // namespace
