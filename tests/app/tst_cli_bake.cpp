// SPDX-License-Identifier: GPL-3.0-or-later
//
// trixel bake.
#include "tests/app/cli_test.h"

#include <cmath>
#include <optional>

namespace trixel::test {
namespace {

using testing::HasSubstr;

constexpr int kUnusable = 2;
constexpr int kPath = 3;

class Bake : public CommandLine
{
protected:
    /// An uncompressed TGA, rows from the bottom, by red, green and blue of each pixel.
    std::string image(const std::string& name, int width, int height, const std::string& rgb) const
    {
        std::string bytes("\0\0\2\0\0\0\0\0\0\0\0\0", 12);
        for (const int size : {width, height}) {
            bytes += static_cast<char>(size % 256);
            bytes += static_cast<char>(size / 256);
        }
        bytes += std::string("\x18\0", 2);
        for (std::size_t k = 0; k + 2 < rgb.size(); k += 3) {
            bytes += {rgb[k + 2], rgb[k + 1], rgb[k]};
        }
        return write(name, bytes);
    }

    std::string fourColors(const std::string& name = "four.dat") const
    {
        return image(name,
                     2,
                     2,
                     "\x10\x20\x30"
                     "\x40\x50\x60"
                     "\x70\x01\x02"
                     "\x03\x04\x05");
    }

    /// A square with uvs times a factor.
    std::string square(const std::string& name,
                       const std::string& uv = "1",
                       const std::optional<std::string>& upwards = {}) const
    {
        const std::string v = upwards.value_or(uv);
        write("square.obj",
              "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt " + uv + " 0\nvt " + uv + " " + v +
                  "\nvt 0 " + v + "\nf 1/1 2/2 3/3 4/4\n");
        EXPECT_THAT(runTrixel({"new", path("square.obj"), "-o", path(name), "--level", "5"}),
                    EndsWith(0));
        return path(name);
    }

