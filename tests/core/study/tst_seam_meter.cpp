// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/query_ellipse.h"
#include "core/study/seam_meter.h"
#include "core/study/value_range.h"
#include "tests/core/test_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace trixel {
namespace {

/// A closed mesh of irregular triangles; corners have valence 5 and 6.
TriangleMesh crumpledSphere(int steps, std::uint32_t seed)
{
    TriangleMesh mesh = test::sphereMesh(steps);
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> factor(0.75F, 1.25F);
    for (glm::vec3& p : mesh.positions) {
        p *= factor(random);
    }
    return mesh;
}

/// Faces of random levels up to `finest`, of white noise in [0, 1] in three channels.
TexelStore noise(std::size_t faces, int finest, std::uint32_t seed)
{
    const TexelFormat format{TexelType::Float, 3, std::nullopt};
    const std::array<float, 3> black{};
    TexelStore store(
        static_cast<std::uint32_t>(faces), format, Level(0), std::as_bytes(std::span(black)));
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> level(0, finest);
    std::uniform_real_distribution<float> value(0.0F, 1.0F);
    for (std::size_t f = 0; f < faces; ++f) {
        const Level own(level(random));
        std::vector<float> values(std::size_t{own.texelCount()} * 3);
        std::ranges::generate(values, [&] { return value(random); });
        store.exchange(
            faceId(f),
            FaceTexels::full(own, format.texelBytes(), std::as_bytes(std::span(values))));
    }
    return store;
}

FilterScene sceneOf(const TriangleMesh& mesh, const TexelStore& store)
{
    NoProgress progress;
    auto surface = std::make_shared<const FilterSurface>(
        FilterSurface::fromMesh(mesh, buildAdjacency(mesh.triangles)));
    return *FilterScene::build(std::move(surface), store, Threads{1}, progress);
}

FilterScene noiseScene(int steps, int finest)
{
    const TriangleMesh mesh = crumpledSphere(steps, 7);
    return sceneOf(mesh, noise(mesh.faceCount(), finest, 11));
}

/// A filter that answers with a function of the query, in every channel.
class Formula final : public FilterMethod
{
public:
    using Answer = std::function<double(const QueryEllipse&, FaceId)>;
    explicit Formula(Answer answer)
        : m_answer(std::move(answer))
    {
    }
    void filter(const FilterScene& scene,
                const FilterQueries& queries,
                const FilterResults& results) const override
    {
        for (std::size_t i = 0; i < queries.size(); ++i) {
            const double value = m_answer(queryEllipse(scene, queries, i), queries.face[i]);
            for (int c = 0; c < scene.channels(); ++c) {
                results.values[static_cast<std::size_t>(c) * results.stride + i] =
                    static_cast<float>(value);
            }
            results.taps[i] = 1;
            results.levels[i] = 0;
        }
    }

private:
    Answer m_answer;
};

SeamReport measured(const FilterScene& scene,
                    const FilterMethod& method,
                    const SeamSettings& settings = {},
                    Threads threads = Threads{1})
{
    NoProgress progress;
    return *measureSeams(scene, method, settings, threads, progress);
}

TEST(SeamMeter, measuresEveryInnerEdgeOnce)
{
    const FilterScene closed = noiseScene(1, 2);
    const Formula zero([](const QueryEllipse&, FaceId) { return 0.0; });
    SeamReport report = measured(closed, zero);
    EXPECT_EQ(report.jumps.size(), 80U * 3 / 2);
    EXPECT_EQ(report.samples, 120U * 6 * 3);
    std::ranges::sort(
        report.jumps, {}, [](const SeamJump& j) { return std::pair(j.face, j.edge); });
    for (const SeamJump& jump : report.jumps) {
        const auto across = closed.surface().adjacency().neighbour(jump.face, jump.edge);
        ASSERT_TRUE(across);
        EXPECT_EQ(*across, (EdgeNeighbour{jump.neighbour, jump.neighbourEdge}));
        EXPECT_EQ(jump.level, closed.level(jump.face));
        EXPECT_EQ(jump.neighbourLevel, closed.level(jump.neighbour));
    }
    const auto twice = std::ranges::adjacent_find(report.jumps, [](const auto& a, const auto& b) {
        return a.face == b.face && a.edge == b.edge;
    });
    EXPECT_EQ(twice, report.jumps.end());

    const TriangleMesh grid = test::gridMesh(3);
    const FilterScene open = sceneOf(grid, noise(grid.faceCount(), 1, 3));
    EXPECT_EQ(measured(open, zero).jumps.size(), (18U * 3 - 12) / 2);
}

TEST(SeamMeter, asksBothSidesForTheSamePointAndTheSameFootprint)
{
    // World position and size of the ellipse: what is the same only if both sides are asked alike.
    const TriangleMesh mesh = crumpledSphere(1, 7);
    const FilterScene scene = sceneOf(mesh, noise(mesh.faceCount(), 4, 11));
    const auto positionX = [&](const QueryEllipse& ellipse, FaceId face) {
        const auto corners = mesh.corners(face);
        return (1 - ellipse.uv.x - ellipse.uv.y) * corners[0].x + ellipse.uv.x * corners[1].x +
               ellipse.uv.y * corners[2].x;
    };
    const SeamReport report = measured(scene, Formula([&](const QueryEllipse& e, FaceId face) {
                                           return positionX(e, face) + e.xx + e.yy + e.determinant;
                                       }));
    EXPECT_LE(report.jumps.front().jump, 5e-6); // values of 16 and more, as floats
}

/// Keeps where it was asked.
class Listening final : public FilterMethod
{
public:
    void filter(const FilterScene& /*scene*/,
                const FilterQueries& queries,
                const FilterResults& results) const override
    {
        auto& call = m_calls.emplace_back();
        for (std::size_t i = 0; i < queries.size(); ++i) {
            const double u = queries.u[i];
            const double v = queries.v[i];
            auto& point = call.emplace_back(std::array{u, v, 1 - u - v});
            std::ranges::sort(point);
        }
        std::ranges::fill(results.values, 0.0F);
        std::ranges::fill(results.taps, 1U);
    }
    const std::vector<std::vector<std::array<double, 3>>>& calls() const { return m_calls; }

private:
    mutable std::vector<std::vector<std::array<double, 3>>> m_calls; ///< barycentric, sorted
};

/// A point counted from the other end of the edge is the same to the last bit, also as a float:
/// beside an edge of contrast a rounded one would look like a seam.
TEST(SeamMeter, asksForPointsThatBothSidesHoldExactly)
{
    for (const int samples : {1, 4, 5, 7, 33}) {
        SeamSettings settings;
        settings.samples = samples;
        const Listening listening;
        measured(noiseScene(1, 2), listening, settings);
        ASSERT_EQ(listening.calls().size(), 2U); // one side, then the other
        EXPECT_EQ(listening.calls()[0], listening.calls()[1]) << samples << " an edge";
        EXPECT_GE(listening.calls()[0].size(), 120U * static_cast<unsigned>(samples));
    }
}

TEST(SeamMeter, tellsTheLargestJumpAsAPartOfTheValueRange)
{
    const FilterScene scene = noiseScene(1, 3);
    const double range = valueRange(scene.mips(), Threads{1});
    EXPECT_GT(range, 0.9);
    // A step of 0.25 ranges between faces of odd and of even number, nowhere else.
    const SeamReport report =
        measured(scene, Formula([&](const QueryEllipse&, FaceId face) {
                     return 0.25 * range * static_cast<double>(indexOf(face) % 2);
                 }));
    EXPECT_EQ(report.range, range);
    for (const SeamJump& jump : report.jumps) {
        const bool mixed = indexOf(jump.face) % 2 != indexOf(jump.neighbour) % 2;
        EXPECT_NEAR(jump.jump, mixed ? 0.25 : 0.0, 1e-6);
        EXPECT_NEAR(jump.mean, mixed ? 0.25 : 0.0, 1e-6);
    }
}

TEST(SeamMeter, putsTheLargestJumpFirstAndSaysWhereItIs)
{
    const FilterScene scene = noiseScene(1, 3);
    const SeamReport report = measured(scene, Formula([](const QueryEllipse& e, FaceId face) {
                                           return indexOf(face) == 0 && e.uv.y == 0 ? e.uv.x : 0.0;
                                       }));
    EXPECT_EQ(report.jumps.front().face, faceId(0));
    EXPECT_EQ(report.jumps.front().edge, LocalEdge::E0);
    EXPECT_NEAR(report.jumps.front().along, (5 + 1.0 / 3) / 6, 1e-6); // the last of six
    EXPECT_TRUE(std::ranges::is_sorted(report.jumps, std::greater(), &SeamJump::jump));
}

TEST(SeamMeter, isTheSameWithAnyNumberOfThreads)
{
    const FilterScene scene = noiseScene(3, 2); // 1,280 faces: several batches
    const auto point = makeMethod({"point", std::nullopt});
    EXPECT_EQ(measured(scene, *point, {}, Threads{1}).jumps,
              measured(scene, *point, {}, Threads{5}).jumps);
}

TEST(SeamMeter, findsMethodsThatJumpToJumpWhereTheContentDoes)
{
    const FilterScene scene = noiseScene(1, 4);
    for (const char* name : {"point", "nearest-level"}) {
        if (findMethod(name) != nullptr) {
            const SeamSummary summary =
                summarize(measured(scene, *makeMethod({name, std::nullopt})).jumps);
            EXPECT_EQ(summary.broken, summary.edges) << name;
            EXPECT_GT(summary.worst, 0.5) << name;
        }
    }
    // And nowhere else: a black mesh with one white face jumps at that face alone.
    const TriangleMesh mesh = crumpledSphere(1, 7);
    const TexelFormat format{TexelType::Float, 1, std::nullopt};
    const float black = 0;
    const float white = 1;
    TexelStore store(80, format, Level(3), std::as_bytes(std::span(&black, 1)));
    store.exchange(faceId(17), FaceTexels::constant(Level(3), std::as_bytes(std::span(&white, 1))));
    const SeamReport report = measured(sceneOf(mesh, store), *makeMethod({"point", std::nullopt}));
    for (const SeamJump& jump : report.jumps) {
        const bool touches = jump.face == faceId(17) || jump.neighbour == faceId(17);
        EXPECT_EQ(jump.jump, touches ? 1.0F : 0.0F);
    }
}

TEST(SeamMeter, methodsThatClaimContinuityHaveNoSeams)
{
    const FilterScene scene = noiseScene(1, 5);
    for (const MethodEntry& entry : filterMethods()) {
        if (entry.claims.edgeContinuous != Claim::Yes) {
            continue;
        }
        // What reads beyond one place has a cut at the vertices of a curved surface: faces laid
        // flat leave a gap there, and no straight line leads on.
        SeamSettings settings;
        settings.ends = entry.name == "lattice-linear";
        // Round ones and elongated ones up to grazing.
        settings.footprints = {{1, 1}, {4, 1}, {4, 1.001}, {4, 1.2}, {4, 4}, {2, 12}};
        const auto method = makeMethod({std::string(entry.name), std::nullopt});
        const SeamReport report = measured(scene, *method, settings, Threads::all());
        EXPECT_LE(report.jumps.front().jump, kSeamless)
            << entry.name << " at face " << indexOf(report.jumps.front().face) << " edge "
            << indexOf(report.jumps.front().edge);
        EXPECT_EQ(report.refused, 0U) << entry.name;
    }
}

TEST(SeamMeter, aViewThatSeesHalfTheMeshMeasuresThatHalf)
{
    const FilterScene scene = noiseScene(1, 3);
    SeamSettings settings;
    settings.view = [](FaceId face, glm::dvec2) -> std::optional<Footprint> {
        return indexOf(face) < 40 ? std::optional(Footprint{{0.1, 0}, {0, 0.1}}) : std::nullopt;
    };
    const auto point = makeMethod({"point", std::nullopt});
    const SeamReport report = measured(scene, *point, settings);
    EXPECT_GT(report.jumps.size(), 50U);
    EXPECT_EQ(report.samples, report.jumps.size() * 6);
    EXPECT_TRUE(
        std::ranges::all_of(report.jumps, [](const SeamJump& j) { return indexOf(j.face) < 40; }));
}

TEST(SeamMeter, aNumberBesideNoneIsAnInfiniteJump)
{
    const FilterScene scene = noiseScene(0, 2);
    const SeamReport report =
        measured(scene, Formula([](const QueryEllipse&, FaceId face) {
                     return indexOf(face) == 3 ? std::numeric_limits<double>::quiet_NaN() : 0.0;
                 }));
    EXPECT_EQ(summarize(report.jumps).broken, 3U);
    EXPECT_TRUE(std::isinf(report.jumps.front().jump));
}

TEST(SeamMeter, constantTexelsHaveNoJump)
{
    const TriangleMesh mesh = test::sphereMesh(1);
    const float grey = 0.5F;
    const TexelStore store(80,
                           TexelFormat{TexelType::Float, 1, std::nullopt},
                           Level(4),
                           std::as_bytes(std::span(&grey, 1)));
    const SeamReport report = measured(sceneOf(mesh, store), *makeMethod({"point", std::nullopt}));
    EXPECT_EQ(report.range, 0.0);
    EXPECT_EQ(report.jumps.front().jump, 0.0F);
}

TEST(SeamMeter, stopsWhenToldTo)
{
    class StopAtOnce final : public Progress
    {
    public:
        bool report(double /*fraction*/) override { return false; }
    } stop;
    const FilterScene scene = noiseScene(1, 1);
    const auto report =
        measureSeams(scene, *makeMethod({"point", std::nullopt}), {}, Threads{2}, stop);
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().kind, ErrorKind::Cancelled);
}

