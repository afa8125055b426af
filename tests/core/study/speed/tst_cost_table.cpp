// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/read_file.h"
#include "core/study/speed/cost_table.h"

#include <cstdlib>
#include <fstream>
#include <gmock/gmock.h>
#include <unistd.h>

namespace trixel {
namespace {

using testing::HasSubstr;

CostTable smallTable()
{
    return {thisMachine(),
            costTableContents(),
            {{{"point", std::nullopt}, FootprintClass::SmallRound, 5, 0.25, 0.5},
             {{"exact", std::nullopt}, FootprintClass::LargeGrazing, 1e6, 0, 0}}};
}

/// A folder of its own, removed with all that is in it.
class CostTableFile : public testing::Test
{
protected:
    CostTableFile()
    {
        std::string name = testing::TempDir() + "trixel-costs-XXXXXX";
        m_folder = mkdtemp(name.data());
    }
    ~CostTableFile() override { std::filesystem::remove_all(m_folder); }

    std::filesystem::path path() const { return m_folder / "deeper" / "filter-costs.json"; }

    void put(const std::string& text) const
    {
        std::filesystem::create_directories(path().parent_path());
        std::ofstream(path(), std::ios::binary) << text;
    }

    /// Finds the table, counting how often it is measured.
    FoundCostTable find()
    {
        NoProgress progress;
        return findCostTable(path(),
                             progress,
                             [&](Progress&) -> Result<CostTable> {
                                 ++m_measured;
                                 return smallTable();
                             })
            .value();
    }

    std::filesystem::path m_folder;
    int m_measured = 0;
};

TEST(CostTable, survivesItsText)
{
    EXPECT_EQ(parseCostTable(toJson(smallTable())).value(), smallTable());
}

TEST(CostTable, takesPointsOfClassesThatNameAMethodAndRefusedNothing)
{
    Study study;
    StudyPoint point;
    point.series = "point";
    point.method = MethodChoice{"point", std::nullopt};
    point.cost = 7;
    study.points.push_back(point); // all classes together
    point.footprintClass = FootprintClass::MediumRound;
    study.points.push_back(point);
    point.refused = 1;
    study.points.push_back(point);
    point.refused = 0;
    point.method.reset(); // a peer
    study.points.push_back(point);
    const CostTable table = costTableOf(study);
    ASSERT_EQ(table.entries.size(), 1U);
    EXPECT_EQ(table.entries[0].footprintClass, FootprintClass::MediumRound);
    EXPECT_EQ(table.entries[0].cost, 7);
}

TEST(CostTable, refusesWhatItCannotUse)
{
    const std::string good = toJson(smallTable());
    const auto with = [&](const std::string& what, const std::string& instead) {
        std::string text = good;
        const std::size_t at = text.find(what);
        EXPECT_NE(at, std::string::npos) << what;
        return text.replace(at, what.size(), instead);
    };
    for (const std::string& text : {std::string(),
                                    std::string("[]"),
                                    good.substr(0, good.size() / 2),
                                    std::string(100000, '['),
                                    with("\"version\": 1", "\"version\": 2"),
                                    with("\"point\"", "\"no-such-method\""),
                                    with("\"point\"", "\"probes-1:1e9\""),
                                    with("\"point\"", "7"),
                                    with("small round", "tiny round"),
                                    with("0.25", "-0.25"),
                                    with("0.25", "1e999"),
                                    with("0.25", "null"),
                                    with("0.25", "\"0.25\""),
                                    with("\"entries\"", "\"entry\"")}) {
        EXPECT_FALSE(parseCostTable(text)) << text.substr(0, 200);
    }
}

TEST_F(CostTableFile, isMeasuredOnceAndThenRead)
{
    const FoundCostTable first = find();
    EXPECT_TRUE(first.measured);
    EXPECT_EQ(first.why, "there was none");
    const FoundCostTable second = find();
    EXPECT_FALSE(second.measured);
    EXPECT_EQ(second.table, smallTable());
    EXPECT_EQ(m_measured, 1);
}

TEST_F(CostTableFile, isMeasuredAnewWhereTheKeptOneIsHostile)
{
    for (const std::string& text : {std::string(),
                                    std::string("{"),
                                    std::string(100, '\0'),
                                    std::string(200000, '['),
                                    std::string("{\"version\":1,\"entries\":[{}]}")}) {
        put(text);
        m_measured = 0;
        EXPECT_EQ(find().why, "it was damaged");
        EXPECT_EQ(m_measured, 1);
        EXPECT_FALSE(find().measured); // and kept
    }
}

TEST_F(CostTableFile, isMeasuredAnewWhereTheKeptOneIsOfSomethingElse)
{
    for (int which = 0; which < 4; ++which) {
        CostTable other = smallTable();
        (which == 0   ? other.machine.processor
         : which == 1 ? other.machine.simd
                      : other.machine.version) += which < 3 ? "x" : "";
        other.contents += which == 3 ? 1 : 0;
        put(toJson(other));
        const FoundCostTable found = find();
        EXPECT_TRUE(found.measured) << which;
        EXPECT_THAT(found.why, HasSubstr("it was made"));
        EXPECT_EQ(found.table, smallTable());
    }
}

TEST_F(CostTableFile, pathThatCannotBeWrittenIsNoError)
{
    std::ofstream(m_folder / "deeper") << "a file where the folder should be";
    EXPECT_TRUE(find().measured);
    EXPECT_TRUE(find().measured);
    EXPECT_EQ(m_measured, 2);
}

TEST_F(CostTableFile, nothingIsKeptOfACancelledMeasurement)
{
    NoProgress progress;
    const auto found =
        findCostTable(path(), progress, [](Progress&) -> Result<CostTable> { return cancelled(); });
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().kind, ErrorKind::Cancelled);
    EXPECT_FALSE(std::filesystem::exists(path()));
}

TEST(CostTablePath, followsTheVariable)
{
    setenv("XDG_CACHE_HOME", "/somewhere/cache", 1);
    EXPECT_EQ(costTablePath(), "/somewhere/cache/trixel/filter-costs.json");
    setenv("XDG_CACHE_HOME", "relative", 1); // to be ignored, says the standard
    setenv("HOME", "/home/ada", 1);
    EXPECT_EQ(costTablePath(), "/home/ada/.cache/trixel/filter-costs.json");
    unsetenv("XDG_CACHE_HOME");
    unsetenv("HOME");
    EXPECT_EQ(costTablePath(), "");
}

} // namespace
} // namespace trixel
