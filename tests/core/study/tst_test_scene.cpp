// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/read_file.h"
#include "core/filter/filter_method.h"
#include "core/study/footprint_class.h"
#include "core/study/query_table.h"
#include "core/study/test_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <gmock/gmock.h>
#include <map>
#include <string>

namespace trixel {
namespace {

using testing::HasSubstr;

/// FNV-1a, 64 bits.
std::uint64_t hashOf(std::string_view bytes)
{
    std::uint64_t hash = 0xCBF29CE484222325U;
    for (const char c : bytes) {
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
    }
    return hash;
}

const TestData& data()
{
    static const TestData parsed = parseTestData(storedTestFiles()).value();
    return parsed;
}

const TestScene& smallScene()
{
    static const TestScene scene = [] {
        NoProgress progress;
        return buildTestScene(data(), TestContent::HardEdged, 1, Threads{2}, progress).value();
    }();
    return scene;
}

TEST(TestScene, filesAreThoseThatFiguresWereMeasuredOn)
{
    const TestDataFiles files = storedTestFiles();
    EXPECT_EQ(hashOf(files.natural), 0xEA0B57847B22628BU);
    EXPECT_EQ(hashOf(files.hardEdged), 0xAD6E1256275B1423U);
    EXPECT_EQ(hashOf(files.queries), 0x5B1B4B811DBC2C53U);
}

TEST(TestScene, programCarriesTheFilesOfTheTests)
{
    const TestDataFiles files = storedTestFiles();
    const std::string folder = std::string(TRIXEL_TEST_DATA) + "/study/";
    EXPECT_EQ(readFile(folder + "natural.ptx").value(), files.natural);
    EXPECT_EQ(readFile(folder + "hard-edged.ptx").value(), files.hardEdged);
    EXPECT_EQ(readFile(folder + "queries.csv").value(), files.queries);
}

/// Width of the narrow axis in texels and anisotropy, without the floor of the ellipse.
struct Shape
{
    double width;
    double anisotropy;
    double angle; ///< of the long axis, in the tile's plane
};

Shape shapeOf(const QueryArrays& queries, std::size_t i)
{
    const double sign = indexOf(queries.face[i]) % 2 == 0 ? 1 : -1;
    const auto inPlane = [&](double u, double v) {
        return glm::dvec2(sign * 64 * (u + v / 2), sign * 64 * v * 0.86602540378443865);
    };
    const glm::dvec2 a = inPlane(queries.uw1[i], queries.vw1[i]);
    const glm::dvec2 b = inPlane(queries.uw2[i], queries.vw2[i]);
    const double xx = a.x * a.x + b.x * b.x;
    const double xy = a.x * a.y + b.x * b.y;
    const double yy = a.y * a.y + b.y * b.y;
    const double middle = (xx + yy) / 2;
    const double largest = middle + std::hypot((xx - yy) / 2, xy);
    const double area = std::abs(a.x * b.y - a.y * b.x);
    return {area / std::sqrt(largest), largest / area, 0.5 * std::atan2(2 * xy, xx - yy)};
}

/// Largest distance between the share of values below x and x itself.
double farthestFromUniform(std::vector<double> values)
{
    std::ranges::sort(values);
    double worst = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        worst = std::max(
            worst,
            std::abs(values[i] - static_cast<double>(i) / static_cast<double>(values.size())));
    }
    return worst;
}

TEST(TestScene, widthsAnisotropiesAndDirectionsAreSpreadEvenly)
{
    const QueryArrays& queries = data().queries;
    ASSERT_EQ(queries.size(), 3000U);
    std::vector<double> widths;
    std::vector<double> anisotropies;
    std::vector<double> angles;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const Shape shape = shapeOf(queries, i);
        widths.push_back(std::log(shape.width * 4) / std::log(256.0));
        anisotropies.push_back(std::log(shape.anisotropy) / std::log(64.0));
        angles.push_back(shape.angle / 3.141592653589793 + 0.5);
    }
    // Kolmogorov and Smirnov: 1.63 / sqrt(3000) is passed by one sample in a hundred.
    EXPECT_LT(farthestFromUniform(widths), 0.03);
    EXPECT_LT(farthestFromUniform(anisotropies), 0.03);
    EXPECT_LT(farthestFromUniform(angles), 0.03);
    EXPECT_GT(std::ranges::min(widths), -1e-4);
    EXPECT_LT(std::ranges::max(widths), 1 + 1e-4);
    EXPECT_LT(std::ranges::max(anisotropies), 1 + 1e-4);
}

