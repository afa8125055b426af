// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

namespace trixel::worker {

/// Whether a JPEG has its end mark after its compressed pixels. The decoder fills in what it does
/// not find, in grey, and says nothing.
bool hasJpegEnd(std::span<const std::byte> file);

} // namespace trixel::worker
