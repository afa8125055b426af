// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <memory>

namespace trixel {

/// A temporary folder of its own, removed with all that is in it.
class TemporaryFolder
{
public:
    static Result<std::shared_ptr<const TemporaryFolder>> make();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return m_path; }

private:
    explicit TemporaryFolder(std::filesystem::path path);

    std::filesystem::path m_path;
};

/// Address of a symbol of a module, which stays loaded: the libraries behind it do not bear being
/// unloaded. Errors say why there is none.
Result<void*> moduleSymbol(const std::filesystem::path& module, const char* symbol);

} // namespace trixel
