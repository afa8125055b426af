// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_reader.h"
#include "core/study/error_sums.h"
#include "core/study/solid_texture.h"
#include "core/study/speed/query_batches.h"
#include "core/study/speed/spread_queries.h"
#include "tests/core/study/study_fixture.h"
#include "tests/core/test_meshes.h"

#include <gmock/gmock.h>
#include <limits>
#include <set>

namespace trixel {
namespace {

using test::Fake;
using test::RememberingWatcher;
using test::smallSubjects;
using testing::HasSubstr;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

SpeedAccuracyOptions quick()
{
    SpeedAccuracyOptions options;
    options.rounds = 1;
    return options;
}

Study measured(const Contestants& contestants, const SpeedAccuracyOptions& options = quick())
{
    RememberingWatcher watcher;
    return measureSpeedAccuracy(smallSubjects(), contestants, options, watcher).value();
}

/// A contestant that is off by so much of the range.
std::unique_ptr<const Contestant> offBy(std::string name, float by)
{
    return std::make_unique<Fake>(
        std::move(name), smallSubjects(), [by](const auto& subject, auto, auto, float truth) {
            return std::optional(truth + by * static_cast<float>(subject.range));
        });
}

FootprintClass classOfQuery(const StudySubject& subject, std::size_t i)
{
    return classOf(queryEllipse(*subject.scene, subject.queries.queries(), i));
}

const StudyPoint& overall(const Study& study, const std::string& series)
{
    return *std::ranges::find_if(study.points, [&](const StudyPoint& point) {
        return point.series == series && !point.footprintClass;
    });
}

TEST(ErrorSums, tellRmsPercentileAndWorst)
{
    ErrorSums sums;
    for (int i = 1; i <= 200; ++i) {
        sums.add(i, 0, 200); // 0.005 … 1
    }
    StudyPoint point;
    sums.tell(point);
    EXPECT_NEAR(point.rms, std::sqrt(201.0 * 401.0 / 6) / 200, 1e-6);
    EXPECT_NEAR(point.p99, 198.0 / 200, 1e-6);
    EXPECT_NEAR(point.worst, 1, 1e-6);
}

TEST(ErrorSums, countAnAnswerThatIsNotFiniteAsWrongByTheWholeRange)
{
    ErrorSums sums;
    sums.add(std::numeric_limits<double>::quiet_NaN(), 0.5, 2);
    sums.add(std::numeric_limits<double>::infinity(), 0.5, 2);
    StudyPoint point;
    sums.tell(point);
    EXPECT_EQ(point.rms, 1);
    ErrorSums same;
    same.add(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), 2);
    same.tell(point);
    EXPECT_EQ(point.worst, 0);
}

TEST(SpeedAccuracy, errorsAreThoseOfTheAnswers)
{
    Contestants contestants;
    contestants.push_back(offBy("tenth", 0.1F));
    const Study study = measured(contestants);
    const StudyPoint& point = overall(study, "tenth");
    EXPECT_NEAR(point.rms, 0.1, 1e-6);
    EXPECT_NEAR(point.p99, 0.1, 1e-6);
    EXPECT_NEAR(point.worst, 0.1, 1e-6);
    EXPECT_EQ(point.samples, smallSubjects()[0].queries.size() + smallSubjects()[1].queries.size());
}

TEST(SpeedAccuracy, classesAreJudgedApart)
{
    Contestants contestants;
    contestants.push_back(std::make_unique<Fake>(
        "by class", smallSubjects(), [](const auto& subject, auto i, auto, float truth) {
            const int number = static_cast<int>(classOfQuery(subject, i));
            return std::optional(truth + 0.01F * static_cast<float>(number * subject.range));
        }));
    const Study study = measured(contestants);
    std::set<FootprintClass> seen;
    std::uint64_t samples = 0;
    for (const StudyPoint& point : study.points) {
        if (point.footprintClass) {
            EXPECT_NEAR(point.rms, 0.01 * static_cast<int>(*point.footprintClass), 1e-6);
            seen.insert(*point.footprintClass);
            samples += point.samples;
        }
    }
    EXPECT_GE(seen.size(), 6U); // few large ones fit on one tile
    EXPECT_EQ(samples, study.points.front().samples);
}

TEST(SpeedAccuracy, refusedFootprintsAreCountedAndLeftOut)
{
    Contestants contestants;
    contestants.push_back(std::make_unique<Fake>(
        "picky", smallSubjects(), [](const auto& subject, auto i, auto, float truth) {
            return classOfQuery(subject, i) == FootprintClass::SmallRound
                       ? std::nullopt
                       : std::optional(truth + 0.02F * static_cast<float>(subject.range));
        }));
    const Study study = measured(contestants);
    std::uint64_t small = 0;
    for (const StudySubject& subject : smallSubjects()) {
        for (std::size_t i = 0; i < subject.queries.size(); ++i) {
            small += classOfQuery(subject, i) == FootprintClass::SmallRound ? 1 : 0;
        }
    }
    EXPECT_GT(small, 0U);
    EXPECT_EQ(study.points.front().refused, small);
    EXPECT_NEAR(study.points.front().rms, 0.02, 1e-6);
    EXPECT_THAT(study.notes,
                testing::ElementsAre(HasSubstr("picky refused " + std::to_string(small))));
    for (const StudyPoint& point : study.points) {
        EXPECT_NE(point.footprintClass, FootprintClass::SmallRound);
    }
}

TEST(SpeedAccuracy, whoRefusesEverythingHasNoPoint)
{
    Contestants contestants;
    contestants.push_back(std::make_unique<Fake>(
        "mute", smallSubjects(), [](const auto&, auto, auto, float) -> std::optional<float> {
            return std::nullopt;
        }));
    const Study study = measured(contestants);
    EXPECT_THAT(study.points, testing::IsEmpty());
    EXPECT_THAT(study.notes, testing::ElementsAre(HasSubstr("mute refused")));
}

TEST(SpeedAccuracy, whoWouldTakeTooLongIsLeftOutAndNamed)
{
    Contestants contestants;
    contestants.push_back(offBy("tenth", 0.1F));
    SpeedAccuracyOptions options = quick();
    options.secondsAtMost = -1;
    const Study study = measured(contestants, options);
    EXPECT_THAT(study.points, testing::IsEmpty());
    EXPECT_THAT(study.notes, testing::ElementsAre(HasSubstr("tenth was left out")));
}

TEST(QueryBatches, thinningKeepsSomeOfEveryClass)
{
    const auto all = makeBatches(smallSubjects());
    const auto some = thinned(smallSubjects(), all, 10);
    ASSERT_EQ(some.size(), all.size());
    for (std::size_t b = 0; b < all.size(); ++b) {
        const double count = static_cast<double>(all[b].indices.size());
        EXPECT_EQ(some[b].footprintClass, all[b].footprintClass);
        EXPECT_GE(some[b].indices.size(), 1U);
        EXPECT_NEAR(static_cast<double>(some[b].indices.size()), count / 10, 5);
        for (const std::size_t i : some[b].indices) {
            EXPECT_THAT(all[b].indices, testing::Contains(i));
        }
    }
}

TEST(SpeedAccuracy, whoIsMeasuredPartlyIsNamed)
{
    Contestants contestants;
    contestants.push_back(offBy("tenth", 0.1F));
    contestants.push_back(offBy("fifth", 0.2F));
    SpeedAccuracyOptions options = quick();
    // So little that everyone takes longer, but not two hundred times as long.
    for (options.secondsAtMost = 1e-6; options.secondsAtMost < 1e-2; options.secondsAtMost *= 2) {
        const Study study = measured(contestants, options);
        for (const StudyPoint& point : study.points) {
            const bool named = std::ranges::any_of(study.notes, [&](const std::string& note) {
                return note.starts_with(point.series + " was measured on one footprint in ");
            });
            EXPECT_EQ(point.partly, named);
            EXPECT_NEAR(point.worst, point.series == "tenth" ? 0.1 : 0.2, 1e-6);
        }
    }
}

TEST(SpeedAccuracy, answersThatAreNotFiniteCountInFull)
{
    Contestants contestants;
    contestants.push_back(offBy("nan", kNan));
    EXPECT_EQ(overall(measured(contestants), "nan").rms, 1);
}

TEST(SpeedAccuracy, pointsReachTheWatcherAsTheyAreMeasuredAndAgainAtTheEnd)
{
    Contestants contestants;
    contestants.push_back(offBy("first", 0.1F));
    contestants.push_back(offBy("second", 0.2F));
    RememberingWatcher watcher;
    const Study study =
        measureSpeedAccuracy(smallSubjects(), contestants, quick(), watcher).value();
    ASSERT_EQ(watcher.points.size(), 2 * study.points.size());
    const std::vector<StudyPoint> last(watcher.points.end() -
                                           static_cast<std::ptrdiff_t>(study.points.size()),
                                       watcher.points.end());
    EXPECT_EQ(last, study.points);
    EXPECT_TRUE(std::ranges::is_sorted(watcher.fractions));
}

TEST(SpeedAccuracy, cancellingStopsAtOnce)
{
    for (int allowed = 0; allowed < 4; ++allowed) {
        Contestants contestants;
        contestants.push_back(offBy("first", 0.1F));
        contestants.push_back(offBy("second", 0.2F));
        RememberingWatcher watcher(allowed);
        const auto study = measureSpeedAccuracy(smallSubjects(), contestants, quick(), watcher);
        ASSERT_FALSE(study);
        EXPECT_EQ(study.error().kind, ErrorKind::Cancelled);
        EXPECT_EQ(watcher.fractions.size(), static_cast<std::size_t>(allowed) + 1);
    }
}

TEST(SpeedAccuracy, frontHoldsWhoIsNeitherDearerNorWorse)
{
    std::vector<StudyPoint> points(4);
    points[0].cost = 1, points[0].rms = 0.5;
    points[1].cost = 2, points[1].rms = 0.6; // worse than the first in both
    points[2].cost = 3, points[2].rms = 0.1;
    points[3].cost = 3, points[3].rms = 0.1; // its twin
    markFront(points);
    EXPECT_TRUE(points[0].onFront);
    EXPECT_FALSE(points[1].onFront);
    EXPECT_TRUE(points[2].onFront);
    EXPECT_TRUE(points[3].onFront);
    points[1].footprintClass = FootprintClass::LargeRound; // alone in its class
    markFront(points);
    EXPECT_TRUE(points[1].onFront);
}

TEST(SpeedAccuracy, everyMethodOfTheTableEntersWithEveryValueOfItsCurve)
{
    std::set<std::string> names;
    for (const auto& contestant : tableContestants(smallSubjects())) {
        names.insert(toText(*contestant->method()));
    }
    for (const MethodEntry& entry : filterMethods()) {
        if (!entry.parameter) {
            EXPECT_TRUE(names.contains(std::string(entry.name)));
            continue;
        }
        EXPECT_FALSE(entry.parameter->curve.empty()) << entry.name;
        for (const double value : entry.parameter->curve) {
            EXPECT_TRUE(names.contains(toText(MethodChoice{std::string(entry.name), value})));
        }
    }
}

TEST(SpeedAccuracy, exactAgreesWithTheStoredValues)
{
    // The stored ones were summed over an endless plane, by no code of the filters.
    const auto exact = makeMethod(MethodChoice{"exact", {}});
    for (const StudySubject& subject : smallSubjects()) {
        ResultArrays answers(subject.queries.size(), 3);
        filterParallel(
            *exact, *subject.scene, subject.queries.queries(), answers.results(), Threads{2});
        for (std::size_t k = 0; k < answers.values.size(); ++k) {
            ASSERT_NEAR(answers.values[k], subject.exact[k], 2e-7) << k;
        }
    }
}

TEST(QueryBatches, holdEveryQueryOnceInItsClassAndOnceInTheMixture)
{
    const auto batches = makeBatches(smallSubjects());
    std::vector<std::vector<int>> inClasses;
    std::vector<std::vector<int>> inMixtures;
    for (const StudySubject& subject : smallSubjects()) {
        inClasses.emplace_back(subject.queries.size());
        inMixtures.emplace_back(subject.queries.size());
    }
    for (const QueryBatch& batch : batches) {
        for (std::size_t k = 0; k < batch.indices.size(); ++k) {
            const std::size_t i = batch.indices[k];
            ++(batch.footprintClass ? inClasses : inMixtures)[batch.subject][i];
            EXPECT_EQ(batch.queries.u[k], smallSubjects()[batch.subject].queries.u[i]);
        }
    }
    for (std::size_t s = 0; s < inClasses.size(); ++s) {
        EXPECT_THAT(inClasses[s], testing::Each(1));
        EXPECT_THAT(inMixtures[s], testing::Each(1));
    }
}

/// A ball with a texture of its own.
std::shared_ptr<const FilterScene> ball()
{
    static const auto scene = [] {
        const TriangleMesh mesh = test::sphereMesh(2);
        const auto data = parseTestData(storedTestFiles()).value();
        NoProgress progress;
        const auto texels =
            solidTexture(mesh, planUniform(mesh.faceCount(), Level(3)), data, Threads{2}, progress);
        auto surface = std::make_shared<const FilterSurface>(
            FilterSurface::fromMesh(mesh, buildAdjacency(mesh.triangles)));
        return std::make_shared<const FilterScene>(
            FilterScene::build(surface, texels.value(), Threads{2}, progress).value());
    }();
    return scene;
}

TEST(SubjectOn, sameSeedGivesTheSameFootprints)
{
    const QueryArrays a = spreadQueries(*ball(), 100, 5);
    const QueryArrays b = spreadQueries(*ball(), 100, 5);
    const QueryArrays c = spreadQueries(*ball(), 100, 6);
    EXPECT_EQ(a.u, b.u);
    EXPECT_EQ(a.vw2, b.vw2);
    EXPECT_NE(a.u, c.u);
}

TEST(SubjectOn, footprintsAreSpreadByArea)
{
    // Two triangles, one nine times the other's area.
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {10, 0, 0}, {13, 0, 0}, {10, 3, 0}};
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
    auto surface = std::make_shared<const FilterSurface>(
        FilterSurface::fromMesh(mesh, buildAdjacency(mesh.triangles)));
    const std::array<std::byte, 3> fill{};
    const TexelStore store(2, TexelFormat{}, Level(4), fill);
    NoProgress progress;
    const auto scene = FilterScene::build(surface, store, Threads{1}, progress);
    const QueryArrays queries = spreadQueries(*scene, 2000, 1);
    const auto onSmall = std::ranges::count(queries.face, faceId(0));
    EXPECT_NEAR(static_cast<double>(onSmall), 200, 45);
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const QueryEllipse e = queryEllipse(*scene, queries.queries(), i);
        const double texel = std::exp2(e.log2Texel);
        EXPECT_LE(2 * e.minorSigma / texel, 65);
        EXPECT_GE(2 * e.minorSigma / texel, 1); // the floor
        EXPECT_LE(e.majorSigma / e.minorSigma, 64.1);
    }
}

TEST(SubjectOn, holdsWhatExactAnswers)
{
    NoProgress progress;
    const auto subject = subjectOn(ball(), "ball", 60, 1, Threads{2}, progress);
    ASSERT_TRUE(subject);
    ASSERT_EQ(subject->queries.size(), 60U);
    ResultArrays answers(60, 3);
    makeMethod(MethodChoice{"exact", {}})
        ->filter(*ball(), subject->queries.queries(), answers.results());
    EXPECT_EQ(answers.values, subject->exact);
    EXPECT_GT(subject->range, 0.5);
}

TEST(SolidTexture, varies)
{
    // Blue is one of two values, and both occur.
    const FloatMips& mips = ball()->mips();
    std::set<float> blues;
    for (std::uint32_t f = 0; f < mips.faceCount(); ++f) {
        blues.insert(mips.texels(faceId(f), Level(3)).values[2]);
    }
    EXPECT_EQ(blues.size(), 2U);
}

} // namespace
} // namespace trixel
