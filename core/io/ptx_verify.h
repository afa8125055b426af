// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/ptx.h"
#include "core/io/ptx_layout.h"

#include <filesystem>
#include <span>

namespace trixel {

/// Reads a file that was just written and compares it with what was meant: the infos of all faces,
/// constant values and averages, every texel of full resolution, every reduction against the texels
/// it is made from, and the metadata. The error names the first face or item that differs.
Status verifyPtx(const std::filesystem::path& written,
                 const PtxContents& contents,
                 std::span<const PtxFaceInfo> infos,
                 std::span<const std::byte> constants,
                 Threads threads,
                 Progress& progress);

} // namespace trixel
