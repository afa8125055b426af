// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texture/touched_rect.h"

#include <vector>

namespace trixel::ui {

/// What a change touched; `rects` is empty when everything may differ.
struct Change
{
    std::vector<TouchedRect> rects;
};

} // namespace trixel::ui
