// SPDX-License-Identifier: GPL-3.0-or-later
//
// The built program, verb by verb.
#include "tests/app/cli_test.h"

namespace trixel::test {
namespace {

using testing::HasSubstr;
using testing::Not;

using Cli = CommandLine;

nlohmann::json infoOf(const std::string& file)
{
    const ProgramRun run = runTrixel({"info", file, "--json"});
    EXPECT_THAT(run, EndsWith(0));
    return jsonOf(run.out);
}

TEST_F(Cli, helpAndVersionGoToStandardOutput)
{
    for (const char* option : {"--help", "--version"}) {
        const ProgramRun run = runTrixel({option});
        EXPECT_THAT(run, EndsWith(0));
        EXPECT_THAT(run.out, HasSubstr("rixel"));
    }
    for (const char* verb :
         {"new", "info", "check", "paint", "export", "convert", "diff", "sample"}) {
        EXPECT_THAT(runTrixel({"--help"}).out, HasSubstr(verb));
        const ProgramRun run = runTrixel({verb, "--help"});
        EXPECT_THAT(run, EndsWith(0)) << verb;
        EXPECT_THAT(run.out, HasSubstr("--help")) << verb;
    }
}

TEST_F(Cli, newGivesEveryFaceTheLevelAskedFor)
{
    const auto info = infoOf(project({"--level", "3"}));
    EXPECT_EQ(info["kind"], "project");
    EXPECT_EQ(info["faces"], 4);
    EXPECT_EQ(info["vertices"], 4);
    EXPECT_EQ(info["levels"], nlohmann::json({{"3", 4}}));
    EXPECT_EQ(info["constantFaces"], 4);
    EXPECT_EQ(info["texels"], 4 * 64);
    EXPECT_EQ(info["texelBytes"], 4 * 64 * 3);
}

TEST_F(Cli, newTakesTypeAndChannels)
{
    const auto info = infoOf(
        project({"--level", "4", "--type", "half", "--channels", "5", "--fill", "0,0.5,1,-2,3e4"}));
    EXPECT_EQ(info["type"], "half");
    EXPECT_EQ(info["channels"], 5);
}

TEST_F(Cli, newReachesADensityAndKeepsWithinATotal)
{
    // The edges are 1 to 1.41 units long: 14 texels a unit are nearest to 16 an edge.
    EXPECT_EQ(infoOf(project({"--density", "14"}))["levels"], nlohmann::json({{"4", 4}}));
    const auto info = infoOf(project({"--texels", "1000"}));
    EXPECT_LE(info["texels"], 1000);
    EXPECT_GT(info["texels"], 250);
}

TEST_F(Cli, infoTellsOfAMesh)
{
    const auto info = infoOf(mesh());
    EXPECT_EQ(info["kind"], "mesh");
    EXPECT_EQ(info["faces"], 4);
    EXPECT_EQ(info["vertices"], 4);
    EXPECT_EQ(info["high"], nlohmann::json({1, 1, 1}));
    EXPECT_EQ(info["borderEdges"], 0);
    EXPECT_THAT(runTrixel({"info", mesh()}).out, HasSubstr("vertices"));
}

TEST_F(Cli, infoTellsOfAPtxWhatItsProjectHolds)
{
    const std::string from = path("b.trixel");
    ASSERT_THAT(runTrixel({"paint",
                           project({"--level", "4", "--type", "uint16", "--channels", "4"}),
                           "--strokes",
                           strokes(),
                           "-o",
                           from}),
                EndsWith(0));
    ASSERT_THAT(runTrixel({"export", from, "-o", path("a.ptx")}), EndsWith(0));
    const auto ofProject = infoOf(from);
    const auto ofPtx = infoOf(path("a.ptx"));
    EXPECT_EQ(ofPtx["kind"], "ptx");
    EXPECT_EQ(ofPtx["mips"], true);
    for (const char* key :
         {"faces", "vertices", "levels", "type", "channels", "constantFaces", "texels"}) {
        EXPECT_EQ(ofPtx[key], ofProject[key]) << key;
    }
    EXPECT_THAT(ofPtx["metadata"].dump(), HasSubstr("PtexFaceVertIndices"));
}

TEST_F(Cli, paintWritesAnotherProjectAndLeavesItsOwn)
{
    const std::string from = project();
    const std::string before = contentsOf(from);
    ASSERT_THAT(runTrixel({"paint", from, "--strokes", strokes(), "-o", path("b.trixel")}),
                EndsWith(0));
    EXPECT_EQ(contentsOf(from), before);
    EXPECT_LT(infoOf(path("b.trixel"))["constantFaces"], 4);
    EXPECT_THAT(files(),
                testing::ElementsAre("b.trixel", "mesh.obj", "new.trixel", "strokes.json"));
}

TEST_F(Cli, paintDoesNotDependOnTheNumberOfThreads)
{
    const std::string from = project({"--level", "7"});
    for (const char* threads : {"1", "2", "5"}) {
        const std::string name = path(std::string("b") + threads);
        ASSERT_THAT(runTrixel({"paint",
                               from,
                               "--strokes",
                               strokes(),
                               "-o",
                               name + ".trixel",
                               "--threads",
                               threads}),
                    EndsWith(0));
        ASSERT_THAT(runTrixel({"export", name + ".trixel", "-o", name + ".ptx"}), EndsWith(0));
    }
    EXPECT_THAT(runTrixel({"diff", path("b1.ptx"), path("b2.ptx")}), EndsWith(0));
    EXPECT_EQ(contentsOf(path("b1.ptx")), contentsOf(path("b2.ptx")));
    EXPECT_EQ(contentsOf(path("b1.ptx")), contentsOf(path("b5.ptx")));
}

TEST_F(Cli, erasingGoesBackToTheColourOfTheStart)
{
    const std::string from = project({"--level", "4", "--fill", "0.2,0.4,0.6"});
    const std::string painted = path("painted.trixel");
    const std::string erased = path("erased.trixel");
    ASSERT_THAT(runTrixel({"paint", from, "--strokes", strokes(), "-o", painted}), EndsWith(0));
    const std::string eraser = strokes({{"blend", "erase"}, {"hardness", 1}, {"radius", 0.5}});
    ASSERT_THAT(runTrixel({"paint", painted, "--strokes", eraser, "-o", erased}), EndsWith(0));
    for (const std::string& file : {from, painted, erased}) {
        ASSERT_THAT(runTrixel({"export", file, "-o", file + ".ptx"}), EndsWith(0));
    }
    EXPECT_EQ(runTrixel({"diff", from + ".ptx", painted + ".ptx"}).status, 1);
    EXPECT_THAT(runTrixel({"diff", from + ".ptx", erased + ".ptx"}), EndsWith(0));
}

TEST_F(Cli, exportedPtxPassesTheCheckAgainstItsMesh)
{
    const std::string painted = path("b.trixel");
    ASSERT_THAT(runTrixel({"paint", project(), "--strokes", strokes(), "-o", painted}),
                EndsWith(0));
    ASSERT_THAT(runTrixel({"export", painted, "-o", path("b.ptx")}), EndsWith(0));
    EXPECT_THAT(runTrixel({"check", path("b.ptx"), "--mesh", mesh()}), EndsWith(0));
    const ProgramRun json = runTrixel({"check", path("b.ptx"), "--json"});
    EXPECT_THAT(json, EndsWith(0));
    EXPECT_EQ(jsonOf(json.out)["faults"], nlohmann::json::array());
}

TEST_F(Cli, checkFindsAPtxOnAnotherMesh)
{
    ASSERT_THAT(runTrixel({"export", project(), "-o", path("b.ptx")}), EndsWith(0));
    const std::string turned = write("turned.obj",
                                     "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                     "f 3 2 1\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    const ProgramRun run = runTrixel({"check", path("b.ptx"), "--mesh", turned, "--json"});
    EXPECT_THAT(run, EndsWith(1));
    EXPECT_THAT(jsonOf(run.out)["faults"].dump(), HasSubstr("face 0"));
}

TEST_F(Cli, checkFindsADamagedPtx)
{
    const std::string painted = path("b.trixel");
    ASSERT_THAT(runTrixel({"paint", project(), "--strokes", strokes(), "-o", painted}),
                EndsWith(0));
    ASSERT_THAT(runTrixel({"export", painted, "-o", path("b.ptx")}), EndsWith(0));
    std::string bytes = contentsOf(path("b.ptx"));
    bytes[bytes.size() / 2] = static_cast<char>(~bytes[bytes.size() / 2]);
    const int status = runTrixel({"check", write("c.ptx", bytes)}).status;
    EXPECT_THAT(status, testing::AnyOf(1, 2));
    EXPECT_THAT(runTrixel({"check", write("d.ptx", bytes.substr(0, bytes.size() - 9))}).status,
                testing::AnyOf(1, 2));
}

TEST_F(Cli, checkNamesWhatIsOddAboutAMesh)
{
    const std::string fin = write("fin.obj",
                                  "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\n"
                                  "f 1 2 3\nf 2 1 4\nf 1 2 5\n");
    const ProgramRun run = runTrixel({"check", fin, "--json"});
    EXPECT_THAT(run, EndsWith(1));
    EXPECT_FALSE(jsonOf(run.out)["faults"].empty());
    EXPECT_THAT(runTrixel({"check", mesh()}), EndsWith(0));
}

TEST_F(Cli, convertRewritesTypeAndMips)
{
    ASSERT_THAT(
        runTrixel({"export", project({"--level", "4", "--fill", "0,0.2,1"}), "-o", path("a.ptx")}),
        EndsWith(0));
    ASSERT_THAT(
        runTrixel({"convert", path("a.ptx"), path("b.ptx"), "--type", "float", "--no-mips"}),
        EndsWith(0));
    const auto info = infoOf(path("b.ptx"));
    EXPECT_EQ(info["type"], "float");
    EXPECT_EQ(info["mips"], false);
    EXPECT_THAT(runTrixel({"check", path("b.ptx")}), EndsWith(0));
    // 8 bits → float → 8 bits is exact.
    ASSERT_THAT(runTrixel({"convert", path("b.ptx"), path("c.ptx"), "--type", "uint8"}),
                EndsWith(0));
    EXPECT_THAT(runTrixel({"diff", path("a.ptx"), path("c.ptx")}), EndsWith(0));
}

TEST_F(Cli, matchBringsAPtxBackOntoAMeshOfAnotherOrderAndWinding)
{
    runTrixel({"paint", project(), "--strokes", strokes(), "-o", path("painted.trixel")});
    runTrixel({"export", path("painted.trixel"), "-o", path("a.ptx")});
    const std::string other = write("other.obj",
                                    "v 0 1 0\nv 0 0 1\nv 1 0 0\nv 0 0 0\n"
                                    "f 3 1 2\nf 2 1 4\nf 4 1 3\nf 3 4 2\n");
    const ProgramRun there =
        runTrixel({"match", path("a.ptx"), "--mesh", other, "-o", path("b.ptx")});
    EXPECT_THAT(there, EndsWith(0));
    EXPECT_THAT(there.out, HasSubstr("by their positions: "));
    EXPECT_THAT(runTrixel({"check", path("b.ptx"), "--mesh", other}), EndsWith(0));
    EXPECT_NE(contentsOf(path("a.ptx")), contentsOf(path("b.ptx")));
    // And back, onto the mesh that the first file carries.
    EXPECT_THAT(runTrixel({"match", path("b.ptx"), "--mesh", path("a.ptx"), "-o", path("b.ptx")}),
                EndsWith(0));
    EXPECT_EQ(contentsOf(path("a.ptx")), contentsOf(path("b.ptx")));
}

TEST_F(Cli, matchRefusesAnotherMeshAndWritesNothing)
{
    runTrixel({"export", project(), "-o", path("a.ptx")});
    const std::string larger = write(
        "larger.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 2 4\nf 1 3 2\nf 2 3 4\nf 3 1 4\n");
    EXPECT_THAT(runTrixel({"match", path("a.ptx"), "--mesh", larger, "-o", path("b.ptx")}),
                FailsWith(2, "does not fit the mesh in any order"));
    EXPECT_THAT(
        runTrixel({"match", path("a.ptx"), "--mesh", path("none.obj"), "-o", path("b.ptx")}),
        FailsWith(3, "none.obj"));
    EXPECT_FALSE(std::filesystem::exists(path("b.ptx")));
}

TEST_F(Cli, diffNamesTheFacesThatDiffer)
{
    const std::string from = project();
    const std::string painted = path("b.trixel");
    ASSERT_THAT(runTrixel({"paint", from, "--strokes", strokes(), "-o", painted}), EndsWith(0));
    ASSERT_THAT(runTrixel({"export", from, "-o", path("a.ptx")}), EndsWith(0));
    ASSERT_THAT(runTrixel({"export", painted, "-o", path("b.ptx")}), EndsWith(0));
    const ProgramRun text = runTrixel({"diff", path("a.ptx"), path("b.ptx")});
    EXPECT_THAT(text, EndsWith(1));
    EXPECT_THAT(text.out, HasSubstr("face 1"));
    const ProgramRun json = runTrixel({"diff", path("a.ptx"), path("b.ptx"), "--json"});
    EXPECT_THAT(json, EndsWith(1));
    EXPECT_FALSE(jsonOf(json.out)["faces"].empty());
}

/// Meshes of Debian packages that the tests' machine has installed.
class RealMesh : public CommandLine, public testing::WithParamInterface<const char*>
{
};

TEST_P(RealMesh, isPaintedExportedAndChecked)
{
    const std::string file = GetParam();
    if (!std::filesystem::exists(file)) {
        GTEST_SKIP() << file << " is not installed";
    }
    const std::string painted = path("painted.trixel");
    ASSERT_THAT(runTrixel({"new", file, "-o", path("new.trixel"), "--level", "2"}), EndsWith(0));
    ASSERT_THAT(runTrixel({"paint", path("new.trixel"), "--strokes", strokes(), "-o", painted}),
                EndsWith(0));
    ASSERT_THAT(runTrixel({"export", painted, "-o", path("painted.ptx")}), EndsWith(0));
    EXPECT_THAT(runTrixel({"check", path("painted.ptx"), "--mesh", file}), EndsWith(0));
    const auto info = infoOf(path("painted.ptx"));
    EXPECT_GT(info["faces"], 10000);
    EXPECT_LT(info["constantFaces"], info["faces"]);
}

INSTANTIATE_TEST_SUITE_P(Packages,
                         RealMesh,
                         testing::Values("/usr/share/glmark2/models/bunny.obj",
                                         "/usr/share/mujoco/model/mug/mug.obj"));

} // namespace
} // namespace trixel::test
