// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/staged_files.h"

#include "core/base/check.h"
#include "core/io/commit_file.h"

#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace trixel {

namespace fs = std::filesystem;

namespace {

std::string lastCause()
{
    return std::generic_category().message(errno);
}

} // namespace

StagedFiles::StagedFiles(fs::path target, fs::path folder)
    : m_target(std::move(target))
    , m_folder(std::move(folder))
{
}

StagedFiles::StagedFiles(StagedFiles&& other) noexcept
    : m_target(std::move(other.m_target))
    , m_folder(std::exchange(other.m_folder, {}))
    , m_names(std::move(other.m_names))
{
}

StagedFiles::~StagedFiles()
{
    if (!m_folder.empty()) {
        std::error_code ignored;
        fs::remove_all(m_folder, ignored);
    }
}

Result<StagedFiles> StagedFiles::beside(const fs::path& target)
{
    const fs::path folder = target.empty() ? fs::path(".") : target;
    std::string name = (folder / ".trixel-export-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
        return pathError(folder.string() + ": " + lastCause());
    }
    return StagedFiles(folder, name);
}

fs::path StagedFiles::add(const std::string& name)
{
    check(!name.empty() && fs::path(name).filename() == name, "the name of a file");
    m_names.push_back(name);
    return m_folder / name;
}

fs::path StagedFiles::scratch(const std::string& name) const
{
    return m_folder / name;
}

Error StagedFiles::told(Error error) const
{
    const std::string folder = m_folder.string();
    for (std::size_t at = error.message.find(folder); at != std::string::npos;
         at = error.message.find(folder, at)) {
        error.message.replace(at, folder.size(), m_target.string());
    }
    return error;
}

Status StagedFiles::commit()
{
    std::vector<WrittenFile> files;
    for (const std::string& name : m_names) {
        files.push_back({m_folder / name, m_target / name});
    }
    if (Status committed = commitWritten(files); !committed) {
        return committed;
    }
    std::error_code ignored;
    fs::remove_all(m_folder, ignored);
    m_folder.clear();
    return {};
}

} // namespace trixel
