// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/app/program_run.h"

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

namespace trixel::test {

inline std::string contentsOf(const std::filesystem::path& file)
{
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

inline nlohmann::json jsonOf(const std::string& text)
{
    return nlohmann::json::parse(text, nullptr, false);
}

/// One sentence on standard error, and nothing else there.
MATCHER(IsOneLine, "is one line that ends in a line break")
{
    return arg.size() > 1 && arg.find('\n') == arg.size() - 1;
}

/// A run that ended with the exit status and one line on standard error that holds the text.
MATCHER_P2(FailsWith,
           status,
           text,
           "fails with status " + std::to_string(status) + " and '" + std::string(text) + "'")
{
    return arg.status == status && arg.err.find(text) != std::string::npos && arg.out.empty() &&
           testing::Matches(IsOneLine())(arg.err);
}

/// A run that ended with the exit status and said nothing on standard error.
MATCHER_P(EndsWith, status, "ends with status " + std::to_string(status) + " and no complaint")
{
    return arg.status == status && arg.err.empty();
}

/// A folder of its own for each test, gone afterwards.
class CommandLine : public testing::Test
{
protected:
    void SetUp() override
    {
        std::string name = (std::filesystem::temp_directory_path() / "trixel-cli-XXXXXX").string();
        m_folder = mkdtemp(name.data());
    }
    void TearDown() override { std::filesystem::remove_all(m_folder); }

    std::string path(const std::string& name) const { return (m_folder / name).string(); }

    std::string write(const std::string& name, const std::string& text) const
    {
        std::ofstream(m_folder / name, std::ios::binary) << text;
        return path(name);
    }

    /// Names of the files in the folder, ascending.
    std::vector<std::string> files() const
    {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(m_folder)) {
            names.push_back(entry.path().filename().string());
        }
        std::sort(names.begin(), names.end());
        return names;
    }

    /// A tetrahedron with edges of about one unit.
    std::string mesh() const
    {
        return write("mesh.obj",
                     "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                     "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    }

    /// A project of the tetrahedron; `options` go to `trixel new`.
    std::string project(const std::vector<std::string>& options = {"--level", "4"}) const
    {
        std::vector<std::string> arguments = {"new", mesh(), "-o", path("new.trixel")};
        arguments.insert(arguments.end(), options.begin(), options.end());
        EXPECT_THAT(runTrixel(arguments), EndsWith(0));
        return path("new.trixel");
    }

    /// One red stroke from face 1 over an edge to face 2; `brush` replaces settings of it.
    std::string strokes(const nlohmann::json& brush = nlohmann::json::object()) const
    {
        nlohmann::json settings = {{"radius", 0.1},
                                   {"unit", "world"},
                                   {"hardness", 0.5},
                                   {"opacity", 1},
                                   {"flow", 1},
                                   {"spacing", 0.1},
                                   {"blend", "normal"},
                                   {"color", {1, 0, 0}}};
        settings.update(brush);
        const nlohmann::json file = {
            {"version", 1},
            {"strokes",
             {{{"layer", 0},
               {"brush", settings},
               {"samples",
                {{{"face", 1}, {"u", 0.3}, {"v", 0.3}, {"pressure", 1}, {"time", 0.0}},
                 {{"face", 1}, {"u", 0.5}, {"v", 0.45}, {"pressure", 1}, {"time", 0.1}},
                 {{"face", 2}, {"u", 0.2}, {"v", 0.5}, {"pressure", 1}, {"time", 0.2}}}}}}}};
        return write("strokes.json", file.dump());
    }

private:
    std::filesystem::path m_folder;
};

} // namespace trixel::test
