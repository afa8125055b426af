// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image/image_levels.h"
#include "tests/core/cancel_after.h"
#include "tests/core/io/image/image_fixture.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/texture.h>
#include <cstring>
#include <gmock/gmock.h>

namespace trixel {
namespace {

using testing::HasSubstr;

bool samePixels(const Image& a, const Image& b)
{
    return a.width() == b.width() && a.height() == b.height() && a.format() == b.format() &&
           std::memcmp(a.pixels().data(), b.pixels().data(), a.byteCount()) == 0;
}

struct Written
{
    const char* name;
    TexelType type;
    std::uint16_t channels;
    bool levels;
    ColorSpace space;
};

class RoundTrip : public ImageFiles, public testing::WithParamInterface<Written>
{
};

TEST_P(RoundTrip, bringsBackEveryBitAndWhatItMeans)
{
    const Written& one = GetParam();
    ImageWriteOptions options;
    options.multipliesByAlpha = false;
    const Image image = wavyImage(70, 37, one.type, one.channels, one.space);
    const auto levels = one.levels ? imageLevels(image, Threads{2}) : std::vector<Image>{image};
    const Status written = write(at(one.name), levels, options);
    ASSERT_TRUE(written) << written.error().message;
    const auto back = read(at(one.name));
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_TRUE(samePixels(*back, image));
    EXPECT_EQ(toText(back->colors()), toText(image.colors()));
    EXPECT_EQ(fileCount(), 1U);
}

INSTANTIATE_TEST_SUITE_P(
    Formats,
    RoundTrip,
    testing::Values(Written{"a.png", TexelType::UInt8, 3, false, ColorSpace::SRgb},
                    Written{"b.png", TexelType::UInt16, 4, false, ColorSpace::Linear},
                    Written{"d.tif", TexelType::UInt8, 4, false, ColorSpace::Raw},
                    Written{"e.tiff", TexelType::UInt16, 1, true, ColorSpace::SRgb},
                    Written{"f.TIF", TexelType::Float, 3, false, ColorSpace::Linear},
                    Written{"g.exr", TexelType::Half, 4, true, ColorSpace::Raw},
                    Written{"h.exr", TexelType::Float, 7, false, ColorSpace::SRgb},
                    Written{"i.tx", TexelType::UInt8, 3, true, ColorSpace::Linear},
                    Written{"j.tx", TexelType::Half, 3, true, ColorSpace::Raw}));

TEST_F(ImageFiles, readsEveryKindByItsBytesNotItsName)
{
    // Made by the library itself, as other programs do, under a name that says nothing.
    OIIO::ImageBuf picture(OIIO::ImageSpec(24, 17, 3, OIIO::TypeDesc::FLOAT));
    OIIO::ImageBufAlgo::fill(picture, {0.25F, 0.5F, 0.75F});
    for (const char* ending : {"png", "jpg", "tif", "exr", "hdr", "tga", "bmp", "webp"}) {
        const auto named = at(std::string("picture.") + ending);
        const bool isFloat = ending == std::string("exr") || ending == std::string("hdr");
        picture.write(named.string(), isFloat ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::UINT8);
        const auto hidden = at("picture.dat");
        std::filesystem::rename(named, hidden);
        const auto image = read(hidden);
        ASSERT_TRUE(image) << ending << ": " << image.error().message;
        EXPECT_EQ(image->width(), 24) << ending;
        EXPECT_EQ(image->height(), 17) << ending;
        ASSERT_GE(image->format().channels, 3) << ending;
        std::vector<float> values(image->byteCount() / byteSize(image->format().type));
        decode(image->format().type, image->pixels(), values);
        EXPECT_NEAR(values[1], 0.5, 0.02) << ending;
        EXPECT_NEAR(values[2], 0.75, 0.02) << ending;
        EXPECT_EQ(image->colors()[0], isFloat ? ColorSpace::Linear : ColorSpace::SRgb) << ending;
    }
}

TEST_F(ImageFiles, rowsBeginAtTheTop)
{
    Image image(4, 3, {TexelType::UInt8, 1, std::nullopt}, {ColorSpace::Raw});
    image.writable()[0] = std::byte{200};
    ASSERT_TRUE(write(at("a.png"), {&image, 1}));
    OIIO::ImageBuf other(at("a.png").string());
    EXPECT_NEAR(other.getchannel(0, 0, 0, 0), 200 / 255.0, 1e-6);
    EXPECT_EQ(other.getchannel(0, 2, 0, 0), 0);
}

TEST_F(ImageFiles, aTurnedPhotographIsUpright)
{
    OIIO::ImageSpec spec(3, 2, 1, OIIO::TypeDesc::UINT8);
    const unsigned char pixels[] = {10, 20, 30, 40, 50, 60};
    // For each orientation the shown picture's first row.
    const std::vector<std::vector<int>> firstRows = {{10, 20, 30},
                                                     {30, 20, 10},
                                                     {60, 50, 40},
                                                     {40, 50, 60},
                                                     {10, 40},
                                                     {40, 10},
                                                     {60, 30},
                                                     {30, 60}};
    for (int orientation = 1; orientation <= 8; ++orientation) {
        spec.attribute("Orientation", orientation);
        const auto out = OIIO::ImageOutput::create("tiff");
        ASSERT_TRUE(out->open(at("a.tif").string(), spec) &&
                    out->write_image(OIIO::TypeDesc::UINT8, pixels) && out->close());
        const auto image = read(at("a.tif"));
        ASSERT_TRUE(image) << image.error().message;
        const auto& row = firstRows[static_cast<std::size_t>(orientation - 1)];
        ASSERT_EQ(image->width(), static_cast<int>(row.size())) << orientation;
        for (std::size_t x = 0; x < row.size(); ++x) {
            EXPECT_EQ(std::to_integer<int>(image->pixels()[x]), row[x]) << orientation;
        }
    }
}

TEST_F(ImageFiles, aCroppedPictureLiesInItsFrame)
{
    OIIO::ImageSpec spec(2, 2, 3, OIIO::TypeDesc::FLOAT);
    spec.x = 1;
    spec.y = 2;
    spec.full_width = 5;
    spec.full_height = 6;
    const std::vector<float> pixels(12, 0.5F);
    const auto out = OIIO::ImageOutput::create("openexr");
    ASSERT_TRUE(out->open(at("a.exr").string(), spec) &&
                out->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) && out->close());
    const auto image = read(at("a.exr"));
    ASSERT_TRUE(image) << image.error().message;
    ASSERT_EQ(image->width(), 5);
    ASSERT_EQ(image->height(), 6);
    std::vector<float> values(90);
    decode(TexelType::Float, image->pixels(), values);
    double sum = 0;
    for (const float value : values) {
        sum += value;
    }
    EXPECT_DOUBLE_EQ(sum, 6);
    EXPECT_EQ(values[3 * (2 * 5 + 1)], 0.5F);
}

TEST_F(ImageFiles, othersFindColorsMultipliedByOpacityInOpenExr)
{
    const Image image = wavyImage(20, 10, TexelType::Float, 4, ColorSpace::Linear);
    ASSERT_TRUE(write(at("a.exr"), {&image, 1}));
    OIIO::ImageBuf other(at("a.exr").string());
    std::vector<float> values(20 * 10 * 4);
    decode(TexelType::Float, image.pixels(), values);
    EXPECT_NEAR(other.getchannel(3, 4, 0, 0), values[332] * values[335], 1e-6);
    const auto back = read(at("a.exr"));
    ASSERT_TRUE(back) << back.error().message;
    std::vector<float> again(values.size());
    decode(TexelType::Float, back->pixels(), again);
    EXPECT_NEAR(again[332], values[332], 1e-6);
}

TEST_F(ImageFiles, renderersTakeTheTextures)
{
    for (const char* name : {"a.tx", "b.exr", "c.tx"}) {
        const TexelType type = name[0] == 'a' ? TexelType::UInt8 : TexelType::Half;
        const Image image = wavyImage(256, 128, type, 3, ColorSpace::Linear);
        const auto levels = imageLevels(image, Threads{2});
        ASSERT_TRUE(write(at(name), levels));

        const auto input = OIIO::ImageInput::open(at(name).string());
        ASSERT_TRUE(input);
        EXPECT_GT(input->spec().tile_width, 0);
        EXPECT_EQ(input->spec().get_string_attribute("textureformat"), "Plain Texture");
        EXPECT_TRUE(input->seek_subimage(0, 3));

        OIIO::TextureSystem* system = OIIO::TextureSystem::create(false);
        OIIO::TextureOpt options;
        options.swrap = options.twrap = OIIO::TextureOpt::WrapClamp;
        options.interpmode = OIIO::TextureOpt::InterpClosest;
        options.mipmode = OIIO::TextureOpt::MipModeOneLevel;
        float value[3] = {};
        EXPECT_TRUE(system->texture(OIIO::ustring(at(name).string()),
                                    options,
                                    40.5F / 256,
                                    30.5F / 128,
                                    8 / 256.0F,
                                    0,
                                    0,
                                    8 / 128.0F,
                                    3,
                                    value))
            << system->geterror();
        // Eight pixels across are level 3.
        std::vector<float> values(3);
        decode(type,
               levels[3].row(3).subspan(5 * levels[3].format().texelBytes(),
                                        levels[3].format().texelBytes()),
               values);
        EXPECT_NEAR(value[0], values[0], 1e-3) << name;
        EXPECT_NEAR(value[1], values[1], 1e-3) << name;
        OIIO::TextureSystem::destroy(system);
    }
}

/// The library's own tool reads every pixel and finds the values that were written.
TEST_F(ImageFiles, oiiotoolCountsTheTexturesPixels)
{
    if (std::system("oiiotool --version >/dev/null 2>&1") != 0) {
        GTEST_SKIP() << "openimageio-tools is not installed";
    }
    for (const auto& [name, type] :
         {std::pair("a.tx", TexelType::UInt8), {"b.tx", TexelType::Float}}) {
        const Image image = wavyImage(96, 64, type, 3, ColorSpace::Linear);
        ASSERT_TRUE(write(at(name), imageLevels(image, Threads{2})));
        const std::string command =
            "oiiotool --stats '" + at(name).string() + "' > '" + at("stats").string() + "' 2>&1";
        ASSERT_EQ(std::system(command.c_str()), 0);
        const std::string stats = bytesOf(at("stats"));
        EXPECT_THAT(stats, testing::HasSubstr("FiniteCount: 6144 6144 6144")) << name;
        std::vector<float> values(3U * 6144U);
        decode(type, image.pixels(), values);
        double sum = 0;
        for (std::size_t k = 0; k < values.size(); k += 3) {
            sum += static_cast<double>(values[k]);
        }
        const double unit = type == TexelType::UInt8 ? 255 : 1;
        const std::string average = stats.substr(stats.find("Stats Avg: ") + 11);
        EXPECT_NEAR(std::stod(average), unit * sum / 6144, 0.006 * unit) << name;
    }
}

/// Channels beyond the tenth, and opacity where no format looks for it, stay where they are.
TEST_F(ImageFiles, channelsKeepTheirOrder)
{
    const struct
    {
        const char* name;
        TexelFormat format;
    } cases[] = {{"a.exr", {TexelType::Half, 14, std::nullopt}},
                 {"b.exr", {TexelType::Float, 4, 0}},
                 {"c.exr", {TexelType::Half, 6, 5}},
                 {"d.exr", {TexelType::Half, 12, 3}},
                 {"e.tx", {TexelType::Half, 13, std::nullopt}},
                 {"f.tif", {TexelType::UInt16, 12, std::nullopt}}};
    for (const auto& [name, format] : cases) {
        Image image(9, 7, format, usualColors(format));
        std::vector<float> values(63U * format.channels);
        for (std::size_t k = 0; k < values.size(); ++k) {
            values[k] = static_cast<float>(k % 251) / 251;
        }
        encode(format.type, values, image.writable());
        const Status written = write(at(name), {&image, 1});
        ASSERT_TRUE(written) << name << ": " << written.error().message;
    }
}

/// Bytes of a BMP of one pixel.
std::string bmp(std::string_view bgra)
{
    const auto number = [](std::uint32_t n) {
        return std::string(reinterpret_cast<const char*>(&n), 4);
    };
    return "BM" + number(58) + number(0) + number(54) + number(40) + number(1) + number(1) +
           std::string("\1\0\x20\0", 4) + number(0) + number(4) + number(2835) + number(2835) +
           number(0) + number(0) + std::string(bgra);
}

TEST_F(ImageFiles, colorsOfABmpAreNotMultipliedByItsOpacity)
{
    const auto half = read(put("half.bmp", bmp("\x32\x64\xC8\x80")));
    ASSERT_TRUE(half) << half.error().message;
    ASSERT_EQ(half->format().alpha, 3);
    EXPECT_EQ(half->pixels()[0], std::byte{0xC8});
    EXPECT_EQ(half->pixels()[2], std::byte{0x32});
    EXPECT_EQ(half->pixels()[3], std::byte{0x80});
    // A fourth byte that nobody filled in.
    const auto unused = read(put("unused.bmp", bmp(std::string("\x32\x64\xC8\0", 4))));
    ASSERT_TRUE(unused);
    EXPECT_EQ(unused->pixels()[3], std::byte{0xFF});
    EXPECT_EQ(unused->pixels()[0], std::byte{0xC8});
}

TEST_F(ImageFiles, whatGlowsThroughNextToNoOpacityStaysFinite)
{
    Image image(1, 1, {TexelType::Half, 4, 3}, uniformColors(ColorSpace::Linear, 4, 3));
    const std::array<float, 4> multiplied = {0.5F, 0.25F, 0, 4e-6F};
    encode(TexelType::Half, multiplied, image.writable());
    OIIO::ImageSpec spec(1, 1, 4, OIIO::TypeDesc::HALF);
    const auto output = OIIO::ImageOutput::create("a.exr");
    ASSERT_TRUE(output->open(at("a.exr").string(), spec));
    ASSERT_TRUE(output->write_image(OIIO::TypeDesc::HALF, image.pixels().data()));
    ASSERT_TRUE(output->close());
    const auto back = read(at("a.exr"));
    ASSERT_TRUE(back);
    std::array<float, 4> values{};
    decode(TexelType::Half, back->pixels(), values);
    EXPECT_EQ(values[0], 65504);
    EXPECT_EQ(values[2], 0);
}

/// An encoder that writes the second level as high as it should be wide.
TEST_F(ImageFiles, aWrongLevelTakesNoName)
{
    const Image image = wavyImage(96, 64, TexelType::UInt8, 3);
    const auto levels = imageLevels(image, Threads{2});
    std::ofstream(at("clumsy"))
        << "#!/bin/sh\nexec " TRIXEL_IMAGE_WORKER
           " \"$(printf %s \"$1\" | sed '/encode/s/\\[48,32\\]/[32,48]/')\"\n";
    std::filesystem::permissions(at("clumsy"), std::filesystem::perms::owner_all);
    worker = ImageWorker(at("clumsy"));
    const Status written = write(at("a.tx"), levels);
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error().message, testing::HasSubstr("level 1 is 32 × 48"));
    EXPECT_FALSE(std::filesystem::exists(at("a.tx")));
    EXPECT_TRUE(write(at("b.tx"), {&image, 1}));
}

