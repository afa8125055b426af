// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lattice/texel.h"
#include "core/texture/face_texels.h"
#include "core/texture/texel_format.h"

#include <cstddef>
#include <span>

namespace trixel {

/// One texel of the face as `reduced` makes it, to the bit, without the others: reads only the
/// 4^steps texels below it.
/// \param steps   levels coarser than the face; steps that would go below level 0 are none
/// \param index   of the texel at that coarser level (checked)
/// \param target  the bytes of one texel in `format` (checked)
void reducedTexel(const TexelFormat& format,
                  const FaceTexels& face,
                  int steps,
                  TexelIndex index,
                  std::span<std::byte> target);

} // namespace trixel
