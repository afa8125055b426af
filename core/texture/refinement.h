// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texture/conforming_pyramid.h"
#include "core/texture/face_texels.h"
#include "core/texture/texel_format.h"

namespace trixel {

/// The face one level finer. The texel of a parent's middle child is its own value, those at its
/// corners lie halfway to the averages there, so neighbouring texels run into each other; then all
/// four are moved by one amount, and their contrast lowered where need be, so that
///   * their mean is the parent: `reduced` brings back the same integers to the bit, and floats
///     within rounding;
///   * no value lies outside the range of the parent and the three averages (rounded outwards).
/// A constant face stays constant. Around a value that is not finite all four are the parent.
/// \param face      below Level::kMax (checked), in the format (checked)
/// \param vertices  averages at the face's own level, one for each group of four channels
FaceTexels
refined(const TexelFormat& format, const FaceTexels& face, std::span<const LevelVertices> vertices);

} // namespace trixel
