// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/atlas/atlas_address.h"
#include "core/atlas/page_pixels.h"
#include "core/io/atlas/atlas_description.h"
#include "core/io/atlas/export_atlas.h"
#include "core/io/channel_colors.h"
#include "core/io/new_project.h"
#include "tests/core/io/image/image_fixture.h"
#include "tests/core/test_meshes.h"

#include <gmock/gmock.h>
#include <random>
#include <set>

using namespace trixel;
using namespace trixel::test;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

/// A sphere of mixed levels and random texels; some faces are constant.
Project anyProject(const TexelFormat& format, int finest = 5)
{
    NoProgress progress;
    const TriangleMesh mesh = sphereMesh(1);
    FaceMap<Level> levels(mesh.faceCount());
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        levels[faceId(f)] = Level(static_cast<int>(f % static_cast<std::size_t>(finest + 1)));
    }
    Project project{*Surface::build(mesh, progress),
                    TexelStore(format, levels, std::vector<std::byte>(format.texelBytes())),
                    {}};
    std::mt19937 random(7);
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        if (f % 5 == 4) {
            continue;
        }
        const std::span<std::byte> texels = project.texels.writable(faceId(f));
        std::vector<float> values(texels.size() / byteSize(format.type));
        for (float& value : values) {
            value = static_cast<float>(random() >> 8U) / 16777216.0F;
        }
        encode(format.type, values, texels);
    }
    return project;
}

bool sameTexels(const TexelStore& a, const TexelStore& b)
{
    if (a.faceCount() != b.faceCount() || a.format() != b.format()) {
        return false;
    }
    for (std::uint32_t f = 0; f < a.faceCount(); ++f) {
        if (!(a.face(faceId(f)) == b.face(faceId(f)))) {
            return false;
        }
    }
    return true;
}

class AtlasFiles : public ImageFiles
{
protected:
    std::vector<std::string> files() const
    {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            names.push_back(entry.path().filename().string());
        }
        std::ranges::sort(names);
        return names;
    }
    Status exportPacked(const std::string& name,
                        const Project& project,
                        const PackedExportOptions& options = {}) const
    {
        NoProgress progress;
        return exportPackedAtlas(worker, at(name), project, options, progress);
    }
    Result<TexelStore> readPacked(const std::string& name) const
    {
        NoProgress progress;
        auto read = readPackedAtlas(worker, at(name), Threads{2}, progress);
        if (!read) {
            return tl::unexpected(read.error());
        }
        return std::move(read->texels);
    }
};

using AtlasText = AtlasFiles;

TEST_F(AtlasFiles, facesComeBackToTheBitThroughEveryFormat)
{
    const TexelFormat bytes{TexelType::UInt8, 3, std::nullopt};
    const TexelFormat shorts{TexelType::UInt16, 4, 3};
    const TexelFormat halves{TexelType::Half, 4, 3};
    const TexelFormat floats{TexelType::Float, 2, std::nullopt};
    const std::vector<std::pair<TexelFormat, std::vector<std::string>>> cases = {
        {bytes, {"a.png", "a.exr"}},
        {shorts, {"a.png", "a.tif"}},
        {halves, {"a.exr"}},
        {floats, {"a.tif"}},
        // Names that do not sort as numbers do, and opacity where only the description says it.
        {{TexelType::Float, 23, std::nullopt}, {"a.exr"}},
        {{TexelType::Half, 5, 4}, {"a.exr"}},
        {{TexelType::UInt16, 4, 0}, {"a.tif", "a.exr"}},
        {{TexelType::UInt8, 4, std::nullopt}, {"a.png", "a.tif"}}};
    for (const auto& [format, names] : cases) {
        const Project project = anyProject(format);
        for (const std::string& name : names) {
            PackedExportOptions options;
            options.layout.mips = name == "a.tif";
            const Status written = exportPacked(name, project, options);
            ASSERT_TRUE(written) << written.error().message;
            const auto back = readPacked("a.json");
            ASSERT_TRUE(back) << back.error().message;
            EXPECT_TRUE(sameTexels(*back, project.texels)) << name;
            EXPECT_EQ(back->format(), format) << name;
        }
    }
}

