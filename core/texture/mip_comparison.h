// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/lattice/texel.h"
#include "core/texture/mip_chain.h"

#include <vector>

namespace trixel {

/// All levels of one face by the right reduction and by the box of images, ready to be shown side
/// by side. It holds none of the face's own texels, so that who keeps it does not make the next
/// stroke copy them.
class MipComparison
{
public:
    /// Finer levels than this are drawn by their means at it: a picture of them would have to be
    /// wider than 256 pixels to show more.
    static constexpr Level kFinestDrawn{8};

    /// Costs about as much as reading the face three times. Fails only when cancelled.
    static Result<MipComparison>
    build(const TexelFormat& format, const FaceTexels& face, Progress& progress);

    const TexelFormat& format() const { return m_format; }
    /// The face's own level.
    Level base() const { return m_base; }

    /// Texels of a level below the face's own (checked).
    const FaceTexels& at(Level level, ReductionRule rule) const;
    /// What to draw of a level up to `base` (checked): its texels, or their right means at
    /// `kFinestDrawn`.
    const FaceTexels& drawn(Level level, ReductionRule rule) const;

    /// Whether all texels of the level are alike, by the right reduction.
    bool isConstant(Level level) const { return facts(level).constant; }
    /// Of the box from the right reduction; none at the face's own level.
    const TexelDifference& difference(Level level) const { return facts(level).difference; }
    /// The largest of all levels.
    double worstDifference() const;

    /// Values of a texel, one a channel, integers in [0,1].
    /// \param face  the texels that were built from: those of its own level are read there
    std::vector<float>
    values(const FaceTexels& face, Level level, TexelCoord texel, ReductionRule rule) const;

private:
    struct Facts
    {
        bool constant = false;
        TexelDifference difference;
        FaceTexels right, box;           ///< empty at the face's own level
        FaceTexels rightDrawn, boxDrawn; ///< share bytes where they are the same
    };

    Facts factsOf(Level level, const MipChain& right, const MipChain& box) const;
    const Facts& facts(Level level) const;

    TexelFormat m_format;
    Level m_base;
    std::vector<Facts> m_levels; ///< from level 0
};

} // namespace trixel
