// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"

#include <cstdint>
#include <span>

namespace trixel {

/// Gives pixels that hold nothing a value that goes over smoothly into those around them (pull and
/// push: means of what is known at ever coarser levels, taken back where nothing finer is known),
/// so that no coarser level of the image mixes in what was never there. Pixels that are known stay.
/// \param values  channels of each pixel, rows one after the other
/// \param known   one a pixel, 0 where it holds nothing; nothing happens where all are 0
/// Fails only when cancelled; some are filled then, others not.
Status fillHoles(std::span<float> values,
                 std::span<const std::uint8_t> known,
                 int width,
                 int height,
                 int channels,
                 Threads threads,
                 Progress& progress);

} // namespace trixel
