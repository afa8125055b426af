// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainterPath>

#include "core/lattice/face_layout.h"
#include "core/texture/mips.h"

namespace trixel::ui {

/// What a texel of one level is at another.
enum class Kinship { Itself, Parent, Children };

/// Where the texel's family lies at a level, in the layout's plane: itself, the one texel that
/// covers it, or those it is the mean of, which boxes pick from the packed square and the right
/// reduction from the texel's own area.
/// \param level  of `texel`
/// \param at     the level that is drawn
QPainterPath familyOutline(
    const FaceLayout& layout, Level level, TexelCoord texel, Level at, ReductionRule rule);

/// \param level  of the texel
Kinship kinshipOf(Level level, Level at);

} // namespace trixel::ui
