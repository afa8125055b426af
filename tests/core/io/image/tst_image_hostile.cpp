// SPDX-License-Identifier: GPL-3.0-or-later
//
// Image files that lie, end too soon or would fill the memory: each is answered by one sentence.
#include "core/io/image/image_kind.h"
#include "tests/core/cancel_after.h"
#include "tests/core/io/image/image_fixture.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

namespace trixel {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::StartsWith;

void append32(std::string& to, std::uint32_t value)
{
    for (const int shift : {24, 16, 8, 0}) {
        to += static_cast<char>(value >> static_cast<unsigned>(shift) & 0xFFU);
    }
}

std::uint32_t crcOf(std::string_view bytes)
{
    std::uint32_t crc = 0xFFFFFFFFU;
    for (const char byte : bytes) {
        crc ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) {
            crc = crc >> 1U ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
        }
    }
    return ~crc;
}

std::string chunk(const std::string& type, const std::string& data)
{
    std::string bytes;
    append32(bytes, static_cast<std::uint32_t>(data.size()));
    bytes += type + data;
    append32(bytes, crcOf(type + data));
    return bytes;
}

/// A PNG that claims any size and holds a few bytes of nothing.
std::string pngOf(std::uint32_t width, std::uint32_t height)
{
    std::string header;
    append32(header, width);
    append32(header, height);
    header += std::string("\x08\x02\x00\x00\x00", 5);
    const std::string empty("\x78\x9C\x03\x00\x00\x00\x00\x01", 8);
    return "\x89PNG\r\n\x1A\n" + chunk("IHDR", header) + chunk("IDAT", empty) + chunk("IEND", "");
}

class HostileImages : public ImageFiles
{
protected:
    /// The sentence that a file is refused with, or "accepted".
    std::string refusal(const std::string& bytes, const ImageLimits& limits = {})
    {
        const auto path = put("hostile", bytes);
        const auto image = read(path, limits);
        if (image) {
            return "accepted";
        }
        EXPECT_EQ(image.error().kind, ErrorKind::Contents);
        EXPECT_THAT(image.error().message, StartsWith(path.string() + ": "));
        EXPECT_EQ(image.error().message.find('\n'), std::string::npos);
        return image.error().message.substr(path.string().size() + 2);
    }

    std::string good(const std::string& name, TexelType type)
    {
        const Image image = wavyImage(60, 50, type, 3);
        EXPECT_TRUE(write(at(name), {&image, 1}));
        return bytesOf(at(name));
    }
};

TEST_F(HostileImages, nothingAndNonsenseAreRefused)
{
    EXPECT_EQ(refusal(""), "the file is empty");
    for (const char* bytes :
         {"P", "hello, this is a text and no image at all", "II*", "RIFFxxxxWAVE"}) {
        EXPECT_THAT(refusal(bytes), HasSubstr("expected an image (PNG")) << bytes;
    }
    // Formats that the library would read but that break it: an icon, and Targa's and Cineon's kin.
    EXPECT_THAT(refusal(std::string("\x00\x00\x01\x00\x01\x00 and so on, an icon", 30)),
                HasSubstr("expected an image"));
    EXPECT_THAT(refusal("SDPX and so on and on and on and on"), HasSubstr("expected an image"));
}

TEST_F(HostileImages, sizesBeyondAllMeasureAreRefusedBeforeAnyMemoryIsTaken)
{
    EXPECT_THAT(refusal(pngOf(0x7FFFFFFF, 1)), AnyOf(HasSubstr("damaged"), HasSubstr("pixels")));
    EXPECT_THAT(refusal(pngOf(0x80000000, 1)), AnyOf(HasSubstr("damaged"), HasSubstr("pixels")));
    EXPECT_THAT(refusal(pngOf(0, 5)), AnyOf(HasSubstr("damaged"), HasSubstr("no pixels")));
    EXPECT_THAT(refusal(pngOf(1 << 18, 8)), HasSubstr("expected at most 131072 across"));
    EXPECT_THAT(refusal(pngOf(1 << 17, 1 << 17)), HasSubstr("bytes, expected at most"));
}

