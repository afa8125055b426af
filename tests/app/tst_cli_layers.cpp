// SPDX-License-Identifier: GPL-3.0-or-later
//
// Projects with layers through the built program: made, painted, told of, exported and back.
#include "tests/app/cli_test.h"

namespace trixel::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class CliLayers : public CommandLine
{
protected:
    /// The test's stroke on a layer.
    std::string strokesOn(int layer) const
    {
        nlohmann::json file = jsonOf(contentsOf(strokes()));
        file["strokes"][0]["layer"] = layer;
        return write("layer-strokes.json", file.dump());
    }

    std::string
    edited(const std::string& from, const std::string& to, std::vector<std::string> edit) const
    {
        edit.insert(edit.begin(), {"layers", from, "-o", path(to)});
        EXPECT_THAT(runTrixel(edit), EndsWith(0));
        return path(to);
    }

    /// A grey project with a stroke on the layer "Lines", and "Shade" above it, which is empty.
    std::string layered() const
    {
        const std::string one = edited(project(), "one.trixel", {"--add", "Lines"});
        const std::string to = path("painted.trixel");
        EXPECT_THAT(runTrixel({"paint", one, "--strokes", strokesOn(1), "-o", to}), EndsWith(0));
        return edited(to,
                      "layered.trixel",
                      {"--add", "Shade", "--opacity", "0.5", "--blend", "multiply", "--hide"});
    }

    std::string exported(const std::string& project,
                         const std::string& name,
                         std::vector<std::string> options = {}) const
    {
        options.insert(options.begin(), {"export", project, "-o", path(name)});
        EXPECT_THAT(runTrixel(options), EndsWith(0)) << name;
        return path(name);
    }

    static nlohmann::json difference(const std::string& a, const std::string& b)
    {
        return jsonOf(runTrixel({"diff", a, b, "--json"}).out);
    }
    static nlohmann::json info(const std::string& file)
    {
        return jsonOf(runTrixel({"info", file, "--json"}).out);
    }
};

TEST_F(CliLayers, paintOnALayerShowsAndLeavesTheBase)
{
    const std::string plain = exported(project(), "plain.ptx");
    const std::string from = layered();
    const std::string shown = exported(from, "shown.ptx");
    EXPECT_EQ(difference(plain, shown)["faces"].size(), 2U);
    EXPECT_THAT(difference(plain, exported(from, "base.ptx", {"--layer", "0"}))["faces"],
                IsEmpty());
    // As painted onto a project without layers, but for the rounding of what is half covered.
    ASSERT_THAT(
        runTrixel(
            {"paint", path("new.trixel"), "--strokes", strokes(), "-o", path("direct.trixel")}),
        EndsWith(0));
    EXPECT_LE(difference(shown, exported(path("direct.trixel"), "direct.ptx"))["maxAbs"],
              1.001 / 255);
}

TEST_F(CliLayers, paintTakesATextureThatDoesNotTellItsColour)
{
    const std::string texture = exported(project(), "grey.ptx", {"--channels", "0,1,2"});
    const std::string to = path("painted.trixel");
    ASSERT_THAT(runTrixel({"paint", texture, "--strokes", strokes(), "-o", to}), EndsWith(0));
    ASSERT_THAT(
        runTrixel({"paint", path("new.trixel"), "--strokes", strokes(), "-o", path("p.trixel")}),
        EndsWith(0));
    EXPECT_THAT(difference(exported(to, "a.ptx"), exported(path("p.trixel"), "b.ptx"))["faces"],
                IsEmpty());
}

TEST_F(CliLayers, aLayerThatIsNotThereIsNotPainted)
{
    const std::string from = layered();
    EXPECT_THAT(runTrixel({"paint", from, "--strokes", strokesOn(3), "-o", path("no.trixel")}),
                FailsWith(2, "stroke 1: layer 3 is not there; the project has 2 layers"));
}

TEST_F(CliLayers, infoListsThemBelowEachOther)
{
    const std::string from = layered();
    EXPECT_THAT(runTrixel({"info", from}).out,
                AllOf(HasSubstr("layer 2         \"Shade\", multiply, opacity 0.5, hidden\n"
                                "layer 1         \"Lines\", normal, opacity 1\n"),
                      HasSubstr("uint8, 3 channels"),
                      Not(HasSubstr("TrixelLayers"))));
    const nlohmann::json json = info(from);
    EXPECT_EQ(json["channels"], 3);
    EXPECT_EQ(
        json["layers"],
        nlohmann::json::array(
            {{{"name", "Lines"}, {"opacity", 1}, {"blend", "normal"}, {"visible", true}},
             {{"name", "Shade"}, {"opacity", 0.5}, {"blend", "multiply"}, {"visible", false}}}));
    EXPECT_THAT(info(path("new.trixel"))["layers"], IsEmpty());
    EXPECT_THAT(runTrixel({"check", from}), EndsWith(0));
}

