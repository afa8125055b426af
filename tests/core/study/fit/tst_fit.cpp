// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lattice/texel.h"
#include "core/study/fit/fit.h"
#include "core/study/fit/fit_method.h"
#include "core/study/fit/fit_subdivision.h"
#include "core/study/views/picture_error.h"
#include "tests/core/study/fit/covered_views.h"
#include "tests/core/test_meshes.h"

#include <bit>
#include <cmath>
#include <gmock/gmock.h>
#include <random>

namespace trixel {
namespace {

constexpr double kTolerance = 3.0 / 255;

/// Half a sphere, 40 faces of levels 3 and 4: soft colours, hard stripes on one side, one colour on
/// the other half.
struct Scene
{
    std::shared_ptr<const Surface> surface;
    TexelStore texels;
    std::shared_ptr<const FilterSurface> shapes;
};

std::array<std::byte, 3> colourAt(glm::vec3 p)
{
    const bool striped = p.x > 0.5F && std::sin(40 * p.y) > 0;
    const auto byteOf = [](float v) {
        return static_cast<std::byte>(std::lround(255 * std::clamp(v, 0.0F, 1.0F)));
    };
    return {byteOf(striped ? 0.9F : 0.5F + 0.3F * std::sin(3 * p.x)),
            byteOf(striped ? 0.1F : 0.5F + 0.2F * p.y),
            byteOf(0.4F)};
}

FaceTexels painted(const TriangleMesh& mesh, FaceId face, Level level)
{
    const auto corners = mesh.corners(face);
    if (corners[0].x + corners[1].x + corners[2].x < 0) {
        return FaceTexels::constant(level, colourAt({0, 0, 0}));
    }
    std::vector<std::byte> texels;
    for (std::uint32_t t = 0; t < level.texelCount(); ++t) {
        const glm::dvec2 uv = centroid(level, texelAt(level, static_cast<TexelIndex>(t)));
        const auto colour = colourAt(
            glm::normalize(pointAt(corners, static_cast<float>(uv.x), static_cast<float>(uv.y))));
        texels.insert(texels.end(), colour.begin(), colour.end());
    }
    return FaceTexels::full(level, 3, texels);
}

TriangleMesh domeMesh()
{
    TriangleMesh mesh = test::sphereMesh(1);
    std::erase_if(mesh.triangles, [&](const auto& triangle) {
        float height = 0;
        for (const auto vertex : triangle) {
            height += mesh.positions[vertex].z;
        }
        return height < 0;
    });
    return mesh;
}

const Scene& scene()
{
    static const Scene made = [] {
        NoProgress progress;
        Scene s;
        s.surface = Surface::build(domeMesh(), progress).value();
        const TriangleMesh& mesh = s.surface->mesh();
        s.texels = TexelStore(static_cast<std::uint32_t>(mesh.faceCount()),
                              TexelFormat(),
                              Level(3),
                              colourAt({0, 0, 0}));
        for (std::uint32_t f = 0; f < mesh.faceCount(); ++f) {
            s.texels.exchange(faceId(f), painted(mesh, faceId(f), Level(f % 3 == 0 ? 3 : 4)));
        }
        s.shapes =
            std::make_shared<FilterSurface>(FilterSurface::fromMesh(mesh, s.surface->adjacency()));
        return s;
    }();
    return made;
}

FilterScene filterScene(const TexelStore& texels)
{
    NoProgress progress;
    return FilterScene::build(scene().shapes, texels, Threads{2}, progress).value();
}

/// Sees the whole dome at about a texel a pixel.
SceneViews farViews()
{
    return {{{"far", {2, 1, 5}, {0, 0, 0}, {0, 1, 0}, 30, 130, 130}}, {}};
}

FitPlan planned(const SceneViews& views, double tolerance = kTolerance, unsigned threads = 2)
{
    NoProgress progress;
    return planFit(*scene().surface, scene().texels, {views, tolerance}, Threads{threads}, progress)
        .value();
}

const FitPlan& farPlan()
{
    static const FitPlan plan = planned(farViews());
    return plan;
}

/// Sees less than half of the dome, no closer.
SceneViews narrowViews()
{
    SceneViews views = farViews();
    views.cameras[0].target = {0.7, 0.2, 0.7};
    views.cameras[0].fovY = 10;
    views.cameras[0].width = 44;
    views.cameras[0].height = 44;
    return views;
}

constexpr double kRough = 5 * kTolerance;

const FitPlan& roughPlan()
{
    static const FitPlan plan = planned(narrowViews(), kRough);
    return plan;
}

const FitPlan& narrowPlan()
{
    static const FitPlan plan = planned(narrowViews());
    return plan;
}

TexelStore fittedStore(const FitPlan& plan)
{
    TexelStore texels = scene().texels;
    applyFit(plan, texels);
    return texels;
}

PictureError errorOf(const FilterScene& before, const FilterScene& after, const ViewCamera& view)
{
    NoProgress progress;
    const auto queries = viewQueries(*scene().surface, view, {5, 3}, Threads{2}, progress);
    return pictureError(before, after, queries->queries.queries(), Threads{2}, progress).value();
}

/// The promise. (A benchmark does the same with the sample scene and a hundred views.)
TEST(Fit, noCoveredViewExceedsTheTolerance)
{
    const FilterScene before = filterScene(scene().texels);
    const SceneViews anyBeyond{{}, {{"any", 4.5, 40, 140, 140}}};
    for (const SceneViews& views : {farViews(), anyBeyond}) {
        const FitPlan plan = views == farViews() ? farPlan() : planned(views);
        EXPECT_LT(plan.cost.texelsAfter, plan.cost.texelsBefore * 3 / 4) << "worth testing";
        const FilterScene after = filterScene(fittedStore(plan));
        test::CoveredViews covered(*scene().surface, views, 11);
        double worst = 0;
        for (int k = 0; k < 8; ++k) {
            const PictureError error = errorOf(before, after, covered.next());
            EXPECT_GT(error.pixels, 100U);
            EXPECT_LE(error.rms, kTolerance) << "view " << k;
            worst = std::max(worst, error.rms);
        }
        EXPECT_GT(worst, 0.1 * kTolerance) << "the tolerance is made use of";
    }
}

TEST(Fit, levelsNeverRiseAndConstantFacesStayConstant)
{
    const FitPlan& plan = farPlan();
    const TexelStore after = fittedStore(plan);
    FaceMap<char> isNear(after.faceCount(), 0); // a face that changed
    const VertexRings& rings = scene().shapes->rings();
    for (std::size_t r = 0; r < rings.ringCount(); ++r) {
        const auto corners = rings.corners(static_cast<RingId>(r));
        for (const Corner& a : corners) {
            for (const Corner& b : corners) {
                const bool changes = plan.levels[b.face] != scene().texels.face(b.face).level();
                isNear[a.face] = isNear[a.face] != 0 || changes ? 1 : 0;
            }
        }
    }
    for (std::uint32_t f = 0; f < after.faceCount(); ++f) {
        const FaceTexels& was = scene().texels.face(faceId(f));
        EXPECT_LE(plan.levels[faceId(f)], was.level());
        EXPECT_EQ(after.face(faceId(f)).level(), plan.levels[faceId(f)]);
        if (was.isConstant()) {
            EXPECT_TRUE(after.face(faceId(f)).isConstant());
        }
        if (isNear[faceId(f)] == 0) {
            EXPECT_EQ(after.face(faceId(f)), was);
        }
    }
    EXPECT_EQ(plan.cost, levelCost(scene().texels, plan.levels));
    EXPECT_EQ(after.texelCount(), plan.cost.texelsAfter);
}

TEST(Fit, undoBringsBackEveryTexel)
{
    const FitPlan& plan = farPlan();
    TexelStore texels = scene().texels;
    TexelPatch patch = applyFit(plan, texels);
    patch.swap(texels);
    for (std::uint32_t f = 0; f < texels.faceCount(); ++f) {
        EXPECT_EQ(texels.face(faceId(f)), scene().texels.face(faceId(f)));
    }
}

TEST(Fit, doesNotDependOnThreads)
{
    const FitPlan& one = roughPlan();
    EXPECT_GT(one.cost.changedFaces, one.unseenFaces);
    const FitPlan many = planned(narrowViews(), kRough, 1);
    EXPECT_EQ(one.levels, many.levels);
    for (std::uint32_t f = 0; f < one.errors.size(); ++f) { // NaN where unseen
        EXPECT_EQ(std::bit_cast<std::uint32_t>(one.errors[faceId(f)]),
                  std::bit_cast<std::uint32_t>(many.errors[faceId(f)]));
    }
    const TexelStore a = fittedStore(one);
    const TexelStore b = fittedStore(many);
    for (std::uint32_t f = 0; f < a.faceCount(); ++f) {
        EXPECT_EQ(a.face(faceId(f)), b.face(faceId(f)));
    }
}

TEST(Fit, aWiderToleranceNeedsFewerTexels)
{
    EXPECT_LT(roughPlan().cost.texelsAfter, narrowPlan().cost.texelsAfter);
}

/// A square of 32 faces of level 4 and one grey, but three red ones and noise on one of them.
std::pair<std::shared_ptr<const Surface>, TexelStore> noisySquare()
{
    NoProgress progress;
    std::shared_ptr<const Surface> surface = Surface::build(test::gridMesh(4), progress).value();
    const std::array<std::byte, 3> grey = {std::byte{200}, std::byte{200}, std::byte{200}};
    const std::array<std::byte, 3> red = {std::byte{200}, std::byte{30}, std::byte{30}};
    TexelStore texels(32, TexelFormat(), Level(4), grey);
    for (const std::uint32_t face : {9U, 10U, 11U}) {
        texels.exchange(faceId(face), FaceTexels::constant(Level(4), red));
    }
    std::mt19937 random(5);
    for (std::byte& value : texels.writable(faceId(9))) {
        value = static_cast<std::byte>(random() % 256);
    }
    return {surface, texels};
}

TEST(Fit, fartherViewsOfAFewFacesNeedNoMoreTexelsButForATenth)
{
    const auto [surface, texels] = noisySquare();
    std::uint64_t nearer = texels.texelCount();
    for (const double distance : {10.0, 20.0, 40.0, 80.0, 200.0}) {
        NoProgress progress;
        const SceneViews views{{}, {{.name = "far", .distance = distance}}};
        const auto plan = planFit(*surface, texels, {views, 1.0 / 255}, Threads{2}, progress);
        ASSERT_TRUE(plan);
        EXPECT_LE(plan->cost.texelsAfter, nearer + nearer / 10) << distance;
        EXPECT_LT(plan->rms, 1.0 / 255);
        nearer = plan->cost.texelsAfter;
    }
    EXPECT_LT(nearer, texels.texelCount() / 4);
}

/// Faces that meet one that is judged at a vertex.
FaceMap<char> besideJudged(const Surface& surface, const FitPlan& plan)
{
    FaceMap<char> beside(plan.levels.size(), 0);
    const auto shapes = FilterSurface::fromMesh(surface.mesh(), surface.adjacency());
    for (std::size_t r = 0; r < shapes.rings().ringCount(); ++r) {
        const auto corners = shapes.rings().corners(static_cast<RingId>(r));
        const bool meets = std::ranges::any_of(
            corners, [&](const Corner& c) { return !std::isnan(plan.errors[c.face]); });
        for (const Corner& corner : corners) {
            beside[corner.face] = meets || beside[corner.face] != 0 ? 1 : 0;
        }
    }
    return beside;
}

TEST(Fit, facesInNoPictureGoToTheLowestLevel)
{
    const FitPlan& plan = narrowPlan();
    EXPECT_GT(plan.unseenFaces, 20U);
    EXPECT_LT(plan.unseenFaces, 40U);
    const FaceMap<char> beside = besideJudged(*scene().surface, plan);
    std::uint32_t lowest = 0;
    for (std::uint32_t f = 0; f < beside.size(); ++f) {
        if (beside[faceId(f)] == 0) {
            EXPECT_EQ(plan.levels[faceId(f)], Level(0)) << f;
            ++lowest;
        }
    }
    EXPECT_GT(lowest, 5U);
}

/// A sphere of 320 faces of level 2, all noise, and a camera that sees it at a texel a pixel.
struct NoisySphere
{
    std::shared_ptr<const Surface> surface;
    TexelStore texels;
    SceneViews views{{{"front", {0, 0, 6}, {0, 0, 0}, {0, 1, 0}, 25, 60, 60}}, {}};
};

NoisySphere noisySphere()
{
    NoProgress progress;
    NoisySphere s;
    s.surface = Surface::build(test::sphereMesh(2), progress).value();
    const std::array<std::byte, 3> black{};
    s.texels = TexelStore(320, TexelFormat(), Level(2), black);
    std::mt19937 random(9);
    for (std::uint32_t f = 0; f < 320; ++f) {
        for (std::byte& value : s.texels.writable(faceId(f))) {
            value = static_cast<std::byte>(random() % 64);
        }
    }
    return s;
}

TEST(Fit, facesThatNoViewSeesKeepOneTexelOrAreFittedByTheirDistance)
{
    const NoisySphere s = noisySphere();
    const auto plan = [&](UnseenFaces unseen) {
        NoProgress progress;
        return planFit(*s.surface, s.texels, {s.views, 1e-3, unseen}, Threads{2}, progress).value();
    };
    const FitPlan one = plan(UnseenFaces::OneTexel);
    const FitPlan all = plan(UnseenFaces::ByDistance);
    EXPECT_GT(one.unseenFaces, 150U);
    EXPECT_EQ(one.unseenFaces, all.unseenFaces);
    EXPECT_EQ(one.unseenTexelsBefore, std::uint64_t{16} * one.unseenFaces);
    EXPECT_EQ(all.unseenTexelsBefore, one.unseenTexelsBefore);
    EXPECT_LT(one.unseenTexelsAfter, one.unseenTexelsBefore / 2);
    EXPECT_GT(all.unseenTexelsAfter, 2 * one.unseenTexelsAfter);

    const FaceMap<char> beside = besideJudged(*s.surface, one);
    std::uint32_t lowest = 0;
    for (std::uint32_t f = 0; f < 320; ++f) {
        EXPECT_FALSE(std::isnan(all.errors[faceId(f)])) << "every face is judged";
        if (beside[faceId(f)] == 0) {
            EXPECT_EQ(one.levels[faceId(f)], Level(0));
            ++lowest;
        }
    }
    EXPECT_GT(lowest, 80U);
}

/// The levels of faces beside seen ones are kept up with those, for footprints reach into them.
TEST(Fit, whatAViewSeesIsKeptToItsVeryEdge)
{
    const NoisySphere s = noisySphere();
    NoProgress progress;
    const double tolerance = 3e-4; // next to nothing may change
    const auto plan =
        planFit(*s.surface, s.texels, {s.views, tolerance}, Threads{2}, progress).value();
    EXPECT_LT(plan.unseenTexelsAfter, plan.unseenTexelsBefore * 2 / 3);
    EXPECT_LE(plan.worstPart, tolerance);
}

TEST(Fit, refusesWhatItCannotUse)
{
    NoProgress progress;
    const auto complaint = [&](const FitSettings& settings) {
        const auto plan = planFit(*scene().surface, scene().texels, settings, Threads{1}, progress);
        return plan ? std::string("accepted") : plan.error().message;
    };
    EXPECT_THAT(complaint({farViews(), 0}), testing::HasSubstr("tolerance: expected"));
    EXPECT_THAT(complaint({farViews(), std::nan("")}), testing::HasSubstr("tolerance: expected"));
    EXPECT_THAT(complaint({{}, 0.1}), testing::HasSubstr("at least one camera"));
}

class StopAt final : public Progress
{
public:
    explicit StopAt(double fraction)
        : m_fraction(fraction)
    {
    }
    bool report(double fraction) override { return fraction < m_fraction; }

private:
    double m_fraction;
};

TEST(Fit, canBeCancelledAtAnyStage)
{
    for (const double fraction : {0.0, 0.05, 0.3}) {
        StopAt progress(fraction);
        const auto plan = planFit(
            *scene().surface, scene().texels, {farViews(), kTolerance}, Threads{2}, progress);
        ASSERT_FALSE(plan) << fraction;
        EXPECT_EQ(plan.error().kind, ErrorKind::Cancelled);
    }
}

TEST(FitMethod, isWithinTheToleranceAndNoneIsCheaper)
{
    const FilterScene before = filterScene(scene().texels);
    NoProgress progress;
    const auto rough = fitMethod(*scene().surface, before, farViews(), 0.05, Threads{2}, progress);
    ASSERT_TRUE(rough && *rough);
    EXPECT_LE((*rough)->rms, 0.05);
    EXPECT_GT((*rough)->nanoseconds, 0);
    const auto never = fitMethod(*scene().surface, before, farViews(), 1e-12, Threads{2}, progress);
    ASSERT_TRUE(never);
    EXPECT_FALSE(*never);
}

TEST(SubdivisionErrors, fallAndStopAtTheBound)
{
    const SceneViews views{{{"v", {0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 30, 400, 400}}, {}};
    const auto errors = subdivisionErrors(test::sphereMesh(0), views, 0.25);
    ASSERT_GE(errors.size(), 3U);
    EXPECT_EQ(errors[0].faces, 20U);
    EXPECT_EQ(errors[1].faces, 80U);
    for (std::size_t k = 1; k < errors.size(); ++k) {
        // By four where the mesh is regular, less about the vertices of five edges.
        EXPECT_GT(errors[k - 1].pixels / errors[k].pixels, 2);
        EXPECT_GT(errors[k - 1].pixels, 0.25);
    }
    EXPECT_LE(errors.back().pixels, 0.25);
}

} // namespace
} // namespace trixel
