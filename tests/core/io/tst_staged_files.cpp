// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/read_file.h"
#include "core/io/commit_file.h"
#include "core/io/staged_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <unistd.h>

using namespace trixel;
namespace fs = std::filesystem;
using testing::HasSubstr;

namespace {

class StagedFilesTest : public testing::Test
{
protected:
    StagedFilesTest() { fs::create_directories(m_folder); }
    ~StagedFilesTest() override { fs::remove_all(m_base); }

    static void put(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }
    std::string content(const std::string& name) const
    {
        return readFile(m_folder / name).value_or("<none>");
    }
    /// Writes "new a" as a and so on, and gives all their names.
    Status commit(const std::vector<std::string>& names) const
    {
        StagedFiles files = StagedFiles::beside(m_folder).value();
        for (const std::string& name : names) {
            put(files.add(name), "new " + name);
        }
        return files.commit();
    }
    std::size_t fileCount() const
    {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(m_folder), fs::directory_iterator()));
    }

    fs::path m_base = fs::temp_directory_path() / ("trixel-staged-" + std::to_string(::getpid()));
    fs::path m_folder = m_base / "target";
};

TEST_F(StagedFilesTest, allTakeTheirNamesAndNothingElseStays)
{
    put(m_folder / "b", "old");
    ASSERT_TRUE(commit({"a", "b"}));
    EXPECT_EQ(content("a"), "new a");
    EXPECT_EQ(content("b"), "new b");
    EXPECT_EQ(fileCount(), 2U);
}

TEST_F(StagedFilesTest, oneThatMustNotBeReplacedStopsAllOfThem)
{
    put(m_folder / "a", "old");
    put(m_folder / "readonly", "old");
    fs::permissions(m_folder / "readonly", fs::perms::owner_read);
    fs::create_directory(m_folder / "folder");
    for (const auto& [last, cause] :
         {std::pair("readonly", "is read-only"), {"folder", "is a directory, not a file"}}) {
        const Status committed = commit({"a", "b", last});
        ASSERT_FALSE(committed) << last;
        EXPECT_EQ(committed.error().kind, ErrorKind::Path);
        EXPECT_EQ(committed.error().message, (m_folder / last).string() + ": " + cause);
        EXPECT_EQ(content("a"), "old");
        EXPECT_FALSE(fs::exists(m_folder / "b"));
        EXPECT_EQ(content("readonly"), "old");
        EXPECT_EQ(fileCount(), 3U); // nothing of the attempt is left
    }
}

TEST_F(StagedFilesTest, linksAreFollowedToWhereverTheyLead)
{
    const fs::path elsewhere = m_base / "elsewhere";
    fs::create_directory(elsewhere);
    put(elsewhere / "far", "old");
    put(m_folder / "near", "old");
    fs::create_symlink(elsewhere / "far", m_folder / "a");
    fs::create_symlink("near", m_folder / "b");
    ASSERT_TRUE(commit({"a", "b"}));
    EXPECT_TRUE(fs::is_symlink(m_folder / "a") && fs::is_symlink(m_folder / "b"));
    EXPECT_EQ(readFile(elsewhere / "far").value(), "new a");
    EXPECT_EQ(content("near"), "new b");
    EXPECT_EQ(std::distance(fs::directory_iterator(elsewhere), fs::directory_iterator()), 1);
    EXPECT_EQ(fileCount(), 3U);
}

TEST_F(StagedFilesTest, replacedFilesKeepTheirModes)
{
    put(m_folder / "a", "old");
    const fs::perms mode = fs::perms::owner_read | fs::perms::owner_write | fs::perms::others_read;
    fs::permissions(m_folder / "a", mode);
    ASSERT_TRUE(commit({"a"}));
    EXPECT_EQ(content("a"), "new a");
    EXPECT_EQ(fs::status(m_folder / "a").permissions(), mode);
}

TEST_F(StagedFilesTest, whatIsNotCommittedGoesAgain)
{
    put(m_folder / "a", "old");
    {
        StagedFiles files = StagedFiles::beside(m_folder).value();
        put(files.add("a"), "new");
        put(files.scratch("b"), "meanwhile");
        EXPECT_EQ(fileCount(), 2U);
    }
    EXPECT_EQ(content("a"), "old");
    EXPECT_EQ(fileCount(), 1U);
}

TEST_F(StagedFilesTest, whetherAFileMayBeReplacedIsSaidBeforehand)
{
    put(m_folder / "a", "old");
    fs::permissions(m_folder / "a", fs::perms::owner_read);
    EXPECT_THAT(checkReplaceable(m_folder / "a").error().message, HasSubstr("is read-only"));
    EXPECT_THAT(checkReplaceable(m_folder).error().message, HasSubstr("is a directory"));
    EXPECT_TRUE(checkReplaceable(m_folder / "free"));
}

} // namespace
