// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_reader.h"
#include "tests/core/mesh/test_data.h"

#include <gmock/gmock.h>

namespace trixel {
namespace {

using test::littleEndian;
using testing::ElementsAre;
using testing::HasSubstr;

Result<TriangleMesh> read(std::string_view text)
{
    NoProgress progress;
    return parseMesh(MeshFormat::Stl, text, progress);
}

std::string errorOf(std::string_view text)
{
    const auto mesh = read(text);
    return mesh ? "no error" : mesh.error().message;
}

std::string facet(const std::string& a, const std::string& b, const std::string& c)
{
    return "facet normal nan -nan(ind) 0\nouter loop\nvertex " + a + "\nvertex " + b + "\nvertex " +
           c + "\nendloop\nendfacet\n";
}

std::string binary(const std::vector<std::array<glm::vec3, 3>>& facets, std::string header = "")
{
    header.resize(80, ' ');
    std::string file = header + littleEndian(static_cast<std::uint32_t>(facets.size()));
    for (const auto& corners : facets) {
        file += std::string(12, '\xff'); // a normal of NaN
        for (const glm::vec3& corner : corners) {
            file += littleEndian(corner.x) + littleEndian(corner.y) + littleEndian(corner.z);
        }
        file += "\x12\x34";
    }
    return file;
}

TEST(StlReaderTest, weldsCornersOfEqualPosition)
{
    const std::string squareText = "solid a square\n" + facet("0 0 0", "1 0 0", "1 1 0") +
                                   facet("-0.0 0 -0", "1 1.000 0e5", "0 1 0") +
                                   "endsolid a square\n";
    const std::string squareData =
        binary({{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}}, {{{-0.0F, 0, -0.0F}, {1, 1, 0}, {0, 1, 0}}}});
    for (const std::string& square : {squareText, squareData}) {
        const auto mesh = read(square);
        ASSERT_TRUE(mesh) << mesh.error().message;
        EXPECT_THAT(
            mesh->positions,
            ElementsAre(glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(1, 1, 0), glm::vec3(0, 1, 0)));
        EXPECT_THAT(mesh->triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
        EXPECT_TRUE(mesh->sourceFaces.empty());
    }
}

TEST(StlReaderTest, positionsThatDifferInTheLastBitStayApart)
{
    const float next = std::nextafter(1.0F, 2.0F);
    const auto mesh = read(binary({{{{0, 0, 0}, {1, 0, 0}, {next, 0, 0}}}}));
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->positions.size(), 3U);
}

TEST(StlReaderTest, manyFacetsWeldToTheirGrid)
{
    std::vector<std::array<glm::vec3, 3>> facets;
    const int n = 100;
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const glm::vec3 p(x, y, 0);
            facets.push_back({p, p + glm::vec3(1, 0, 0), p + glm::vec3(0, 1, 0)});
            facets.push_back(
                {p + glm::vec3(1, 0, 0), p + glm::vec3(1, 1, 0), p + glm::vec3(0, 1, 0)});
        }
    }
    const auto mesh = read(binary(facets));
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->positions.size(), static_cast<std::size_t>((n + 1) * (n + 1)));
    for (std::size_t f = 0; f < facets.size(); ++f) {
        ASSERT_EQ(mesh->corners(faceId(f)), facets[f]);
    }
}

TEST(StlReaderTest, binaryIsToldBySizeNotByItsHeader)
{
    EXPECT_TRUE(read(binary({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}}, "solid of an exporter")));
    EXPECT_THAT(
        errorOf(binary({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}}) + "x"),
        HasSubstr("byte 80: expected a number of facets that matches the file's 135 bytes"));
    EXPECT_EQ(errorOf(binary({})), "expected at least one facet, found none");
}

TEST(StlReaderTest, asciiTakesAnyCaseLineEndsAndSeveralSolids)
{
    std::string text = "\xEF\xBB\xBF  Solid\tcaf\xC3\xA9\n" + facet("0 0 0", "1 0 0", "0 1 0") +
                       "EndSolid\nsolid\n" + facet("0 0 0", "0 1 0", "0 0 1") + "endsolid x";
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) {
        text.replace(at, 1, "\r\n");
    }
    const auto mesh = read(text);
    ASSERT_TRUE(mesh) << mesh.error().message;
    EXPECT_EQ(mesh->faceCount(), 2U);
    EXPECT_EQ(mesh->positions.size(), 4U);
}

TEST(StlReaderTest, asciiErrorsNameTheirLine)
{
    const std::string good = "solid\n" + facet("0 0 0", "1 0 0", "0 1 0");
    EXPECT_EQ(errorOf(good), "line 9: expected 'facet' or 'endsolid', found the end of the file");
    EXPECT_EQ(errorOf(good + "endsolid\nrubbish"), "line 10: expected 'solid', found 'rubbish'");
    EXPECT_EQ(errorOf("solid\n" + facet("0 0", "1 0 0", "0 1 0")),
              "line 4: expected a finite number that fits a float, found the end of the line");
    EXPECT_EQ(errorOf("solid\n" + facet("0 0 0", "1 0 0 0", "0 1 0")),
              "line 5: expected 'vertex', found '0'");
    EXPECT_EQ(errorOf("solid\nfacet normal 0 0\n"),
              "line 2: expected the three numbers of a normal, found the end of the line");
}

} // namespace
} // namespace trixel
