// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/io/ptx_layout.h"

#include <cstddef>
#include <span>

namespace trixel {

/// Sets the neighbourhood flag of every constant face around whose three vertices all faces are
/// constant with the same bytes, so that a filter need not look further. The links must hold from
/// both sides. Vertices of very many faces leave the flag unset, which is always allowed.
/// \param constants  one texel a face (checked)
void flagConstantNeighbourhoods(std::span<PtxFaceInfo> infos,
                                std::span<const std::byte> constants,
                                std::size_t texelBytes,
                                Threads threads);

enum class PtxNeighbourhood { Constant, Different, TooLarge };

/// What lies around the three vertices of a constant face: only the face's own value, something
/// else (as for any face that is not constant), or too many faces to tell.
PtxNeighbourhood neighbourhoodOf(std::span<const PtxFaceInfo> infos,
                                 std::span<const std::byte> constants,
                                 std::size_t texelBytes,
                                 std::size_t face);

} // namespace trixel