TEST_F(HostileImages, aBombIsRefusedByItsRatio)
{
    EXPECT_THAT(refusal(pngOf(16384, 16384)), HasSubstr("bytes claim to hold 805306368 bytes"));
    ImageLimits generous;
    generous.mostBytesPerByte = 100'000'000;
    EXPECT_THAT(refusal(pngOf(16384, 16384), generous), HasSubstr("damaged"));
}

TEST_F(HostileImages, limitsOfTheCallerHold)
{
    const std::string png = good("a.png", TexelType::UInt8);
    ImageLimits limits;
    limits.mostPixelsAcross = 59;
    EXPECT_THAT(refusal(png, limits), HasSubstr("60 × 50 pixels, expected at most 59"));
    limits = {};
    limits.mostBytes = 8999;
    EXPECT_THAT(refusal(png, limits), HasSubstr("9000 bytes, expected at most 8999"));
    limits = {};
    limits.mostChannels = 2;
    EXPECT_THAT(refusal(png, limits), HasSubstr("3 channels"));
}

TEST_F(HostileImages, truncatedFilesAreRefusedWherever)
{
    for (const auto& [name, type] : {std::pair("a.png", TexelType::UInt8),
                                     {"b.tif", TexelType::UInt8},
                                     {"c.exr", TexelType::Half}}) {
        const std::string bytes = good(name, type);
        for (const double part : {0.4, 0.95}) {
            const auto size = static_cast<std::size_t>(part * static_cast<double>(bytes.size()));
            EXPECT_NE(refusal(bytes.substr(0, std::max<std::size_t>(size, 9))), "accepted")
                << name << " cut to " << part;
        }
    }
}

TEST_F(HostileImages, aJpegWithoutItsEndIsRefused)
{
    const std::string bytes = bytesOf(TRIXEL_TEST_DATA "/image/grey.jpg");
    ASSERT_GT(bytes.size(), 100U);
    EXPECT_EQ(refusal(bytes), "accepted");
    EXPECT_THAT(refusal(bytes.substr(0, bytes.size() - 2)), HasSubstr("cut off"));
    EXPECT_THAT(refusal(bytes.substr(0, bytes.size() / 2)),
                AnyOf(HasSubstr("cut off"), HasSubstr("damaged")));
}

TEST_F(HostileImages, damagedBytesNeverReachThisProcess)
{
    std::uint32_t state = 1;
    const auto random = [&state] { return state = state * 1664525U + 1013904223U, state >> 8U; };
    for (const auto& [name, type] : {std::pair("a.png", TexelType::UInt8),
                                     {"b.tif", TexelType::UInt16},
                                     {"c.exr", TexelType::Half}}) {
        const std::string bytes = good(name, type);
        for (int mutant = 0; mutant < 2; ++mutant) {
            std::string damaged = bytes;
            for (int k = 0; k < 6; ++k) {
                damaged[16 + random() % (damaged.size() - 16)] = static_cast<char>(random());
            }
            refusal(damaged); // accepted or not: with a sentence, and alive
        }
    }
}

TEST_F(HostileImages, memoryAndTimeAreLimited)
{
    const Image image = wavyImage(2000, 2000, TexelType::UInt8, 3);
    ASSERT_TRUE(write(at("a.png"), {&image, 1}));
    const std::string bytes = bytesOf(at("a.png"));
    ImageLimits limits;
    limits.memoryBytes = 1 << 20U; // less than the libraries have already
    EXPECT_THAT(
        refusal(bytes, limits),
        AnyOf(HasSubstr("more memory"), HasSubstr("its decoder failed"), HasSubstr("damaged")));
    limits = {};
    limits.wallTime = std::chrono::seconds(0);
    EXPECT_THAT(refusal(bytes, limits), HasSubstr("too long"));
}