TEST_F(CliLayers, savingAgainKeepsEveryLayerToTheBit)
{
    const std::string from = layered();
    const std::string again = edited(from, "again.trixel", {"--layer", "Lines", "--show"});
    EXPECT_EQ(contentsOf(again), contentsOf(from));
    EXPECT_EQ(info(again)["layers"], info(from)["layers"]);
}

TEST_F(CliLayers, aProjectWhoseLayersAreRemovedIsTheFileItWas)
{
    const std::string plain = project();
    const std::string one = edited(plain, "one.trixel", {"--add", "Lines"});
    EXPECT_NE(contentsOf(one), contentsOf(plain));
    EXPECT_EQ(contentsOf(edited(one, "none.trixel", {"--remove", "Lines"})), contentsOf(plain));
}

TEST_F(CliLayers, aLayerLeavesAloneWithItsCoverageAsOpacity)
{
    const std::string from = layered();
    const std::string lines = exported(from, "lines.ptx", {"--layer", "Lines"});
    EXPECT_EQ(info(lines)["channels"], 4);
    EXPECT_EQ(info(lines)["alpha"], 3);
    EXPECT_THAT(info(lines)["layers"], IsEmpty());
    EXPECT_EQ(info(lines)["constantFaces"], 2); // those that the stroke does not reach
    EXPECT_THAT(runTrixel({"check", lines, "--mesh", path("mesh.obj")}), EndsWith(0));
    // The layer's opacity is in the coverage, whether it is shown or not.
    const std::string half =
        edited(from, "half.trixel", {"--layer", "1", "--opacity", "0.5", "--hide"});
    const nlohmann::json halved =
        difference(exported(from, "a.ptx", {"--layer", "1", "--channels", "3"}),
                   exported(half, "b.ptx", {"--layer", "1", "--channels", "3"}));
    EXPECT_NEAR(halved["maxAbs"], 0.5, 0.5 / 255);
    EXPECT_THAT(difference(exported(from, "c.ptx", {"--layer", "1", "--channels", "0-2"}),
                           exported(half, "d.ptx", {"--layer", "1", "--channels", "0-2"}))["faces"],
                IsEmpty());
}

TEST_F(CliLayers, aLayerComesBackFromAPackedAtlasToTheBit)
{
    const std::string from = layered();
    const std::string lines = exported(from, "lines.ptx", {"--layer", "Lines"});
    for (const char* name : {"a.png", "a.exr", "a.tif"}) {
        exported(from, name, {"--layer", "Lines"});
        ASSERT_THAT(
            runTrixel(
                {"new", path("mesh.obj"), "-o", path("back.trixel"), "--atlas", path("a.json")}),
            EndsWith(0));
        EXPECT_THAT(difference(lines, exported(path("back.trixel"), "back.ptx"))["faces"],
                    IsEmpty())
            << name;
    }
}

TEST_F(CliLayers, facesAndChannelsOfALayerLeaveTogether)
{
    const std::string from = layered();
    const std::string part =
        exported(from, "part.ptx", {"--layer", "Lines", "--faces", "1-2", "--channels", "3,0"});
    EXPECT_EQ(info(part)["faces"], 2);
    EXPECT_EQ(info(part)["channels"], 2);
    EXPECT_EQ(info(part)["alpha"], 0);
    EXPECT_EQ(info(part)["constantFaces"], 0);
    EXPECT_THAT(
        runTrixel({"export", from, "-o", path("no.ptx"), "--layer", "Lines", "--channels", "4"}),
        FailsWith(2, "there is no channel 4: 4 channels"));
}

