// SPDX-License-Identifier: GPL-3.0-or-later
//
// Projects with layers in files: to the bit, within memory, and nothing of them in what is
// exported.
#include "core/io/channel_colors.h"
#include "core/io/layered_texels.h"
#include "core/io/layers_metadata.h"
#include "core/io/new_project.h"
#include "core/io/project.h"
#include "core/io/project_metadata.h"
#include "core/io/ptx_check.h"
#include "core/io/ptx_metadata.h"
#include "core/io/ptx_reader.h"
#include "core/io/ptx_rematch.h"
#include "core/io/ptx_summary.h"
#include "core/layers/compose.h"
#include "core/texture/rearranged_faces.h"
#include "tests/core/io/ptx_samples.h"
#include "tests/core/test_meshes.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <random>
#include <unistd.h>

using namespace trixel;
using namespace trixel::test;
using testing::HasSubstr;
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kFaces = 80;

FaceMap<Level> someLevels()
{
    FaceMap<Level> levels(kFaces);
    for (std::size_t f = 0; f < kFaces; ++f) {
        levels[faceId(f)] = Level(static_cast<int>(f % 4));
    }
    return levels;
}

/// Face f of every `every`th holds any bytes.
void paint(TexelStore& texels, std::size_t every, unsigned seed)
{
    for (std::size_t f = 0; f < texels.faceCount(); f += every) {
        const Level level = texels.face(faceId(f)).level();
        texels.exchange(
            faceId(f),
            FaceTexels::full(
                level,
                texels.format().texelBytes(),
                samples::randomTexels(texels.format(), level, seed + static_cast<unsigned>(f)))
                .collapsed());
    }
}

/// A base with paint on every other face, "Lines" on every third and "Shade" with one value.
LayerStack someLayers(const TexelFormat& format)
{
    const auto fill = samples::randomTexels(format, Level(), 7);
    TexelStore base(format, someLevels(), fill);
    paint(base, 2, 100);
    LayerStack layers(std::move(base));
    const LayerId lines = layers.insert(0, {"Lines ✎ \"1\"", 0.3F, LayerBlend::Multiply, true});
    paint(layers.texels(lines), 3, 200);
    const LayerId shade = layers.insert(1, {"", 1, LayerBlend::Add, false});
    const auto value = samples::randomTexels(layerFormat(format), Level(), 9);
    TexelStore& shaded = layers.texels(shade);
    for (std::size_t f = 10; f < 20; ++f) {
        shaded.exchange(faceId(f), FaceTexels::constant(shaded.face(faceId(f)).level(), value));
    }
    return layers;
}

void expectSame(const TexelStore& a, const TexelStore& b)
{
    ASSERT_EQ(a.format(), b.format());
    ASSERT_EQ(a.faceCount(), b.faceCount());
    for (std::size_t f = 0; f < a.faceCount(); ++f) {
        EXPECT_EQ(a.face(faceId(f)), b.face(faceId(f))) << "face " << f;
    }
}

void expectSame(const LayerStack& a, const LayerStack& b)
{
    expectSame(a.base(), b.base());
    ASSERT_EQ(a.layers().size(), b.layers().size());
    for (std::size_t k = 0; k < a.layers().size(); ++k) {
        EXPECT_EQ(a.layers()[k].settings, b.layers()[k].settings);
        expectSame(a.layers()[k].texels, b.layers()[k].texels);
    }
}

