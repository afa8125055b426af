// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/cli_test.h"

namespace trixel::test {
namespace {

class Fit : public CommandLine
{
protected:
    std::string painted() const
    {
        const std::string plain = project();
        EXPECT_THAT(runTrixel({"paint", plain, "--strokes", strokes(), "-o", path("p.trixel")}),
                    EndsWith(0));
        return path("p.trixel");
    }
    /// Far enough that a face is a few pixels wide.
    std::string cameras() const
    {
        return write("cameras.json",
                     R"({"version":1,"cameras":[{"name":"far","position":[3,40,40],)"
                     R"("target":[0.3,0.3,0.3],"fovY":20,"size":[80,60]}]})");
    }
};

TEST_F(Fit, writesAProjectOfFewerTexelsAndTellsThem)
{
    const auto run = runTrixel(
        {"fit", painted(), "--cameras", cameras(), "-o", path("fitted.trixel"), "--json"});
    ASSERT_THAT(run, EndsWith(0));
    const auto json = jsonOf(run.out);
    EXPECT_EQ(json["texelsBefore"], 1024);
    EXPECT_LT(json["texelsAfter"], 1024);
    EXPECT_EQ(json["bytesAfter"], json["texelsAfter"].get<int>() * 3);
    EXPECT_LE(json["worstPart"], json["tolerance"]);
    EXPECT_EQ(json["facesUnseen"], 0);
    EXPECT_TRUE(json.contains("subdivision"));

    const auto info = jsonOf(runTrixel({"info", path("fitted.trixel"), "--json"}).out);
    EXPECT_EQ(info["texels"], json["texelsAfter"]) << info.dump();
}

TEST_F(Fit, dryRunWritesNothing)
{
    const std::string file = painted();
    const std::string views = cameras();
    const auto before = files();
    const auto run =
        runTrixel({"fit", file, "--cameras", views, "--tolerance", "2/255", "--dry-run"});
    EXPECT_THAT(run, EndsWith(0));
    EXPECT_THAT(run.out, testing::HasSubstr("times fewer"));
    EXPECT_EQ(files(), before);
}

TEST_F(Fit, facesThatNoCameraSeesKeepOneTexelUnlessTheyAreWanted)
{
    const std::string file = painted();
    // From straight below: the other three faces are hidden.
    const std::string views = write("below.json",
                                    R"({"version":1,"cameras":[{"position":[0.3,0.3,-5],)"
                                    R"("target":[0.3,0.3,0],"fovY":20,"size":[800,600]}]})");
    const auto fitted = [&](const std::vector<std::string>& choice) {
        std::vector<std::string> arguments = {
            "fit", file, "--cameras", views, "--dry-run", "--json"};
        arguments.insert(arguments.end(), choice.begin(), choice.end());
        return jsonOf(runTrixel(arguments).out);
    };
    const auto one = fitted({});
    EXPECT_EQ(one["unseen"], "one-texel");
    const auto all = fitted({"--unseen", "by-distance"});
    EXPECT_EQ(all["unseen"], "by-distance");
    for (const auto& json : {one, all}) {
        EXPECT_EQ(json["facesUnseen"], 3);
        EXPECT_EQ(json["texelsUnseenBefore"], 768);
    }
    EXPECT_LT(one["texelsUnseenAfter"], all["texelsUnseenAfter"]);
    EXPECT_LT(one["texelsAfter"], all["texelsAfter"]);
}

TEST_F(Fit, unusableArgumentsAreNamed)
{
    const std::string file = painted();
    const std::string views = cameras();
    const std::string out = path("o.trixel");
    EXPECT_THAT(runTrixel({"fit", file, "--cameras", views}), FailsWith(2, "--dry-run"));
    EXPECT_THAT(runTrixel({"fit", file, "--cameras", views, "-o", path("o.ptx")}),
                FailsWith(2, ".trixel"));
    for (const std::string tolerance : {"0", "-1", "1/0", "x", "1/2/3", "nan"}) {
        EXPECT_THAT(
            runTrixel({"fit", file, "--cameras", views, "--tolerance", tolerance, "-o", out}),
            FailsWith(2, "--tolerance"));
    }
    EXPECT_THAT(runTrixel({"fit", file, "--cameras", views, "--unseen", "all", "-o", out}),
                FailsWith(2, "--unseen: expected one-texel or by-distance"));
    EXPECT_THAT(runTrixel({"fit", file, "--cameras", path("none.json"), "-o", out}),
                FailsWith(3, "none.json"));
    const std::string bad = write("bad.json", R"({"version":1,"cameras":[{}]})");
    EXPECT_THAT(runTrixel({"fit", file, "--cameras", bad, "-o", out}),
                FailsWith(2, "bad.json: camera 1: position is missing"));
    EXPECT_FALSE(std::filesystem::exists(out));
}

} // namespace
} // namespace trixel::test
