// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/texture/texel_store.h"

namespace trixel {

/// The store with every channel value stored as another type, by `decode` and `encode`: integers
/// stand for [0,1], values outside it are clamped when they become integers, NaN becomes 0.
/// Levels and channels stay; constant faces stay constant and share what they shared. The store
/// itself (a cheap copy) where the type is the same already. Fails only when cancelled.
Result<TexelStore>
converted(const TexelStore& store, TexelType type, Threads threads, Progress& progress);

} // namespace trixel
