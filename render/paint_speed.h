// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/texture/texel_format.h"
#include "render/gl.h"
#include "render/paint_sheet.h"

namespace trixel::render {

/// What a texel under a dab costs, in nanoseconds of the clock.
struct PaintSpeed
{
    double card = 0;      ///< drawn into the sheet
    double processor = 0; ///< painted into the store, on as many threads as large dabs are

    bool isCardFaster() const { return card < processor; }
};

/// Paints one dab of 65,536 texels both ways, the second time of two, and waits for the card: about
/// a millisecond on a graphics card, a few where a processor plays one.
/// \param sheet  empty: a square of it is drawn into
PaintSpeed measurePaintSpeed(Gl& gl, PaintSheet& sheet, const TexelFormat& format, Threads threads);

} // namespace trixel::render
