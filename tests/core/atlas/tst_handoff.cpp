// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/handoff_pages.h"
#include "core/atlas/handoff_sample_points.h"
#include "core/lattice/edge_transfer.h"
#include "core/study/solid_texture.h"
#include "core/study/views/view_queries.h"
#include "tests/core/atlas/atlas_pages.h"
#include "tests/core/cancel_after.h"
#include "tests/core/filter/filter_scenes.h"
#include "tests/core/filter/test_scenes.h"

#include <gtest/gtest.h>

#include <bit>
#include <new>
#include <random>
#include <set>
#include <tuple>

using namespace trixel;
using namespace trixel::test;

namespace {

/// A surface, its texels and a hand-off atlas of them.
struct HandOff
{
    TexelStore store;
    FilterScene scene;
    HandOffLayout layout;
    std::vector<Image> pages;

    HandOff(const TriangleMesh& mesh,
            TexelStore texels,
            const HandOffOptions& options,
            TexelType type = TexelType::Float)
        : store(std::move(texels))
        , scene(sceneOf(surfaceOf(mesh), store))
        , layout(*HandOffLayout::plan(handOffIntervals(store, scene.surface(), options), options))
    {
        NoProgress progress;
        const TexelFormat format{type, store.format().channels, std::nullopt};
        pages = *handOffPages(layout,
                              scene,
                              *makeMethod({"exact", std::nullopt}),
                              format,
                              {uniformColors(ColorSpace::Raw, format.channels, {}), {}},
                              Threads{2},
                              progress);
    }