TEST_F(AtlasFiles, severalPagesAreNumberedAndSaidBefore)
{
    const Project project = anyProject({TexelType::UInt8, 3, std::nullopt});
    PackedExportOptions options;
    options.layout.largestPage = 140;
    const auto estimate = estimatePackedAtlas(at("a.png"), project, options);
    ASSERT_TRUE(estimate);
    ASSERT_GE(estimate->pages.size(), 2U);
    EXPECT_GT(estimate->occupancy, 0.2);
    EXPECT_TRUE(estimate->otherOccupancy);
    ASSERT_TRUE(exportPacked("a.png", project, options));
    std::vector<std::string> expected = estimate->files;
    std::ranges::sort(expected);
    EXPECT_EQ(files(), expected);
    EXPECT_THAT(expected, testing::Contains("a.1.png"));
    for (std::size_t k = 0; k < estimate->pages.size(); ++k) {
        const auto page = read(at(estimate->files[k]));
        ASSERT_TRUE(page);
        EXPECT_EQ(static_cast<std::uint32_t>(page->width()), estimate->pages[k].width);
        EXPECT_EQ(static_cast<std::uint32_t>(page->height()), estimate->pages[k].height);
        EXPECT_EQ(page->colors(), uniformColors(ColorSpace::SRgb, 3, {}));
    }
    EXPECT_TRUE(sameTexels(*readPacked("a.json"), project.texels));
}

/// What a shader reads is in the JSON file, and the function beside it.
TEST_F(AtlasFiles, theTableAndTheAddressFunctionAreThere)
{
    const Project project = anyProject({TexelType::UInt8, 3, std::nullopt});
    PackedExportOptions options;
    options.layout.mips = true;
    ASSERT_TRUE(exportPacked("a.png", project, options));
    const auto json = nlohmann::json::parse(bytesOf(at("a.json")));
    FaceMap<Level> levels(project.texels.faceCount());
    for (std::uint32_t f = 0; f < project.texels.faceCount(); ++f) {
        levels[faceId(f)] = project.texels.face(faceId(f)).level();
    }
    const AtlasLayout layout = *AtlasLayout::plan(levels, options.layout);
    EXPECT_EQ(json["table"].get<std::vector<std::uint32_t>>(), atlasTable(layout));
    EXPECT_EQ(json["shader"], "a.glsl");
    EXPECT_THAT(bytesOf(at("a.glsl")), HasSubstr("vec4 atlasTrilinear("));
    for (std::size_t f = 0; f < levels.size(); ++f) {
        const AtlasPlace place = layout.place(faceId(f), levels[faceId(f)]);
        EXPECT_EQ(json["faces"]["x"][f], place.origin.x);
        EXPECT_EQ(json["faces"]["rank"][f], layout.rank(faceId(f)));
    }
    for (const auto& level : json["levels"]) {
        EXPECT_EQ(level["finerFaces"], layout.finerFaces(Level(level["level"].get<int>())));
    }
}

TEST_F(AtlasFiles, whatCannotBeWrittenIsRefusedBeforeAnyWork)
{
    const Project floats = anyProject({TexelType::Float, 7, std::nullopt}, 2);
    const auto message = [](const Status& status) {
        return status ? std::string("written") : status.error().message;
    };
    EXPECT_THAT(message(exportPacked("a.png", floats)), HasSubstr("1 to 4 channels"));
    EXPECT_THAT(message(exportPacked("a.jpg", floats)),
                HasSubstr("expected a name that ends in .exr, .tif or .png"));
    PackedExportOptions options;
    options.layout.largestPage = 6;
    EXPECT_THAT(message(exportPacked("a.exr", floats, options)),
                HasSubstr("needs pages of 8 pixels, more than the 6 allowed"));
    options = {};
    options.image.colors = {ColorSpace::Raw};
    EXPECT_THAT(message(exportPacked("a.exr", floats, options)),
                HasSubstr("a colour space for each of 7 channels, found 1"));
    EXPECT_THAT(message(exportPacked("no/a.exr", floats)), HasSubstr("no: No such file"));
    EXPECT_THAT(files(), ElementsAre());
}

