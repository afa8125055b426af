// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/lattice/corner_order.h"
#include "core/mesh/face_match.h"
#include "core/texture/texel_store.h"

namespace trixel {

/// The same texels for a face whose corners are in another order: each keeps its place on the
/// triangle and its bytes.
/// \param order  of the face asked for: its corner k is corner order[k] of `other`
FaceTexels inOrder(const FaceTexels& other, const CornerOrder& order);

/// The texels of every face where a match says they are. Constant faces and those of the same
/// corners share their bytes with `other`; no value is computed anew.
/// \param match  names faces of `other` (checked)
/// Fails when cancelled and when a face cannot be read.
Result<TexelStore>
rearranged(const TexelStore& other, const FaceMatch& match, Threads threads, Progress& progress);

} // namespace trixel
