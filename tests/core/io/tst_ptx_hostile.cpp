// SPDX-License-Identifier: GPL-3.0-or-later
//
// Damaged files open right or are refused with one sentence; nothing crashes or hangs.
#include "core/io/ptx.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <random>

using namespace trixel;

namespace {

const std::filesystem::path kData = TRIXEL_TEST_DATA;

std::string contentOf(const std::filesystem::path& path)
{
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void expectAnswer(const Result<PtxContents>& read)
{
    if (!read) {
        EXPECT_EQ(read.error().kind, ErrorKind::Contents);
        EXPECT_FALSE(read.error().message.empty());
        EXPECT_EQ(read.error().message.find('\n'), std::string::npos);
    }
}

Result<PtxContents> parse(std::string_view bytes)
{
    NoProgress progress;
    return parsePtx(bytes, progress);
}

std::string messageOf(std::string_view bytes)
{
    const auto read = parse(bytes);
    return read ? std::string("was opened") : read.error().message;
}

} // namespace

TEST(PtxHostile, everyCollectedFileIsRefusedWithOneSentenceInTime)
{
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(kData / "hostile" / "ptx")) {
        SCOPED_TRACE(entry.path().filename().string());
        NoProgress progress;
        const auto start = std::chrono::steady_clock::now();
        const auto read = readPtx(entry.path(), progress);
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
        ASSERT_FALSE(read.has_value());
        expectAnswer(read);
        EXPECT_NE(read.error().message.find(entry.path().filename().string()), std::string::npos);
        ++count;
    }
    EXPECT_EQ(count, 8U);
}

TEST(PtxHostile, everyTruncationOfAFileIsRefused)
{
    const std::string whole = contentOf(kData / "ptx" / "fmt_0_2.ptx");
    ASSERT_TRUE(parse(whole).has_value());
    for (std::size_t size = 0; size < whole.size(); size += size < 2048 ? 1 : 61) {
        const auto read = parse(std::string_view(whole).substr(0, size));
        ASSERT_FALSE(read.has_value()) << size;
        expectAnswer(read);
    }
}

TEST(PtxHostile, everyByteOfTheStructureMayBeAnything)
{
    const std::string whole = contentOf(kData / "ptx" / "fmt_1_3.ptx");
    for (std::size_t at = 0; at < 1024; ++at) {
        for (int value : {0x00, 0x01, 0x7F, 0x80, 0xFF}) {
            std::string bytes = whole;
            bytes[at] = static_cast<char>(value);
            expectAnswer(parse(bytes));
        }
    }
}

TEST(PtxHostile, randomDamageAnywhereIsAnswered)
{
    std::mt19937 random(7);
    for (const char* name : {"fmt_0_1.ptx", "fmt_3_3.ptx"}) {
        const std::string whole = contentOf(kData / "ptx" / name);
        for (int k = 0; k < 300; ++k) {
            std::string bytes = whole;
            for (int flips = 1 + k % 8; flips > 0; --flips) {
                bytes[random() % bytes.size()] = static_cast<char>(random());
            }
            expectAnswer(parse(bytes));
        }
    }
}

TEST(PtxHostile, refusalsSayWhatWasExpected)
{
    std::string bytes = contentOf(kData / "ptx" / "fmt_0_0.ptx");
    const auto with = [&](std::size_t at, char value) {
        std::string changed = bytes;
        changed[at] = value;
        return messageOf(changed);
    };
    EXPECT_NE(messageOf("").find("has 0 bytes"), std::string::npos);
    EXPECT_NE(with(0, 'Q').find("not a .ptx"), std::string::npos);
    EXPECT_NE(with(4, 2).find("version 2"), std::string::npos);
    EXPECT_NE(with(8, 1).find("quads"), std::string::npos);
    EXPECT_NE(with(12, 9).find("data type 9"), std::string::npos);
    EXPECT_NE(with(16, 3).find("as alpha"), std::string::npos);
    EXPECT_NE(with(20, 0).find("0 channels"), std::string::npos);
    EXPECT_NE(with(22, 99).find("99 levels"), std::string::npos);
    EXPECT_NE(with(27, 0x7F).find("faces"), std::string::npos);
}

TEST(PtxHostile, pathsThatAreNoFilesAreNamed)
{
    NoProgress progress;
    for (const auto& path : {kData / "ptx", kData / "no such file.ptx"}) {
        const auto read = readPtx(path, progress);
        ASSERT_FALSE(read.has_value());
        EXPECT_EQ(read.error().kind, ErrorKind::Path);
        EXPECT_NE(read.error().message.find(path.filename().string()), std::string::npos);
    }
}
