// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/views/seen_faces.h"
#include "tests/core/test_meshes.h"

#include <gmock/gmock.h>

namespace trixel {
namespace {

std::shared_ptr<const Surface> surfaceOf(TriangleMesh mesh)
{
    NoProgress progress;
    return Surface::build(std::move(mesh), progress).value();
}

SeenFaces found(const Surface& surface,
                const std::vector<ViewCamera>& cameras,
                double margin = 0,
                unsigned threads = 2)
{
    NoProgress progress;
    return SeenFaces::find(surface, cameras, margin, Threads{threads}, progress).value();
}

/// Adds a rectangle of two faces at z = 1.
void addScreen(TriangleMesh& mesh, glm::vec2 low, glm::vec2 high)
{
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.emplace_back(low.x, low.y, 1.0F);
    mesh.positions.emplace_back(high.x, low.y, 1.0F);
    mesh.positions.emplace_back(high.x, high.y, 1.0F);
    mesh.positions.emplace_back(low.x, high.y, 1.0F);
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
}

/// Before the middle of a square of 8 × 8 cells; shadows at z = 0 are 1.5 times as wide.
const ViewCamera kFront{"front", {0.5, 0.5, 3}, {0.5, 0.5, 0}, {0, 1, 0}, 30, 100, 100};

TEST(SeenFaces, whatStandsBeforeAFaceHidesIt)
{
    TriangleMesh mesh = test::gridMesh(8);
    addScreen(mesh, {0.3F, 0.3F}, {0.7F, 0.7F}); // its shadow from 0.2 to 0.8
    const auto surface = surfaceOf(std::move(mesh));
    const SeenFaces seen = found(*surface, {kFront});
    for (std::uint32_t f = 0; f < 128; ++f) {
        bool isHidden = true;
        for (const glm::vec3 corner : surface->mesh().corners(faceId(f))) {
            isHidden =
                isHidden && std::abs(corner.x - 0.5F) < 0.3F && std::abs(corner.y - 0.5F) < 0.3F;
        }
        EXPECT_EQ(seen.isSeen(faceId(f)), !isHidden) << "face " << f;
    }
    EXPECT_TRUE(seen.isSeen(faceId(128)));
    EXPECT_TRUE(seen.isSeen(faceId(129)));
}

TEST(SeenFaces, aSphereHidesWhatIsBeyondItsHorizon)
{
    const auto surface = surfaceOf(test::sphereMesh(3));
    const glm::vec3 eye(1.2F, 2.0F, 3.0F);
    const ViewCamera camera{"", glm::dvec3(eye), {0, 0, 0}, {0, 1, 0}, 50, 300, 300};
    const SeenFaces seen = found(*surface, {camera});
    std::size_t hidden = 0;
    for (std::uint32_t f = 0; f < surface->mesh().faceCount(); ++f) {
        const auto corners = surface->mesh().corners(faceId(f));
        const glm::vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        // A convex solid: a face is seen if its plane leaves the eye outside.
        const float height = glm::dot(glm::normalize(normal), eye - corners[0]);
        if (std::abs(height) > 0.01F) {
            EXPECT_EQ(seen.isSeen(faceId(f)), height > 0) << "face " << f;
        }
        hidden += seen.isSeen(faceId(f)) ? 0 : 1;
    }
    EXPECT_GT(hidden, 640U);
}

TEST(SeenFaces, whatShowsThroughASlitOfAPixelIsSeen)
{
    TriangleMesh mesh = test::gridMesh(1); // large faces: no point that is asked lies in the slit
    addScreen(mesh, {-1.0F, -1.0F}, {0.43F, 2.0F});
    addScreen(mesh, {0.437F, -1.0F}, {2.0F, 2.0F});
    const auto surface = surfaceOf(std::move(mesh));
    ViewCamera fine = kFront;
    fine.width = 400;
    fine.height = 400;
    const SeenFaces seen = found(*surface, {fine});
    EXPECT_TRUE(seen.isSeen(faceId(0)));
    EXPECT_TRUE(seen.isSeen(faceId(1)));
}

TEST(SeenFaces, facesSmallerThanAPixelAreSeen)
{
    const auto surface = surfaceOf(test::gridMesh(30)); // nine faces a pixel
    ViewCamera far = kFront;
    far.width = 24;
    far.height = 24;
    const SeenFaces seen = found(*surface, {far});
    for (std::uint32_t f = 0; f < 1800; ++f) {
        EXPECT_TRUE(seen.isSeen(faceId(f))) << "face " << f;
    }
}

TEST(SeenFaces, onlyWhatThePictureFramesIsSeenAndItsMargin)
{
    const auto surface = surfaceOf(test::gridMesh(8));
    ViewCamera narrow = kFront; // about 0.2 wide, 20 pixels: the four cells about the middle
    narrow.fovY = 3.8;
    narrow.width = 20;
    narrow.height = 20;
    const auto count = [&](double margin) {
        const SeenFaces seen = found(*surface, {narrow}, margin);
        std::size_t faces = 0;
        for (std::uint32_t f = 0; f < 128; ++f) {
            faces += seen.isSeen(faceId(f)) ? 1 : 0;
        }
        return faces;
    };
    EXPECT_EQ(count(0), 8U);
    EXPECT_GT(count(4), 8U); // a cell has 12.5 pixels, 2.5 of the next are within four of the edge
    EXPECT_LE(count(4), 32U);
}

TEST(SeenFaces, tellCamerasApartAndDoNotDependOnThreads)
{
    const auto surface = surfaceOf(test::sphereMesh(2));
    std::vector<ViewCamera> cameras(70); // more than one word of bits
    for (std::size_t k = 0; k < cameras.size(); ++k) {
        const double angle = 0.3 * static_cast<double>(k);
        cameras[k].position = {4 * std::cos(angle), 0.5, 4 * std::sin(angle)};
        cameras[k].width = 40;
        cameras[k].height = 40;
    }
    const SeenFaces all = found(*surface, cameras, 0, 1);
    const SeenFaces again = found(*surface, cameras, 0, 3);
    for (const std::size_t k : {0U, 1U, 63U, 64U, 69U}) {
        const SeenFaces one = found(*surface, {cameras[k]});
        for (std::uint32_t f = 0; f < surface->mesh().faceCount(); ++f) {
            EXPECT_EQ(all.isSeenBy(k, faceId(f)), one.isSeen(faceId(f))) << k << ": " << f;
            EXPECT_EQ(all.isSeenBy(k, faceId(f)), again.isSeenBy(k, faceId(f)));
        }
    }
}

TEST(SeenFaces, withoutCamerasNoneIsSeen)
{
    const auto surface = surfaceOf(test::gridMesh(1));
    EXPECT_FALSE(found(*surface, {}).isSeen(faceId(0)));
}

class Refuses final : public Progress
{
public:
    bool report(double fraction) override { return fraction < 0.6; }
};

TEST(SeenFaces, canBeCancelled)
{
    const auto surface = surfaceOf(test::sphereMesh(6)); // more faces than between two reports
    Refuses progress;
    const std::vector<ViewCamera> cameras = {kFront};
    const auto seen = SeenFaces::find(*surface, cameras, 0, Threads{2}, progress);
    ASSERT_FALSE(seen);
    EXPECT_EQ(seen.error().kind, ErrorKind::Cancelled);
}

} // namespace
} // namespace trixel
