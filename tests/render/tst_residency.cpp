// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/residency.h"
#include "tests/bench/sheet_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

using namespace trixel;
using namespace trixel::render;

namespace {

/// Views of the sheet: whole, close, grazing, from within.
std::vector<Camera> views()
{
    std::vector<Camera> result;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> in(-1, 1);
    for (int k = 0; k < 40; ++k) {
        Camera camera;
        camera.setViewport(640 + 20 * k, 480);
        camera.setScene({-1, -1, -0.2F}, {1, 1, 0.2F});
        CameraPose pose;
        pose.target = {0.8 * in(random), 0.8 * in(random), 0.1 * in(random)};
        pose.distance = std::exp(2.5 * in(random)-1);
        pose.yaw = 3 * in(random);
        pose.pitch = 1.5 * in(random);
        camera.setPose(pose);
        result.push_back(camera);
    }
    return result;
}

std::vector<Wish> wishesFor(const TriangleMesh& mesh, const Camera& camera)
{
    std::vector<Wish> wishes(mesh.faceCount());
    wishesOf(FaceExtents::of(mesh, Threads{1}), camera, Threads{1}, wishes);
    return wishes;
}

bool isInside(const Camera& camera, const std::optional<glm::dvec2>& p)
{
    return p && p->x >= 0 && p->y >= 0 && p->x <= camera.viewport().x &&
           p->y <= camera.viewport().y;
}

/// Room for so many elements in a buffer of texels.
CardRoom roomOf(std::uint64_t elements)
{
    return CardRoom::of(CardBlocks(BlockKind::Texels, 0, static_cast<std::uint32_t>(elements)),
                        elements);
}

} // namespace

TEST(Residency, noTexelOfAWishedLevelIsLargerThanAPixel)
{
    const TriangleMesh mesh = sheetMesh(24);
    std::size_t looked = 0;
    for (const Camera& camera : views()) {
        const std::vector<Wish> wishes = wishesFor(mesh, camera);
        for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
            const auto c = mesh.corners(faceId(f));
            for (const auto& [u, v] : {std::pair{0.F, 0.F}, {1.F, 0.F}, {0.F, 1.F}, {.3F, .3F}}) {
                const glm::dvec3 p(pointAt(c, u, v));
                const auto seen = camera.project(p);
                if (!isInside(camera, seen)) {
                    continue;
                }
                ASSERT_NE(wishes[f], kUnseen) << "a face in view";
                if (wishes[f] == kMostWish) {
                    continue; // as fine as faces can be
                }
                const double texels = std::exp2((wishes[f] + 7) / 8);
                for (int k = 0; k < 3; ++k) {
                    const glm::dvec3 edge(c[static_cast<std::size_t>((k + 1) % 3)] -
                                          c[static_cast<std::size_t>(k)]);
                    const auto next = camera.project(p + edge / texels * 0.01);
                    ASSERT_TRUE(next);
                    ASSERT_LE(glm::length(*next - *seen) * 100, 1.01);
                    ++looked;
                }
            }
        }
    }
    EXPECT_GT(looked, 10'000U);
}

TEST(Residency, aWishIsNoFinerThanItHelps)
{
    // Face-on in the middle of the view the wish is the level whose texels just fit a pixel.
    const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}};
    for (const double distance : {2.0, 10.0, 77.0}) {
        Camera camera;
        camera.setViewport(800, 800);
        camera.setScene({0, 0, 0}, {1, 1, 0});
        CameraPose pose;
        pose.target = {1.0 / 3, 1.0 / 3, 0};
        pose.distance = distance;
        camera.setPose(pose);
        const double pixels = std::sqrt(2.0) / camera.worldPerPixel({0, 0, 0});
        const double wished = wishesFor(mesh, camera)[0] / 8.0;
        EXPECT_GE(wished, std::log2(pixels));
        EXPECT_LE(wished, std::log2(pixels) + (distance > 5 ? 0.6 : 1.0));
    }
}

TEST(Residency, facesOutOfViewAreNotWishedFor)
{
    const TriangleMesh mesh = sheetMesh(40);
    Camera camera;
    camera.setViewport(800, 600);
    camera.setScene({-1, -1, -0.2F}, {1, 1, 0.2F});
    CameraPose pose;
    pose.target = {0.5, 0.5, 0};
    pose.distance = 0.5;
    camera.setPose(pose);
    const std::vector<Wish> wishes = wishesFor(mesh, camera);
    const auto unseen = std::ranges::count(wishes, kUnseen);
    EXPECT_GT(unseen, 2800) << "of 3200, where a fortieth of the sheet is seen";
    EXPECT_LT(unseen, 3200);
}

