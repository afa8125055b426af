// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/fit/face_views.h"
#include "core/study/fit/fit_rim.h"
#include "tests/core/test_meshes.h"

#include <cmath>
#include <gmock/gmock.h>
#include <set>

namespace trixel {
namespace {

std::shared_ptr<const Surface> surfaceOf(TriangleMesh mesh)
{
    NoProgress progress;
    return Surface::build(std::move(mesh), progress).value();
}

FaceViews viewsOf(const Surface& surface, const SceneViews& views, UnseenFaces unseen)
{
    NoProgress progress;
    return FaceViews::find(surface, views, unseen, Threads{2}, progress).value();
}

glm::dvec3 middleOf(const Surface& surface, FaceId face)
{
    const auto corners = surface.mesh().corners(face);
    return (glm::dvec3(corners[0]) + glm::dvec3(corners[1]) + glm::dvec3(corners[2])) / 3.0;
}

const ViewCamera kNear{"near", {0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 40, 200, 200};
const ViewCamera kFar{"far", {0, 0, -40}, {0, 0, 0}, {0, 1, 0}, 40, 200, 200};

/// A face well before the horizon of the camera "near", and one well behind.
struct Sphere
{
    std::shared_ptr<const Surface> surface = surfaceOf(test::sphereMesh(2));
    FaceId front = nearestTo({0, 0, 1});
    FaceId back = nearestTo({0, 0, -1});

    FaceId nearestTo(glm::vec3 point) const { return surface->bvh().closestPoint(point, 1)->face; }
};

TEST(FaceViews, aFaceNeedsWhatTheViewsThatSeeItNeed)
{
    const Sphere sphere;
    const SceneViews views{{kNear, kFar}, {}};
    const FaceViews found = viewsOf(*sphere.surface, views, UnseenFaces::OneTexel);
    const glm::dvec3 front = middleOf(*sphere.surface, sphere.front);
    const glm::dvec3 back = middleOf(*sphere.surface, sphere.back);
    EXPECT_EQ(found.finestSpacing(sphere.front, front), kNear.unitsPerPixel(front));
    EXPECT_EQ(found.finestSpacing(sphere.back, back), kFar.unitsPerPixel(back))
        << "the nearer camera is hidden from it";
    EXPECT_TRUE(found.isSeen(sphere.back));
}

TEST(FaceViews, whatNoViewSeesNeedsNothingOrCountsByItsDistance)
{
    const Sphere sphere;
    const SceneViews views{{kNear}, {}};
    const glm::dvec3 back = middleOf(*sphere.surface, sphere.back);
    const FaceViews one = viewsOf(*sphere.surface, views, UnseenFaces::OneTexel);
    EXPECT_FALSE(one.isSeen(sphere.back));
    EXPECT_TRUE(std::isinf(one.finestSpacing(sphere.back, back)));
    const FaceViews all = viewsOf(*sphere.surface, views, UnseenFaces::ByDistance);
    EXPECT_FALSE(all.isSeen(sphere.back));
    EXPECT_EQ(all.finestSpacing(sphere.back, back), kNear.unitsPerPixel(back));

    ViewCamera away = kNear; // looks past it
    away.target = {4, 0, 4};
    const SceneViews past{{away}, {}};
    const FaceViews turned = viewsOf(*sphere.surface, past, UnseenFaces::ByDistance);
    const glm::dvec3 front = middleOf(*sphere.surface, sphere.front);
    ViewCamera straight = away;
    straight.target = front;
    EXPECT_FALSE(turned.isSeen(sphere.front));
    EXPECT_NEAR(turned.finestSpacing(sphere.front, front), straight.unitsPerPixel(front), 1e-12);
}

TEST(FaceViews, everyViewOfADistanceSeesEveryFace)
{
    const Sphere sphere;
    const SceneViews views{{kNear}, {{"any", 30, 40, 200, 200}}};
    const FaceViews found = viewsOf(*sphere.surface, views, UnseenFaces::OneTexel);
    const glm::dvec3 back = middleOf(*sphere.surface, sphere.back);
    EXPECT_TRUE(found.isSeen(sphere.back));
    EXPECT_EQ(found.finestSpacing(sphere.back, back), views.distant[0].unitsPerPixel());
}

/// Judges the faces of one corner of a square of 16 × 16 cells.
FitSamples cornerOf(const Surface& surface, double spacing)
{
    FitSamples samples;
    samples.pixels = FaceMap<double>(surface.mesh().faceCount(), 0);
    samples.spacing =
        FaceMap<double>(surface.mesh().faceCount(), std::numeric_limits<double>::infinity());
    for (std::size_t f = 0; f < samples.pixels.size(); ++f) {
        const glm::dvec3 middle = middleOf(surface, faceId(f));
        if (middle.x < 0.25 && middle.y < 0.25) {
            samples.pixels[faceId(f)] = 1;
            samples.spacing[faceId(f)] = spacing;
        }
    }
    return samples;
}

TEST(FitRim, isWhatMeetsJudgedFacesOrComesWithinTwoPixels)
{
    const auto surface = surfaceOf(test::gridMesh(16)); // cells of 1/16
    const auto shapes = FilterSurface::fromMesh(surface->mesh(), surface->adjacency());
    for (const double pixel : {1e-3, 0.04, 0.07}) {
        const FitSamples samples = cornerOf(*surface, pixel);
        const FitRim rim = fitRim(*surface, shapes.rings(), samples);
        std::set<std::size_t> reached;
        for (const auto& faces : rim.reached.values()) {
            for (const FaceId face : faces) {
                reached.insert(indexOf(face));
            }
        }
        for (std::size_t f = 0; f < samples.pixels.size(); ++f) {
            const auto corners = surface->mesh().corners(faceId(f));
            float away = 1; // how far from the judged corner the face begins
            for (const glm::vec3 corner : corners) {
                away = std::min(away, std::max(corner.x, corner.y) - 0.25F);
            }
            const bool isJudged = samples.isJudged(faceId(f));
            if (isJudged || away > 2 * pixel) {
                EXPECT_EQ(rim.contains(faceId(f)), !isJudged && away <= 0) << pixel << ": " << f;
            } else if (away <= 0) {
                EXPECT_TRUE(rim.contains(faceId(f))) << pixel << ": " << f;
            }
            EXPECT_EQ(rim.contains(faceId(f)), reached.contains(f));
        }
        EXPECT_EQ(rim.contains(surface->bvh().closestPoint({0.34F, 0.1F, 0}, 1)->face),
                  pixel > 0.0625 / 2)
            << "the second row, " << pixel;
    }
}

TEST(FitRim, isEmptyWhereAllIsJudged)
{
    const auto surface = surfaceOf(test::sphereMesh(1));
    const auto shapes = FilterSurface::fromMesh(surface->mesh(), surface->adjacency());
    FitSamples samples;
    samples.pixels = FaceMap<double>(80, 1);
    samples.spacing = FaceMap<double>(80, 0.1);
    const FitRim rim = fitRim(*surface, shapes.rings(), samples);
    for (std::size_t f = 0; f < 80; ++f) {
        EXPECT_FALSE(rim.contains(faceId(f)));
    }
}

} // namespace
} // namespace trixel
