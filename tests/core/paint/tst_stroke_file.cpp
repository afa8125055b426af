// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/paint/stroke_file.h"
#include "tests/core/paint/paint_fixture.h"
#include "tests/core/test_meshes.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <random>
#include <string>

using namespace trixel;
using testing::HasSubstr;

namespace {

constexpr std::string_view kGood =
    R"({"version":1,"strokes":[{"layer":0,"brush":{"radius":0.05,"unit":"world","hardness":0.5,
"opacity":1,"flow":1,"spacing":0.1,"blend":"normal","color":[1,0,0]},
"samples":[{"face":12,"u":0.2,"v":0.3,"pressure":1,"time":0.0},{"face":3,"u":0,"v":1}]},
{"brush":{"radius":2,"blend":"erase","color":[0.5]},"samples":[]}]})";

/// The good file with one piece of it replaced.
std::string with(std::string_view what, std::string_view by)
{
    std::string text(kGood);
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), by);
}

std::string errorOf(const std::string& text)
{
    const auto strokes = parseStrokes(text, 20);
    EXPECT_FALSE(strokes);
    return strokes ? "" : strokes.error().message;
}

/// On layers 0 to below a number of them.
std::vector<RecordedStroke> scribbles(std::size_t faceCount, std::size_t layers = 1)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<float> part(0, 1);
    std::vector<RecordedStroke> strokes(6);
    for (std::size_t k = 0; k < strokes.size(); ++k) {
        Brush& brush = strokes[k].brush;
        brush.radius = 0.05F + 0.3F * part(random);
        brush.hardness = part(random);
        brush.opacity = 0.3F + 0.7F * part(random);
        brush.flow = 0.2F + 0.8F * part(random);
        brush.blend = k == 4 ? BlendMode::Erase : BlendMode::Normal;
        brush.color = {part(random), part(random), part(random), 1};
        brush.pressureToSize = k % 2 == 0;
        brush.pressureToOpacity = k % 3 == 0;
        brush.paintThrough = k == 2;
        strokes[k].layer = static_cast<std::uint32_t>(layers * k / 6);
        if (k == 1) {
            brush.radius = 1.5F; // half a sphere of radius 1: work for several threads
            brush.spacing = 1;
        }
        for (int n = 0; n < 5; ++n) {
            const float u = part(random);
            strokes[k].samples.push_back({faceId(random() % faceCount),
                                          {u, (1 - u) * part(random)},
                                          part(random),
                                          0.01 * n});
        }
    }
    return strokes;
}

class StopAtSecondReport final : public Progress
{
public:
    bool report(double /*fraction*/) override { return ++reports < 2; }

    int reports = 0;
};

} // namespace

TEST(StrokeFile, readsWhatTheDocumentationShows)
{
    const auto strokes = parseStrokes(kGood, 20);
    ASSERT_TRUE(strokes) << strokes.error().message;
    ASSERT_EQ(strokes->size(), 2U);
    const RecordedStroke& first = strokes->front();
    EXPECT_EQ(first.brush.radius, 0.05F);
    EXPECT_EQ(first.brush.blend, BlendMode::Normal);
    EXPECT_EQ(first.brush.color, (std::array{1.0F, 0.0F, 0.0F, 1.0F}));
    ASSERT_EQ(first.samples.size(), 2U);
    EXPECT_EQ(first.samples[0], (StrokeSample{faceId(12), {0.2F, 0.3F}, 1.0F, 0.0}));
    EXPECT_EQ(first.samples[1], (StrokeSample{faceId(3), {0, 1}, 1.0F, 0.0}));
    EXPECT_EQ(strokes->back().brush.blend, BlendMode::Erase);
    EXPECT_EQ(strokes->back().brush.color, (std::array{0.5F, 0.5F, 0.5F, 1.0F}));
}

