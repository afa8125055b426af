// SPDX-License-Identifier: GPL-3.0-or-later
//
// The fixed-size records of a .ptx file (Ptex 1.4), byte-packed and little-endian.
#pragma once

#include "core/base/level.h"
#include "core/base/result.h"
#include "core/texture/texel_format.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace trixel {

/// Faces beyond which the format's own 32-bit sizes overflow (20 bytes a face below 2^31).
inline constexpr std::uint32_t kMaxPtxFaces = 107'374'182;
/// Texels of one face take fewer bytes than this.
inline constexpr std::uint64_t kMaxPtxFaceBytes = std::uint64_t{1} << 31U;
inline constexpr int kMaxPtxLevels = 20;

/// Header and extended header, as they lie in the file.
struct PtxHeader
{
    static constexpr std::size_t kBytes = 64;
    static constexpr std::size_t kExtendedBytes = 40;

    std::uint32_t meshType = 0; ///< 0 triangles, 1 quads
    std::uint32_t dataType = 0; ///< as TexelType
    std::int32_t alphaChannel = -1;
    std::uint16_t channels = 0;
    std::uint16_t levels = 0; ///< 1: no reductions are stored
    std::uint32_t faces = 0;
    std::uint32_t extendedBytes = kExtendedBytes;
    std::uint32_t faceInfoBytes = 0; ///< zipped
    std::uint32_t constantBytes = 0; ///< zipped
    std::uint32_t levelInfoBytes = 0;
    std::uint32_t minorVersion = 4;
    std::uint64_t levelDataBytes = 0;
    std::uint32_t metadataZippedBytes = 0;
    std::uint32_t metadataBytes = 0;

    std::uint16_t uBorderMode = 0; ///< 0 clamp, 1 black, 2 periodic; no effect on triangles
    std::uint16_t vBorderMode = 0;
    std::uint16_t edgeFilterMode = 0; ///< 0 none, 1 tangent-space vectors
    std::uint32_t largeHeaderZippedBytes = 0;
    std::uint32_t largeHeaderBytes = 0;
    std::uint64_t largeDataBytes = 0;
    std::uint64_t editBytes = 0;
    std::uint64_t editOffset = 0;

    bool operator==(const PtxHeader&) const = default;
};

/// Reads the 64 bytes of the header (checked) and decides whether this is a .ptx of triangles that
/// Trixel can hold: magic, version, mesh type, data type, channels, alpha, levels, faces.
Result<PtxHeader> parsePtxHeader(std::span<const std::byte> bytes);

/// Fills in the extended header; bytes missing at its end count as 0.
void parsePtxExtendedHeader(std::span<const std::byte> bytes, PtxHeader& header);

/// Header and extended header, 104 bytes.
std::vector<std::byte> bytesOf(const PtxHeader& header);

/// The format of the texels; the header must have been accepted by `parsePtxHeader`.
TexelFormat formatOf(const PtxHeader& header);

/// What the file says about one face (20 bytes).
struct PtxFaceInfo
{
    static constexpr std::uint8_t kConstant = 1;
    static constexpr std::uint8_t kEdited = 2; ///< never stored; set while edits are read
    static constexpr std::uint8_t kConstantNeighbours = 4;
    static constexpr std::uint8_t kSubface = 8; ///< quads only

    std::int8_t uLog2 = 0;
    std::int8_t vLog2 = 0;
    std::uint8_t adjacentEdges = 0; ///< edge e in bits 2e and 2e+1
    std::uint8_t flags = 0;
    std::array<std::int32_t, 4> adjacentFaces{-1, -1, -1, -1}; ///< -1 at a border

    bool isConstant() const { return (flags & kConstant) != 0; }
    bool isEdited() const { return (flags & kEdited) != 0; }
    int adjacentEdge(std::size_t edge) const { return (adjacentEdges >> (2 * edge)) & 3; }
    /// Of a face whose info was checked.
    Level level() const { return Level(uLog2); }

    bool operator==(const PtxFaceInfo&) const = default;
};
static_assert(sizeof(PtxFaceInfo) == 20);

/// What is unusable about a face's info, as a sentence that names the face; empty if nothing.
std::string faultOf(const PtxFaceInfo& info, std::uint32_t face, std::uint32_t faceCount);

/// One entry of the level table (16 bytes).
struct PtxLevelInfo
{
    std::uint64_t dataBytes = 0;   ///< headers and blocks
    std::uint32_t headerBytes = 0; ///< zipped
    std::uint32_t faces = 0;

    bool operator==(const PtxLevelInfo&) const = default;
};
static_assert(sizeof(PtxLevelInfo) == 16);

enum class PtxEncoding : std::uint8_t { Constant = 0, Zipped = 1, DiffZipped = 2, Tiled = 3 };

/// How many bytes a block of texels takes and how they are packed.
struct PtxBlockHeader
{
    static constexpr std::uint32_t kMaxBytes = (1U << 30U) - 1;

    std::uint32_t bits = 0;

    PtxBlockHeader() = default;
    explicit PtxBlockHeader(std::uint32_t stored)
        : bits(stored)
    {
    }
    PtxBlockHeader(PtxEncoding encoding, std::uint32_t size)
        : bits(size | static_cast<std::uint32_t>(encoding) << 30U)
    {
    }

    std::uint32_t size() const { return bits & kMaxBytes; }
    PtxEncoding encoding() const { return static_cast<PtxEncoding>(bits >> 30U); }

    bool operator==(const PtxBlockHeader&) const = default;
};

} // namespace trixel
