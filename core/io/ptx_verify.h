// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/ptx.h"
#include "core/io/ptx_faces.h"

#include <filesystem>

namespace trixel {

/// Reads a file that was just written and compares it with what was meant: the infos of all faces,
/// constant values and averages, every texel of full resolution, the blocks of the reductions byte
/// for byte, and the metadata. The error names the first face or item that differs.
/// \param packed  what was written; the blocks of full resolution are not looked at
Status verifyPtx(const std::filesystem::path& written,
                 const PtxContents& contents,
                 const PtxFaces& packed,
                 Threads threads,
                 Progress& progress);

} // namespace trixel
