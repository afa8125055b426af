// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ids.h"
#include "core/base/level.h"
#include "core/base/progress.h"
#include "core/base/result.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace trixel {

/// How the texels of one face differ. Values are compared as numbers: integers in [0,1], half and
/// float as they are; a NaN equals only a NaN, and differs from anything else by infinity.
struct PtxFaceDifference
{
    FaceId face{};
    Level levelOfA;
    Level levelOfB;
    std::uint64_t texels = 0; ///< that differ in any channel; 0 where the levels differ
    double maxAbs = 0;
    double rms = 0; ///< over all texels and channels of the face
};

struct PtxDiff
{
    /// Why the texels could not be compared (face counts, channels); then nothing below is filled.
    std::string incomparable;
    /// Differences that are not of texels, each a sentence: data type, alpha channel, metadata,
    /// links between faces, stored reductions.
    std::vector<std::string> notes;
    /// Every face whose level or texels differ, by number.
    std::vector<PtxFaceDifference> faces;
    std::uint64_t levelDifferences = 0; ///< faces of differing level
    std::uint64_t texels = 0;           ///< texels that differ, over all faces of equal level
    double maxAbs = 0;                  ///< over all faces of equal level
    double rms = 0;                     ///< over all texels and channels of those faces

    bool isEqual() const { return incomparable.empty() && notes.empty() && faces.empty(); }
};

/// Compares two .ptx at full resolution, edits folded in. Errors name the file.
Result<PtxDiff>
diffPtx(const std::filesystem::path& a, const std::filesystem::path& b, Progress& progress);

} // namespace trixel