TEST(TestScene, everyClassHasFootprints)
{
    std::array<int, kFootprintClasses> counts{};
    const TestScene& scene = smallScene();
    for (std::size_t i = 0; i < data().queries.size(); ++i) {
        // Any face will do for the class: all are alike.
        const QueryArrays& q = data().queries;
        const QueryEllipse ellipse = queryEllipse(
            scene.scene, faceId(0), {q.u[i], q.v[i]}, {q.uw1[i], q.vw1[i]}, {q.uw2[i], q.vw2[i]});
        ++counts[static_cast<std::size_t>(classOf(ellipse))];
    }
    EXPECT_GT(std::ranges::min(counts), 90) << testing::PrintToString(counts);
}

TEST(TestScene, tileClosesUponItself)
{
    const Adjacency adjacency = tileAdjacency();
    for (std::uint32_t f = 0; f < kTileFaces; ++f) {
        for (const LocalEdge edge : kLocalEdges) {
            const auto across = adjacency.neighbour(faceId(f), edge);
            ASSERT_TRUE(across);
            // The two share the edge's middle, but for whole tiles.
            constexpr std::array<glm::dvec2, 3> kMiddles = {{{0.5, 0}, {0.5, 0.5}, {0, 0.5}}};
            const glm::dvec2 apart = inTile(faceId(f), kMiddles[indexOf(edge)]) -
                                     inTile(across->face, kMiddles[indexOf(across->edge)]);
            EXPECT_EQ(apart.x, 8 * std::round(apart.x / 8));
            EXPECT_EQ(apart.y, 8 * std::round(apart.y / 8));
        }
    }
    const VertexRings rings(adjacency);
    for (std::size_t r = 0; r < rings.ringCount(); ++r) {
        EXPECT_EQ(rings.corners(static_cast<RingId>(r)).size(), 6U);
    }
}

TEST(TestScene, patchRepeatsTheTileAndSharesItsTexels)
{
    NoProgress progress;
    const auto scene = buildTestScene(data(), TestContent::HardEdged, 3, Threads{2}, progress);
    ASSERT_TRUE(scene);
    EXPECT_EQ(scene->scene.faceCount(), 9U * kTileFaces);
    // One tile of float mips, not nine.
    EXPECT_LT(scene->scene.mips().memoryBytes(), kTileFaces * std::size_t{4096} * 16 * 3 / 2);
    // Stored and moved query lie on the same texels.
    for (std::size_t i = 0; i < scene->queries.size(); ++i) {
        const FaceId stored = data().queries.face[scene->stored[i]];
        const FloatMips& mips = scene->scene.mips();
        const float* own = mips.texels(scene->queries.face[i], kTileLevel).values;
        std::array<float, 3> first{};
        decode(TexelType::UInt8, data().tiles[1].face(stored).texel(0), first);
        EXPECT_TRUE(std::equal(first.begin(), first.end(), own));
    }
}

TEST(TestScene, largeFacesHoldTheSameTexelsAtTheSamePlaces)
{
    const TexelStore& stored = data().tiles[1];
    const TexelStore large = tileOf(data(), TestContent::HardEdged, TestFaces::Large);
    ASSERT_EQ(large.faceCount(), 2U);
    const Level level = levelOf(TestFaces::Large);
    const auto where = [](glm::dvec2 at) { // in thirds of a texel, which centroids lie on
        return std::pair(std::lround(3 * 64 * at.x), std::lround(3 * 64 * at.y));
    };
    std::map<std::pair<long, long>, std::uint8_t> red;
    for (std::uint32_t f = 0; f < kTileFaces; ++f) {
        for (std::uint32_t t = 0; t < kTileLevel.texelCount(); ++t) {
            const auto middle = centroid(kTileLevel, texelAt(kTileLevel, TexelIndex{t}));
            red[where(inTile(faceId(f), middle))] =
                std::to_integer<std::uint8_t>(stored.face(faceId(f)).texel(t)[0]);
        }
    }
    EXPECT_EQ(red.size(), 2 * level.texelCount());
    for (std::uint32_t f = 0; f < 2; ++f) {
        ASSERT_EQ(large.face(faceId(f)).level(), level);
        for (std::uint32_t t = 0; t < level.texelCount(); ++t) {
            const auto middle = centroid(level, texelAt(level, TexelIndex{t}));
            const auto found = red.find(where(inTile(faceId(f), middle, TestFaces::Large)));
            ASSERT_NE(found, red.end());
            ASSERT_EQ(std::to_integer<std::uint8_t>(large.face(faceId(f)).texel(t)[0]),
                      found->second);
        }
    }
}

