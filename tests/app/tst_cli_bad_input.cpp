// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whatever is wrong gets one sentence and its exit status, and leaves files as they were.
#include "tests/app/cli_test.h"

#include <csignal>
#include <sys/stat.h>

namespace trixel::test {
namespace {

using testing::AnyOf;
using testing::ElementsAre;

constexpr int kFaults = 1;
constexpr int kUnusable = 2;
constexpr int kPath = 3;

class BadArguments : public CommandLine
{
protected:
    /// `trixel new` with these options refuses, naming `text`, and writes nothing.
    void expectNewRefuses(std::vector<std::string> options, const std::string& text) const
    {
        std::vector<std::string> arguments = {"new", mesh(), "-o", path("new.trixel")};
        arguments.insert(arguments.end(), options.begin(), options.end());
        EXPECT_THAT(runTrixel(arguments), FailsWith(kUnusable, text))
            << testing::PrintToString(options);
        EXPECT_THAT(files(), ElementsAre("mesh.obj"));
    }
};

TEST_F(BadArguments, anUnknownVerbIsAnsweredWithTheKnownOnes)
{
    const ProgramRun run = runTrixel({"pant"});
    EXPECT_THAT(run, FailsWith(kUnusable, "'pant'"));
    EXPECT_THAT(run, FailsWith(kUnusable, "new, info, check"));
}

TEST_F(BadArguments, aWindowWithoutADisplayIsRefused)
{
    EXPECT_THAT(runTrixel({}), FailsWith(kUnusable, "--help"));
    EXPECT_THAT(runTrixel({mesh()}), FailsWith(kUnusable, "--help"));
    // Built without the window, the program has no such verb.
    const char* answer = TRIXEL_HAS_TOUR ? "--help" : "'tour' is neither a verb";
    EXPECT_THAT(runTrixel({"tour", "-o", path("tour")}), FailsWith(kUnusable, answer));
    EXPECT_THAT(files(), ElementsAre("mesh.obj"));
}

TEST_F(BadArguments, aFileForTheWindowThatIsNotThereIsNamed)
{
    EXPECT_THAT(runTrixel({path("missing.obj")}), FailsWith(kPath, "missing.obj"));
    EXPECT_THAT(runTrixel({write("a.fbx", "x")}), FailsWith(kUnusable, ".trixel"));
    EXPECT_THAT(runTrixel({mesh(), mesh()}), FailsWith(kUnusable, "one file"));
}

TEST_F(BadArguments, anUnknownOptionAndAMissingOneAreNamed)
{
    EXPECT_THAT(runTrixel({"--what"}), FailsWith(kUnusable, "--what"));
    EXPECT_THAT(runTrixel({"info", mesh(), "--what"}), FailsWith(kUnusable, "--what"));
    EXPECT_THAT(runTrixel({"info"}), FailsWith(kUnusable, "FILE"));
    EXPECT_THAT(runTrixel({"new", mesh()}), FailsWith(kUnusable, "--output"));
    EXPECT_THAT(runTrixel({"paint", "a.trixel", "-o", "b.trixel"}),
                FailsWith(kUnusable, "--strokes"));
}

TEST_F(BadArguments, anUnknownEndingIsAnsweredWithTheKnownOnes)
{
    EXPECT_THAT(runTrixel({"info", write("a.fbx", "x")}), FailsWith(kUnusable, ".trixel"));
    EXPECT_THAT(runTrixel({"new", write("a.fbx", "x"), "-o", path("a.trixel")}),
                FailsWith(kUnusable, ".stl"));
    EXPECT_THAT(runTrixel({"export", path("a.trixel"), "-o", path("a.jpg")}),
                FailsWith(kUnusable, ".ptx"));
    EXPECT_THAT(runTrixel({"new", mesh(), "-o", path("a.ptx")}), FailsWith(kUnusable, ".trixel"));
}

TEST_F(BadArguments, aLevelOutsideZeroToTwelveIsRefused)
{
    for (const char* level : {"13", "-1", "abc", "4.5", "", " 4", "99999999999999999999"}) {
        expectNewRefuses({std::string("--level=") + level}, "--level");
    }
}

TEST_F(BadArguments, aDensityOrTotalThatIsNoPositiveNumberIsRefused)
{
    for (const char* value : {"0", "-1", "nan", "inf", "1e999", "x", ""}) {
        expectNewRefuses({std::string("--density=") + value}, "--density");
    }
    for (const char* value : {"0", "-1", "1.5", "x"}) {
        expectNewRefuses({std::string("--texels=") + value}, "--texels");
    }
    // Four faces need four texels at least.
    expectNewRefuses({"--texels=3"}, "3");
    expectNewRefuses({"--level=2", "--texels=100"}, "--texels");
}

TEST_F(BadArguments, aTypeChannelCountOrFillThatDoesNotFitIsRefused)
{
    expectNewRefuses({"--type=double"}, "--type");
    expectNewRefuses({"--channels=0"}, "--channels");
    expectNewRefuses({"--channels=1025"}, "--channels");
    expectNewRefuses({"--fill=1,0"}, "--fill");
    expectNewRefuses({"--fill=1,0,0,1"}, "--fill");
    expectNewRefuses({"--fill=1,,0"}, "--fill");
    expectNewRefuses({"--fill=nan,0,0"}, "--fill");
    expectNewRefuses({"--fill=red"}, "--fill");
}

TEST_F(BadArguments, aNumberOfThreadsBelowOneIsRefused)
{
    const std::string from = project();
    for (const char* threads : {"0", "-2", "x", "100000"}) {
        EXPECT_THAT(runTrixel({"paint",
                               from,
                               "--strokes",
                               strokes(),
                               "-o",
                               path("b.trixel"),
                               std::string("--threads=") + threads}),
                    FailsWith(kUnusable, "--threads"));
    }
    EXPECT_FALSE(std::filesystem::exists(path("b.trixel")));
}

class BadStrokes : public CommandLine
{
protected:
    /// `trixel paint` refuses the text as a stroke file, naming the file and `text`.
    void expectPaintRefuses(const std::string& strokes, const std::string& text) const
    {
        const ProgramRun run = runTrixel({"paint",
                                          path("new.trixel"),
                                          "--strokes",
                                          write("bad.json", strokes),
                                          "-o",
                                          path("b.trixel")});
        EXPECT_THAT(run, FailsWith(kUnusable, text)) << strokes;
        EXPECT_THAT(run, FailsWith(kUnusable, "bad.json")) << strokes;
        EXPECT_FALSE(std::filesystem::exists(path("b.trixel")));
    }

