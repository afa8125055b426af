// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/speed/peers/atlas.h"
#include "core/study/speed/peers/peer_files.h"
#include "core/study/speed/peers/peers.h"
#include "core/study/tile_picture.h"
#include "tests/core/study/study_fixture.h"
#include "tests/core/test_meshes.h"

#include <fstream>
#include <gmock/gmock.h>

namespace trixel {
namespace {

using test::RememberingWatcher;
using test::smallSubjects;
using testing::HasSubstr;

/// Value of the pixel that (s,t) falls on.
float pixelAt(const peers::Picture& picture, double s, double t, int channel)
{
    const int x = static_cast<int>((s - std::floor(s)) * picture.width);
    const int y = static_cast<int>((t - std::floor(t)) * picture.height);
    return picture.values[(y * picture.width + x) * picture.channels + channel];
}

/// Queries at the centroids of some texels of every face, with no footprint at all.
QueryArrays atCentroids(const FilterScene& scene, std::uint32_t each)
{
    QueryArrays queries;
    for (std::size_t f = 0; f < scene.faceCount(); ++f) {
        const Level level = scene.level(faceId(f));
        for (std::uint32_t k = 0; k < each; ++k) {
            const auto texel = static_cast<TexelIndex>((k * 977U + f) % level.texelCount());
            queries.add(faceId(f), centroid(level, texelAt(level, texel)), {0, 0}, {0, 0});
        }
    }
    return queries;
}

/// Of the natural tile; takes a while to make.
const Atlas& smallAtlas()
{
    static const auto kAtlas =
        makePlanarAtlas(parseTestData(storedTestFiles()).value(), TestContent::Natural, 1);
    return *kAtlas;
}

TEST(PlanarAtlas, showsTheTileWhereItsFacesLie)
{
    const FilterScene& scene = *smallSubjects()[0].scene;
    const Atlas& atlas = smallAtlas();
    const QueryArrays queries = atCentroids(scene, 40);
    const AtlasSamples samples = atlas.samples(scene, queries.queries());
    double squares = 0;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const Level level = scene.level(queries.face[i]);
        const auto texel = texelAt(level, glm::dvec2(queries.u[i], queries.v[i]));
        const float* truth =
            scene.mips().texels(queries.face[i], level).texel(texelIndex(level, texel));
        const double error = static_cast<double>(
            pixelAt(atlas.picture(), double{samples.s[i]}, double{samples.t[i]}, 1) - truth[1]);
        squares += error * error;
    }
    // Pixels are not quite inside the texels.
    EXPECT_LT(std::sqrt(squares / static_cast<double>(queries.size())), 0.03);
}

TEST(PlanarAtlas, samplesAreTheSameOnLargeFaces)
{
    const auto data = parseTestData(storedTestFiles()).value();
    NoProgress progress;
    const TestPatch patch(1, TestFaces::Large);
    const auto large = storedSubjects(patch, Threads{2}, progress).value();
    const StudySubject& small = smallSubjects()[0];
    const AtlasSamples a = smallAtlas().samples(*small.scene, small.queries.queries());
    const AtlasSamples b = makePlanarAtlas(data, TestContent::Natural, patch)
                               ->samples(*large[0].scene, large[0].queries.queries());
    ASSERT_EQ(a.s.size(), b.s.size());
    for (std::size_t i = 0; i < a.s.size(); ++i) {
        EXPECT_NEAR(a.s[i], b.s[i], 1e-6);
        EXPECT_NEAR(a.t[i], b.t[i], 1e-6);
        // A round footprint has axes of any direction.
        const auto area = [i](const AtlasSamples& x) {
            return x.dsdx[i] * x.dtdy[i] - x.dsdy[i] * x.dtdx[i];
        };
        EXPECT_NEAR(std::abs(area(a)), std::abs(area(b)), 1e-4 * std::abs(area(a)));
        EXPECT_NEAR(std::hypot(a.dsdx[i], a.dsdy[i]), std::hypot(b.dsdx[i], b.dsdy[i]), 1e-6);
        EXPECT_NEAR(std::hypot(a.dtdx[i], a.dtdy[i]), std::hypot(b.dtdx[i], b.dtdy[i]), 1e-6);
    }
}

TEST(PlanarAtlas, derivativesKeepTheFootprintsAreaAndSpanItsTexels)
{
    const FilterScene& scene = *smallSubjects()[0].scene;
    const Atlas& atlas = smallAtlas();
    const FilterQueries queries = smallSubjects()[0].queries.queries();
    const AtlasSamples samples = atlas.samples(scene, queries);
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const QueryEllipse ellipse = queryEllipse(scene, queries, i);
        // The picture is 8 edges wide and 16 sin 60° high.
        const double x = double{samples.dsdx[i]} * 8;
        const double y = double{samples.dtdx[i]} * 16 * 0.86602540378443865;
        EXPECT_NEAR(std::hypot(x, y), 2 * ellipse.majorSigma, 1e-5 * (1 + ellipse.majorSigma));
        const double x2 = double{samples.dsdy[i]} * 8;
        const double y2 = double{samples.dtdy[i]} * 16 * 0.86602540378443865;
        EXPECT_NEAR(std::abs(x * y2 - y * x2),
                    4 * std::sqrt(ellipse.determinant),
                    1e-4 * (1e-4 + std::sqrt(ellipse.determinant)));
    }
}

