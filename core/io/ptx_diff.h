// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/texture/texel_diff.h"

#include <filesystem>
#include <string>
#include <vector>

namespace trixel {

using PtxFaceDifference = FaceDifference;

/// The texels' differences, and all others.
struct PtxDiff : TexelDiff
{
    /// Why the texels could not be compared (face counts, channels); then nothing below is filled.
    std::string incomparable;
    /// Differences that are not of texels, each a sentence: data type, alpha channel, metadata,
    /// links between faces, stored reductions.
    std::vector<std::string> notes;

    bool isEqual() const { return incomparable.empty() && notes.empty() && faces.empty(); }
};

/// Compares two .ptx at full resolution, edits folded in. Errors name the file.
Result<PtxDiff>
diffPtx(const std::filesystem::path& a, const std::filesystem::path& b, Progress& progress);

} // namespace trixel