std::string contentOf(const fs::path& path)
{
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

class LayeredProject : public testing::Test
{
protected:
    LayeredProject() { fs::create_directories(m_folder); }
    ~LayeredProject() override { fs::remove_all(m_folder); }

    Project layered(const TexelFormat& format = TexelFormat())
    {
        Project project;
        project.surface = Surface::build(sphereMesh(1), m_progress).value();
        Layered all = composed(someLayers(format), Threads{1}, m_progress).value();
        project.texels = std::move(all.shown);
        project.layers = std::move(all.layers);
        project.metadata = {{"note", std::string("kept")}};
        return project;
    }

    Project plain()
    {
        Project project = layered();
        project.layers = {};
        return project;
    }

    std::vector<PtxMetadata> itemsOf(const Project& project, int version) const
    {
        std::vector<PtxMetadata> items = project.metadata;
        for (PtxMetadata& item : metadataOf(project.surface->mesh())) {
            items.push_back(std::move(item));
        }
        items.push_back({kProjectVersionKey, std::vector<std::int32_t>{version}});
        return items;
    }

    Project saved(const Project& project)
    {
        const Status status = saveProject(m_path, project, m_progress);
        EXPECT_TRUE(status) << status.error().message;
        auto opened = openProject(m_path, m_progress);
        EXPECT_TRUE(opened) << opened.error().message;
        return std::move(*opened);
    }

    NoProgress m_progress;
    fs::path m_folder =
        fs::temp_directory_path() / ("trixel-layered-" + std::to_string(::getpid()));
    fs::path m_path = m_folder / "work.trixel";
    fs::path m_ptx = m_folder / "texture.ptx";
};

} // namespace

TEST_F(LayeredProject, layersRoundTripToTheBit)
{
    for (const TexelFormat& format : {TexelFormat(),
                                      TexelFormat{TexelType::UInt16, 1, std::nullopt},
                                      TexelFormat{TexelType::Half, 4, 3},
                                      TexelFormat{TexelType::Float, 2, 0}}) {
        const Project project = layered(format);
        const Project opened = saved(project);
        expectSame(opened.layers, project.layers);
        expectSame(opened.texels, project.texels);
        EXPECT_EQ(opened.metadata, project.metadata);
        EXPECT_EQ(opened.surface->mesh().triangles, project.surface->mesh().triangles);
    }
}

TEST_F(LayeredProject, whatIsShownIsComposedAnewWhenOpened)
{
    Project project = layered();
    const TexelStore shown = project.texels;
    paint(project.texels, 1, 5); // not kept up to date
    expectSame(saved(project).texels, shown);
}

TEST_F(LayeredProject, savingWhatWasOpenedGivesTheSameFile)
{
    const Project opened = saved(layered());
    const std::string before = contentOf(m_path);
    (void)saved(opened);
    EXPECT_EQ(contentOf(m_path), before);
}

TEST_F(LayeredProject, plainProjectsAreWrittenAsBeforeThereWereLayers)
{
    const Project project = plain();
    (void)saved(project);
    const PtxContents contents{
        project.texels, project.surface->adjacency(), itemsOf(project, 1), false};
    ASSERT_TRUE(writePtx(m_ptx, contents, {.mips = false}, m_progress));
    EXPECT_EQ(contentOf(m_path), contentOf(m_ptx));
}

TEST_F(LayeredProject, aProjectWhoseLayersAreAllRemovedIsPlainAgain)
{
    (void)saved(plain());
    const std::string before = contentOf(m_path);
    Project project = layered();
    while (!project.layers.isPlain()) {
        project.layers.remove(project.layers.layers().front().id);
    }
    (void)saved(project);
    EXPECT_EQ(contentOf(m_path), before);
}

TEST_F(LayeredProject, facesTakeNoMoreMemoryThanBeforeTheyWereSaved)
{
    const Project project = layered();
    const Project opened = saved(project);
    EXPECT_LE(opened.layers.base().storedBytes(), project.layers.base().storedBytes());
    for (std::size_t k = 0; k < 2; ++k) {
        const TexelStore& before = project.layers.layers()[k].texels;
        const TexelStore& after = opened.layers.layers()[k].texels;
        EXPECT_LE(after.storedBytes(), before.storedBytes());
        for (std::size_t f = 0; f < kFaces; ++f) {
            EXPECT_EQ(after.face(faceId(f)).isConstant(), before.face(faceId(f)).isConstant());
        }
    }
}

