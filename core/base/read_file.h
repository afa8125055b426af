// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace trixel {

/// All bytes of a regular file. Errors (kind Path) name the file and the cause: missing, a
/// directory or another special file, not readable, larger than `maxBytes`.
Result<std::string> readFile(const std::filesystem::path& path,
                             std::uint64_t maxBytes = std::uint64_t{64} << 30U);

} // namespace trixel