TEST(SeamMeter, summaryCountsWhatTheReportHolds)
{
    std::vector<SeamJump> jumps(200);
    for (std::size_t k = 0; k < jumps.size(); ++k) {
        jumps[k].jump = static_cast<float>(199 - k) / 199.0F;
        jumps[k].mean = 0.5F;
    }
    const SeamSummary summary = summarize(jumps);
    EXPECT_EQ(summary.edges, 200U);
    EXPECT_EQ(summary.broken, 199U);
    EXPECT_DOUBLE_EQ(summary.worst, 1.0);
    EXPECT_NEAR(summary.p99, 0.99, 0.006);
    EXPECT_NEAR(summary.p90, 0.90, 0.006);
    EXPECT_NEAR(summary.median, 0.50, 0.006);
    EXPECT_DOUBLE_EQ(summary.mean, 0.5);
    EXPECT_EQ(summarize({}).edges, 0U);
}

TEST(SeamMeter, aFaceIsToldTheLargestJumpOfItsEdges)
{
    std::vector<SeamJump> jumps(3);
    jumps[0].face = FaceId{0};
    jumps[0].neighbour = FaceId{1};
    jumps[0].jump = 0.5F;
    jumps[1].face = FaceId{1};
    jumps[1].neighbour = FaceId{3};
    jumps[1].jump = 0.25F;
    jumps[2].face = FaceId{0};
    jumps[2].neighbour = FaceId{3};
    jumps[2].jump = 0.0F;
    const std::vector<float> faces = jumpsOfFaces(jumps, 4);
    EXPECT_EQ(faces[0], 0.5F);
    EXPECT_EQ(faces[1], 0.5F);
    EXPECT_TRUE(std::isnan(faces[2]));
    EXPECT_EQ(faces[3], 0.25F);
}

TEST(ValueRange, isTheLargestSpanOfFiniteTexels)
{
    const TexelFormat format{TexelType::Float, 2, std::nullopt};
    const std::array<float, 2> fill{0.5F, -1.0F};
    TexelStore store(3, format, Level(0), std::as_bytes(std::span(fill)));
    const std::array<float, 2> other{0.75F, 2.0F};
    store.exchange(faceId(1), FaceTexels::constant(Level(0), std::as_bytes(std::span(other))));
    const std::array<float, 2> notFinite{std::numeric_limits<float>::infinity(),
                                         std::numeric_limits<float>::quiet_NaN()};
    store.exchange(faceId(2), FaceTexels::constant(Level(0), std::as_bytes(std::span(notFinite))));
    NoProgress progress;
    EXPECT_DOUBLE_EQ(valueRange(*FloatMips::build(store, Threads{1}, progress), Threads{2}), 3.0);
}

} // namespace
} // namespace trixel