TEST(Residency, thePlanKeepsToTheRoomAndUsesIt)
{
    std::mt19937 random(5);
    for (int round = 0; round < 60; ++round) {
        std::vector<Wish> wishes(3000);
        std::vector<FaceOnCard> faces(wishes.size());
        for (std::size_t f = 0; f < wishes.size(); ++f) {
            wishes[f] = random() % 4 == 0 ? kUnseen : static_cast<Wish>(random() % 70);
            faces[f].own = static_cast<std::uint8_t>(random() % 8);
            faces[f].shown = static_cast<std::uint8_t>(random() % (faces[f].own + 1U));
        }
        const CardRoom room = roomOf(1ULL << (12U + random() % 10));
        const ResidencyPlan plan = planResidency(wishes, faces, room);
        std::uint64_t elements = 0;
        std::uint64_t finer = 0; // with an eighth of a level more for each
        for (std::size_t f = 0; f < wishes.size(); ++f) {
            const auto cost = [&](int bias) -> std::uint64_t {
                const int level =
                    wishes[f] == kUnseen
                        ? 0
                        : std::clamp((wishes[f] - bias + 7) >> 3, 0, int{faces[f].own});
                return room.perBlock[static_cast<std::size_t>(level)];
            };
            elements += cost(plan.bias);
            finer += cost(plan.bias - 1);
        }
        EXPECT_EQ(plan.elements, elements);
        EXPECT_LE(elements, room.elements);
        EXPECT_TRUE(plan.bias == 0 || finer > room.elements);
        // Doing it all brings every face to its level, and what is spare is all that is beyond.
        std::vector<int> shown(faces.size());
        for (std::size_t f = 0; f < faces.size(); ++f) {
            shown[f] = faces[f].level();
        }
        for (const BlockJob& job : plan.make) {
            EXPECT_GT(int{job.level}, shown[indexOf(job.face)]);
            shown[indexOf(job.face)] = job.level;
        }
        for (const BlockJob& job : plan.spare) {
            EXPECT_LT(int{job.level}, shown[indexOf(job.face)]);
            shown[indexOf(job.face)] = job.level;
        }
        std::uint64_t left = 0;
        for (const int level : shown) {
            left += room.perBlock[static_cast<std::size_t>(level)];
        }
        EXPECT_EQ(left, elements);
    }
}

TEST(Residency, coarseBlocksComeFirstThenTheLargestOnTheScreen)
{
    std::mt19937 random(6);
    std::vector<Wish> wishes(2000);
    std::vector<FaceOnCard> faces(wishes.size(), FaceOnCard{9, 0});
    for (Wish& wish : wishes) {
        wish = static_cast<Wish>(random() % 73);
    }
    const ResidencyPlan plan = planResidency(wishes, faces, roomOf(1ULL << 31U));
    ASSERT_EQ(plan.bias, 0);
    const auto rank = [&](const BlockJob& job) {
        return std::pair((job.level + 2) / 3, -int{wishes[indexOf(job.face)]});
    };
    EXPECT_TRUE(std::ranges::is_sorted(plan.make, {}, rank));
    const auto sees3 = std::ranges::count_if(plan.make, [](auto job) { return job.level == 3; });
    EXPECT_GT(sees3, 1000) << "a step on the way to finer levels";
}

TEST(Residency, whatIsOutOfViewIsGivenUpFirst)
{
    const std::vector<Wish> wishes{8, 40, kUnseen, 24};
    const std::vector<FaceOnCard> faces{{6, 6}, {6, 5}, {6, 4}, {6, 3}};
    const ResidencyPlan plan = planResidency(wishes, faces, roomOf(1U << 24U));
    ASSERT_EQ(plan.spare.size(), 2U);
    EXPECT_EQ(plan.spare[0], (BlockJob{faceId(2), 0}));
    EXPECT_EQ(plan.spare[1], (BlockJob{faceId(0), 1}));
    EXPECT_TRUE(plan.make.empty());
}

TEST(Residency, whatMustNotBeShownIsMadeAnewInViewAndGivenUpElsewhere)
{
    const std::vector<Wish> wishes{40, 40, kUnseen, kUnseen};
    const std::uint8_t stale = 4 | FaceOnCard::kStale;
    // Finer than the face is to be shown, and stale; in view and not.
    const std::vector<FaceOnCard> faces{{3, 5}, {6, stale}, {3, 5}, {6, stale}};
    const ResidencyPlan plan = planResidency(wishes, faces, roomOf(1U << 24U));
    EXPECT_EQ(plan.make, (std::vector<BlockJob>{{faceId(0), 3}, {faceId(1), 5}}));
    EXPECT_EQ(plan.release, (std::vector<FaceId>{faceId(2), faceId(3)}));
}
