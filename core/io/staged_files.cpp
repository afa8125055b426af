// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/staged_files.h"

#include "core/base/check.h"
#include "core/io/commit_file.h"

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
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

/// What was renamed in it is on the disk then.
Status syncFolder(const fs::path& folder)
{
    const int handle = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const bool synced = handle >= 0 && ::fsync(handle) == 0;
    const std::string cause = synced ? "" : lastCause();
    if (handle >= 0) {
        ::close(handle);
    }
    return synced ? Status() : pathError(folder.string() + ": " + cause);
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
    for (const std::string& name : m_names) { // all of them before the first is moved
        if (Status replaceable = checkReplaceable(m_target / name); !replaceable) {
            return replaceable;
        }
    }
    for (const std::string& name : m_names) {
        std::error_code error;
        fs::rename(m_folder / name, m_target / name, error);
        if (error) {
            return pathError((m_target / name).string() + ": " + error.message());
        }
    }
    if (Status synced = syncFolder(m_target); !synced) {
        return synced;
    }
    std::error_code ignored;
    fs::remove_all(m_folder, ignored);
    m_folder.clear();
    return {};
}

} // namespace trixel