TEST_F(AtlasFiles, cancellingLeavesWhatWasThere)
{
    const Project project = anyProject({TexelType::UInt8, 3, std::nullopt});
    put("a.png", "before");
    put("a.glb", "before too");
    class CancelAt final : public Progress
    {
    public:
        explicit CancelAt(double at)
            : m_at(at)
        {
        }
        bool report(double fraction) override { return fraction < m_at; }

    private:
        double m_at;
    };
    for (const double part : {0.0, 0.2, 0.4, 0.7, 0.96, 1.0}) {
        CancelAt progress(part);
        const Status packed = exportPackedAtlas(worker, at("a.png"), project, {}, progress);
        ASSERT_FALSE(packed) << part;
        EXPECT_EQ(packed.error().kind, ErrorKind::Cancelled);
        const auto handOff = exportHandOff(worker, at("a.glb"), project, {}, progress);
        ASSERT_FALSE(handOff) << part;
        EXPECT_EQ(handOff.error().kind, ErrorKind::Cancelled);
        EXPECT_THAT(files(), ElementsAre("a.glb", "a.png"));
    }
    EXPECT_EQ(bytesOf(at("a.png")), "before");
    EXPECT_EQ(bytesOf(at("a.glb")), "before too");
}

TEST_F(AtlasFiles, aFolderThatCannotBeWrittenToIsNoticedBeforeAnythingIsDrawn)
{
    class Furthest final : public Progress
    {
    public:
        bool report(double fraction) override
        {
            reached = std::max(reached, fraction);
            return true;
        }
        double reached = 0;
    };
    const Project project = anyProject({TexelType::UInt8, 3, std::nullopt}, 2);
    for (const std::string name : {"no/a.glb", "no/a.png"}) {
        Furthest progress;
        const Status written =
            name == "no/a.png"
                ? exportPackedAtlas(worker, at(name), project, {}, progress)
                : exportHandOff(worker, at(name), project, {}, progress).map([](const auto&) {});
        ASSERT_FALSE(written);
        EXPECT_EQ(written.error().kind, ErrorKind::Path);
        EXPECT_EQ(progress.reached, 0) << name;
    }
}

TEST_F(AtlasFiles, aFailureNamesTheFileAsItWasMeant)
{
    const Project project = anyProject({TexelType::UInt8, 3, std::nullopt}, 2);
    NoProgress progress;
    const Status written =
        exportPackedAtlas(ImageWorker("/no/such/program"), at("a.png"), project, {}, progress);
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error().message, testing::Not(HasSubstr(".trixel-export")));
    EXPECT_THAT(files(), ElementsAre());
}

TEST_F(AtlasFiles, aMeshWithUvsAndItsTexturesComeTogether)
{
    const Project project = anyProject({TexelType::UInt8, 3, std::nullopt}, 3);
    NoProgress progress;
    HandOffExportOptions options;
    for (const std::string name : {"a.glb", "b.obj", "c.ply"}) {
        const auto estimate = estimateHandOff(at(name), project, options);
        ASSERT_TRUE(estimate);
        const auto before = files();
        const auto outcome = exportHandOff(worker, at(name), project, options, progress);
        ASSERT_TRUE(outcome) << outcome.error().message;
        EXPECT_LT(outcome->largestJump, 0.1); // noise of full range in eight bits
        std::set<std::string> now(before.begin(), before.end());
        now.insert(estimate->files.begin(), estimate->files.end());
        EXPECT_EQ(files(), std::vector<std::string>(now.begin(), now.end()));
    }
    EXPECT_THAT(files(), ElementsAre("a.glb", "b.mtl", "b.obj", "b.png", "c.ply", "c.png"));
    const auto texture = read(at("b.png"));
    ASSERT_TRUE(texture);
    EXPECT_EQ(texture->width() % 4, 0);
    // The embedded one is the same.
    const std::string glb = bytesOf(at("a.glb"));
    EXPECT_THAT(glb, HasSubstr(bytesOf(at("b.png"))));
}

