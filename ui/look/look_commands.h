// SPDX-License-Identifier: GPL-3.0-or-later
//
// What panel and menu do with a look.
#pragma once

#include "core/texture/texel_format.h"
#include "render/look.h"

namespace trixel::ui {

/// Stops that exposure can be set to, either way.
inline constexpr float kMostStops = 16;
inline constexpr float kStopStep = 0.5F;

/// The look with so many stops more, within what can be set.
render::Look exposed(render::Look look, float by);

/// The look that shows these stored values black and white, whatever its exposure; the same look
/// where they are equal or no numbers.
render::Look ranged(render::Look look, float black, float white);

/// The next thing to show: colour, each channel, luminance, and colour again.
/// \param by  1 or -1
render::Look nextChannel(const TexelFormat& format, render::Look look, int by);

} // namespace trixel::ui