TEST(StrokeFile, whatIsWrittenReadsBackEqual)
{
    const std::vector<RecordedStroke> strokes = scribbles(20, 3);
    const auto back = parseStrokes(writeStrokes(strokes), 20);
    ASSERT_TRUE(back) << back.error().message;
    ASSERT_EQ(back->size(), strokes.size());
    for (std::size_t k = 0; k < strokes.size(); ++k) {
        EXPECT_EQ((*back)[k].brush, strokes[k].brush);
        EXPECT_EQ((*back)[k].samples, strokes[k].samples);
        EXPECT_EQ((*back)[k].layer, strokes[k].layer);
    }
}

TEST(StrokeFile, errorsNameTheStrokeTheSampleAndTheField)
{
    EXPECT_EQ(errorOf(with("\"radius\":2", "\"radius\":0")),
              "stroke 2, brush: radius: expected a finite number above 0, found 0");
    EXPECT_EQ(errorOf(with("\"radius\":2", "\"radius\":\"big\"")),
              "stroke 2, brush: radius: expected a finite number, found \"big\"");
    EXPECT_EQ(errorOf(with("\"radius\":2", "\"radius\":1e39")),
              "stroke 2, brush: radius: expected a finite number, found 1e+39");
    EXPECT_EQ(errorOf(with("\"radius\":2,", "")), "stroke 2, brush: radius is missing");
    EXPECT_EQ(errorOf(with("\"world\"", "\"pixel\"")),
              "stroke 1, brush: unit: expected \"world\", found \"pixel\"");
    EXPECT_EQ(
        errorOf(with("\"layer\":0", "\"layer\":-1")),
        "stroke 1: layer: expected 0 for the base or the number of a layer above it, found -1");
    EXPECT_THAT(errorOf(with("\"layer\":0", "\"layer\":0.5")), HasSubstr("stroke 1: layer:"));
    EXPECT_THAT(errorOf(with("\"layer\":0", "\"layer\":4294967296")),
                HasSubstr("stroke 1: layer:"));
    EXPECT_EQ(errorOf(with("\"normal\"", "\"multiply\"")),
              "stroke 1, brush: blend: expected \"normal\" or \"erase\", found \"multiply\"");
    EXPECT_EQ(errorOf(with("\"flow\":1", "\"flow\":1.5")),
              "stroke 1, brush: flow: expected a number from 0 to 1, found 1.5");
    EXPECT_EQ(errorOf(with("[1,0,0]", "[1,0,null]")),
              "stroke 1, brush: color: expected an array of 1 to 4 finite numbers, found an array");
    EXPECT_EQ(errorOf(with("\"hardness\"", "\"hardnes\"")),
              "stroke 1, brush: there is no field \"hardnes\"");
    EXPECT_EQ(errorOf(with("\"face\":3", "\"face\":20")),
              "stroke 1, sample 2: face: expected a whole number below the mesh's 20 faces, "
              "found 20");
    EXPECT_THAT(errorOf(with("\"face\":3", "\"face\":-3")), HasSubstr("sample 2: face"));
    EXPECT_THAT(errorOf(with("\"face\":3", "\"face\":1.5")), HasSubstr("sample 2: face"));
    EXPECT_THAT(errorOf(with("\"face\":3,", "")), HasSubstr("sample 2: face is missing"));
    EXPECT_THAT(errorOf(with("\"u\":0.2", "\"u\":0.9")), HasSubstr("stroke 1, sample 1: u:"));
    EXPECT_THAT(errorOf(with("\"v\":0.3", "\"v\":-0.3")), HasSubstr("sample 1: v:"));
    EXPECT_THAT(errorOf(with("\"pressure\":1", "\"pressure\":2")),
                HasSubstr("sample 1: pressure: expected a number from 0 to 1"));
    EXPECT_THAT(errorOf(with("\"time\":0.0", "\"time\":[]")),
                HasSubstr("sample 1: time: expected a finite number, found an array"));
    EXPECT_THAT(errorOf(with("\"samples\":[]", "\"samples\":{}")),
                HasSubstr("stroke 2: samples: expected an array"));
    EXPECT_THAT(errorOf(with("\"samples\":[]", "\"samples\":[7]")),
                HasSubstr("stroke 2, sample 1: expected an object, found 7"));
    EXPECT_THAT(errorOf(with("\"version\":1", "\"version\":2")),
                HasSubstr("version: expected 1, found 2"));
}

