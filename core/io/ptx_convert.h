// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/texture/texel_format.h"

#include <filesystem>
#include <optional>

namespace trixel {

struct PtxConvertOptions
{
    std::optional<TexelType> type; ///< as it is, if nothing
    bool mips = true;
};

/// Rewrites a .ptx: edits folded in, reductions made anew, adjacency and metadata kept. Both paths
/// may be the same. Errors name the file; the file at `to` is replaced whole or not at all.
Status convertPtx(const std::filesystem::path& from,
                  const std::filesystem::path& to,
                  const PtxConvertOptions& options,
                  Progress& progress);

} // namespace trixel
