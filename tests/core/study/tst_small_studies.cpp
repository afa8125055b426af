// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/small_studies.h"
#include "tests/core/study/study_fixture.h"
#include "tests/core/test_meshes.h"

#include <gmock/gmock.h>
#include <set>

namespace trixel {
namespace {

using test::RememberingWatcher;
using testing::Contains;
using testing::HasSubstr;

using Measure = std::function<Result<Study>(StudyWatcher&)>;

Study measured(const Measure& measure)
{
    RememberingWatcher watcher;
    return measure(watcher).value();
}

const Study& paintProjection()
{
    static const Study study = measured(studyPaintProjection);
    return study;
}
const Study& reduction()
{
    static const Study study = measured(studyReduction);
    return study;
}
const Study& storage()
{
    static const Study study = measured(studyStorage);
    return study;
}
const Study& subdivision()
{
    static const Study study = measured(
        [](StudyWatcher& watcher) { return studySubdivision(storedCage().value(), watcher); });
    return study;
}

const StudyPoint& pointOf(const Study& study, const std::string& series, const std::string& variant)
{
    return *std::ranges::find_if(study.points, [&](const StudyPoint& point) {
        return point.series == series && point.variant == variant;
    });
}

TEST(PaintProjection, theOffsetSamplesEveryCentroid)
{
    for (int n = 2; n <= 9; ++n) {
        const StudyPoint& point =
            pointOf(paintProjection(), "offset 1/6", "level " + std::to_string(n));
        EXPECT_LT(point.worst, 1e-9);
        EXPECT_EQ(point.samples, 1ULL << (2 * n));
    }
    EXPECT_THAT(paintProjection().notes,
                Contains(HasSubstr("offset 1/6: 0 texels from the wrong half, 0 unpainted")));
}

TEST(PaintProjection, withoutItTheDiagonalIsFromTheWrongHalf)
{
    // R texels of each level: 4 + 8 + … + 512. A sample is 1/6 of each axis off: √3/6 of an edge.
    EXPECT_THAT(paintProjection().notes,
                Contains("no offset: 1020 texels from the wrong half, 0 unpainted, the farthest "
                         "sample 0.29 texels from its centroid."));
    EXPECT_GT(pointOf(paintProjection(), "no offset", "level 8").rms, 0.02);
}

TEST(Reduction, theRuleForTrianglesIsTheMeanOverTheArea)
{
    for (const char* variant :
         {"1 level down", "2 levels down", "3 levels down", "4 levels down"}) {
        EXPECT_LT(pointOf(reduction(), "triangles, float", variant).worst, 1e-4) << variant;
        EXPECT_LT(pointOf(reduction(), "triangles, uint8", variant).rms, 0.5 / 255) << variant;
    }
}

TEST(Reduction, theBoxIsWrongByWholePercents)
{
    EXPECT_NEAR(pointOf(reduction(), "2 × 2 box, float", "1 level down").rms, 0.03, 0.01);
    EXPECT_NEAR(pointOf(reduction(), "2 × 2 box, float", "2 levels down").rms, 0.085, 0.02);
    EXPECT_NEAR(pointOf(reduction(), "2 × 2 box, float", "3 levels down").rms, 0.16, 0.03);
}

TEST(Storage, costsAreBytesATexel)
{
    EXPECT_EQ(pointOf(storage(), "uint8", "texels").cost, 3);
    EXPECT_EQ(pointOf(storage(), "uint16", "texels").cost, 6);
    EXPECT_EQ(pointOf(storage(), "half", "texels").cost, 6);
    EXPECT_EQ(pointOf(storage(), "float", "texels").cost, 12);
}

TEST(Storage, errorsAreThoseOfTheTypes)
{
    // Uniform rounding errors: the step over √12.
    EXPECT_NEAR(pointOf(storage(), "uint8", "texels").rms, 1 / 255.0 / std::sqrt(12.0), 5e-5);
    EXPECT_NEAR(pointOf(storage(), "uint16", "texels").rms, 1 / 65535.0 / std::sqrt(12.0), 2e-7);
    EXPECT_LE(pointOf(storage(), "uint8", "texels").worst, 0.5001 / 255);
    EXPECT_LE(pointOf(storage(), "half", "texels").worst, 0.0002442);
    EXPECT_LT(pointOf(storage(), "float", "mips 6 down").worst, 3e-7);
    EXPECT_GT(pointOf(storage(), "float", "mips 6 down").worst, 0);
    // Six roundings of one another stay below a step.
    EXPECT_LT(pointOf(storage(), "uint8", "mips 6 down").rms, 1 / 255.0);
    EXPECT_GT(pointOf(storage(), "uint8", "filtered").rms,
              pointOf(storage(), "half", "filtered").rms);
}

TEST(Storage, uint8MipsDriftByLessThanHalfAStep)
{
    for (const std::string& note : storage().notes) {
        if (note.starts_with("uint8")) {
            const double drift = std::stod(note.substr(note.find("drift by ") + 9));
            EXPECT_LT(std::abs(drift), 0.5);
            return;
        }
    }
    FAIL() << "the drift is not told";
}

TEST(Subdivision, everyStepComesNearerByAboutFourTimes)
{
    double former = pointOf(subdivision(), "vertices on the limit", "0 steps").rms;
    double faces = pointOf(subdivision(), "vertices on the limit", "0 steps").cost;
    for (const char* variant : {"1 step", "2 steps"}) {
        const StudyPoint& point = pointOf(subdivision(), "vertices on the limit", variant);
        EXPECT_EQ(point.cost, 4 * faces);
        EXPECT_NEAR(former / point.rms, 4, 1.5) << variant;
        former = point.rms;
        faces = point.cost;
    }
}

TEST(Subdivision, aSphereLikeCageConvergesOnItsLimit)
{
    const Study study = measured(
        [](StudyWatcher& watcher) { return studySubdivision(test::sphereMesh(0), watcher); });
    EXPECT_LT(pointOf(study, "vertices on the limit", "5 steps").worst, 1e-4);
    EXPECT_GT(pointOf(study, "cage as it is", "").rms, 0.01);
    EXPECT_TRUE(pointOf(study, "vertices on the limit", "5 steps").onFront);
    EXPECT_FALSE(pointOf(study, "cage as it is", "").onFront); // as dear as no steps, and farther
}

TEST(Subdivision, refusesWhatHasNoExtent)
{
    RememberingWatcher watcher;
    EXPECT_FALSE(studySubdivision(TriangleMesh(), watcher));
    TriangleMesh point;
    point.positions = {{1, 1, 1}};
    point.triangles = {{0, 0, 0}};
    EXPECT_FALSE(studySubdivision(point, watcher));
}

TEST(SmallStudies, tellEveryPoint)
{
    for (const Measure& measure : {Measure(studyReduction), Measure(studyPaintProjection)}) {
        RememberingWatcher watcher;
        const Study study = measure(watcher).value();
        EXPECT_EQ(watcher.points.size(), study.points.size());
        EXPECT_TRUE(std::ranges::is_sorted(watcher.fractions));
    }
}

TEST(SmallStudies, stopWhenCancelled)
{
    for (const Measure& measure : {Measure(studyPaintProjection),
                                   Measure(studyReduction),
                                   Measure(studyStorage),
                                   Measure([](StudyWatcher& watcher) {
                                       return studySubdivision(test::sphereMesh(0), watcher);
                                   })}) {
        RememberingWatcher watcher(1);
        const auto study = measure(watcher);
        ASSERT_FALSE(study);
        EXPECT_EQ(study.error().kind, ErrorKind::Cancelled);
        EXPECT_EQ(watcher.fractions.size(), 2U);
    }
}

} // namespace
} // namespace trixel