    std::vector<float> value(FaceId face, glm::dvec2 uv) const
    {
        const Image& page = pages[layout.place(face).page];
        std::vector<float> result(page.format().channels);
        bilinear(page, layout.position(face, uv), result);
        return result;
    }
    double jump() const
    {
        NoProgress progress;
        return measureHandOff(layout, pages, scene.surface().adjacency(), 5, Threads{2}, progress)
            ->largestJump;
    }
    /// Of the first channels against `exact` at so many places, in decibels for values of [0,1].
    double psnr(int count, std::size_t channels) const
    {
        Dice dice(11);
        const auto exact = makeMethod({"exact", std::nullopt});
        double sum = 0;
        for (int k = 0; k < count; ++k) {
            const FaceId face = faceId(dice.below(store.faceCount()));
            const double s = std::sqrt(dice.uniform());
            const double t = dice.uniform();
            const glm::dvec2 uv(s * (1 - t), s * t);
            const Answer answer =
                ask(*exact, scene, Query{face, glm::vec2(uv), glm::vec2(0), glm::vec2(0)});
            const std::vector<float> shown = value(face, uv);
            for (std::size_t c = 0; c < channels; ++c) {
                sum += (answer.value[c] - double(shown[c])) * (answer.value[c] - double(shown[c]));
            }
        }
        return -10 * std::log10(sum / (double(channels) * count));
    }
};

TexelStore natural(const TriangleMesh& mesh, const FaceMap<Level>& levels)
{
    NoProgress progress;
    const TestData data = *parseTestData(storedTestFiles());
    return *solidTexture(mesh, LevelPlan{levels, 0}, data, Threads{2}, progress);
}

TEST(HandOffTile, everySampleOfBothFacesHasAPixelOfItsOwn)
{
    for (const std::uint32_t n : {1U, 2U, 3U, 16U}) {
        for (const std::uint32_t padding : {1U, 2U, 5U}) {
            const HandOffTile tile(n, padding);
            std::set<std::pair<std::uint32_t, std::uint32_t>> taken;
            std::size_t samples = 0;
            const int p = tile.padding();
            for (const HandOffSlot slot : {HandOffSlot::First, HandOffSlot::Second}) {
                for (int j = -p; j <= tile.intervals() + 2 * p; ++j) {
                    for (int i = -p; tile.holds({i, j}); ++i) {
                        const AtlasPixel pixel = tile.pixel(slot, {i, j});
                        EXPECT_LT(std::max(pixel.x, pixel.y), tile.side());
                        taken.insert({pixel.x, pixel.y});
                        ++samples;
                        const glm::dvec2 at =
                            tile.position(slot, glm::dvec2(i, j) / double(tile.intervals()));
                        EXPECT_NEAR(at.x, pixel.x + 0.5, 1e-12 * n);
                        EXPECT_NEAR(at.y, pixel.y + 0.5, 1e-12 * n);
                    }
                }
            }
            EXPECT_EQ(taken.size(), samples);
        }
    }
}

TEST(HandOffLayout, tilesOfMixedSizesDoNotOverlapAndFitTheirPages)
{
    FaceMap<std::uint32_t> intervals(999);
    Dice dice(4);
    for (std::uint32_t& n : intervals.values()) {
        n = 1U << dice.below(7);
    }
    HandOffOptions options;
    options.largestPage = 512;
    const HandOffLayout layout = *HandOffLayout::plan(intervals, options);
    EXPECT_GT(layout.pages().size(), 1U);
    std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> taken;
    std::size_t samples = 0;
    for (std::size_t f = 0; f < intervals.size(); ++f) {
        const FaceId face = faceId(f);
        const HandOffTile tile = layout.tile(face);
        const AtlasPage& page = layout.pages()[layout.place(face).page];
        for (int j = -tile.padding(); tile.holds({-tile.padding(), j}); ++j) {
            for (int i = -tile.padding(); tile.holds({i, j}); ++i) {
                const AtlasPixel pixel = layout.pixel(face, {i, j});
                ASSERT_LT(pixel.x, page.width);
                ASSERT_LT(pixel.y, page.height);
                taken.insert({layout.place(face).page, pixel.x, pixel.y});
                ++samples;
            }
        }
    }
    EXPECT_EQ(taken.size(), samples);
    for (const AtlasPage& page : layout.pages()) {
        EXPECT_EQ(page.width % 4 + page.height % 4, 0U);
    }
    options.powerOfTwo = true;
    for (const std::uint32_t largest : {512U, 700U, 5000U}) {
        options.largestPage = largest;
        const HandOffLayout powers = *HandOffLayout::plan(intervals, options);
        for (const AtlasPage& page : powers.pages()) {
            EXPECT_TRUE(std::has_single_bit(page.width) && std::has_single_bit(page.height));
            EXPECT_LE(std::max(page.width, page.height), largest);
        }
    }
}

TEST(HandOffLayout, aPageTooSmallForAFaceIsRefusedAndNamesTheFace)
{
    FaceMap<std::uint32_t> intervals(3, 4);
    intervals[faceId(1)] = 100;
    HandOffOptions options;
    options.largestPage = 64;
    const auto layout = HandOffLayout::plan(intervals, options);
    ASSERT_FALSE(layout);
    EXPECT_EQ(layout.error().message, "face 1 needs pages of 108 pixels, more than the 64 allowed");
}

TEST(HandOff, aFlatMeshShowsAnAffineFunctionAsItIs)
{
    const TriangleMesh mesh = flatPatch(5);
    const HandOff handOff(mesh,
                          filledStore(mesh,
                                      FaceMap<Level>(mesh.faceCount(), Level(3)),
                                      affineContent({0.3, -0.2, 0}, 0.4)),
                          {});
    for (const FaceId face : {faceId(22), faceId(24), faceId(25)}) { // away from the border
        for (const glm::dvec2 uv :
             {glm::dvec2(0.31, 0.17), glm::dvec2(0.5, 0.5), glm::dvec2(0.93, 0.02)}) {
            const glm::dvec3 at = pointOf(mesh, face, uv);
            EXPECT_NEAR(handOff.value(face, uv)[0], 0.4 + 0.3 * at.x - 0.2 * at.y, 1e-5);
        }
    }
}

TEST(HandOff, noiseOnMixedLevelsAndValencesHasNoJumpAcrossAnyEdge)
{
    const TriangleMesh mesh = closedIrregular(9, 3);
    for (const std::uint32_t perTexel : {1U, 2U}) {
        HandOffOptions options;
        options.samplesPerTexel = perTexel;
        const HandOff handOff(
            mesh,
            filledStore(mesh, mixedLevels(mesh.faceCount(), 0, 4, 5), noiseContent(6)),
            options);
        EXPECT_LT(handOff.jump(), 1e-6);
    }
}

/// Two channels of natural content and one of hard edges.
TEST(HandOff, contentIsShownAsExactDoesEvenInEightBits)
{
    const TriangleMesh mesh = closedIrregular(5, 8);
    const HandOff mixed(mesh,
                        natural(mesh, mixedLevels(mesh.faceCount(), 3, 5, 2)),
                        HandOffOptions{},
                        TexelType::UInt8);
    EXPECT_GE(mixed.psnr(4000, 2), 60);
    EXPECT_LE(255 * mixed.jump(), 2);
    const HandOff even(mesh,
                       natural(mesh, FaceMap<Level>(mesh.faceCount(), Level(4))),
                       HandOffOptions{},
                       TexelType::UInt8);
    EXPECT_GE(even.psnr(4000, 3), 45);
    EXPECT_LE(255 * even.jump(), 2);
}

/// What a camera sees of a mesh through its atlas against what `exact` answers for the same pixels,
/// in decibels over the first channels.
double picturePsnr(const TriangleMesh& mesh,
                   const HandOff& handOff,
                   const ViewCamera& camera,
                   std::size_t channels)
{
    NoProgress progress;
    const auto surface = *Surface::build(mesh, progress);
    const ViewQueries seen = *viewQueries(*surface, camera, {}, Threads{2}, progress);
    const FilterQueries queries = seen.queries.queries();
    ResultArrays exact(queries.size(), handOff.scene.channels());
    filterParallel(
        *makeMethod({"exact", std::nullopt}), handOff.scene, queries, exact.results(), Threads{2});
    double sum = 0;
    for (std::size_t k = 0; k < queries.size(); ++k) {
        const auto shown = handOff.value(queries.face[k], {queries.u[k], queries.v[k]});
        for (std::size_t c = 0; c < channels; ++c) {
            const double apart = double(shown[c]) - exact.values[c * queries.size() + k];
            sum += apart * apart;
        }
    }
    EXPECT_GT(queries.size(), 50'000U);
    return -10 * std::log10(sum / double(channels * queries.size()));
}

TEST(HandOff, picturesShowWhatExactRenders)
{
    const TriangleMesh mesh = closedIrregular(5, 8);
    for (const bool mixed : {false, true}) {
        const FaceMap<Level> levels = mixed ? mixedLevels(mesh.faceCount(), 4, 6, 2)
                                            : FaceMap<Level>(mesh.faceCount(), Level(5));
        const HandOff handOff(mesh, natural(mesh, levels), HandOffOptions{}, TexelType::UInt8);
        ViewCamera camera;
        camera.width = camera.height = 512;
        EXPECT_GE(picturePsnr(mesh, handOff, camera, 2), 60);
        EXPECT_GE(picturePsnr(mesh, handOff, camera, 3), 40); // hard edges, too
    }
}

/// Small faces next to hard edges: three pixels go on to beyond 1, which eight bits cannot hold.
TEST(HandOff, facesTurnSoThatEightBitsSufficeAtTheEndsOfTheirDiagonals)
{
    const TriangleMesh mesh = closedIrregular(6, 8);
    const FaceMap<Level> levels(mesh.faceCount(), Level(2));
    const HandOff checks(mesh,
                         filledStore(mesh, levels, checkerContent(0.4), 3),
                         HandOffOptions{},
                         TexelType::UInt8);
    EXPECT_LE(255 * checks.jump(), 2);
}

TEST(HandOff, aFaceThatIsOneValueWithAllAboutItTakesOneInterval)
{
    const TriangleMesh mesh = flatPatch(6);
    TexelStore store(
        kOneFloat, FaceMap<Level>(mesh.faceCount(), Level(5)), std::vector<std::byte>(4));
    (void)store.writable(faceId(0));
    const FilterSurface surface = surfaceOf(mesh);
    const auto intervals = handOffIntervals(store, surface, {});
    EXPECT_EQ(intervals[faceId(0)], 64U);
    EXPECT_EQ(intervals[faceId(1)], 64U); // shares a vertex with it
    EXPECT_EQ(intervals[faceId(71)], 1U);
}

/// Where a flat mesh goes on, so does the padding, to the nearest sample of the true neighbour.
TEST(HandOff, paddingIsOfTrueNeighbours)
{
    const TriangleMesh mesh = turnedGrid(4, 6);
    const HandOff handOff(mesh,
                          filledStore(mesh,
                                      FaceMap<Level>(mesh.faceCount(), Level(2)),
                                      affineContent({0.1, 0.07, 0}, 0)),
                          HandOffOptions{.samplesPerTexel = 2, .padding = 3});
    int compared = 0;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const FaceId face = faceId(f);
        const HandOffTile tile = handOff.layout.tile(face);
        for (int j = -tile.padding(); tile.holds({-tile.padding(), j}); ++j) {
            for (int i = -tile.padding(); tile.holds({i, j}); ++i) {
                const glm::dvec2 uv = glm::dvec2(i, j) / double(tile.intervals());
                const glm::vec3 at = pointOf(mesh, face, uv);
                if (std::min(at.x, at.y) < 0.7F || std::max(at.x, at.y) > 3.3F) {
                    continue; // the border's own texels are about
                }
                ++compared;
                EXPECT_NEAR(handOff.value(face, uv)[0], 0.1 * at.x + 0.07 * at.y, 1e-5);
            }
        }
    }
    EXPECT_GT(compared, 1500);
}

TEST(HandOff, givesUpWhenCancelled)
{
    const TriangleMesh mesh = flatPatch(2);
    const FilterScene scene = sceneOf(
        surfaceOf(mesh), filledStore(mesh, FaceMap<Level>(mesh.faceCount()), noiseContent(1)));
    auto layout = *HandOffLayout::plan(FaceMap<std::uint32_t>(mesh.faceCount(), 2), {});
    for (int reports = 0; reports < 8; ++reports) {
        CancelAfter progress(reports);
        const auto pages = handOffPages(layout,
                                        scene,
                                        *makeMethod({"exact", std::nullopt}),
                                        kOneFloat,
                                        {{ColorSpace::Raw}, {}},
                                        Threads{1},
                                        progress);
        ASSERT_FALSE(pages);
        EXPECT_EQ(pages.error().kind, ErrorKind::Cancelled);
    }
}

/// Counts what it is told.
class CountReports final : public Progress
{
public:
    bool report(double /*fraction*/) override
    {
        ++count;
        return true;
    }
    int count = 0;
};

TEST(HandOff, twoLargeFacesAreToldOfWhileTheyAreSampled)
{
    const TriangleMesh mesh = flatPatch(1);
    ASSERT_EQ(mesh.faceCount(), 2U);
    const FilterScene scene = sceneOf(
        surfaceOf(mesh), filledStore(mesh, FaceMap<Level>(mesh.faceCount()), noiseContent(1)));
    auto layout = *HandOffLayout::plan(FaceMap<std::uint32_t>(2, 256), {});
    CountReports progress;
    ASSERT_TRUE(handOffPages(layout,
                             scene,
                             *makeMethod({"lattice-linear", std::nullopt}),
                             kOneFloat,
                             {{ColorSpace::Raw}, {}},
                             Threads{2},
                             progress));
    // 33,153 samples each: a report for every 4096 of both, but for the six steps' own.
    EXPECT_GE(progress.count, 2 * 33'153 / 4096);
}

TEST(HandOff, memoryThatRunsOutInAThreadIsAnError)
{
    class Greedy final : public FilterMethod
    {
    public:
        void filter(const FilterScene& /*scene*/,
                    const FilterQueries& /*queries*/,
                    const FilterResults& /*results*/) const override
        {
            throw std::bad_alloc();
        }
    };
    const TriangleMesh mesh = flatPatch(2);
    const FilterScene scene = sceneOf(
        surfaceOf(mesh), filledStore(mesh, FaceMap<Level>(mesh.faceCount()), noiseContent(1)));
    auto layout = *HandOffLayout::plan(FaceMap<std::uint32_t>(mesh.faceCount(), 64), {});
    NoProgress progress;
    const auto pages = handOffPages(
        layout, scene, Greedy(), kOneFloat, {{ColorSpace::Raw}, {}}, Threads{2}, progress);
    ASSERT_FALSE(pages);
    EXPECT_EQ(pages.error().message, "what is made of the faces does not fit into memory");
}

/// Pages of noise have their largest jump where a plain walk along all edges finds it.
TEST(HandOff, theLargestJumpIsFoundWhereverItIsAndCanBeCancelled)
{
    const TriangleMesh mesh = flatPatch(4);
    HandOff handOff(
        mesh, filledStore(mesh, mixedLevels(mesh.faceCount(), 0, 5, 5), noiseContent(6)), {});
    std::mt19937 random(3);
    for (std::byte& byte : handOff.pages.front().writable()) {
        byte = std::byte(random() & 0x3FU); // small floats, none of them NaN
    }
    const Adjacency& adjacency = handOff.scene.surface().adjacency();
    double largest = 0;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        for (const LocalEdge edge : kLocalEdges) {
            const auto next = adjacency.neighbour(faceId(f), edge);
            const int points = next ? 5 * std::max(handOff.layout.tile(faceId(f)).intervals(),
                                                   handOff.layout.tile(next->face).intervals())
                                    : -1;
            for (int k = 0; k <= points; ++k) {
                const double t = double(k) / points;
                largest =
                    std::max(largest,
                             std::abs(double(handOff.value(faceId(f), fromEdge(edge, {t, 0}))[0]) -
                                      double(handOff.value(next->face,
                                                           fromEdge(next->edge, {1 - t, 0}))[0])));
            }
        }
    }
    EXPECT_GT(largest, 0);
    EXPECT_DOUBLE_EQ(handOff.jump(), largest);
    for (int reports = 0; reports < 2; ++reports) {
        CancelAfter progress(reports);
        const auto report =
            measureHandOff(handOff.layout, handOff.pages, adjacency, 5, Threads{2}, progress);
        ASSERT_FALSE(report);
        EXPECT_EQ(report.error().kind, ErrorKind::Cancelled);
    }
}

TEST(HandOffSamples, areNumberedRowAfterRow)
{
    for (const int n : {1, 2, 7, 64, 4096}) {
        HandOffSample expected;
        const std::uint64_t step = n > 64 ? 997 : 1;
        std::uint64_t number = 0;
        for (; number < sampleCount(n); ++number, expected = nextSample(expected, n)) {
            if (number % step == 0) {
                ASSERT_EQ(sampleOfNumber(number, n), expected) << n;
            }
        }
        EXPECT_EQ(expected, (HandOffSample{0, n + 1}));
    }
}

} // namespace