TEST(FaceAtlas, showsEveryTexelOfEveryFace)
{
    // Two levels, so that squares of two sizes have to be placed.
    const TriangleMesh mesh = test::sphereMesh(0);
    FaceMap<Level> levels(mesh.faceCount(), Level(2));
    levels[faceId(7)] = Level(4);
    const std::array<std::byte, 3> fill{};
    TexelStore store(TexelFormat{}, levels, fill);
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const auto bytes = store.writable(faceId(f));
        for (std::size_t k = 0; k < bytes.size(); ++k) {
            bytes[k] = static_cast<std::byte>((k * 37 + f * 11) % 256);
        }
    }
    NoProgress progress;
    const auto scene =
        FilterScene::build(std::make_shared<const FilterSurface>(
                               FilterSurface::fromMesh(mesh, buildAdjacency(mesh.triangles))),
                           store,
                           Threads{1},
                           progress)
            .value();
    const auto atlas = makeFaceAtlas(scene);
    const QueryArrays queries = atCentroids(scene, 256);
    const AtlasSamples samples = atlas->samples(scene, queries.queries());
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const Level level = scene.level(queries.face[i]);
        const auto texel = texelAt(level, glm::dvec2(queries.u[i], queries.v[i]));
        const float* truth =
            scene.mips().texels(queries.face[i], level).texel(texelIndex(level, texel));
        EXPECT_EQ(pixelAt(atlas->picture(), double{samples.s[i]}, double{samples.t[i]}, 2),
                  truth[2]);
    }
}

TEST(Peers, openImageIoIsAlwaysMeasuredAndReadsTheSameContent)
{
    NoProgress progress;
    const auto peers = makePeers(smallSubjects(), TRIXEL_PEER_FOLDER, progress);
    ASSERT_TRUE(peers);
    EXPECT_THAT(peers->notes, testing::Contains(HasSubstr("OpenImageIO reads a periodic picture")));
    SpeedAccuracyOptions options;
    options.rounds = 1;
    RememberingWatcher watcher;
    const Study study =
        measureSpeedAccuracy(smallSubjects(), peers->contestants, options, watcher).value();
    int points = 0;
    for (const StudyPoint& point : study.points) {
        if (point.series.starts_with("OpenImageIO") && !point.footprintClass) {
            ++points;
            EXPECT_LT(point.rms, 0.12) << point.variant; // wrong content is off by 0.3
            EXPECT_FALSE(point.method);
        }
    }
    EXPECT_EQ(points, 8);
}

TEST(Peers, missingModulesAreNamedAndNoError)
{
    NoProgress progress;
    const auto peers = makePeers(smallSubjects(), "/nowhere", progress);
    ASSERT_TRUE(peers);
    EXPECT_THAT(peers->contestants, testing::IsEmpty());
    EXPECT_THAT(peers->notes,
                testing::ElementsAre(HasSubstr("OpenImageIO was not measured"),
                                     HasSubstr("Ptex library was not measured")));
}

TEST(Peers, cancellingIsHeard)
{
    RememberingWatcher watcher(0);
    const auto peers = makePeers(smallSubjects(), TRIXEL_PEER_FOLDER, watcher);
    ASSERT_FALSE(peers);
    EXPECT_EQ(peers.error().kind, ErrorKind::Cancelled);
}

TEST(TemporaryFolder, goesWithAllThatIsInIt)
{
    std::filesystem::path path;
    {
        const auto folder = TemporaryFolder::make().value();
        path = folder->path();
        std::filesystem::create_directory(path / "deeper");
        std::ofstream(path / "deeper" / "file") << "text";
        EXPECT_TRUE(std::filesystem::exists(path));
    }
    EXPECT_FALSE(std::filesystem::exists(path));
}

} // namespace
} // namespace trixel