TEST_F(AtlasFiles, pagesMeanWhatTheProjectSaysItsChannelsMean)
{
    using enum ColorSpace;
    Project project = anyProject({TexelType::UInt8, 3, std::nullopt}, 2);
    declareChannelColors(project, {Linear, Raw, SRgb});
    ASSERT_TRUE(exportPacked("a.png", project));
    EXPECT_EQ(nlohmann::json::parse(bytesOf(at("a.json")))["colors"],
              nlohmann::json({"linear", "raw", "srgb"}));
    declareChannelColors(project, {Linear, Linear, Linear});
    ASSERT_TRUE(exportPacked("b.png", project));
    EXPECT_EQ(read(at("b.png"))->colors(), uniformColors(Linear, 3, {}));
    NoProgress progress;
    ASSERT_TRUE(exportHandOff(worker, at("c.obj"), project, {}, progress));
    EXPECT_EQ(read(at("c.png"))->colors(), uniformColors(Linear, 3, {}));
    HandOffExportOptions options;
    options.image.colors = {Raw, Raw, Raw}; // said here
    ASSERT_TRUE(exportHandOff(worker, at("d.obj"), project, options, progress));
    EXPECT_EQ(read(at("d.png"))->colors(), uniformColors(Raw, 3, {}));
}

/// glTF takes base colours for sRGB, whatever the picture says of itself.
TEST_F(AtlasFiles, aGlbHoldsColoursAsSRgb)
{
    using enum ColorSpace;
    NoProgress progress;
    // A pixel of the picture that is in a .glb of faces of one value.
    const auto shown = [&](TexelType type, const std::vector<ColorSpace>& colors) {
        const std::array<float, 3> fill = {0.25F, 0.5F, 0.75F};
        Project project = *newProject(sphereMesh(0),
                                      planUniform(20, Level(0)),
                                      TexelFormat{type, 3, std::nullopt},
                                      fill,
                                      progress);
        if (!colors.empty()) {
            declareChannelColors(project, colors);
        }
        EXPECT_TRUE(exportHandOff(worker, at("a.glb"), project, {}, progress));
        const std::string glb = bytesOf(at("a.glb"));
        put("in.png", glb.substr(glb.find("\x89PNG")));
        const auto picture = read(at("in.png"));
        EXPECT_TRUE(picture) << picture.error().message;
        std::array<float, 3> value{};
        decode(picture->format().type, pixelOf(*picture, {3, 3}), value);
        return std::pair(value, picture->colors());
    };
    const auto expect = [&](TexelType type,
                            const std::vector<ColorSpace>& colors,
                            const std::vector<ColorSpace>& meant,
                            const std::array<bool, 3>& isEncoded) {
        const auto [value, found] = shown(type, colors);
        EXPECT_EQ(found, meant);
        for (std::size_t c = 0; c < 3; ++c) {
            const float number = 0.25F * static_cast<float>(c + 1);
            EXPECT_NEAR(value[c], isEncoded[c] ? fromLinear(SRgb, number) : number, 3e-3)
                << nameOf(type) << ' ' << c;
        }
    };
    const auto sRgb = uniformColors(SRgb, 3, {});
    expect(TexelType::Half, {}, sRgb, {true, true, true});
    expect(TexelType::UInt8, uniformColors(Linear, 3, {}), sRgb, {true, true, true});
    expect(TexelType::UInt8, {}, sRgb, {false, false, false});
    expect(TexelType::UInt8, uniformColors(Raw, 3, {}), uniformColors(Raw, 3, {}), {});
}

