// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/buffer.h"
#include "core/io/byte_source.h"
#include "core/io/inflate.h"
#include "core/io/ptx_layout.h"

#include <array>
#include <span>
#include <string>

namespace trixel {

/// What decoding works with; one per thread, reused from face to face.
struct PtxDecoder
{
    Inflater inflater;
    std::array<ReadAhead, kMaxPtxLevels> zipped; ///< blocks as they lie in the file, by level
    Buffer planar;                               ///< an unzipped block
    Buffer headers;                              ///< the table of a tiled block
    Buffer texels;                               ///< a whole face
};

/// Unpacks the block of one face into its packed square.
/// \param block   the header.size() bytes of the block (checked)
/// \param texels  4^n texels, interleaved (checked)
/// \return  what is wrong with the block, as the end of a sentence that starts with its name; empty
///          if nothing is. What `texels` then holds is unspecified.
std::string decodePtxBlock(const TexelFormat& format,
                           Level level,
                           PtxBlockHeader header,
                           std::span<const std::byte> block,
                           PtxDecoder& decoder,
                           std::span<std::byte> texels);

} // namespace trixel
