// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/read_file.h"
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

} // namespace trixel
