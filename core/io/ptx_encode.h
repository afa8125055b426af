// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/buffer.h"
#include "core/io/deflate.h"
#include "core/io/ptx_layout.h"

#include <cstddef>
#include <span>
#include <vector>

namespace trixel {

/// What encoding works with; one per thread, reused from face to face.
struct PtxEncoder
{
    Deflater deflater;
    Buffer planar;
    std::vector<std::byte> tiles;
};

/// Log2 of the texels of a tile along u and v.
struct PtxTileSize
{
    int uLog2 = 0;
    int vLog2 = 0;

    bool operator==(const PtxTileSize&) const = default;
};

/// How a face is cut into tiles of 64 to 128 KiB; the whole face if it is smaller than 128 KiB.
/// Source: the writer of the reference library.
PtxTileSize ptxTileSize(Level level, std::size_t texelBytes);

/// Appends the block of one face's texels.
/// \param texels  4^n texels, interleaved (checked)
/// \return  its header; of size 0 when the block is larger than the format can hold, and then what
///          was appended is of no use
PtxBlockHeader encodePtxBlock(const TexelFormat& format,
                              Level level,
                              std::span<const std::byte> texels,
                              PtxEncoder& encoder,
                              std::vector<std::byte>& blocks);

} // namespace trixel
