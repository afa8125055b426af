// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the texels of two stores, or of two files, differ face by face.
#pragma once

#include "core/base/ids.h"
#include "core/base/level.h"
#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/texture/texel_store.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace trixel {

/// How the texels of one face differ. Values are compared as numbers: integers in [0,1], half and
/// float as they are; a NaN equals only a NaN, and differs from anything else by infinity.
struct FaceDifference
{
    FaceId face{};
    Level levelOfA;
    Level levelOfB;
    std::uint64_t texels = 0; ///< that differ in any channel; 0 where the levels differ
    double maxAbs = 0;
    double rms = 0; ///< over all texels and channels of the face
};

struct TexelDiff
{
    /// Every face whose level or texels differ, by number.
    std::vector<FaceDifference> faces;
    std::uint64_t levelDifferences = 0; ///< faces of differing level
    std::uint64_t texels = 0;           ///< texels that differ, over all faces of equal level
    double maxAbs = 0;                  ///< over all faces measured
    double rms = 0;                     ///< over all texels and channels of those faces
    /// What errors are told in parts of: 1 for integers, else the span of A's finite values (1
    /// where they are all alike).
    double peak = 1;

    /// Peak signal to noise ratio in dB, 20 log10(peak / rms); infinite where nothing differs.
    double psnr() const;
};

struct TexelDiffOptions
{
    /// Also measures faces of differing level, at the finer of the two, the coarser one seen as its
    /// texels stand; otherwise they count in no figure but `levelDifferences`.
    bool acrossLevels = false;
    Threads threads = Threads::all();
};

/// Gives the texels of a face; each thread has its own.
using FaceSource = std::function<Result<FaceTexels>(FaceId)>;

/// One of the two that are compared.
struct DiffSide
{
    TexelFormat format;
    std::uint32_t faceCount = 0;
    std::function<Level(FaceId)> level; ///< of a face, from any thread
    std::function<FaceSource()> makeSource;

    /// Of a store that outlives the comparison. Stored faces are read without being kept.
    static DiffSide of(const TexelStore& texels);
};

/// Why two sides cannot be compared (other numbers of faces or channels), or empty.
std::string incomparable(const DiffSide& a, const DiffSide& b);

/// Compares all faces. The sides are comparable (checked). Fails when cancelled and when a face
/// cannot be read.
Result<TexelDiff> diffTexels(const DiffSide& a,
                             const DiffSide& b,
                             const TexelDiffOptions& options,
                             Progress& progress);

} // namespace trixel