TEST_F(LayeredProject, uncoveredFacesOfALayerShareOneValue)
{
    const Project opened = saved(layered());
    const TexelStore& lines = opened.layers.layers()[0].texels;
    EXPECT_TRUE(lines.face(faceId(1)).sharesBytesWith(lines.face(faceId(79))));
    const TexelStore& shade = opened.layers.layers()[1].texels;
    EXPECT_TRUE(shade.face(faceId(10)).sharesBytesWith(shade.face(faceId(19))));
}

TEST_F(LayeredProject, aBaseThatLiesInAFileIsSavedWithItsLayers)
{
    const Project source = plain();
    (void)saved(source);
    Project project = openProject(m_path, m_progress, {.wholeBytes = 0}).value();
    ASSERT_TRUE(project.storedFaces);
    LayerStack layers(project.texels);
    paint(layers.texels(layers.insert(0, {"Over"})), 5, 300);
    project.layers = layers;
    const fs::path second = m_folder / "second.trixel";
    ASSERT_TRUE(saveProject(second, project, m_progress));
    const auto opened = openProject(second, m_progress, {.wholeBytes = 0});
    ASSERT_TRUE(opened) << opened.error().message;
    expectSame(opened->layers.base(), source.texels);
    expectSame(opened->layers, layers);
    EXPECT_FALSE(opened->storedFaces); // read whole
}

TEST_F(LayeredProject, aBaseThatCannotBeReadIsNotWrittenOut)
{
    (void)saved(plain());
    Project project = openProject(m_path, m_progress, {.wholeBytes = 0}).value();
    LayerStack layers(project.texels);
    layers.insert(0, {"Over"});
    project.layers = std::move(layers);
    std::ofstream(m_path, std::ios::binary | std::ios::app) << "changed";
    const fs::path second = m_folder / "second.trixel";
    const Status status = saveProject(second, project, m_progress);
    ASSERT_FALSE(status);
    EXPECT_THAT(status.error().message, HasSubstr("could not be read from its file"));
    EXPECT_FALSE(fs::exists(second));
}

TEST_F(LayeredProject, whatIsExportedIsWhatIsShownWithoutATraceOfLayers)
{
    const Project project = saved(layered({TexelType::UInt8, 4, 3}));
    ASSERT_TRUE(exportPtx(m_ptx, project, {}, m_progress));
    const Project opened = openPtx(m_ptx, m_progress).value();
    expectSame(opened.texels, project.texels);
    EXPECT_TRUE(opened.layers.isPlain());
    const PtxContents contents = readPtx(m_ptx, m_progress).value();
    for (const char* key : {kLayersKey, kProjectVersionKey}) {
        EXPECT_EQ(findMetadata(contents.metadata, key), nullptr);
    }
}

TEST_F(LayeredProject, readersThatWantTexelsGetWhatIsShown)
{
    const Project project = saved(layered());
    const auto texels = openPtxTexels(m_path, m_progress);
    ASSERT_TRUE(texels) << texels.error().message;
    expectSame(texels->texels, project.texels);
    const auto renamed = openPtx(m_path, m_progress);
    ASSERT_TRUE(renamed) << renamed.error().message;
    expectSame(renamed->layers, project.layers);
}

TEST_F(LayeredProject, layersAreMatchedToAMeshOfAnotherOrder)
{
    const Project project = saved(layered());
    TriangleMesh mesh = project.surface->mesh();
    std::ranges::reverse(mesh.triangles);
    for (Triangle& triangle : mesh.triangles) {
        std::ranges::rotate(triangle, triangle.begin() + 1);
    }
    mesh.sourceFaces.clear();
    const auto matched =
        openPtxMatched(m_path, Surface::build(mesh, m_progress).value(), m_progress);
    ASSERT_TRUE(matched) << matched.error().message;
    EXPECT_EQ(matched->match.moved(), kFaces);
    const CornerOrder turned = matched->match.faces[0].corners;
    EXPECT_EQ(matched->project.texels.face(faceId(0)).level(),
              project.texels.face(faceId(79)).level());
    for (const std::size_t f : {0U, 1U, 40U}) {
        const FaceId from = faceId(kFaces - 1 - f);
        EXPECT_EQ(matched->project.texels.face(faceId(f)),
                  inOrder(project.texels.face(from), turned));
        EXPECT_EQ(matched->project.layers.layers()[0].texels.face(faceId(f)),
                  inOrder(project.layers.layers()[0].texels.face(from), turned));
    }
}