TEST(StrokeFile, textThatIsNotJsonIsRefusedInOneSentence)
{
    EXPECT_EQ(errorOf("{\"version\":1,"), "not JSON: byte 14 is not what the grammar expects");
    EXPECT_THAT(errorOf(with("0.05", "NaN")), HasSubstr("not JSON: byte"));
    EXPECT_THAT(errorOf(with("0.05", "1e999")), HasSubstr("a number is out of range"));
    EXPECT_THAT(errorOf(""), HasSubstr("not JSON"));
    EXPECT_THAT(errorOf("[]"), HasSubstr("expected an object, found an array"));
    EXPECT_THAT(errorOf("{}"), HasSubstr("version is missing"));
    EXPECT_THAT(errorOf(with("\"normal\"", "\"\xff\"")), HasSubstr("not JSON"));
}

TEST(StrokeFile, damagedFilesNeverCrashAndHugeNestingIsRefused)
{
    EXPECT_FALSE(parseStrokes(std::string(300'000, '['), 20));
    const std::string nested = std::string(100'000, '[') + std::string(100'000, ']');
    EXPECT_FALSE(parseStrokes(with("\"world\"", nested), 20));
    std::mt19937 random(9);
    for (int k = 0; k < 20'000; ++k) {
        std::string text(kGood);
        for (int change = 0; change < 1 + k % 3; ++change) {
            const std::size_t at = random() % text.size();
            switch (random() % 3) {
            case 0:
                text[at] = static_cast<char>(random() % 256);
                break;
            case 1:
                text.erase(at, 1 + random() % 8);
                break;
            default:
                text.insert(at, text, random() % text.size(), random() % 16);
                break;
            }
        }
        const auto strokes = parseStrokes(text, 20);
        if (!strokes) {
            ASSERT_FALSE(strokes.error().message.empty());
            continue;
        }
        for (const RecordedStroke& stroke : *strokes) {
            ASSERT_TRUE(validate(stroke.brush));
            for (const StrokeSample& sample : stroke.samples) {
                ASSERT_LT(indexOf(sample.face), 20U);
            }
        }
    }
}

TEST(ReplayStrokes, theResultDoesNotDependOnThreads)
{
    const auto surface = test::surfaceOf(test::sphereMesh(2));
    const auto strokes = scribbles(surface->mesh().faceCount());
    for (const TexelType type : {TexelType::UInt8, TexelType::Half, TexelType::Float}) {
        const TexelFormat format{type, 3, std::nullopt};
        const std::vector<std::byte> fill(format.texelBytes());
        const TexelStore blank(320, format, Level(6), fill);
        std::vector<TexelStore> results;
        for (const unsigned threads : {1U, 2U, 8U}) {
            TexelStore store = blank;
            NoProgress progress;
            ASSERT_TRUE(replayStrokes(strokes, surface, fill, store, Threads{threads}, progress));
            results.push_back(store);
        }
        EXPECT_FALSE(test::sameToTheBit(results[0], blank));
        EXPECT_TRUE(test::sameToTheBit(results[0], results[1]));
        EXPECT_TRUE(test::sameToTheBit(results[0], results[2]));
    }
}

TEST(ReplayStrokes, cancellingAndBadBrushesLeaveTheStoreAsItWas)
{
    const auto surface = test::surfaceOf(test::sphereMesh(1));
    auto strokes = scribbles(surface->mesh().faceCount());
    for (int k = 0; k < 15; ++k) { // enough samples for a second report
        strokes.push_back(RecordedStroke(strokes[3]));
    }
    const TexelFormat format;
    const std::vector<std::byte> fill(format.texelBytes());
    const TexelStore blank(80, format, Level(3), fill);
    TexelStore store = blank;
    StopAtSecondReport stop;
    const Status cancelled = replayStrokes(strokes, surface, fill, store, Threads{1}, stop);
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().kind, ErrorKind::Cancelled);
    EXPECT_EQ(stop.reports, 2); // some of it had been painted
    EXPECT_TRUE(test::sameToTheBit(store, blank));

    strokes[3].brush.spacing = 0;
    NoProgress progress;
    const Status refused = replayStrokes(strokes, surface, fill, store, Threads{1}, progress);
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message, HasSubstr("stroke 4, brush: spacing"));
    EXPECT_TRUE(test::sameToTheBit(store, blank));
}

TEST(ReplayStrokes, eachStrokeChangesItsLayerAndWhatIsShown)
{
    const auto surface = test::surfaceOf(test::sphereMesh(2));
    const auto faces = static_cast<std::uint32_t>(surface->mesh().faceCount());
    const auto strokes = scribbles(faces, 3);
    const TexelFormat format;
    const std::vector<std::byte> fill(format.texelBytes());
    LayerStack blank(TexelStore(faces, format, Level(5), fill));
    blank.insert(0, {"", 0.5F, LayerBlend::Multiply, true});
    blank.insert(1, {});
    NoProgress progress;
    Layered painted{blank.base(), blank};
    ASSERT_TRUE(replayStrokes(strokes, surface, fill, painted, Threads{2}, progress));

    // The strokes of each layer alone, on that layer.
    LayerStack apart = blank;
    for (std::size_t k = 0; k < strokes.size(); ++k) {
        const std::uint32_t layer = strokes[k].layer;
        const LayerId id = layer == 0 ? kBaseLayer : blank.layers()[layer - 1].id;
        Stroke stroke(surface, strokes[k].brush, layer == 0 ? Ground(fill) : Ground::layer());
        for (const StrokeSample& sample : strokes[k].samples) {
            stroke.add(sample, apart.texels(id));
        }
    }
    for (const LayerId id : {kBaseLayer, blank.layers()[0].id, blank.layers()[1].id}) {
        EXPECT_FALSE(test::sameToTheBit(painted.layers.texels(id), blank.texels(id)));
        EXPECT_TRUE(test::sameToTheBit(painted.layers.texels(id), apart.texels(id)));
    }
    EXPECT_TRUE(test::sameToTheBit(painted.shown, composed(apart, Threads{2}, progress)->shown));
}

TEST(ReplayStrokes, aLayerThatIsNotThereIsOneSentenceAndChangesNothing)
{
    const auto surface = test::surfaceOf(test::sphereMesh(1));
    auto strokes = scribbles(80);
    strokes[2].layer = 2;
    const std::vector<std::byte> fill(3);
    const TexelStore blank(80, TexelFormat(), Level(3), fill);
    TexelStore store = blank;
    NoProgress progress;
    const Status plain = replayStrokes(strokes, surface, fill, store, Threads{1}, progress);
    ASSERT_FALSE(plain);
    EXPECT_EQ(plain.error().message, "stroke 3: layer 2 is not there; the project has no layers");
    EXPECT_TRUE(test::sameToTheBit(store, blank));

    LayerStack layers(blank);
    layers.insert(0, {});
    Layered painted{blank, layers};
    const Status layered = replayStrokes(strokes, surface, fill, painted, Threads{1}, progress);
    ASSERT_FALSE(layered);
    EXPECT_EQ(layered.error().message, "stroke 3: layer 2 is not there; the project has one layer");
    EXPECT_TRUE(test::sameToTheBit(painted.shown, blank));
}