    /// The good stroke file with one piece of text replaced.
    std::string with(const std::string& piece, const std::string& other) const
    {
        std::string text = contentsOf(strokes());
        const std::size_t at = text.find(piece);
        EXPECT_NE(at, std::string::npos) << piece;
        return text.replace(at, piece.size(), other);
    }
};

TEST_F(BadStrokes, aBrushOfNoRadiusIsRefused)
{
    project();
    for (const char* radius : {"0", "-1", "null", "1e999", "\"nan\"", "[]", "NaN"}) {
        expectPaintRefuses(with("\"radius\":0.1", std::string("\"radius\":") + radius), "");
    }
    expectPaintRefuses(with("\"radius\":0.1", "\"radius\":0"), "radius");
}

TEST_F(BadStrokes, settingsAndFacesOutOfRangeAreRefused)
{
    project();
    expectPaintRefuses(with("\"opacity\":1", "\"opacity\":1.5"), "opacity");
    expectPaintRefuses(with("\"flow\":1", "\"flow\":-1"), "flow");
    expectPaintRefuses(with("\"spacing\":0.1", "\"spacing\":0"), "spacing");
    expectPaintRefuses(with("\"blend\":\"normal\"", "\"blend\":\"sparkle\""), "sparkle");
    expectPaintRefuses(with("\"face\":2", "\"face\":4"), "face");
    expectPaintRefuses(with("\"face\":2", "\"face\":-1"), "face");
    expectPaintRefuses(with("\"version\":1", "\"version\":2"), "version");
}

TEST_F(BadStrokes, textThatIsNoStrokeFileIsRefused)
{
    project();
    const std::string whole = contentsOf(strokes());
    for (const std::string& text : {std::string(),
                                    std::string("{}"),
                                    std::string("[]"),
                                    std::string("x"),
                                    whole + "x",
                                    whole.substr(0, whole.size() / 2),
                                    std::string(100'000, '['),
                                    std::string("\xff\xfe\0", 3)}) {
        expectPaintRefuses(text, "");
    }
}

class BadPath : public CommandLine
{
};

TEST_F(BadPath, aFileThatCannotBeReadIsNamed)
{
    const std::string from = project();
    for (const std::string ending : {".obj", ".ply", ".stl", ".off", ".ptx", ".trixel"}) {
        const std::string missing = path("missing" + ending);
        const std::string folder = path("folder" + ending);
        const std::string pipe = path("pipe" + ending); // opening one would wait for a writer
        std::filesystem::create_directory(folder);
        ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
        for (const std::string& file : {missing, folder, pipe}) {
            EXPECT_THAT(runTrixel({"info", file}), FailsWith(kPath, file));
            EXPECT_THAT(runTrixel({"check", file}), FailsWith(kPath, file));
        }
    }
    EXPECT_THAT(runTrixel({"new", path("missing.obj"), "-o", path("a.trixel")}),
                FailsWith(kPath, "missing.obj"));
    EXPECT_THAT(
        runTrixel({"paint", from, "--strokes", path("missing.json"), "-o", path("a.trixel")}),
        FailsWith(kPath, "missing.json"));
    EXPECT_THAT(runTrixel({"export", path("missing.trixel"), "-o", path("a.ptx")}),
                FailsWith(kPath, "missing.trixel"));
    EXPECT_THAT(runTrixel({"convert", path("missing.ptx"), path("a.ptx")}),
                FailsWith(kPath, "missing.ptx"));
    EXPECT_THAT(runTrixel({"diff", path("missing.ptx"), path("other.ptx")}),
                FailsWith(kPath, "missing.ptx"));
    EXPECT_FALSE(std::filesystem::exists(path("a.trixel")));
    EXPECT_FALSE(std::filesystem::exists(path("a.ptx")));
}

TEST_F(BadPath, aTargetThatCannotBeWrittenIsNamed)
{
    const std::string from = project();
    std::filesystem::create_directory(path("folder.trixel"));
    // The last: a file system that takes no files, whoever asks.
    for (const std::string& target :
         {path("no/such/folder/a.trixel"), path("folder.trixel"), std::string("/proc/a.trixel")}) {
        EXPECT_THAT(runTrixel({"new", mesh(), "-o", target}), FailsWith(kPath, target));
    }
    EXPECT_THAT(runTrixel({"export", from, "-o", path("no/such/folder/a.ptx")}),
                FailsWith(kPath, "a.ptx"));
    EXPECT_THAT(files(), ElementsAre("folder.trixel", "mesh.obj", "new.trixel"));
}

TEST_F(BadPath, aReadOnlyTargetStaysWhoeverAsks)
{
    const std::string from = project();
    const std::string target = write("a.ptx", "precious");
    std::filesystem::permissions(target, std::filesystem::perms(0444));
    EXPECT_THAT(runTrixel({"export", from, "-o", target}), FailsWith(kPath, "read-only"));
    EXPECT_EQ(contentsOf(target), "precious");
}

TEST_F(BadPath, aDeviceIsNeverReplacedByAFile)
{
    const std::string from = project();
    std::filesystem::create_symlink("/dev/full", path("a.ptx"));
    EXPECT_THAT(runTrixel({"export", from, "-o", path("a.ptx")}), FailsWith(kPath, "/dev/full"));
    EXPECT_TRUE(std::filesystem::is_symlink(path("a.ptx")));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST_F(BadPath, aFullDiskLeavesWhatWasThere)
{
    const std::string from = project({"--level", "8"});
    ASSERT_THAT(runTrixel({"export", from, "-o", path("a.ptx")}), EndsWith(0));
    const std::string before = contentsOf(path("a.ptx"));
    const std::string painted = path("b.trixel");
    ASSERT_THAT(runTrixel({"paint", from, "--strokes", strokes(), "-o", painted}), EndsWith(0));
    const auto filesBefore = files();

    RunOptions full;
    full.fileSizeLimit = 4096;
    ASSERT_GT(std::filesystem::file_size(painted), full.fileSizeLimit);
    EXPECT_THAT(runTrixel({"export", painted, "-o", path("a.ptx")}, full),
                FailsWith(kPath, "a.ptx"));
    EXPECT_EQ(contentsOf(path("a.ptx")), before);
    EXPECT_THAT(files(), testing::ContainerEq(filesBefore));
}

TEST_F(BadPath, standardOutputThatTakesNothingIsReported)
{
    RunOptions full;
    full.standardOutput = "/dev/full";
    EXPECT_THAT(runTrixel({"info", mesh()}, full), FailsWith(kPath, "tandard output"));
}

TEST_F(BadPath, anEmptyFileIsUnusable)
{
    for (const char* ending : {".obj", ".ply", ".stl", ".off", ".ptx", ".trixel"}) {
        const std::string file = write(std::string("empty") + ending, "");
        EXPECT_THAT(runTrixel({"info", file}), FailsWith(kUnusable, file));
        EXPECT_THAT(runTrixel({"check", file}), FailsWith(kUnusable, file));
    }
}

TEST_F(BadPath, aNameWithALineBreakStillGivesOneLine)
{
    EXPECT_THAT(runTrixel({"info", path("a\nb.obj")}), FailsWith(kPath, "b.obj"));
}

TEST_F(BadPath, controlCStopsTheWorkAndLeavesNothingBehind)
{
    const std::string from = project({"--level", "10"});
    nlohmann::json file = jsonOf(contentsOf(strokes({{"radius", 0.3}})));
    const nlohmann::json stroke = file["strokes"][0];
    for (int i = 0; i < 2000; ++i) { // minutes of work
        file["strokes"].push_back(stroke);
    }
    const std::string many = write("strokes.json", file.dump());
    const auto filesBefore = files();

    RunOptions interrupted;
    interrupted.signal = SIGINT;
    interrupted.signalAfterMs = 300;
    const ProgramRun run =
        runTrixel({"paint", from, "--strokes", many, "-o", path("b.trixel")}, interrupted);
    // On a very slow machine the signal ends the program before the work begins.
    EXPECT_THAT(run.status, AnyOf(130, -SIGINT)) << run.err;
    EXPECT_LT(run.cpuSeconds, 20);
    EXPECT_THAT(files(), testing::ContainerEq(filesBefore));
}

/// Files that crash, hang or mislead other readers.
class HostileFile : public CommandLine, public testing::WithParamInterface<std::filesystem::path>
{
};

TEST_P(HostileFile, opensRightOrIsRefusedInASentence)
{
    for (const char* verb : {"info", "check"}) {
        const ProgramRun run = runTrixel({verb, GetParam().string()});
        EXPECT_THAT(run.status, AnyOf(0, kFaults, kUnusable)) << verb << ": " << run.err;
        EXPECT_EQ(run.status == kUnusable, !run.err.empty()) << verb << ": " << run.err;
        if (run.status == kUnusable) {
            EXPECT_THAT(run, FailsWith(kUnusable, GetParam().filename().string())) << verb;
        }
        EXPECT_LT(run.cpuSeconds, 2) << verb;
    }
}

std::vector<std::filesystem::path> filesUnder(const char* folder)
{
    std::vector<std::filesystem::path> found;
    const auto root = std::filesystem::path(TRIXEL_TEST_DATA) / folder;
    if (std::filesystem::is_directory(root)) {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
            if (entry.is_regular_file()) {
                found.push_back(entry.path());
            }
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

INSTANTIATE_TEST_SUITE_P(Hostile, HostileFile, testing::ValuesIn(filesUnder("hostile")));
INSTANTIATE_TEST_SUITE_P(MeshCases, HostileFile, testing::ValuesIn(filesUnder("mesh-cases")));
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(HostileFile);

} // namespace
} // namespace trixel::test
