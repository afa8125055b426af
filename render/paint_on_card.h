// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace trixel::render {

/// Whether the graphics card shows strokes before the texels have them.
enum class PaintOnCard : std::uint8_t {
    Never,
    WhereFaster, ///< large dabs, where the card was measured to be faster than the processor
    Always       ///< wherever it is able to
};

} // namespace trixel::render
