// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ptx_layout.h"

#include "core/base/check.h"
#include "core/io/byte_reader.h"

#include <algorithm>
#include <cstring>

namespace trixel {

namespace {

constexpr std::array<char, 4> kMagic{'P', 't', 'e', 'x'};

// The records byte for byte; they have no padding, which the asserts hold fast.
struct RawHeader
{
    std::array<char, 4> magic;
    std::uint32_t version;
    std::uint32_t meshType;
    std::uint32_t dataType;
    std::int32_t alphaChannel;
    std::uint16_t channels;
    std::uint16_t levels;
    std::uint32_t faces;
    std::uint32_t extendedBytes;
    std::uint32_t faceInfoBytes;
    std::uint32_t constantBytes;
    std::uint32_t levelInfoBytes;
    std::uint32_t minorVersion;
    std::uint64_t levelDataBytes;
    std::uint32_t metadataZippedBytes;
    std::uint32_t metadataBytes;
};
static_assert(sizeof(RawHeader) == PtxHeader::kBytes);

struct RawExtended
{
    std::uint16_t uBorderMode;
    std::uint16_t padding;
    std::uint16_t vBorderMode;
    std::uint16_t edgeFilterMode;
    std::uint32_t largeHeaderZippedBytes;
    std::uint32_t largeHeaderBytes;
    std::uint64_t largeDataBytes;
    std::uint64_t editBytes;
    std::uint64_t editOffset;
};
static_assert(sizeof(RawExtended) == PtxHeader::kExtendedBytes);

std::string unusable(const RawHeader& raw)
{
    if (raw.magic != kMagic) {
        return "is not a .ptx file: it does not start with \"Ptex\"";
    }
    if (raw.version != 1) {
        return "is of .ptx version " + std::to_string(raw.version) + ", only version 1 is known";
    }
    if (raw.meshType == 1) {
        return "is a texture of quads; Trixel opens textures of triangles";
    }
    if (raw.meshType > 1) {
        return "has the unknown mesh type " + std::to_string(raw.meshType) +
               ", expected 0 (triangles)";
    }
    if (raw.dataType > 3) {
        return "has the unknown data type " + std::to_string(raw.dataType) + ", expected 0 to 3";
    }
    if (raw.channels < 1 || raw.channels > TexelFormat::kMaxChannels) {
        return "has " + std::to_string(raw.channels) + " channels, expected 1 to " +
               std::to_string(TexelFormat::kMaxChannels);
    }
    if (raw.alphaChannel < -1 || raw.alphaChannel >= raw.channels) {
        return "names channel " + std::to_string(raw.alphaChannel) + " as alpha, but has " +
               std::to_string(raw.channels) + " channels";
    }
    if (raw.levels < 1 || raw.levels > kMaxPtxLevels) {
        return "has " + std::to_string(raw.levels) + " levels, expected 1 to " +
               std::to_string(kMaxPtxLevels);
    }
    if (raw.levelInfoBytes != raw.levels * sizeof(PtxLevelInfo)) {
        return "has a level table of " + std::to_string(raw.levelInfoBytes) + " bytes, expected " +
               std::to_string(raw.levels * sizeof(PtxLevelInfo));
    }
    if (raw.faces < 1 || raw.faces > kMaxPtxFaces) {
        return "has " + std::to_string(raw.faces) + " faces, expected 1 to " +
               std::to_string(kMaxPtxFaces);
    }
    return {};
}

} // namespace

Result<PtxHeader> parsePtxHeader(std::span<const std::byte> bytes)
{
    const auto raw = ByteReader(bytes).take<RawHeader>();
    check(raw.has_value(), "the 64 bytes of a header");
    if (std::string why = unusable(*raw); !why.empty()) {
        return contentsError(std::move(why));
    }
    PtxHeader header;
    header.meshType = raw->meshType;
    header.dataType = raw->dataType;
    header.alphaChannel = raw->alphaChannel;
    header.channels = raw->channels;
    header.levels = raw->levels;
    header.faces = raw->faces;
    header.extendedBytes = raw->extendedBytes;
    header.faceInfoBytes = raw->faceInfoBytes;
    header.constantBytes = raw->constantBytes;
    header.levelInfoBytes = raw->levelInfoBytes;
    header.minorVersion = raw->minorVersion;
    header.levelDataBytes = raw->levelDataBytes;
    header.metadataZippedBytes = raw->metadataZippedBytes;
    header.metadataBytes = raw->metadataBytes;
    return header;
}

void parsePtxExtendedHeader(std::span<const std::byte> bytes, PtxHeader& header)
{
    RawExtended raw{};
    std::memcpy(&raw, bytes.data(), std::min(bytes.size(), sizeof(raw)));
    header.uBorderMode = raw.uBorderMode;
    header.vBorderMode = raw.vBorderMode;
    header.edgeFilterMode = raw.edgeFilterMode;
    header.largeHeaderZippedBytes = raw.largeHeaderZippedBytes;
    header.largeHeaderBytes = raw.largeHeaderBytes;
    header.largeDataBytes = raw.largeDataBytes;
    header.editBytes = raw.editBytes;
    header.editOffset = raw.editOffset;
}

std::vector<std::byte> bytesOf(const PtxHeader& header)
{
    const RawHeader raw{kMagic,
                        1,
                        header.meshType,
                        header.dataType,
                        header.alphaChannel,
                        header.channels,
                        header.levels,
                        header.faces,
                        header.extendedBytes,
                        header.faceInfoBytes,
                        header.constantBytes,
                        header.levelInfoBytes,
                        header.minorVersion,
                        header.levelDataBytes,
                        header.metadataZippedBytes,
                        header.metadataBytes};
    const RawExtended extended{header.uBorderMode,
                               0,
                               header.vBorderMode,
                               header.edgeFilterMode,
                               header.largeHeaderZippedBytes,
                               header.largeHeaderBytes,
                               header.largeDataBytes,
                               header.editBytes,
                               header.editOffset};
    std::vector<std::byte> bytes(sizeof(raw) + sizeof(extended));
    std::memcpy(bytes.data(), &raw, sizeof(raw));
    std::memcpy(bytes.data() + sizeof(raw), &extended, sizeof(extended));
    return bytes;
}

TexelFormat formatOf(const PtxHeader& header)
{
    TexelFormat format;
    format.type = static_cast<TexelType>(header.dataType);
    format.channels = header.channels;
    if (header.alphaChannel >= 0) {
        format.alpha = static_cast<std::uint16_t>(header.alphaChannel);
    }
    return format;
}

std::string faultOf(const PtxFaceInfo& info, std::uint32_t face, std::uint32_t faceCount)
{
    const auto name = [face] { return "face " + std::to_string(face); };
    if (info.uLog2 != info.vLog2) {
        return name() + " is 2^" + std::to_string(info.uLog2) + " by 2^" +
               std::to_string(info.vLog2) + " texels; both must be alike for triangles";
    }
    if (info.uLog2 < 0 || info.uLog2 > Level::kMax) {
        return name() + " has level " + std::to_string(info.uLog2) + ", Trixel holds levels 0 to " +
               std::to_string(Level::kMax);
    }
    for (std::size_t edge = 0; edge < 3; ++edge) {
        const std::int64_t neighbour = info.adjacentFaces[edge];
        if (neighbour < -1 || neighbour >= faceCount) {
            return name() + " names face " + std::to_string(neighbour) +
                   " as neighbour across edge " + std::to_string(edge) + ", but there are " +
                   std::to_string(faceCount) + " faces";
        }
        if (neighbour >= 0 && info.adjacentEdge(edge) > 2) {
            return name() + " names edge 3 of its neighbour across edge " + std::to_string(edge) +
                   "; triangles have edges 0 to 2";
        }
    }
    return {};
}

} // namespace trixel
