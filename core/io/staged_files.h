// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace trixel {

/// Files that belong together, written to a folder of their own beside the place they are meant
/// for, and moved there when all are done. What was there before stays until then; if something
/// fails or is cancelled the folder is removed.
class StagedFiles
{
public:
    /// \param target  the folder that the files are meant for. Errors: it cannot be written to
    /// (Path)
    static Result<StagedFiles> beside(const std::filesystem::path& target);

    StagedFiles(StagedFiles&& other) noexcept;
    StagedFiles& operator=(StagedFiles&&) = delete;
    StagedFiles(const StagedFiles&) = delete;
    StagedFiles& operator=(const StagedFiles&) = delete;
    ~StagedFiles();

    /// Where to write a file of this name (one that has no folder, checked).
    std::filesystem::path add(const std::string& name);

    /// Where to write what is only needed meanwhile.
    std::filesystem::path scratch(const std::string& name) const;

    /// An error as if files were written where they are meant to be.
    Error told(Error error) const;

    /// Moves every file to its place, in the order they were added: those that refer to others come
    /// last. Links are followed and modes kept. Errors name the file: one that must not be replaced
    /// (`checkReplaceable`) before any is moved; of others those before it are moved by then.
    Status commit();

private:
    StagedFiles(std::filesystem::path target, std::filesystem::path folder);

    std::filesystem::path m_target;
    std::filesystem::path m_folder; ///< empty once it is gone
    std::vector<std::string> m_names;
};

} // namespace trixel
