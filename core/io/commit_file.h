// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string_view>

namespace trixel {

/// A file being filled by `commitFile`.
class FileWriter
{
public:
    virtual ~FileWriter() = default;

    /// Appends bytes. Errors (kind Path) name the file and the cause.
    virtual Status write(std::span<const std::byte> bytes) = 0;
    Status write(std::string_view text) { return write(std::as_bytes(std::span(text))); }
};

/// Replaces a file whole or not at all: fills a temporary file in the same folder, syncs it,
/// verifies it, renames it, syncs the folder. Whatever fails, a file that was there stays as it
/// was, and the temporary file is removed. A link is followed: what it points to is replaced.
/// Errors of the file system are of kind Path and name the file and the cause.
/// \param write   fills the file; what it returns as an error is the outcome
/// \param verify  reads the finished file (under its temporary name) and compares it with what was
///                meant; its errors need not name the file
Status commitFile(const std::filesystem::path& path,
                  const std::function<Status(FileWriter&)>& write,
                  const std::function<Status(const std::filesystem::path& written)>& verify);

/// Fails, naming the path, if a file of that name must not be replaced: a folder, a device or a
/// pipe, or a file that is read-only. A name that is free is fine.
Status checkReplaceable(const std::filesystem::path& path);

/// A file that is written and synced, on its way to its name.
struct WrittenFile
{
    std::filesystem::path written; ///< in the file system of the target's folder
    std::filesystem::path target;
};

/// Gives files that belong together their names, in this order, as `commitFile` does: links are
/// followed, modes kept, folders synced. All targets are looked at before the first is replaced
/// (`checkReplaceable`): errors leave everything as it was, unless the system refuses a name in the
/// midst of it; those before it are replaced then.
Status commitWritten(std::span<const WrittenFile> files);

} // namespace trixel