TEST_F(ImageFiles, writingRefusesWhatAFormatCannotHold)
{
    const struct
    {
        const char* name;
        TexelType type;
        std::uint16_t channels;
        const char* says;
    } cases[] = {{"a.jpg", TexelType::UInt8, 3, "expected a name that ends in"},
                 {"a.png", TexelType::Half, 3, "a PNG holds 1 to 4 channels of uint8 or uint16"},
                 {"a.png", TexelType::UInt8, 5, "not 5 of uint8"},
                 {"a.tif", TexelType::Half, 3, "not half"},
                 {"a.exr", TexelType::UInt8, 3, "not uint8"}};
    for (const auto& one : cases) {
        const Image image = wavyImage(4, 4, one.type, one.channels);
        const Status status = write(at(one.name), {&image, 1});
        ASSERT_FALSE(status);
        EXPECT_THAT(status.error().message, HasSubstr(one.says));
        EXPECT_EQ(fileCount(), 0U);
    }
    EXPECT_FALSE(checkImageTarget("a.png", {TexelType::UInt8, 3, {}}, 1 << 20, 4, false));
    EXPECT_FALSE(checkImageTarget("a.png", {TexelType::UInt8, 3, {}}, 0, 4, false));
    EXPECT_FALSE(checkImageTarget("a.png", {TexelType::UInt8, 3, {}}, 4, 4, true));
}

