// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/face_map.h"
#include "core/base/level.h"
#include "core/base/progress.h"
#include "core/base/result.h"

#include <gtest/gtest.h>

#include <vector>

using namespace trixel;

TEST(Level, countsTexelsAndRefusesInputOutOfRange)
{
    EXPECT_EQ(Level(0).texelCount(), 1U);
    EXPECT_EQ(Level(12).texelCount(), 1U << 24U);
    EXPECT_EQ(Level(3).resolution(), 8U);
    EXPECT_EQ(Level(2).coarser(5), Level(0));
    EXPECT_FALSE(Level::fromInput(-1).has_value());
    EXPECT_FALSE(Level::fromInput(13).has_value());
    EXPECT_EQ(Level::fromInput(12), Level(12));
}

TEST(FaceMapDeathTest, aFaceOutOfRangeStopsTheProgram)
{
    const FaceMap<int> map(3, 7);
    EXPECT_EQ(map[faceId(2)], 7);
    EXPECT_DEATH((void)map[faceId(3)], "broken promise");
}

TEST(StageProgress, mapsItsFractionIntoTheWholeAndPassesTheAnswerOn)
{
    struct Recorder final : Progress
    {
        bool report(double fraction) override
        {
            seen.push_back(fraction);
            return fraction < 0.5;
        }
        std::vector<double> seen;
    } whole;
    StageProgress stage(whole, 0.25, 0.75);
    EXPECT_TRUE(stage.report(0.0));
    EXPECT_FALSE(stage.report(1.0));
    EXPECT_EQ(whole.seen, (std::vector<double>{0.25, 0.75}));
}

TEST(Error, aPrefixKeepsItsKind)
{
    const Status status = prefixed("bunny.obj", pathError("no such file").value());
    EXPECT_EQ(status.error().kind, ErrorKind::Path);
    EXPECT_EQ(status.error().message, "bunny.obj: no such file");
}