TEST_F(AtlasText, hostileDescriptionsAreRefusedInOneSentence)
{
    const Project project = anyProject({TexelType::UInt8, 3, std::nullopt}, 2);
    ASSERT_TRUE(exportPacked("a.png", project));
    const auto good = nlohmann::json::parse(bytesOf(at("a.json")));
    const auto refused = [&](const auto& change) {
        nlohmann::json json = good;
        change(json);
        const auto parsed = parseAtlasDescription(json.dump());
        EXPECT_FALSE(parsed);
        const std::string message = parsed ? "taken" : parsed.error().message;
        EXPECT_EQ(std::ranges::count(message, '\n'), 0);
        return message;
    };
    using Json = nlohmann::json;
    EXPECT_THAT(refused([](Json& j) { j["version"] = 2; }), HasSubstr("version"));
    EXPECT_THAT(refused([](Json& j) { j["kind"] = "hand-off"; }), HasSubstr("kind"));
    EXPECT_THAT(refused([](Json& j) { j["border"] = 9; }), HasSubstr("border"));
    EXPECT_THAT(refused([](Json& j) { j["channels"] = 0; }), HasSubstr("channels"));
    EXPECT_THAT(refused([](Json& j) { j["channels"] = 1e300; }), HasSubstr("channels"));
    EXPECT_THAT(refused([](Json& j) { j["alpha"] = 3; }), HasSubstr("alpha"));
    EXPECT_THAT(refused([](Json& j) { j["type"] = "int"; }), HasSubstr("type"));
    EXPECT_THAT(refused([](Json& j) { j["colors"] = {"srgb"}; }), HasSubstr("colors"));
    EXPECT_THAT(refused([](Json& j) { j["pages"] = Json::array(); }), HasSubstr("pages"));
    EXPECT_THAT(refused([](Json& j) { j["pages"][0]["file"] = "../../etc/passwd"; }),
                HasSubstr("file"));
    EXPECT_THAT(refused([](Json& j) { j["pages"][0]["width"] = 4; }), HasSubstr("tile of face"));
    EXPECT_THAT(refused([](Json& j) { j["faces"]["level"][3] = 13; }), HasSubstr("face 3"));
    EXPECT_THAT(refused([](Json& j) { j["faces"]["page"][0] = 1; }), HasSubstr("page"));
    EXPECT_THAT(refused([](Json& j) { j["faces"]["x"][7] = 4294967295U; }), HasSubstr("x"));
    EXPECT_THAT(refused([](Json& j) { j["faces"]["y"].erase(2); }), HasSubstr("as many"));
    EXPECT_THAT(refused([](Json& j) { j.erase("faces"); }), HasSubstr("faces"));
    // Few bytes that stand for any number of texels.
    EXPECT_THAT(refused([](Json& j) {
                    for (Json& column : j["faces"]) {
                        for (int k = 0; k < 5000; ++k) {
                            column.push_back(column[0]);
                        }
                    }
                }),
                HasSubstr("take more pixels than the pages have"));
    EXPECT_THAT(refused([](Json& j) { j["pages"].push_back(j["pages"][0]); }),
                HasSubstr("two of them"));
    EXPECT_THAT(parseAtlasDescription("{").error().message, HasSubstr("JSON"));
}

TEST_F(AtlasText, aPageThatIsAnotherImageIsRefused)
{
    const Project project = anyProject({TexelType::UInt8, 3, std::nullopt}, 2);
    ASSERT_TRUE(exportPacked("a.png", project));
    const Image other = wavyImage(9, 9, TexelType::UInt8, 3);
    ASSERT_TRUE(write(at("a.png"), std::span(&other, 1)));
    const auto back = readPacked("a.json");
    ASSERT_FALSE(back);
    EXPECT_THAT(back.error().message, HasSubstr("a.png: expected"));
    EXPECT_THAT(back.error().message, HasSubstr("found 9 × 9 pixels of 3 channels"));
}

} // namespace