TEST_F(CliLayers, meshesAndImagesByUvsTakeALayer)
{
    write("uvs.obj",
          "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\n"
          "f 1/1 2/2 3/3\nf 4/4 3/3 2/2\nf 2/2 1/1 4/4\n");
    ASSERT_THAT(runTrixel({"new", path("uvs.obj"), "-o", path("new.trixel"), "--level", "3"}),
                EndsWith(0));
    const std::string one = edited(path("new.trixel"), "one.trixel", {"--add", "Lines"});
    ASSERT_THAT(runTrixel({"paint", one, "--strokes", strokesOn(1), "-o", path("p.trixel")}),
                EndsWith(0));
    for (const char* name : {"a.glb", "b.obj"}) {
        exported(path("p.trixel"), name, {"--layer", "Lines"});
    }
    EXPECT_THAT(contentsOf(path("a.glb")), HasSubstr("alphaMode")); // opacity is told of
    ASSERT_THAT(runTrixel({"bake-out",
                           path("p.trixel"),
                           "-o",
                           path("uv.png"),
                           "--size",
                           "64",
                           "--layer",
                           "Lines"}),
                EndsWith(0));
    constexpr std::size_t kColorType = 25; // of a PNG: 6 is RGBA
    EXPECT_EQ(contentsOf(path("uv.png"))[kColorType], 6);
}

TEST_F(CliLayers, namesThatMeanNoLayerOrSeveralAreAnsweredWithThoseThereAre)
{
    const std::string from = layered();
    const auto exporting = [&](const std::string& layer) {
        return runTrixel({"export", from, "-o", path("no.ptx"), "--layer", layer});
    };
    EXPECT_THAT(exporting("lines"),
                FailsWith(2,
                          "--layer: there is no layer \"lines\"; the layers are 0 (the base), "
                          "1 \"Lines\", 2 \"Shade\""));
    EXPECT_THAT(exporting("3"), FailsWith(2, "--layer: there is no layer 3; the layers are 0"));
    EXPECT_THAT(exporting("99999999999999999999"), FailsWith(2, "there is no layer 9999"));
    EXPECT_THAT(runTrixel({"export", path("new.trixel"), "-o", path("no.ptx"), "--layer", "1"}),
                FailsWith(2, "there is no layer 1; the layers are 0 (the base)"));
    const std::string twice = edited(from, "twice.trixel", {"--add", "Lines"});
    EXPECT_THAT(runTrixel({"export", twice, "-o", path("no.ptx"), "--layer", "Lines"}),
                FailsWith(2, "--layer: 2 layers are called \"Lines\", expected the number of one"));
    EXPECT_THAT(files(), Not(testing::Contains("no.ptx")));
}

TEST_F(CliLayers, layersAreMovedMergedAndSet)
{
    const std::string from = layered();
    const nlohmann::json moved = info(edited(
        from, "a.trixel", {"--layer", "Shade", "--place", "1", "--name", "Below", "--show"}));
    EXPECT_EQ(moved["layers"][0]["name"], "Below");
    EXPECT_EQ(moved["layers"][0]["visible"], true);
    EXPECT_EQ(moved["layers"][1]["name"], "Lines");
    const std::string shown = exported(from, "shown.ptx");
    const std::string merged = edited(from, "b.trixel", {"--merge", "Lines"});
    EXPECT_EQ(info(merged)["layers"].size(), 1U);
    EXPECT_THAT(difference(shown, exported(merged, "merged.ptx"))["faces"], IsEmpty());
}

TEST_F(CliLayers, editsThatCannotBeAreRefused)
{
    const std::string from = layered();
    const auto refuses = [&](std::vector<std::string> edit) {
        edit.insert(edit.begin(), {"layers", from, "-o", path("no.trixel")});
        return runTrixel(edit);
    };
    EXPECT_THAT(refuses({}), FailsWith(2, "expected one of --add, --layer, --remove and --merge"));
    EXPECT_THAT(refuses({"--add", "a", "--remove", "Lines"}), FailsWith(2, "expected one of"));
    EXPECT_THAT(refuses({"--remove", "Lines", "--hide"}), FailsWith(2, "nothing is set"));
    EXPECT_THAT(refuses({"--remove", "0"}),
                FailsWith(2, "--remove: expected a layer above the base, found 0"));
    EXPECT_THAT(refuses({"--remove", "Line"}), FailsWith(2, "there is no layer \"Line\""));
    EXPECT_THAT(refuses({"--merge", "Shade"}), FailsWith(2, "--merge: the layer is hidden"));
    EXPECT_THAT(refuses({"--layer", "1", "--opacity", "1.5"}), FailsWith(2, "--opacity"));
    EXPECT_THAT(refuses({"--layer", "1", "--opacity", "nan"}), FailsWith(2, "--opacity"));
    EXPECT_THAT(refuses({"--layer", "1", "--blend", "glow"}),
                FailsWith(2, "--blend: expected one of normal, multiply, screen"));
    EXPECT_THAT(refuses({"--layer", "1", "--place", "3"}), FailsWith(2, "--place"));
    EXPECT_THAT(refuses({"--layer", "1", "--show", "--hide"}), FailsWith(2, "--hide"));
    EXPECT_THAT(files(), Not(testing::Contains("no.trixel")));
}

