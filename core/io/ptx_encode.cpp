// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ptx_encode.h"

#include "core/base/check.h"
#include "core/io/ptx_planar.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace trixel {

namespace {

constexpr std::size_t kTileBytes = 65536;

using Window = TexelWindow<const std::byte>;

void append(std::span<const std::byte> bytes, std::vector<std::byte>& to)
{
    to.insert(to.end(), bytes.begin(), bytes.end());
}

bool isConstant(const Window& window, std::size_t texelBytes)
{
    const std::size_t rowBytes = window.columns * texelBytes;
    if (std::memcmp(window.first, window.first + texelBytes, rowBytes - texelBytes) != 0) {
        return false;
    }
    for (std::size_t row = 1; row < window.rows; ++row) {
        if (std::memcmp(window.first, window.first + row * window.rowStrideBytes, rowBytes) != 0) {
            return false;
        }
    }
    return true;
}

PtxBlockHeader headerFor(PtxEncoding encoding, std::size_t size)
{
    return size > PtxBlockHeader::kMaxBytes
               ? PtxBlockHeader()
               : PtxBlockHeader(encoding, static_cast<std::uint32_t>(size));
}

PtxBlockHeader encodeZipped(const TexelFormat& format,
                            const Window& window,
                            PtxEncoder& encoder,
                            std::vector<std::byte>& blocks)
{
    const bool differences = format.type == TexelType::UInt8 || format.type == TexelType::UInt16;
    const std::span<std::byte> planar =
        encoder.planar.first(window.texelCount() * format.texelBytes());
    toPlanar(format, window, differences, planar);
    const std::span<const std::byte> zipped = encoder.deflater.zip(planar);
    append(zipped, blocks);
    return headerFor(differences ? PtxEncoding::DiffZipped : PtxEncoding::Zipped, zipped.size());
}

PtxBlockHeader encodeTile(const TexelFormat& format,
                          const Window& window,
                          PtxEncoder& encoder,
                          std::vector<std::byte>& blocks)
{
    if (isConstant(window, format.texelBytes())) {
        append({window.first, format.texelBytes()}, blocks);
        return headerFor(PtxEncoding::Constant, format.texelBytes());
    }
    return encodeZipped(format, window, encoder, blocks);
}

PtxBlockHeader encodeTiled(const TexelFormat& format,
                           Level level,
                           PtxTileSize tile,
                           std::span<const std::byte> texels,
                           PtxEncoder& encoder,
                           std::vector<std::byte>& blocks)
{
    const std::size_t resolution = level.resolution();
    const std::size_t columns = std::size_t{1} << tile.uLog2;
    const std::size_t rows = std::size_t{1} << tile.vLog2;
    const std::size_t rowBytes = resolution * format.texelBytes();
    std::vector<PtxBlockHeader> headers;
    encoder.tiles.clear();
    for (std::size_t v = 0; v < resolution; v += rows) {
        for (std::size_t u = 0; u < resolution; u += columns) {
            const Window window{
                texels.data() + v * rowBytes + u * format.texelBytes(), columns, rows, rowBytes};
            headers.push_back(encodeTile(format, window, encoder, encoder.tiles));
        }
    }
    const std::span<const std::byte> table =
        encoder.deflater.zip(std::as_bytes(std::span(headers)));
    const std::array<std::byte, 2> size{static_cast<std::byte>(tile.uLog2),
                                        static_cast<std::byte>(tile.vLog2)};
    const auto tableBytes = static_cast<std::uint32_t>(table.size());
    const std::size_t begin = blocks.size();
    append(size, blocks);
    append(std::as_bytes(std::span(&tableBytes, 1)), blocks);
    append(table, blocks);
    append(encoder.tiles, blocks);
    return headerFor(PtxEncoding::Tiled, blocks.size() - begin);
}

} // namespace

PtxTileSize ptxTileSize(Level level, std::size_t texelBytes)
{
    const std::size_t tiles = level.texelCount() * texelBytes / kTileBytes;
    const int cuts = tiles < 2 ? 0 : static_cast<int>(std::bit_width(tiles)) - 1;
    const int area = 2 * level.log2() - cuts;
    const int uLog2 = std::min((area + 1) / 2, level.log2());
    return {uLog2, area - uLog2};
}

PtxBlockHeader encodePtxBlock(const TexelFormat& format,
                              Level level,
                              std::span<const std::byte> texels,
                              PtxEncoder& encoder,
                              std::vector<std::byte>& blocks)
{
    check(texels.size() == level.texelCount() * format.texelBytes(), "4^n texels");
    const PtxTileSize tile = ptxTileSize(level, format.texelBytes());
    if (tile != PtxTileSize{level.log2(), level.log2()}) {
        return encodeTiled(format, level, tile, texels, encoder, blocks);
    }
    const std::size_t resolution = level.resolution();
    return encodeZipped(format,
                        {texels.data(), resolution, resolution, resolution * format.texelBytes()},
                        encoder,
                        blocks);
}

} // namespace trixel