TEST_F(LayeredProject, theSummaryTellsOfLayersAndOfWhatIsShown)
{
    const TexelFormat format{TexelType::UInt8, 4, 3};
    const Project project = saved(layered(format));
    const auto summary = summarisePtx(m_path);
    ASSERT_TRUE(summary) << summary.error().message;
    EXPECT_EQ(summary->format, format);
    EXPECT_EQ(summary->texelCount, project.texels.texelCount());
    ASSERT_EQ(summary->layers.size(), 2U);
    EXPECT_EQ(summary->layers[0], project.layers.layers()[0].settings);
    EXPECT_EQ(summary->layers[1], project.layers.layers()[1].settings);
    (void)saved(plain());
    EXPECT_TRUE(summarisePtx(m_path)->layers.empty());
}

TEST_F(LayeredProject, aSoundFileHasNoFaults)
{
    (void)saved(layered({TexelType::Half, 4, 3}));
    EXPECT_THAT(checkPtx(m_path, {}, m_progress).value(), testing::IsEmpty());
}

TEST_F(LayeredProject, theEraserFindsTheColourOfTheBase)
{
    Project project = layered();
    const auto bytes = project.layers.base().face(faceId(0)).bytes(); // the first constant one
    const std::vector<std::byte> fill(bytes.begin(), bytes.end());
    std::vector<std::byte> other = fill;
    other[0] ^= std::byte{1};
    project.texels.exchange(faceId(0), FaceTexels::constant(Level(), other)); // shown
    EXPECT_EQ(fillOf(project), fill);
}

TEST_F(LayeredProject, namesAreCutWhereTheyDoNotFitAFile)
{
    Project project = layered();
    const LayerId first = project.layers.layers()[0].id;
    const std::string longest(kMostLayerNameBytes - 1, 'x');
    project.layers.set(first, {longest + "é" + longest});
    EXPECT_EQ(saved(project).layers.layers()[0].settings.name, longest);
    project.layers.set(first,
                       {"a\xFF"
                        "b"}); // no UTF-8
    EXPECT_EQ(saved(project).layers.layers()[0].settings.name, "ab");
}