TEST_F(CliLayers, paintIsNotMergedOntoAHiddenLayer)
{
    const std::string over = edited(layered(), "over.trixel", {"--add", "Over"}); // "Shade"
    EXPECT_THAT(runTrixel({"layers", over, "--merge", "Over", "-o", path("no.trixel")}),
                FailsWith(2, "--merge: the layer below is hidden"));
}

TEST_F(CliLayers, aPictureBecomesALayerOfItsOwn)
{
    const std::string from = layered();
    ASSERT_THAT(runTrixel({"bake",
                           from,
                           "--map",
                           "sphere",
                           "--image",
                           "/usr/share/mujoco/model/mug/mug.png",
                           "-o",
                           path("baked.trixel")}),
                EndsWith(0));
    const std::string baked = path("baked.trixel");
    ASSERT_EQ(info(baked)["layers"].size(), 3U);
    EXPECT_EQ(info(baked)["layers"][2]["name"], "Image");
    EXPECT_THAT(difference(exported(from, "a.ptx", {"--layer", "1"}),
                           exported(baked, "b.ptx", {"--layer", "1"}))["faces"],
                IsEmpty());
    EXPECT_EQ(difference(exported(from, "c.ptx"), exported(baked, "d.ptx"))["faces"].size(), 4U);
}

TEST_F(CliLayers, aFitChangesTheLevelsOfAll)
{
    const std::string from = layered();
    const std::string cameras =
        write("cameras.json",
              R"({"version":1,"cameras":[{"name":"far","position":[3,40,40],)"
              R"("target":[0.3,0.3,0.3],"fovY":20,"size":[80,60]}]})");
    ASSERT_THAT(runTrixel({"fit", from, "--cameras", cameras, "-o", path("fitted.trixel")}),
                EndsWith(0));
    const nlohmann::json fitted = info(path("fitted.trixel"));
    EXPECT_EQ(fitted["layers"], info(from)["layers"]);
    EXPECT_LT(fitted["texels"], info(from)["texels"]);
    EXPECT_EQ(info(exported(path("fitted.trixel"), "a.ptx", {"--layer", "1"}))["levels"],
              fitted["levels"]);
}

TEST_F(CliLayers, paintFromElsewhereBecomesALayerOfItsOwn)
{
    const std::string from = layered();
    const std::string mesh = write("moved.obj", "v 0 0 -0.01\nv 1 0 -0.01\nv 0 1 -0.01\nf 1 3 2\n");
    ASSERT_THAT(
        runTrixel({"new", mesh, "-o", path("green.trixel"), "--level", "4", "--fill", "0,1,0"}),
        EndsWith(0));
    ASSERT_THAT(runTrixel({"transfer",
                           path("green.trixel"),
                           from,
                           "-o",
                           path("got.trixel"),
                           "--distance",
                           "0.02"}),
                EndsWith(0));
    const nlohmann::json got = info(path("got.trixel"));
    ASSERT_EQ(got["layers"].size(), 3U);
    EXPECT_EQ(got["layers"][2]["name"], "Transferred paint");
    for (const char* layer : {"0", "1", "2"}) {
        EXPECT_THAT(difference(exported(from, "a.ptx", {"--layer", layer}),
                               exported(path("got.trixel"), "b.ptx", {"--layer", layer}))["faces"],
                    IsEmpty());
    }
    // What is shown is as if there had been no layers.
    const std::string flat = exported(from, "flat.ptx");
    ASSERT_THAT(runTrixel({"transfer",
                           path("green.trixel"),
                           flat,
                           "-o",
                           path("direct.trixel"),
                           "--distance",
                           "0.02"}),
                EndsWith(0));
    EXPECT_THAT(difference(exported(path("direct.trixel"), "direct.ptx"),
                           exported(path("got.trixel"), "got.ptx"))["faces"],
                IsEmpty());
}

} // namespace
} // namespace trixel::test
