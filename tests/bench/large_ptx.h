// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <filesystem>

namespace trixel {

/// Writes a .ptx of about so many bytes, of a wavy sheet of large faces (8-bit RGB) with its mesh,
/// all reductions and averages, as `exportPtx` would lay it out. A few faces are packed and stand
/// in the file again and again: that takes seconds, not the minute of packing each. \param log2
/// level of the faces
Status writeLargePtx(const std::filesystem::path& path, std::uint64_t bytes, int log2);

} // namespace trixel
