// SPDX-License-Identifier: GPL-3.0-or-later
//
// The structure of a .ptx: everything but the texels, read and checked once, from which single
// faces of single levels can be read.
#pragma once

#include "core/base/ids.h"
#include "core/io/byte_source.h"
#include "core/io/memory_budget.h"
#include "core/io/ptx.h"
#include "core/io/ptx_decode.h"
#include "core/io/ptx_layout.h"
#include "core/texture/face_texels.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trixel {

/// Where a block lies and how it is packed.
struct PtxBlock
{
    std::uint64_t offset = 0;
    PtxBlockHeader header;
};

/// Refuses a size that no zlib stream of that length can give, before room is made for it.
Status checkPtxRatio(std::uint64_t zipped, std::uint64_t unzipped, std::string_view what);

class PtxFile
{
public:
    /// Reads header, face infos, constant values, level tables and edits; every size, offset and
    /// number is checked. Errors name the place in the file, what was expected and what was found.
    static Result<PtxFile> open(std::unique_ptr<const ByteSource> source, MemoryBudget& budget);

    const PtxHeader& header() const { return m_header; }
    const TexelFormat& format() const { return m_format; }
    std::uint32_t faceCount() const { return m_header.faces; }
    int levelCount() const { return m_header.levels; }
    const ByteSource& source() const { return *m_source; }

    /// Edits folded in.
    const PtxFaceInfo& info(FaceId face) const;
    std::span<const PtxFaceInfo> infos() const { return m_infos; }
    std::span<const std::byte> constantValues() const { return m_constantValues; }
    /// The value of a constant face, else the average; one texel as stored, edits folded in.
    std::span<const std::byte> constantValue(FaceId face) const;

    /// Where the texels lie, or nothing if they are not stored: those of a constant face, and the
    /// reductions that are too small or of an edited face.
    /// \param reduction  how often the face was reduced, from 0
    std::optional<PtxBlock> block(FaceId face, int reduction) const;

    /// Where the blocks of a stored level begin, after its table.
    std::uint64_t blocksBegin(int reduction) const;

    /// The face reduced so often, if it is stored; any reduction of a constant face. Nothing
    /// otherwise. May be called from several threads, each with its own decoder.
    Result<std::optional<FaceTexels>> texels(FaceId face, int reduction, PtxDecoder& decoder) const;

    /// The same into decoder.texels, whose first 4^n texels are then filled; false if nothing is
    /// stored there (nor is it for constant faces).
    Result<bool> decode(FaceId face, int reduction, PtxDecoder& decoder) const;
    /// The same into memory of the caller. \param texels  4^n texels (checked)
    Result<bool>
    decode(FaceId face, int reduction, PtxDecoder& decoder, std::span<std::byte> texels) const;

    /// Refuses a face whose texels take more bytes than the format can hold in one.
    Status checkFaceSize(FaceId face, int reduction = 0) const;

    /// Bytes that all faces' texels take in memory, constant faces as one texel.
    std::uint64_t texelBytes() const;

    /// Every item, large and edited ones included, in the order of their first appearance; of
    /// several with one key, the last.
    Result<std::vector<PtxMetadata>> metadata(MemoryBudget& budget) const;

private:
    struct Range
    {
        std::uint64_t offset = 0;
        std::uint64_t size = 0;
    };
    struct LevelTable
    {
        std::uint64_t blocksBegin = 0;
        std::vector<PtxBlockHeader> headers; ///< in the order of the level's entries
        std::vector<std::uint64_t> offsets;
    };
    struct MetadataEdit
    {
        Range zipped;
        std::uint32_t bytes = 0;
    };

    explicit PtxFile(std::unique_ptr<const ByteSource> source);

    Status readHeaders();
    Status placeParts();
    Status readFaceInfos(MemoryBudget& budget);
    Status readConstants(MemoryBudget& budget);
    Status readLevels(MemoryBudget& budget);
    Status
    readLevel(const PtxLevelInfo& info, int reduction, std::uint64_t offset, MemoryBudget& budget);
    Status orderFaces(MemoryBudget& budget);
    Status readEdits();
    Status readFaceEdit(Range payload);
    Status readMetadataEdit(Range payload);
    Status readSmallMetadata(Range zipped,
                             std::uint32_t bytes,
                             MemoryBudget& budget,
                             std::vector<PtxMetadata>& items) const;
    Status readLargeMetadata(MemoryBudget& budget, std::vector<PtxMetadata>& items) const;

    tl::unexpected<Error> blockError(FaceId face, int reduction, const std::string& why) const;
    Result<std::vector<std::byte>> bytes(Range range) const;
    Status unzip(Range zipped, std::span<std::byte> out, std::string_view what) const;

    std::unique_ptr<const ByteSource> m_source;
    PtxHeader m_header;
    TexelFormat m_format;
    Range m_faceInfos, m_constants, m_levelInfos, m_levels, m_metadata, m_largeTable, m_largeData;
    std::uint64_t m_end = 0; ///< of the parts that are not edits
    std::vector<PtxFaceInfo> m_infos;
    std::vector<std::byte> m_constantValues;
    std::vector<LevelTable> m_tables;
    std::vector<std::uint32_t> m_places; ///< of each face among the entries of the reductions
    std::vector<MetadataEdit> m_metadataEdits;
};

} // namespace trixel
