// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/filtering.h"

#include <optional>

namespace trixel::render {

/// Of a picture split in two: left of the line or right of it. One that is not split is all A.
enum class Side { A, B };

/// Where a picture is split, and what its sides share.
struct Split
{
    int column = 0;                          ///< device pixels: from here on it is B
    bool ownTexels = false;                  ///< B shows texels of its own; else those of A
    std::optional<Filtering> otherFiltering; ///< of B; else that of A
    bool ownPicture = false; ///< B has a picture of its own laid over it; else that of A
};

} // namespace trixel::render
