// SPDX-License-Identifier: GPL-3.0-or-later
//
// Atlases and meshes with uvs, out of the built program and back.
#include "tests/app/cli_test.h"

#include <cmath>

namespace trixel::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class CliExport : public CommandLine
{
protected:
    std::string painted() const
    {
        const std::string to = path("painted.trixel");
        EXPECT_THAT(runTrixel({"paint", project(), "--strokes", strokes(), "-o", to}), EndsWith(0));
        return to;
    }
};

TEST_F(CliExport, aPackedAtlasComesBackAsTheSameProject)
{
    const std::string from = painted();
    for (const char* name : {"a.png", "b.exr"}) {
        const std::string stem = std::string(1, name[0]);
        ASSERT_THAT(runTrixel({"export", from, "-o", path(name), "--mips"}), EndsWith(0));
        EXPECT_THAT(files(),
                    testing::IsSupersetOf({name + std::string(), stem + ".json", stem + ".glsl"}));
        ASSERT_THAT(runTrixel({"new",
                               path("mesh.obj"),
                               "-o",
                               path("back.trixel"),
                               "--atlas",
                               path(stem + ".json")}),
                    EndsWith(0));
        ASSERT_THAT(runTrixel({"export", path("back.trixel"), "-o", path("back.ptx")}),
                    EndsWith(0));
        ASSERT_THAT(runTrixel({"export", from, "-o", path("from.ptx")}), EndsWith(0));
        const auto difference =
            jsonOf(runTrixel({"diff", path("from.ptx"), path("back.ptx"), "--json"}).out);
        EXPECT_THAT(difference["faces"], testing::IsEmpty()) << difference;
    }
}

TEST_F(CliExport, sizesAreSaidBeforeAnythingIsWritten)
{
    const std::string from = painted();
    const auto before = files();
    const ProgramRun run = runTrixel({"export", from, "-o", path("a.tif"), "--estimate", "--json"});
    ASSERT_THAT(run, EndsWith(0));
    const auto json = jsonOf(run.out);
    EXPECT_EQ(json["pages"], nlohmann::json({{40, 40}}));
    EXPECT_EQ(json["bytes"], 40 * 40 * 3);
    EXPECT_DOUBLE_EQ(json["occupancy"], 4 * 256 / 1600.0);
    EXPECT_EQ(files(), before);
}

TEST_F(CliExport, meshesLeaveWithUvsAndTextures)
{
    const std::string from = painted();
    for (const char* name : {"a.glb", "b.obj", "c.ply"}) {
        const ProgramRun run = runTrixel({"export", from, "-o", path(name), "--power-of-two"});
        ASSERT_THAT(run, EndsWith(0));
        EXPECT_THAT(run.out, AllOf(HasSubstr("128 × 64 pixels"), HasSubstr("largest jump")));
    }
    EXPECT_THAT(files(),
                testing::IsSupersetOf({"a.glb", "b.mtl", "b.obj", "b.png", "c.ply", "c.png"}));
}

TEST_F(CliExport, whatMeansNothingForTheOutputIsRefused)
{
    const std::string from = project();
    const auto before = files();
    const auto refuses = [&](std::vector<std::string> options, const std::string& name) {
        options.insert(options.begin(), {"export", from, "-o", path(name)});
        return runTrixel(options);
    };
    EXPECT_THAT(refuses({"--mips"}, "a.glb"), FailsWith(2, "--mips: means nothing for"));
    EXPECT_THAT(refuses({"--samples", "2"}, "a.exr"), FailsWith(2, "--samples"));
    EXPECT_THAT(refuses({"--page", "512"}, "a.ptx"), FailsWith(2, "--page"));
    EXPECT_THAT(refuses({}, "a.jpg"), FailsWith(2, "expected .ptx, a packed atlas"));
    EXPECT_THAT(refuses({"--packing", "tight"}, "a.exr"),
                FailsWith(2, "--packing: expected bands or shelves, found tight"));
    EXPECT_THAT(refuses({"--page", "0"}, "a.exr"), FailsWith(2, "--page"));
    EXPECT_THAT(refuses({"--page", "16"}, "a.exr"), FailsWith(2, "needs pages of 20 pixels"));
    EXPECT_THAT(refuses({"--colors", "red"}, "a.exr"), FailsWith(2, "--colors"));
    EXPECT_THAT(refuses({"--type", "half"}, "a.png"), FailsWith(2, "a PNG holds"));
    EXPECT_EQ(files(), before);
}

TEST_F(CliExport, partsOfAProjectLeaveAlone)
{
    const std::string from = painted();
    ASSERT_THAT(
        runTrixel({"export", from, "-o", path("a.ptx"), "--faces", "1-2", "--channels", "0"}),
        EndsWith(0));
    const auto info = jsonOf(runTrixel({"info", path("a.ptx"), "--json"}).out);
    EXPECT_EQ(info["faces"], 2);
    EXPECT_EQ(info["channels"], 1);
    ASSERT_THAT(runTrixel({"export", from, "-o", path("a.png"), "--faces", "3,1"}), EndsWith(0));
    EXPECT_THAT(runTrixel({"export", from, "-o", path("b.ptx"), "--faces", "4"}),
                FailsWith(2, "there is no face 4: 4 faces"));
    EXPECT_THAT(runTrixel({"export", from, "-o", path("b.png"), "--channels", "3"}),
                FailsWith(2, "there is no channel 3: 3 channels"));
    EXPECT_THAT(runTrixel({"export", from, "-o", path("b.png"), "--faces", "2-1"}),
                FailsWith(2, "--faces"));
    EXPECT_THAT(files(), testing::Not(testing::Contains("b.png")));
}

