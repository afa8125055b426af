// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/query_csv.h"

#include <gtest/gtest.h>

#include <cmath>
#include <gmock/gmock.h>
#include <limits>

namespace trixel::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::size_t kFaces = 10;

std::string errorOf(const std::string& text)
{
    const auto csv = parseQueryCsv(text, kFaces);
    return csv ? "none" : csv.error().message;
}

TEST(QueryCsv, readsColumnsByNameInAnyOrder)
{
    const std::string text = "note,vw2,uw2,vw1,uw1,v,u,face\n"
                             "a b,6,5,4,3,0.25,0.125,7\r\n"
                             ",-1e-3,.5,0,1e30,1,0,0";
    const auto csv = parseQueryCsv(text, kFaces);
    ASSERT_TRUE(csv) << csv.error().message;
    EXPECT_THAT(csv->queries.face, ElementsAre(faceId(7), faceId(0)));
    EXPECT_THAT(csv->queries.u, ElementsAre(0.125F, 0.0F));
    EXPECT_THAT(csv->queries.v, ElementsAre(0.25F, 1.0F));
    EXPECT_THAT(csv->queries.uw1, ElementsAre(3.0F, 1e30F));
    EXPECT_THAT(csv->queries.vw1, ElementsAre(4.0F, 0.0F));
    EXPECT_THAT(csv->queries.uw2, ElementsAre(5.0F, 0.5F));
    EXPECT_THAT(csv->queries.vw2, ElementsAre(6.0F, -1e-3F));
    EXPECT_THAT(csv->lines, ElementsAre("a b,6,5,4,3,0.25,0.125,7", ",-1e-3,.5,0,1e30,1,0,0"));
}

TEST(QueryCsv, readsWhatIsNoFiniteNumberAndWhatVanishesInAFloat)
{
    const auto csv =
        parseQueryCsv("face,u,v,uw1,vw1,uw2,vw2\n0,nan,inf,-inf,1e-60,1e-44,3.4e38\n", kFaces);
    ASSERT_TRUE(csv) << csv.error().message;
    EXPECT_TRUE(std::isnan(csv->queries.u[0]));
    EXPECT_EQ(csv->queries.v[0], std::numeric_limits<float>::infinity());
    EXPECT_EQ(csv->queries.uw1[0], -std::numeric_limits<float>::infinity());
    EXPECT_EQ(csv->queries.vw1[0], 0.0F);
    EXPECT_GT(csv->queries.uw2[0], 0.0F);
    EXPECT_EQ(csv->queries.vw2[0], 3.4e38F);
}

TEST(QueryCsv, aTableWithoutQueriesIsOne)
{
    const auto csv = parseQueryCsv("\xEF\xBB\xBF"
                                   "face,u,v,uw1,vw1,uw2,vw2",
                                   kFaces);
    ASSERT_TRUE(csv) << csv.error().message;
    EXPECT_EQ(csv->queries.size(), 0U);
}

TEST(QueryCsv, namesTheColumnThatIsMissingOrThereTwice)
{
    EXPECT_THAT(errorOf("face,u,v,uw1,vw1,uw2\n"), HasSubstr("line 1: expected a column 'vw2'"));
    EXPECT_THAT(errorOf(""), HasSubstr("'face'"));
    EXPECT_THAT(errorOf("face,u,v,uw1,vw1,uw2,vw2,u\n"), HasSubstr("'u' is there 2 times"));
    EXPECT_THAT(errorOf("face, u,v,uw1,vw1,uw2,vw2\n"), HasSubstr("'u'"));
}

TEST(QueryCsv, namesTheLineAndColumnOfWhatIsNoNumber)
{
    const std::string header = "face,u,v,uw1,vw1,uw2,vw2\n0,0,0,0,0,0,0\n";
    EXPECT_THAT(errorOf(header + "10,0,0,0,0,0,0\n"),
                HasSubstr("line 3: column face: expected a face below 10, found '10'"));
    for (const char* face : {"-1", "1.5", "x", "", "nan", "99999999999999999999"}) {
        EXPECT_THAT(errorOf(header + face + ",0,0,0,0,0,0\n"),
                    HasSubstr(std::string("found '") + face + "'"));
    }
    for (const char* number : {"", "x", "1 ", " 1", "1e39", "-1e400", "0x1", "1,5", "--1"}) {
        EXPECT_THAT(errorOf(header + "0,0,0,0," + number + ",0,0\n"), HasSubstr("line 3: "))
            << number;
    }
    EXPECT_THAT(errorOf(header + "0,0,0,0,blue,0,0\n"), HasSubstr("column vw1: expected a number"));
    EXPECT_THAT(errorOf(header + "0,0,0\n"), HasSubstr("line 3: expected 7 columns"));
    EXPECT_THAT(errorOf(header + "\n0,0,0,0,0,0,0\n"), HasSubstr("line 3: expected 7 columns"));
    EXPECT_THAT(errorOf(header + std::string(1000, '9') + ",0,0,0,0,0,0\n"), HasSubstr("…"));
}

TEST(QueryCsv, repeatsTheTableAndAddsWhatWasAnswered)
{
    const std::string text = "face,u,v,uw1,vw1,uw2,vw2,name\n0,0,0,0,0,0,0,a\n1,0,0,0,0,0,0,b\n";
    const auto csv = parseQueryCsv(text, kFaces);
    ASSERT_TRUE(csv);
    const float third = 1.0F / 3;
    const std::vector<float> values = {third, 2, std::nanf(""), -1e-30F};
    const std::vector<float> levels = {0, 5};
    const std::vector<std::string_view> methods = {"point", "exact"};
    EXPECT_EQ(*withSamples(*csv, {values, 2, 2, levels, methods}),
              "face,u,v,uw1,vw1,uw2,vw2,name,c0,c1,method,level\n"
              "0,0,0,0,0,0,0,a,0.33333334,nan,point,0\n"
              "1,0,0,0,0,0,0,b,2,-1e-30,exact,5\n");
}

TEST(QueryCsv, doesNotAddAColumnThatIsThere)
{
    for (const std::string name : {"c1", "method", "level"}) {
        const std::string text = "face,u,v,uw1,vw1,uw2,vw2," + name + "\n";
        const auto csv = parseQueryCsv(text, kFaces);
        ASSERT_TRUE(csv);
        const auto written = withSamples(*csv, {{}, 0, 2, {}, {}});
        ASSERT_FALSE(written);
        EXPECT_THAT(written.error().message, HasSubstr("'" + name + "'"));
    }
}

} // namespace
} // namespace trixel::test
