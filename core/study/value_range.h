// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/texture/float_mips.h"

namespace trixel {

/// The largest span, over the channels, between the least and the greatest base-level texel: what
/// jumps and errors are told in fractions of. Texels that are not finite do not count; 0 where all
/// texels are alike.
double valueRange(const FloatMips& mips, Threads threads);

} // namespace trixel
