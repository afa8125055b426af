// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texture/face_texels.h"
#include "core/texture/texel_format.h"
#include "core/texture/touched_rect.h"

#include <vector>

namespace trixel {

/// Every coarser level of one face, as `reduced` makes them one from the other, brought up to date
/// where texels change. Takes a third of the face's bytes.
class CoarserLevels
{
public:
    /// Costs as much as reading the face.
    static CoarserLevels of(const TexelFormat& format, const FaceTexels& face);

    Level base() const { return m_base; } ///< of the face itself, which is not kept
    /// \param level  below `base` (checked)
    const FaceTexels& at(Level level) const;

    /// Whether `update` can follow a change, and need not begin anew: the face has the same level
    /// as before and is no more and no less constant.
    bool canFollow(const FaceTexels& face, const TouchedRect& rect) const;

    /// Takes over the texels of a rectangle, and their parents.
    /// \param face  as it is now; `canFollow` (checked)
    void update(const TexelFormat& format, const FaceTexels& face, const TouchedRect& rect);

private:
    Level m_base;
    bool m_constant = true;
    std::vector<FaceTexels> m_levels; ///< at their own numbers
};

/// The texels that lie in the middle of those of a coarser level, without mean: a first look at a
/// face that would take long to reduce.
/// \param level  not above the face's (checked)
FaceTexels sampledAt(Level level, const FaceTexels& face);

} // namespace trixel
