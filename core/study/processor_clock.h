// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace trixel {

/// Processor time of the calling thread so far, in seconds: other programs do not count.
double processorSeconds();

} // namespace trixel
