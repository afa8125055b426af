// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/read_file.h"
#include "core/io/commit_file.h"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace trixel;
namespace fs = std::filesystem;

namespace {

class CommitFile : public testing::Test
{
protected:
    CommitFile()
    {
        fs::create_directories(m_folder);
        std::ofstream(m_path) << "old";
    }
    ~CommitFile() override { fs::remove_all(m_folder); }

    std::string content() const { return readFile(m_path).value_or("<none>"); }
    std::size_t fileCount() const
    {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(m_folder), fs::directory_iterator()));
    }
    void expectOldFileAlone() const
    {
        EXPECT_EQ(content(), "old");
        EXPECT_EQ(fileCount(), 1U);
    }

    fs::path m_folder = fs::temp_directory_path() / ("trixel-commit-" + std::to_string(::getpid()));
    fs::path m_path = m_folder / "file.txt";
};

Status accept(const fs::path& /*written*/)
{
    return {};
}

Status writeNew(FileWriter& file)
{
    return file.write("new");
}

} // namespace

TEST_F(CommitFile, replacesTheWholeFile)
{
    std::string verified;
    const Status status = commitFile(m_path, writeNew, [&](const fs::path& written) {
        EXPECT_EQ(content(), "old");
        EXPECT_EQ(written.parent_path(), m_path.parent_path());
        verified = readFile(written).value();
        return Status();
    });
    ASSERT_TRUE(status.has_value()) << status.error().message;
    EXPECT_EQ(verified, "new");
    EXPECT_EQ(content(), "new");
    EXPECT_EQ(fileCount(), 1U);
}

TEST_F(CommitFile, makesAFileThatWasNotThere)
{
    fs::remove(m_path);
    ASSERT_TRUE(commitFile(m_path, writeNew, accept).has_value());
    EXPECT_EQ(content(), "new");
}

TEST_F(CommitFile, failedWritingLeavesTheOldFile)
{
    const Status status = commitFile(
        m_path,
        [](FileWriter& file) -> Status {
            EXPECT_TRUE(file.write("half").has_value());
            return cancelled();
        },
        accept);
    ASSERT_FALSE(status.has_value());
    EXPECT_EQ(status.error().kind, ErrorKind::Cancelled);
    expectOldFileAlone();
}

TEST_F(CommitFile, failedVerificationLeavesTheOldFile)
{
    const Status status = commitFile(m_path, writeNew, [](const fs::path&) -> Status {
        return contentsError("face 3 differs");
    });
    ASSERT_FALSE(status.has_value());
    EXPECT_THAT(status.error().message, testing::HasSubstr("file.txt"));
    EXPECT_THAT(status.error().message, testing::HasSubstr("face 3 differs"));
    expectOldFileAlone();
}

TEST_F(CommitFile, aDirectoryIsNotReplaced)
{
    const Status status = commitFile(m_folder, writeNew, accept);
    ASSERT_FALSE(status.has_value());
    EXPECT_EQ(status.error().kind, ErrorKind::Path);
    EXPECT_THAT(status.error().message, testing::HasSubstr("is a directory"));
    expectOldFileAlone();
}

TEST_F(CommitFile, aMissingFolderIsNamed)
{
    const Status status = commitFile(m_folder / "none" / "file.txt", writeNew, accept);
    ASSERT_FALSE(status.has_value());
    EXPECT_EQ(status.error().kind, ErrorKind::Path);
    EXPECT_THAT(status.error().message, testing::HasSubstr("No such file or directory"));
}

TEST_F(CommitFile, aReadOnlyFileStays)
{
    fs::permissions(m_path, fs::perms::owner_read);
    const Status status = commitFile(m_path, writeNew, accept);
    ASSERT_FALSE(status.has_value());
    EXPECT_EQ(status.error().kind, ErrorKind::Path);
    EXPECT_THAT(status.error().message, testing::HasSubstr("read-only"));
    expectOldFileAlone();
}

TEST_F(CommitFile, permissionsOfTheFileAreKept)
{
    fs::permissions(m_path, fs::perms::owner_read | fs::perms::owner_write);
    ASSERT_TRUE(commitFile(m_path, writeNew, accept).has_value());
    EXPECT_EQ(fs::status(m_path).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(CommitFile, aLinkKeepsPointingToTheReplacedFile)
{
    const fs::path link = m_folder / "link.txt";
    fs::create_symlink(m_path.filename(), link);
    ASSERT_TRUE(commitFile(link, writeNew, accept).has_value());
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(content(), "new");
}

// A folder without write permission stops all but the superuser: the test becomes a user.
TEST_F(CommitFile, aReadOnlyFolderIsNamed)
{
    fs::permissions(m_folder,
                    fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_all,
                    fs::perm_options::replace);
    fs::permissions(m_folder, fs::perms::others_write, fs::perm_options::remove);
    fs::permissions(m_path, fs::perms::all);
    const pid_t child = ::fork();
    if (child == 0) {
        if (::geteuid() == 0 && ::seteuid(65534) != 0) {
            ::_exit(2);
        }
        const Status status = commitFile(m_path, writeNew, accept);
        ::_exit(!status && status.error().kind == ErrorKind::Path &&
                        status.error().message.find("file.txt") != std::string::npos &&
                        status.error().message.find("Permission denied") != std::string::npos
                    ? 0
                    : 1);
    }
    int outcome = 0;
    ::waitpid(child, &outcome, 0);
    EXPECT_EQ(WEXITSTATUS(outcome), 0);
    fs::permissions(m_folder, fs::perms::all);
    expectOldFileAlone();
}

// A limit on the size of files stands for a full disk.
TEST_F(CommitFile, aFullDiskLeavesTheOldFile)
{
    const pid_t child = ::fork();
    if (child == 0) {
        ::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{1 << 20U, 1 << 20U};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        const Status status = commitFile(
            m_path,
            [](FileWriter& file) { return file.write(std::string(3 << 20U, 'x')); },
            accept);
        ::_exit(!status && status.error().kind == ErrorKind::Path &&
                        status.error().message.find("file.txt: cannot be written") !=
                            std::string::npos
                    ? 0
                    : 1);
    }
    int outcome = 0;
    ::waitpid(child, &outcome, 0);
    EXPECT_EQ(WEXITSTATUS(outcome), 0);
    expectOldFileAlone();
}