    /// What a point of face 0 holds, red only.
    std::string redAt(const std::string& project, const std::string& u, const std::string& v)
    {
        const std::string queries =
            write("q.csv", "face,u,v,uw1,vw1,uw2,vw2\n0," + u + "," + v + ",0,0,0,0\n");
        EXPECT_THAT(runTrixel({"sample",
                               project,
                               "--queries",
                               queries,
                               "--method",
                               "point",
                               "-o",
                               path("out.csv")}),
                    EndsWith(0));
        std::istringstream text(contentsOf(path("out.csv")));
        std::string line;
        std::getline(text, line);
        std::getline(text, line);
        for (int field = 0; field < 7; ++field) {
            line = line.substr(line.find(',') + 1);
        }
        return std::to_string(std::lround(255 * std::stod(line)));
    }
};

TEST_F(Bake, anImageComesOntoTheFacesByTheMeshsUvs)
{
    const std::string project = square("p.trixel");
    EXPECT_THAT(runTrixel({"bake",
                           project,
                           "--image",
                           fourColors(),
                           "--lookup",
                           "nearest",
                           "-o",
                           path("q.trixel")}),
                EndsWith(0));
    // Face 0 is (0,0) (1,0) (1,1): its third corner is the image's upper right.
    EXPECT_EQ(redAt(path("q.trixel"), "0.1", "0.05"), "16");
    EXPECT_EQ(redAt(path("q.trixel"), "0.9", "0.05"), "64");
    EXPECT_EQ(redAt(path("q.trixel"), "0.05", "0.9"), "3");
}

TEST_F(Bake, everyWayOfLayingItWorks)
{
    const std::string project = square("p.trixel");
    const std::string picture = fourColors();
    const std::string cameras = write(
        "c.json",
        R"({"version":1,"cameras":[{"name":"front","position":[0.5,0.5,3],"target":[0.5,0.5,0],)"
        R"("up":[0,1,0],"fovY":19,"size":[64,64]}]})");
    const std::vector<std::vector<std::string>> ways = {
        {"--map", "planar"},
        {"--map", "quad", "--corners", "0,0,0 1,0,0 1,1,0 0,1,0"},
        {"--map", "camera", "--cameras", cameras}};
    for (const auto& way : ways) {
        std::vector<std::string> arguments = {
            "bake", project, "--image", picture, "--lookup", "nearest", "-o", path("q.trixel")};
        arguments.insert(arguments.end(), way.begin(), way.end());
        EXPECT_THAT(runTrixel(arguments), EndsWith(0)) << way[1];
        EXPECT_EQ(redAt(path("q.trixel"), "0.1", "0.05"), "16") << way[1];
        EXPECT_EQ(redAt(path("q.trixel"), "0.9", "0.05"), "64") << way[1];
        EXPECT_EQ(redAt(path("q.trixel"), "0.05", "0.9"), "3") << way[1];
    }
    EXPECT_THAT(runTrixel({"bake",
                           project,
                           "--image",
                           picture,
                           "--map",
                           "sphere",
                           "--centre",
                           "0,0,-1",
                           "--turn",
                           "30",
                           "-o",
                           path("q.trixel")}),
                EndsWith(0));
}

TEST_F(Bake, tilesAreFoundByTheirNumbers)
{
    const std::string project = square("p.trixel", "2");
    for (const char* number : {"1001", "1002", "1011"}) {
        image(std::string("t.") + number + ".tga", 1, 1, std::string(3, number[3]));
    }
    const std::vector<std::string> bake = {
        "bake", project, "--image", path("t.<UDIM>.tga"), "-o", path("q.trixel")};
    EXPECT_THAT(runTrixel(bake), FailsWith(kUnusable, "reach tile 1012 (face 0)"));
    image("t.1012.tga", 1, 1, "\x21\x22\x23");
    EXPECT_THAT(runTrixel(bake), EndsWith(0));
    EXPECT_EQ(redAt(path("q.trixel"), "0.8", "0.05"), std::to_string('2'));
    EXPECT_EQ(redAt(path("q.trixel"), "0.05", "0.9"), std::to_string(0x21));
    EXPECT_THAT(
        runTrixel({"bake", project, "--image", path("none.<UDIM>.tga"), "-o", path("q.trixel")}),
        FailsWith(kPath, "no such file for any tile"));
}

TEST_F(Bake, badInputIsOneLineAndWritesNothing)
{
    const std::string project = square("p.trixel");
    const std::string wide = square("wide.trixel", "1.5");
    EXPECT_THAT(runTrixel({"new", mesh(), "-o", path("plain.trixel"), "--level", "2"}),
                EndsWith(0));
    const std::string picture = fourColors();
    const std::string broken = write("broken.png", "\x89PNG\r\n\x1A\n and no more of it");
    const struct
    {
        std::vector<std::string> arguments;
        int status;
        const char* says;
    } cases[] = {
        {{path("plain.trixel"), "--image", picture}, kUnusable, "the mesh has no uvs"},
        {{wide, "--image", picture}, kUnusable, "leave the image: face 0 reaches (1.5, 0)"},
        {{project, "--image", broken}, kUnusable, "broken.png: it is damaged"},
        {{project, "--image", path("none.png")}, kPath, "there is no such file"},
        {{project, "--image", project}, kUnusable, "expected an image (PNG"},
        {{project, "--image", picture, "--map", "cube"}, kUnusable, "--map: expected one of uv"},
        {{project, "--image", picture, "--lookup", "best"}, kUnusable, "--lookup: expected"},
        {{project, "--image", picture, "--index", "left"}, kUnusable, "--index: expected"},
        {{project, "--image", picture, "--color", "cmyk"}, kUnusable, "--color: expected"},
        {{project, "--image", picture, "--as", "cmyk"}, kUnusable, "--as: expected"},
        {{project, "--image", picture, "--map", "quad"}, kUnusable, "needs --corners"},
        {{project, "--image", picture, "--map", "camera"}, kUnusable, "needs --cameras"},
        {{project, "--image", picture, "--map", "quad", "--corners", "1,2"},
         kUnusable,
         "expected 12 finite numbers"},
        {{project, "--image", picture, "--map", "quad", "--corners", "0,0,0 1,1,0 1,0,0 0,1,0"},
         kUnusable,
         "crosses itself"},
        {{project, "--image", picture, "--map", "quad", "--corners", "0,0,0 1,0,0 2,0,0 3,0,0"},
         kUnusable,
         "on a line"},
        {{project, "--image", picture, "--map", "planar", "--right", "0,0,0"},
         kUnusable,
         "lie on a line"},
        {{project, "--image", picture, "--map", "planar", "--origin", "9,9,9"},
         kUnusable,
         "the image reaches no texel"},
        {{project, "--image", picture, "--map", "sphere", "--axis", "0,0,0"}, kUnusable, "--axis"},
    };
    const auto before = files();
    for (const auto& one : cases) {
        std::vector<std::string> arguments = {"bake"};
        arguments.insert(arguments.end(), one.arguments.begin(), one.arguments.end());
        arguments.insert(arguments.end(), {"-o", path("q.trixel")});
        EXPECT_THAT(runTrixel(arguments), FailsWith(one.status, one.says));
        EXPECT_EQ(files(), before);
    }
    EXPECT_THAT(runTrixel({"bake", wide, "--image", picture, "--repeat", "-o", path("q.trixel")}),
                EndsWith(0));
}

TEST_F(Bake, whatIsPaintedGoesOutByTheMeshsUvsAndComesBack)
{
    const std::string project = square("p.trixel");
    ASSERT_THAT(runTrixel({"bake",
                           project,
                           "--image",
                           fourColors(),
                           "--lookup",
                           "nearest",
                           "-o",
                           path("q.trixel")}),
                EndsWith(0));
    for (const char* name : {"out.png", "out.tx"}) {
        std::vector<std::string> arguments = {
            "bake-out", path("q.trixel"), "-o", path(name), "--size", "64"};
        if (std::string(name) == "out.tx") {
            arguments.emplace_back("--levels");
        }
        const auto out = runTrixel(arguments);
        EXPECT_THAT(out, EndsWith(0)) << name;
        EXPECT_THAT(out.out, HasSubstr("4096 of 4096 pixels lie on faces"));
        EXPECT_THAT(runTrixel({"bake", project, "--image", path(name), "-o", path("again.trixel")}),
                    EndsWith(0));
        EXPECT_NEAR(std::stoi(redAt(path("again.trixel"), "0.1", "0.05")), 16, 1) << name;
        EXPECT_NEAR(std::stoi(redAt(path("again.trixel"), "0.9", "0.05")), 64, 1) << name;
    }
}

TEST_F(Bake, whatCannotGoOutIsOneLineAndWritesNothing)
{
    const std::string project = square("p.trixel");
    const std::string tiles = square("tiles.trixel", "2", "1");
    const std::string tiny = square("tiny.trixel", "0.001");
    EXPECT_THAT(runTrixel({"new", mesh(), "-o", path("plain.trixel"), "--level", "2"}),
                EndsWith(0));
    const struct
    {
        std::vector<std::string> arguments;
        int status;
        const char* says;
    } cases[] = {
        {{path("plain.trixel"), "-o", path("o.png")}, kUnusable, "the mesh has no uvs"},
        {{tiles, "-o", path("o.png")}, kUnusable, "expected <UDIM> in the name"},
        {{tiny, "-o", path("o.png"), "--size", "16"}, kUnusable, "16 × 16 pixels is too small"},
        {{project, "-o", path("o.jpg")}, kUnusable, "expected a name that ends in"},
        {{project, "-o", path("o.png"), "--size", "0"}, kUnusable, "--size"},
        {{project, "-o", path("o.png"), "--size", "4x"}, kUnusable, "--size"},
        {{project, "-o", path("o.png"), "--gutter", "-1"}, kUnusable, "--gutter"},
        {{project, "-o", path("o.png"), "--type", "half"}, kUnusable, "a PNG holds"},
        {{project, "-o", path("o.png"), "--levels"}, kUnusable, "a PNG holds one level"},
        {{project, "-o", path("no/o.png"), "--size", "8"}, kPath, "folder"},
    };
    const auto before = files();
    for (const auto& one : cases) {
        std::vector<std::string> arguments = {"bake-out"};
        arguments.insert(arguments.end(), one.arguments.begin(), one.arguments.end());
        EXPECT_THAT(runTrixel(arguments), FailsWith(one.status, one.says));
        EXPECT_EQ(files(), before);
    }
    EXPECT_THAT(
        runTrixel({"bake-out", tiles, "-o", path("o.<UDIM>.png"), "--size", "8", "--gutter", "2"}),
        EndsWith(0));
    EXPECT_EQ(files().size(), before.size() + 2);
}

TEST_F(Bake, tilesTakeTheirNamesTogetherOrNotAtAll)
{
    const std::string tiles = square("tiles.trixel", "2", "1");
    std::filesystem::create_directory(path("o.1002.png")); // the last of them cannot be written
    const auto before = files();
    const auto run =
        runTrixel({"bake-out", tiles, "-o", path("o.<UDIM>.png"), "--size", "8", "--gutter", "2"});
    EXPECT_THAT(run, FailsWith(kPath, "o.1002.png: is a directory"));
    EXPECT_EQ(files(), before);
    std::filesystem::remove(path("o.1002.png"));
    write("o.1001.png", "kept");
    std::filesystem::permissions(path("o.1001.png"), std::filesystem::perms::owner_read);
    EXPECT_THAT(
        runTrixel({"bake-out", tiles, "-o", path("o.<UDIM>.png"), "--size", "8", "--gutter", "2"}),
        FailsWith(kPath, "o.1001.png: is read-only"));
    EXPECT_EQ(contentsOf(path("o.1001.png")), "kept");
}

} // namespace
} // namespace trixel::test
