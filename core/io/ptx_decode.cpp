// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ptx_decode.h"

#include "core/base/check.h"
#include "core/io/byte_reader.h"
#include "core/io/ptx_planar.h"

#include <cstring>

namespace trixel {

namespace {

using Window = TexelWindow<std::byte>;

std::string expectedBytes(const char* what, std::size_t expected, std::size_t found)
{
    return std::string(what) + " of " + std::to_string(found) + " bytes, expected " +
           std::to_string(expected);
}

void fillWindow(const Window& window, std::span<const std::byte> texel)
{
    for (std::size_t row = 0; row < window.rows; ++row) {
        std::byte* to = window.first + row * window.rowStrideBytes;
        for (std::size_t k = 0; k < window.columns; ++k) {
            std::memcpy(to + k * texel.size(), texel.data(), texel.size());
        }
    }
}

// One block that is not tiled: a whole face or a tile.
std::string decodePlain(const TexelFormat& format,
                        PtxEncoding encoding,
                        std::span<const std::byte> block,
                        PtxDecoder& decoder,
                        const Window& window)
{
    if (encoding == PtxEncoding::Constant) {
        if (block.size() != format.texelBytes()) {
            return expectedBytes("has a constant value", format.texelBytes(), block.size());
        }
        fillWindow(window, block);
        return {};
    }
    const std::span<std::byte> planar =
        decoder.planar.first(window.texelCount() * format.texelBytes());
    if (!decoder.inflater.unzip(block, planar)) {
        return "does not unzip to " + std::to_string(planar.size()) + " bytes";
    }
    fromPlanar(format, planar, encoding == PtxEncoding::DiffZipped, window);
    return {};
}

struct TileTable
{
    std::size_t columns = 0; ///< texels of a tile
    std::size_t rows = 0;
    std::span<const std::byte> headers; ///< u32 a tile
    std::span<const std::byte> blocks;
};

std::string
readTileTable(Level level, std::span<const std::byte> block, PtxDecoder& decoder, TileTable& table)
{
    ByteReader reader(block);
    const auto uLog2 = reader.take<std::int8_t>();
    const auto vLog2 = reader.take<std::int8_t>();
    const auto headerBytes = reader.take<std::uint32_t>();
    const auto zipped = headerBytes ? reader.takeBytes(*headerBytes) : std::nullopt;
    if (!zipped) {
        return "has a table of tiles that does not fit into it";
    }
    if (*uLog2 < 0 || *vLog2 < 0 || *uLog2 > level.log2() || *vLog2 > level.log2()) {
        return "has tiles of 2^" + std::to_string(*uLog2) + " by 2^" + std::to_string(*vLog2) +
               " texels in a face of 2^" + std::to_string(level.log2());
    }
    table.columns = std::size_t{1} << *uLog2;
    table.rows = std::size_t{1} << *vLog2;
    const std::size_t tableBytes =
        level.texelCount() / (table.columns * table.rows) * sizeof(PtxBlockHeader);
    if (tableBytes > zipped->size() * Inflater::kMaxRatio) {
        return "has a table of tiles that cannot be as short as it is";
    }
    const std::span<std::byte> headers = decoder.headers.first(tableBytes);
    if (!decoder.inflater.unzip(*zipped, headers)) {
        return "has a table of tiles that does not unzip to " + std::to_string(tableBytes) +
               " bytes";
    }
    table.headers = headers;
    table.blocks = block.last(reader.remaining());
    return {};
}

std::string decodeTiled(const TexelFormat& format,
                        Level level,
                        std::span<const std::byte> block,
                        PtxDecoder& decoder,
                        std::byte* texels)
{
    TileTable table;
    if (std::string why = readTileTable(level, block, decoder, table); !why.empty()) {
        return why;
    }
    const std::size_t resolution = level.resolution();
    const std::size_t rowBytes = resolution * format.texelBytes();
    ByteReader headers(table.headers);
    ByteReader blocks(table.blocks);
    std::size_t tile = 0;
    for (std::size_t v = 0; v < resolution; v += table.rows) {
        for (std::size_t u = 0; u < resolution; u += table.columns, ++tile) {
            const PtxBlockHeader header(headers.take<std::uint32_t>().value());
            const auto bytes = blocks.takeBytes(header.size());
            if (!bytes || header.encoding() == PtxEncoding::Tiled) {
                return "has a tile " + std::to_string(tile) +
                       (bytes ? " that is tiled itself" : " that ends beyond the block");
            }
            const Window window{texels + v * rowBytes + u * format.texelBytes(),
                                table.columns,
                                table.rows,
                                rowBytes};
            if (std::string why = decodePlain(format, header.encoding(), *bytes, decoder, window);
                !why.empty()) {
                return "has a tile " + std::to_string(tile) + " that " + why;
            }
        }
    }
    return {};
}

} // namespace

std::string decodePtxBlock(const TexelFormat& format,
                           Level level,
                           PtxBlockHeader header,
                           std::span<const std::byte> block,
                           PtxDecoder& decoder,
                           std::span<std::byte> texels)
{
    check(block.size() == header.size(), "the whole block");
    check(texels.size() == level.texelCount() * format.texelBytes(), "4^n texels");
    if (header.encoding() == PtxEncoding::Tiled) {
        return decodeTiled(format, level, block, decoder, texels.data());
    }
    const Window window{texels.data(),
                        level.resolution(),
                        level.resolution(),
                        level.resolution() * format.texelBytes()};
    return decodePlain(format, header.encoding(), block, decoder, window);
}

} // namespace trixel
