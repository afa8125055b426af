// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texture/texel_store.h"

namespace trixel::ui {

/// What a `.ptx` would weigh, before it is written.
struct ExportEstimate
{
    std::uint64_t texels = 0;      ///< at full resolution, constant faces counted as one
    std::uint64_t plainBytes = 0;  ///< of all texels written, mips included, before compression
    std::uint64_t likelyBytes = 0; ///< of the file, as a sample of the faces compresses
};

/// Compresses a few dozen faces spread over the mesh the way a `.ptx` does (channel by channel,
/// differences for integers) and takes them for the rest. Looks at every face once.
ExportEstimate estimatePtx(const TexelStore& texels, TexelType type, bool mips);

} // namespace trixel::ui
