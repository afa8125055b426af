// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/error_sums.h"
#include "core/study/speed/auto_contestants.h"
#include "core/study/speed/auto_method.h"
#include "core/study/speed/contest.h"
#include "tests/core/study/study_fixture.h"

#include <algorithm>
#include <gmock/gmock.h>

namespace trixel {
namespace {

using testing::HasSubstr;

CostEntry entry(std::string method, FootprintClass footprintClass, double cost, double rms)
{
    return {parseMethod(method).value(), footprintClass, cost, rms, rms};
}

/// Cheap and coarse, dear and fine, in every class.
CostTable twoMethods()
{
    CostTable table;
    for (const FootprintClass footprintClass : footprintClasses()) {
        const double c = static_cast<double>(footprintClass);
        table.entries.push_back(entry("point", footprintClass, 10, 0.01 + 0.01 * c));
        table.entries.push_back(entry("trilinear", footprintClass, 100, 0.005));
    }
    return table;
}

const std::vector<StudySubject>& subjects()
{
    static const std::vector<StudySubject> made = [] {
        NoProgress progress;
        return storedSubjects(kStudyTiles, Threads{2}, progress).value();
    }();
    return made;
}

const CostTable& measuredTable()
{
    // As `measureCostTable` has it, without the slow ones.
    static const CostTable table = [] {
        Contestants contestants = tableContestants(subjects());
        std::erase_if(contestants, [](const auto& contestant) {
            const std::string& name = contestant->series();
            return name != "point" && name != "trilinear" && !name.starts_with("probes-") &&
                   name != "ewa";
        });
        SpeedAccuracyOptions options;
        options.rounds = 1;
        options.secondsOfRounds = 0.1;
        options.withAuto = false;
        test::RememberingWatcher watcher;
        return costTableOf(measureSpeedAccuracy(subjects(), contestants, options, watcher).value());
    }();
    return table;
}

TEST(ChooseMethods, takesTheCheapestThatIsGoodEnough)
{
    const AutoChoices choices = chooseMethods(twoMethods(), 0.045).value();
    for (std::size_t k = 0; k < choices.classes.size(); ++k) {
        EXPECT_EQ(choices.classes[k].method.name, k < 4 ? "point" : "trilinear");
        EXPECT_EQ(static_cast<std::size_t>(choices.classes[k].footprintClass), k);
    }
}

TEST(ChooseMethods, ofEquallyCheapOnesTakesTheMoreAccurate)
{
    CostTable table = twoMethods();
    for (CostEntry& e : table.entries) {
        e.cost = 10;
    }
    EXPECT_EQ(chooseMethods(table, 1).value().classes[0].method.name, "trilinear");
}

TEST(ChooseMethods, namesTheClassThatNobodyServes)
{
    EXPECT_EQ(chooseMethods(twoMethods(), 0.001).error().message,
              "No method has an RMS error within 0.001 for small round footprints; the best is "
              "trilinear with 0.005.");
    CostTable table = twoMethods();
    std::erase_if(table.entries, [](const CostEntry& e) {
        return e.footprintClass == FootprintClass::LargeRound;
    });
    EXPECT_EQ(chooseMethods(table, 0.1).error().message,
              "No method has an RMS error within 0.1 for large round footprints.");
}

TEST(ChooseMethods, showsEveryClassInItsText)
{
    const std::string text = toText(chooseMethods(twoMethods(), 0.045).value());
    for (const FootprintClass footprintClass : footprintClasses()) {
        EXPECT_THAT(text, HasSubstr(std::string(nameOf(footprintClass))));
    }
    EXPECT_EQ(std::ranges::count(text, '\n'), kFootprintClasses);
}

TEST(Classify, agreesWithClassOfButBesideBoundaries)
{
    for (const StudySubject& subject : subjects()) {
        const FilterQueries queries = subject.queries.queries();
        std::vector<std::uint8_t> classes(queries.size());
        classify(*subject.scene, queries, classes);
        int differing = 0;
        for (std::size_t i = 0; i < queries.size(); ++i) {
            const auto expected =
                static_cast<std::uint8_t>(classOf(queryEllipse(*subject.scene, queries, i)));
            differing += classes[i] == expected ? 0 : 1;
        }
        EXPECT_LE(differing, 2);
    }
}

TEST(Classify, givesEveryBitPatternAClass)
{
    const StudySubject& subject = subjects()[0];
    std::vector<float> hostile = {0.0F,
                                  -0.0F,
                                  1e-45F,
                                  1e30F,
                                  -1e38F,
                                  std::numeric_limits<float>::infinity(),
                                  std::numeric_limits<float>::quiet_NaN()};
    QueryArrays queries;
    for (const float a : hostile) {
        for (const float b : hostile) {
            queries.add(faceId(0), {a, b}, {b, a}, {a, -b});
            queries.add(faceId(0), {0.2F, 0.2F}, {b, a}, {b, b});
        }
    }
    std::vector<std::uint8_t> classes(queries.size(), 255);
    classify(*subject.scene, queries.queries(), classes);
    for (const std::uint8_t found : classes) {
        EXPECT_LT(found, kFootprintClasses);
    }
}

TEST(AutoMethod, answersAsTheChosenMethodsDo)
{
    const AutoMethod method(chooseMethods(twoMethods(), 0.045).value());
    const StudySubject& subject = subjects()[1];
    const FilterQueries queries = subject.queries.queries();
    ResultArrays answers(queries.size(), 3);
    method.filter(*subject.scene, queries, answers.results());
    std::vector<ResultArrays> single;
    for (const char* name : {"point", "trilinear"}) {
        single.emplace_back(queries.size(), 3);
        makeMethod(MethodChoice{name, {}})
            ->filter(*subject.scene, queries, single.back().results());
    }
    int points = 0;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const bool isPoint = method.choiceFor(*subject.scene, queries, i).name == "point";
        points += isPoint ? 1 : 0;
        const ResultArrays& expected = single[isPoint ? 0 : 1];
        for (std::size_t c = 0; c < 3; ++c) {
            ASSERT_EQ(answers.values[c * queries.size() + i],
                      expected.values[c * queries.size() + i]);
        }
        ASSERT_EQ(answers.levels[i], expected.levels[i]);
        ASSERT_EQ(answers.taps[i], expected.taps[i]);
    }
    EXPECT_GT(points, 500);
    EXPECT_LT(points, static_cast<int>(queries.size()) - 500);
}

TEST(AutoMethod, needsNeitherLevelsNorTapsAndKeepsToItsPart)
{
    const AutoMethod method(chooseMethods(twoMethods(), 0.045).value());
    const StudySubject& subject = subjects()[1];
    const FilterQueries queries = subject.queries.queries();
    ResultArrays all(queries.size(), 3);
    method.filter(*subject.scene, queries, all.results());
    // A part in the middle, by several threads, into the middle of a larger array.
    std::vector<float> values(3 * queries.size(), -7);
    filterParallel(method,
                   *subject.scene,
                   queries.subspan(100, 1500),
                   {std::span(values).subspan(100), queries.size(), {}, {}},
                   Threads{2});
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const bool inside = i >= 100 && i < 1600;
        EXPECT_EQ(values[i], inside ? all.values[i] : -7);
    }
}

