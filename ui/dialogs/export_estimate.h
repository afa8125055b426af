// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/io/export_project.h"
#include "core/texture/texel_store.h"

namespace trixel::ui {

/// What a `.ptx` would weigh, before it is written.
struct ExportEstimate
{
    std::uint64_t texels = 0;      ///< at full resolution, constant faces counted as one
    std::uint64_t plainBytes = 0;  ///< of all texels written, mips included, before compression
    std::uint64_t likelyBytes = 0; ///< of the file, as a sample of the faces compresses
};

/// Compresses a few dozen faces spread over the mesh the way a `.ptx` does (channel by channel,
/// differences for integers) and takes them for the rest. Looks at every face once.
ExportEstimate estimatePtx(const TexelStore& texels, TexelType type, bool mips);

/// What an export will take, in a sentence or two: pages, bytes, time. The time is that of a sample
/// of the work, done here and now. Errors: what stands against it.
Result<QString>
estimateExport(const Project& project, const ExportRequest& request, Progress& progress);

} // namespace trixel::ui