TEST_F(HostileImages, whatIsNoFileIsRefused)
{
    const auto refused = [&](const std::filesystem::path& path) {
        const auto image = read(path);
        return image ? Error{} : image.error();
    };
    EXPECT_EQ(refused(at("missing")).kind, ErrorKind::Path);
    EXPECT_THAT(refused(folder).message, HasSubstr("is a directory"));
    ASSERT_EQ(::mkfifo(at("pipe").c_str(), 0600), 0);
    EXPECT_THAT(refused(at("pipe")).message, HasSubstr("not a regular file"));
    EXPECT_THAT(refused("/dev/zero").message, HasSubstr("not a regular file"));
}

TEST_F(HostileImages, readingCanBeCancelled)
{
    const auto path = put("a.png", good("b.png", TexelType::UInt8));
    CancelAfter progress(0);
    const auto image = readImage(worker, path, progress);
    ASSERT_FALSE(image);
    EXPECT_EQ(image.error().kind, ErrorKind::Cancelled);
}

/// Programs in the worker's place that answer wrongly.
TEST_F(HostileImages, aDecoderThatLiesIsNotBelieved)
{
    const auto path = put("a.png", good("b.png", TexelType::UInt8));
    const auto refusedBy = [&](const std::string& script) {
        put("liar", "#!/bin/sh\n" + script);
        std::filesystem::permissions(at("liar"), std::filesystem::perms::owner_all);
        worker = ImageWorker(at("liar"));
        const auto image = read(path);
        return image ? std::string("accepted") : image.error().message;
    };
    const std::string answer =
        R"({"width":8,"height":8,"type":"uint8","channels":3,"alpha":-1,"colors":"raw,raw,raw"})";
    EXPECT_THAT(refusedBy("echo '" + answer + "' >&5\n"), HasSubstr("handed over 0 bytes"));
    EXPECT_THAT(refusedBy("echo '" + answer + "' >&5; echo 12345 >&4\n"),
                HasSubstr("handed over 6 bytes, expected 192"));
    // As many bytes as it says; a width that wraps round to 8; opacity where no channel is.
    const auto changed = [&](const std::string& from, const std::string& to) {
        std::string lie = answer;
        lie.replace(lie.find(from), from.size(), to);
        return "head -c 192 /dev/zero >&4; echo '" + lie + "' >&5\n";
    };
    EXPECT_EQ(refusedBy(changed("8", "8")), "accepted");
    EXPECT_THAT(refusedBy(changed("8", "4294967304")), HasSubstr("answers nonsense"));
    EXPECT_THAT(refusedBy(changed("-1", "3")), HasSubstr("answers nonsense"));
    EXPECT_THAT(refusedBy(changed("\"channels\":3", "\"channels\":65")),
                HasSubstr("answers nonsense"));
    EXPECT_EQ(refusedBy(changed("raw,raw,raw", "linear,linear")), "accepted");
    EXPECT_EQ(read(path)->colors(), std::vector<ColorSpace>(3, ColorSpace::SRgb));
    EXPECT_THAT(refusedBy("echo '{\"width\":1e9}' >&5\n"), HasSubstr("answers nonsense"));
    EXPECT_THAT(refusedBy("echo '{\"width\":\"a\"}' >&5\n"), HasSubstr("answers nonsense"));
    EXPECT_THAT(refusedBy("echo 'no json' >&5\n"), HasSubstr("its decoder failed"));
    EXPECT_THAT(refusedBy("yes >&5\n"), HasSubstr("answers without end"));
    EXPECT_THAT(refusedBy("echo '" + answer + "' >&5; exec 5>&-; sleep 100\n"),
                HasSubstr("its decoder failed"));
    EXPECT_THAT(refusedBy("kill -SEGV $$\n"), HasSubstr("its decoder failed"));
    EXPECT_THAT(refusedBy("kill -XCPU $$\n"), HasSubstr("too long"));
    EXPECT_THAT(refusedBy("exit 3\n"), HasSubstr("its decoder failed"));
}

} // namespace
} // namespace trixel