TEST_F(LayeredProject, damagedLayersAreRefusedByName)
{
    const Project project = saved(layered());
    const PtxContents good = readPtx(m_path, m_progress).value();
    const auto write = [&](std::optional<PtxMetadata::Value> value) {
        PtxContents contents = good;
        removeMetadata(contents.metadata, kLayersKey);
        if (value) {
            contents.metadata.push_back({kLayersKey, *value});
        }
        ASSERT_TRUE(writePtx(m_path, contents, {.mips = false}, m_progress));
    };
    // Opened, summarised or checked: always one sentence that names the key.
    const auto refusal = [&](std::optional<PtxMetadata::Value> value) {
        write(std::move(value));
        const auto opened = openProject(m_path, m_progress);
        EXPECT_FALSE(opened);
        const std::string message = opened ? "was opened" : opened.error().message;
        EXPECT_THAT(message, testing::StartsWith(m_path.string() + ": "));
        EXPECT_EQ(message.find('\n'), std::string::npos);
        const std::string cause = message.substr(m_path.string().size() + 2);
        const auto summary = summarisePtx(m_path);
        EXPECT_EQ(summary ? "was summarised" : summary.error().message, message);
        EXPECT_THAT(checkPtx(m_path, {}, m_progress).value(), testing::Contains(cause));
        EXPECT_EQ(openPtxTexels(m_path, m_progress).error().message, message);
        return cause;
    };
    const auto text = [](const std::string& layers) { return PtxMetadata::Value(layers); };
    const auto layer = [&](const std::string& fields) {
        const std::string sound = R"({"name":"a","opacity":1,"blend":"normal","visible":true})";
        return text("[" + sound + ",{" + fields + "}]");
    };

    EXPECT_EQ(refusal(std::vector<float>{1}), "TrixelLayers is not a text");
    EXPECT_THAT(refusal(text("two")), HasSubstr("TrixelLayers is not JSON"));
    EXPECT_THAT(refusal(text(std::string(100'000, '['))), HasSubstr("TrixelLayers is not JSON"));
    EXPECT_EQ(refusal(text("{}")), "TrixelLayers is not an array of 1 to 64 layers");
    EXPECT_EQ(refusal(text("[]")), "TrixelLayers is not an array of 1 to 64 layers");
    std::string many = "[0";
    for (int k = 0; k < 64; ++k) {
        many += ",0";
    }
    EXPECT_EQ(refusal(text(many + "]")), "TrixelLayers is not an array of 1 to 64 layers");
    EXPECT_EQ(refusal(text("[1]")), "TrixelLayers, layer 1: expected an object, found 1");
    EXPECT_EQ(refusal(layer(R"("opacity":1,"blend":"normal","visible":true)")),
              "TrixelLayers, layer 2: name is missing");
    EXPECT_EQ(refusal(layer(R"("name":"a","blend":"normal","visible":true)")),
              "TrixelLayers, layer 2: opacity is missing");
    EXPECT_EQ(refusal(layer(R"("name":"a","opacity":1,"visible":true)")),
              "TrixelLayers, layer 2: blend is missing");
    EXPECT_EQ(refusal(layer(R"("name":"a","opacity":1,"blend":"normal")")),
              "TrixelLayers, layer 2: visible is missing");
    EXPECT_EQ(refusal(layer(R"("name":"a","opacity":1,"blend":"normal","visible":1)")),
              "TrixelLayers, layer 2: visible: expected true or false, found 1");
    EXPECT_THAT(
        refusal(layer(R"("name":"a","opacity":1,"blend":"normal","visible":true,"mask":1)")),
        HasSubstr("there is no field \"mask\""));
    for (const char* bad : {"-0.1", "1.0001", "1e999", "NaN", "null", "\"1\""}) {
        EXPECT_THAT(refusal(layer(std::string(R"("name":"a","blend":"normal","visible":true,)") +
                                  "\"opacity\":" + bad)),
                    HasSubstr("TrixelLayers"));
    }
    for (const char* bad : {"\"glow\"", "\"Normal\"", "3"}) {
        EXPECT_THAT(refusal(layer(std::string(R"("name":"a","opacity":1,"visible":true,)") +
                                  "\"blend\":" + bad)),
                    HasSubstr("blend: expected the name of a blend mode, found "));
    }
    const auto named = [&](const std::string& name) {
        return layer("\"name\":\"" + name + R"(","opacity":1,"blend":"normal","visible":true)");
    };
    EXPECT_EQ(refusal(named(std::string(1025, 'x'))),
              "TrixelLayers, layer 2: name: expected at most 1024 bytes, found 1025");
    EXPECT_THAT(refusal(named("\xFF")), HasSubstr("TrixelLayers is not JSON"));
    EXPECT_THAT(refusal(named("\xED\xA0\x80")), HasSubstr("TrixelLayers is not JSON"));
    // The texels are those of two layers over three channels.
    const std::string one = R"({"name":"a","opacity":1,"blend":"normal","visible":true})";
    EXPECT_EQ(refusal(text("[" + one + ',' + one + ',' + one + ',' + one + ']')),
              "TrixelLayers names 4 layers, which do not fit texels of 11 channels");
    EXPECT_EQ(refusal(text("[" + one + ',' + one + ',' + one + ',' + one + ',' + one + ',' + one +
                           ',' + one + ',' + one + ',' + one + ',' + one + ',' + one + ']')),
              "TrixelLayers names 11 layers, which do not fit texels of 11 channels");
}

TEST_F(LayeredProject, anOpacityBeyondTheBaseIsRefused)
{
    EXPECT_EQ(baseFormat({TexelType::UInt8, 7, 5}, 1).error().message,
              "TrixelLayers leaves the base 3 channels, but the opacity is in channel 5");
    EXPECT_EQ(baseFormat({TexelType::UInt8, 7, 2}, 1).value(),
              (TexelFormat{TexelType::UInt8, 3, 2}));
    EXPECT_EQ(baseFormat({TexelType::UInt8, 1, std::nullopt}, 1).error().message,
              "TrixelLayers names 1 layer, which do not fit texels of 1 channel");
}

TEST_F(LayeredProject, versionTwoNamesItsLayers)
{
    const Project project = plain();
    const PtxContents contents{
        project.texels, project.surface->adjacency(), itemsOf(project, 2), false};
    ASSERT_TRUE(writePtx(m_path, contents, {.mips = false}, m_progress));
    const auto opened = openProject(m_path, m_progress);
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().message,
              m_path.string() +
                  ": is a project of version 2, but does not name its layers (TrixelLayers)");
}

TEST_F(LayeredProject, whatTrixelsOfBeforeReadIsOfAVersionTheyRefuse)
{
    (void)saved(layered());
    const PtxContents contents = readPtx(m_path, m_progress).value();
    EXPECT_EQ(projectVersionOf(contents.metadata), 2);
}

TEST_F(LayeredProject, layersBeyondTheMemoryAreRefused)
{
    (void)saved(layered());
    MemoryBudget all;
    const auto file = openPtxFile(m_path, all);
    ASSERT_TRUE(file);
    const auto settings = layersOf(file->metadata(all).value());
    MemoryBudget enough(100'000);
    ASSERT_TRUE(readLayers(*file, *settings, enough, Threads{2}, m_progress));
    const std::uint64_t taken = 100'000 - enough.left();
    EXPECT_GE(taken, file->texelBytes() / 4);
    MemoryBudget little(taken - 1);
    const auto refused = readLayers(*file, *settings, little, Threads{2}, m_progress);
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message, HasSubstr("the layers would take"));
    EXPECT_EQ(refused.error().kind, ErrorKind::Contents);
}

TEST_F(LayeredProject, facesThatALayerLeavesCountTowardsTheMemory)
{
    Project project = layered();
    while (project.layers.layers().size() < 40) {
        (void)project.layers.insert(0, {});
    }
    (void)saved(project);
    MemoryBudget all;
    const auto file = openPtxFile(m_path, all);
    ASSERT_TRUE(file);
    const auto settings = layersOf(file->metadata(all).value());
    const std::uint64_t before = all.left();
    ASSERT_TRUE(readLayers(*file, *settings, all, Threads{2}, m_progress));
    // One face that is covered gives each in its block a place of its own.
    EXPECT_GE(before - all.left(), 41 * kFaces * sizeof(FaceTexels));
}

TEST_F(LayeredProject, randomDamageIsAnsweredWithOneSentence)
{
    (void)saved(layered());
    const std::string whole = contentOf(m_path);
    std::mt19937 random(11);
    for (int k = 0; k < 200; ++k) {
        std::string bytes = whole;
        for (int flips = 1 + k % 4; flips > 0; --flips) {
            bytes[random() % bytes.size()] = static_cast<char>(random());
        }
        std::ofstream(m_path, std::ios::binary) << bytes;
        const auto opened = openProject(m_path, m_progress);
        if (!opened) {
            EXPECT_EQ(opened.error().kind, ErrorKind::Contents);
            EXPECT_EQ(opened.error().message.find('\n'), std::string::npos);
        }
    }
}
