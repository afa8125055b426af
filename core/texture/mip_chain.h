// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/texture/mips.h"

#include <vector>

namespace trixel {

/// Every level of one face, from its own down to the one texel of level 0, each made from the
/// finer one as stored. A value: copies share texels.
class MipChain
{
public:
    /// No levels at all; only a placeholder.
    MipChain() = default;

    /// Costs a third more than reading the face. Fails only when cancelled.
    static Result<MipChain>
    build(const TexelFormat& format, FaceTexels face, ReductionRule rule, Progress& progress);

    /// The face's own level.
    Level base() const { return m_levels.front().level(); }
    /// \param level  not above `base` (checked)
    const FaceTexels& at(Level level) const;
    /// Bytes of texels that were made for it: of all levels but the face's own.
    std::uint64_t madeBytes() const;

private:
    std::vector<FaceTexels> m_levels; ///< from the finest
};

/// How far two reductions of a face lie apart at one level, over all texels and channels, as
/// numbers (integers spread over [0,1]). What is not finite in one of them is left out.
struct TexelDifference
{
    double worst = 0;
    double rms = 0;

    bool operator==(const TexelDifference&) const = default;
};

/// \param a, b  of one level and in that format (checked)
TexelDifference
differenceBetween(const TexelFormat& format, const FaceTexels& a, const FaceTexels& b);

} // namespace trixel