TEST(AutoMethod, keepsItsToleranceOnTheStoredDistributionInEveryClass)
{
    int tested = 0;
    for (const double tolerance : {0.05, 0.02, 0.01, 0.005, 0.003}) {
        const auto choices = chooseMethods(measuredTable(), tolerance);
        if (!choices) {
            continue;
        }
        ++tested;
        const AutoMethod method(*choices);
        std::array<ErrorSums, kFootprintClasses> errors;
        for (const StudySubject& subject : subjects()) {
            const FilterQueries queries = subject.queries.queries();
            ResultArrays answers(queries.size(), 3);
            method.filter(*subject.scene, queries, answers.results());
            for (std::size_t i = 0; i < queries.size(); ++i) {
                const auto k =
                    static_cast<std::size_t>(classOf(queryEllipse(*subject.scene, queries, i)));
                for (std::size_t c = 0; c < 3; ++c) {
                    const std::size_t at = c * queries.size() + i;
                    errors[k].add(static_cast<double>(answers.values[at]),
                                  static_cast<double>(subject.exact[at]),
                                  subject.range);
                }
            }
        }
        for (const ErrorSums& sums : errors) {
            ASSERT_GT(sums.count(), 0U);
            StudyPoint point;
            sums.tell(point);
            // A footprint beside a boundary may fall to the class across it.
            EXPECT_LE(point.rms, 1.01 * tolerance);
        }
    }
    EXPECT_GE(tested, 3);
}

TEST(AutoMethod, noCheaperEntryOfTheTableWouldDo)
{
    for (const double tolerance : {0.05, 0.02, 0.01}) {
        const AutoChoices choices = chooseMethods(measuredTable(), tolerance).value();
        for (const CostEntry& e : measuredTable().entries) {
            const CostEntry& chosen = choices.classes[static_cast<std::size_t>(e.footprintClass)];
            EXPECT_LE(chosen.rms, tolerance);
            EXPECT_TRUE(e.cost >= chosen.cost || e.rms > tolerance) << toText(e.method);
        }
    }
}

TEST(AutoContestants, enterOnceForEachToleranceThatChangesTheChoice)
{
    // Deterministic figures: costs are those of the table, not measured.
    Study study;
    for (const CostEntry& e : twoMethods().entries) {
        StudyPoint point;
        point.series = e.method.name;
        point.method = e.method;
        point.footprintClass = e.footprintClass;
        point.cost = e.cost;
        point.rms = e.rms;
        study.points.push_back(point);
    }
    const Contestants contestants = autoContestants(study, subjects());
    // 0.1 takes points everywhere; 0.05, 0.02 and 0.01 differ; 0.007 and 0.005 are both trilinear;
    // 0.002 is nobody.
    std::vector<std::string> variants;
    for (const auto& contestant : contestants) {
        EXPECT_EQ(contestant->series(), "auto");
        EXPECT_FALSE(contestant->method());
        variants.push_back(contestant->variant());
    }
    EXPECT_THAT(variants,
                testing::ElementsAre("tolerance 0.1",
                                     "tolerance 0.05",
                                     "tolerance 0.02",
                                     "tolerance 0.01",
                                     "tolerance 0.007"));
    EXPECT_THAT(autoContestants(Study(), subjects()), testing::IsEmpty());
}

TEST(CostTable, measuringStopsWhenCancelled)
{
    class Stop final : public Progress
    {
    public:
        bool report(double) override { return false; }
    } stop;
    EXPECT_EQ(measureCostTable(stop).error().kind, ErrorKind::Cancelled);
}

} // namespace
} // namespace trixel
