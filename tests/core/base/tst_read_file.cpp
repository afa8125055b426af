// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/read_file.h"

#include <fstream>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

namespace trixel {
namespace {

using testing::HasSubstr;

class ReadFileTest : public testing::Test
{
protected:
    ReadFileTest()
        : m_folder(std::filesystem::temp_directory_path() /
                   ("trixel_read_file_" + std::to_string(::getpid())))
    {
        std::filesystem::create_directory(m_folder);
    }
    ~ReadFileTest() override { std::filesystem::remove_all(m_folder); }

    // A file that cannot be read: error of kind Path that begins with its name.
    static std::string causeOf(const std::filesystem::path& path, std::uint64_t maxBytes = 100)
    {
        const auto bytes = readFile(path, maxBytes);
        EXPECT_FALSE(bytes);
        EXPECT_EQ(bytes.error().kind, ErrorKind::Path);
        EXPECT_THAT(bytes.error().message, testing::StartsWith(path.string() + ": "));
        return bytes.error().message;
    }

    std::filesystem::path m_folder;
};

TEST_F(ReadFileTest, givesAllBytes)
{
    std::string bytes(100'000, '\0');
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        bytes[i] = static_cast<char>(i * 31);
    }
    std::ofstream(m_folder / "f", std::ios::binary) << bytes;
    EXPECT_EQ(readFile(m_folder / "f"), bytes);
    std::ofstream(m_folder / "empty").flush();
    EXPECT_EQ(readFile(m_folder / "empty"), std::string());
}

TEST_F(ReadFileTest, namesTheCause)
{
    EXPECT_THAT(causeOf(m_folder / "missing"), HasSubstr("No such file"));
    EXPECT_THAT(causeOf(m_folder), HasSubstr("it is a directory"));
    std::ofstream(m_folder / "large") << std::string(101, 'x');
    EXPECT_THAT(causeOf(m_folder / "large"), HasSubstr("101 bytes, more than the limit of 100"));
    EXPECT_THAT(causeOf(m_folder / "large" / "below"), HasSubstr("Not a directory"));
}

TEST_F(ReadFileTest, doesNotWaitForAPipe)
{
    ASSERT_EQ(::mkfifo((m_folder / "pipe").c_str(), 0600), 0);
    EXPECT_THAT(causeOf(m_folder / "pipe"), HasSubstr("it is not a regular file"));
}

} // namespace
} // namespace trixel
