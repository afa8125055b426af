// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace trixel {

/// The formats that images are read from. All others that the library behind it knows stay shut.
enum class ImageKind { Png, Jpeg, Tiff, OpenExr, Hdr, Tga, Bmp, WebP };

/// "PNG", "JPEG", …: as people write them.
std::string_view nameOf(ImageKind kind);
/// "png", "jpeg", "tiff", "openexr", …: as OpenImageIO calls its readers and writers.
std::string_view readerOf(ImageKind kind);

/// By how the file begins, whatever its name; nothing for what is none of them. TGA has no mark of
/// its own at the beginning: a header that makes sense is taken for one.
/// \param begin  at least the first 32 bytes, or all there are
std::optional<ImageKind> imageKindOf(std::span<const std::byte> begin);

} // namespace trixel
