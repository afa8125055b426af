// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a texel is written by those who look for it.
#pragma once

#include "core/base/result.h"
#include "core/texture/texel_walk.h"

#include <string>
#include <string_view>

namespace trixel {

/// Reads `face` (its first texel), `face:index` (in storage order), `face:i,j,lower`,
/// `face:i,j,upper` or `face@u,v` (the texel that contains the point); spaces between them do not
/// matter. Errors are one sentence that says what was expected there and what the surface has.
Result<TexelPlace> parseTexelAddress(std::string_view text, const WalkedSurface& surface);

/// "12:3,1,upper"
std::string toText(const TexelPlace& place);

} // namespace trixel