TEST(TestScene, largeFacesHaveTheSameExactValues)
{
    NoProgress progress;
    const TestPatch patch(1, TestFaces::Large);
    const auto scene =
        buildTestScene(data(), TestContent::HardEdged, patch, Threads{2}, progress).value();
    EXPECT_EQ(scene.stored, smallScene().stored);
    EXPECT_EQ(scene.exact, smallScene().exact);
    const auto exact = makeMethod({"exact", std::nullopt});
    ResultArrays results(scene.queries.size(), 3);
    filterParallel(*exact, scene.scene, scene.queries.queries(), results.results(), Threads{2});
    double worst = 0;
    for (std::size_t k = 0; k < results.values.size(); ++k) {
        worst = std::max(worst, double(std::abs(results.values[k] - scene.exact[k])));
    }
    EXPECT_LE(worst, 1e-5);
}

TEST(TestScene, queriesThatReachBeyondThePatchAreLeftOut)
{
    EXPECT_LT(smallScene().queries.size(), 2200U);
    EXPECT_GT(smallScene().queries.size(), 1000U);
    EXPECT_EQ(smallScene().exact.size(), 3 * smallScene().queries.size());
    EXPECT_EQ(smallScene().stored.size(), smallScene().queries.size());
}

TEST(TestScene, parsingNamesTheFileAndThePlace)
{
    TestDataFiles files = storedTestFiles();
    files.natural = files.natural.substr(0, 5000);
    EXPECT_THAT(parseTestData(files).error().message, HasSubstr("natural.ptx: "));
    files = storedTestFiles();
    files.queries = "face,u,v,uw1,vw1,uw2,vw2,a,b,c,d,e,f\n128,0,0,0,0,0,0,0,0,0,0,0,0\n";
    EXPECT_EQ(parseTestData(files).error().message,
              "queries.csv: line 2: expected a face below 128, found '128'.");
}

TEST(QueryTable, readsEveryColumn)
{
    const auto table =
        parseQueryTable("face,u,v,uw1,vw1,uw2,vw2,x,y\r\n7,0.25,0.5,1,2,3,4,10,20\r\n"
                        "0,nan,-inf,0,0,0,0,11,21",
                        8,
                        2);
    ASSERT_TRUE(table) << table.error().message;
    EXPECT_EQ(table->queries.face[0], faceId(7));
    EXPECT_EQ(table->queries.vw2[0], 4);
    EXPECT_TRUE(std::isnan(table->queries.u[1]));
    EXPECT_THAT(table->values, testing::ElementsAre(10, 11, 20, 21));
}

TEST(QueryTable, refusesWhatIsNotATable)
{
    const std::string header = "face,u,v,uw1,vw1,uw2,vw2\n";
    EXPECT_THAT(parseQueryTable("", 8).error().message, HasSubstr("line 1: expected the header"));
    EXPECT_THAT(parseQueryTable(header + "1,0,0,0,0,0", 8).error().message,
                HasSubstr("line 2: expected a number, found ''"));
    EXPECT_THAT(parseQueryTable(header + "1,0,0,0,0,0,0,5", 8).error().message,
                HasSubstr("line 2: expected 7 columns, found more"));
    EXPECT_THAT(parseQueryTable(header + "1,0,0,0,0,0,0\n-1,0,0,0,0,0,0", 8).error().message,
                HasSubstr("line 3: expected a face below 8"));
    EXPECT_THAT(parseQueryTable(header + "1,0,0x,0,0,0,0", 8).error().message,
                HasSubstr("found '0x'"));
}

} // namespace
} // namespace trixel