TEST_F(ImageFiles, cancellingLeavesWhatWasThere)
{
    put("a.png", "before");
    const Image image = wavyImage(64, 64, TexelType::UInt8, 3);
    for (int reports = 0; reports < 3; ++reports) {
        CancelAfter progress(reports);
        const Status status = writeImage(worker, at("a.png"), {&image, 1}, {}, progress);
        if (status) {
            break;
        }
        EXPECT_EQ(status.error().kind, ErrorKind::Cancelled);
        EXPECT_EQ(bytesOf(at("a.png")), "before");
        EXPECT_EQ(fileCount(), 1U);
    }
}

TEST_F(ImageFiles, aFolderThatIsNotThereIsOneSentence)
{
    const Image image = wavyImage(4, 4, TexelType::UInt8, 3);
    const Status status = write(at("no") / "a.png", {&image, 1});
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().kind, ErrorKind::Path);
}

TEST_F(ImageFiles, withoutTheWorkerThereIsOneSentence)
{
    const Image image = wavyImage(4, 4, TexelType::UInt8, 3);
    worker = ImageWorker(at("nothing"));
    const Status status = write(at("a.png"), {&image, 1});
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().kind, ErrorKind::Path);
    EXPECT_THAT(status.error().message, HasSubstr("cannot be started"));
}

} // namespace
} // namespace trixel