TEST_F(CliExport, anAtlasOfAnotherMeshIsRefused)
{
    ASSERT_THAT(runTrixel({"export", project(), "-o", path("a.png")}), EndsWith(0));
    const std::string other = write("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_THAT(runTrixel({"new", other, "-o", path("b.trixel"), "--atlas", path("a.json")}),
                FailsWith(2, "it has 4 faces, the mesh 1"));
}

TEST_F(CliExport, paintGoesOverToAnotherMesh)
{
    const std::string from = painted();
    const std::string mesh = write("moved.obj", "v 0 0 -0.01\nv 1 0 -0.01\nv 0 1 -0.01\nf 1 3 2\n");
    ASSERT_THAT(runTrixel({"new", mesh, "-o", path("to.trixel"), "--level", "4"}), EndsWith(0));
    const ProgramRun run = runTrixel(
        {"transfer", from, path("to.trixel"), "-o", path("got.trixel"), "--distance", "0.1"});
    ASSERT_THAT(run, EndsWith(0));
    EXPECT_THAT(run.out, HasSubstr("256 of 256 texels took paint"));
    EXPECT_THAT(
        runTrixel(
            {"transfer", from, path("to.trixel"), "-o", path("no.trixel"), "--distance", "0.001"}),
        FailsWith(2, "no texel is within 0.001 of"));
    EXPECT_THAT(runTrixel({"transfer",
                           from,
                           path("to.trixel"),
                           "-o",
                           path("no.trixel"),
                           "--distance",
                           "1",
                           "--method",
                           "magic"}),
                FailsWith(2, "--method"));
    EXPECT_THAT(files(), testing::Not(testing::Contains("no.trixel")));
}

/// The bunny with a picture on it and a stroke over that, out every way and back.
class PaintedBunny : public CliExport
{
protected:
    void SetUp() override
    {
        CliExport::SetUp();
        ASSERT_TRUE(std::filesystem::exists(kBunny)) << "glmark2-data has the bunny";
        ASSERT_THAT(runTrixel({"new", kBunny, "-o", path("plain.trixel"), "--level", "2"}),
                    EndsWith(0));
        ASSERT_THAT(runTrixel({"bake",
                               path("plain.trixel"),
                               "--map",
                               "sphere",
                               "--image",
                               "/usr/share/mujoco/model/mug/mug.png",
                               "-o",
                               path("pictured.trixel")}),
                    EndsWith(0));
        ASSERT_THAT(runTrixel({"paint",
                               path("pictured.trixel"),
                               "--strokes",
                               strokes(),
                               "-o",
                               path("bunny.trixel")}),
                    EndsWith(0));
        exportTo("bunny.ptx");
    }

    void exportTo(const std::string& name, const std::string& project = "bunny.trixel") const
    {
        ASSERT_THAT(runTrixel({"export", path(project), "-o", path(name)}), EndsWith(0)) << name;
    }
    /// Between `bunny.ptx` and that file.
    nlohmann::json differenceTo(const std::string& ptx) const
    {
        return jsonOf(runTrixel({"diff", path("bunny.ptx"), path(ptx), "--json"}).out);
    }

    static constexpr const char* kBunny = "/usr/share/glmark2/models/bunny.obj";
};

TEST_F(PaintedBunny, comesBackFromAPtxAndFromAPackedAtlasToTheBit)
{
    exportTo("plain.ptx", "plain.trixel");
    ASSERT_GT(differenceTo("plain.ptx")["faces"].size(), 10'000U); // it is painted
    exportTo("again.ptx", "bunny.ptx");
    EXPECT_THAT(differenceTo("again.ptx")["faces"], testing::IsEmpty());
    exportTo("atlas.exr");
    ASSERT_THAT(
        runTrixel({"new", kBunny, "-o", path("back.trixel"), "--atlas", path("atlas.json")}),
        EndsWith(0));
    exportTo("back.ptx", "back.trixel");
    EXPECT_THAT(differenceTo("back.ptx")["faces"], testing::IsEmpty());
}

/// Any program that has uvs and bilinear filtering is as good as the one that bakes here.
TEST_F(PaintedBunny, comesBackFromAMeshWithUvsAsItWasSeen)
{
    exportTo("bunny.glb");
    EXPECT_EQ(contentsOf(path("bunny.glb")).substr(0, 4), "glTF");
    exportTo("bunny.obj");
    ASSERT_THAT(runTrixel({"new", path("bunny.obj"), "-o", path("empty.trixel"), "--level", "2"}),
                EndsWith(0));
    ASSERT_THAT(runTrixel({"bake",
                           path("empty.trixel"),
                           "--image",
                           path("bunny.png"),
                           "--lookup",
                           "bilinear",
                           "-o",
                           path("back.trixel")}),
                EndsWith(0));
    exportTo("back.ptx", "back.trixel");
    const double rms = differenceTo("back.ptx")["rms"];
    EXPECT_GE(-20 * std::log10(rms), 40);
}

} // namespace
} // namespace trixel::test
