// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <functional>
#include <iosfwd>

namespace trixel {

/// Replaces a file whole or not at all: writes a temporary file in the same folder, syncs it,
/// re-opens and verifies it, renames it, syncs the folder. Whatever fails, a file that was there
/// stays as it was, and the temporary file is removed.
/// \param write   fills the temporary file; what it returns as an error is the outcome
/// \param verify  reads the finished temporary file and compares it with what was meant
Status commitFile(const std::filesystem::path& path,
                  const std::function<Status(std::ostream&)>& write,
                  const std::function<Status(const std::filesystem::path& written)>& verify);

/// All bytes of a regular file. Errors (kind Path) name the file and the cause: missing, a
/// directory, not readable, larger than `maxBytes`.
Result<std::string> readFile(const std::filesystem::path& path,
                             std::uint64_t maxBytes = std::uint64_t{64} << 30U);

} // namespace trixel
