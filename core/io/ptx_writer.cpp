// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/check.h"
#include "core/io/commit_file.h"
#include "core/io/deflate.h"
#include "core/io/ptx.h"
#include "core/io/ptx_faces.h"
#include "core/io/ptx_metadata.h"
#include "core/io/ptx_verify.h"

#include <algorithm>
#include <array>
#include <string>
#include <unordered_set>

namespace trixel {

namespace {

constexpr std::size_t kLargeMetadataBytes = 1024; // larger items are kept apart
constexpr std::array<std::byte, 8> kBarrier{};
// The tables are a small part of a file; packing them harder would only cost time.
constexpr int kTableDeflateLevel = 4;

using Bytes = std::vector<std::byte>;

// Everything of a file but the blocks of texels.
struct Tables
{
    PtxHeader header;
    Bytes faceInfos;
    Bytes constants;
    std::vector<PtxLevelInfo> levels;
    std::vector<Bytes> levelHeaders;
    Bytes metadata;
    Bytes largeTable;
    std::vector<Bytes> largeItems;
};

Bytes zipped(std::span<const std::byte> bytes, int level = Deflater::kDefaultLevel)
{
    Deflater deflater(level);
    const auto stream = deflater.zip(bytes);
    return {stream.begin(), stream.end()};
}

void packLevel(const PtxFaces& faces, int reduction, Tables& tables)
{
    std::vector<PtxBlockHeader> headers;
    std::uint64_t bytes = 0;
    faces.forEachBlocks(reduction, [&](const PtxBlocks& blocks) {
        headers.insert(headers.end(), blocks.headers.begin(), blocks.headers.end());
        bytes += blocks.bytes.size();
    });
    Bytes& stream = tables.levelHeaders[static_cast<std::size_t>(reduction)];
    stream = zipped(std::as_bytes(std::span(headers)), kTableDeflateLevel);
    tables.levels[static_cast<std::size_t>(reduction)] = {
        stream.size() + bytes,
        static_cast<std::uint32_t>(stream.size()),
        static_cast<std::uint32_t>(headers.size())};
}

void packMetadata(std::span<const PtxMetadata> items, Tables& tables)
{
    Bytes small;
    Bytes largeTable;
    for (const PtxMetadata& item : items) {
        if (valueByteCount(item) > kLargeMetadataBytes) {
            tables.largeItems.push_back(zipped(valueBytes(item)));
            appendLargeMetadata(
                item, static_cast<std::uint32_t>(tables.largeItems.back().size()), largeTable);
        } else {
            appendMetadata(item, small);
        }
    }
    tables.metadata = small.empty() ? Bytes() : zipped(small);
    tables.largeTable = largeTable.empty() ? Bytes() : zipped(largeTable);
    tables.header.metadataBytes = static_cast<std::uint32_t>(small.size());
    tables.header.largeHeaderBytes = static_cast<std::uint32_t>(largeTable.size());
}

PtxHeader headerOf(const Tables& tables, const PtxContents& contents)
{
    const TexelFormat& format = contents.texels.format();
    PtxHeader header = tables.header;
    header.dataType = static_cast<std::uint32_t>(format.type);
    header.alphaChannel = format.alpha ? *format.alpha : -1;
    header.channels = format.channels;
    header.levels = static_cast<std::uint16_t>(tables.levels.size());
    header.faces = contents.texels.faceCount();
    header.faceInfoBytes = static_cast<std::uint32_t>(tables.faceInfos.size());
    header.constantBytes = static_cast<std::uint32_t>(tables.constants.size());
    header.levelInfoBytes = static_cast<std::uint32_t>(tables.levels.size() * sizeof(PtxLevelInfo));
    for (const PtxLevelInfo& level : tables.levels) {
        header.levelDataBytes += level.dataBytes;
    }
    header.metadataZippedBytes = static_cast<std::uint32_t>(tables.metadata.size());
    header.largeHeaderZippedBytes = static_cast<std::uint32_t>(tables.largeTable.size());
    for (const Bytes& item : tables.largeItems) {
        header.largeDataBytes += item.size();
    }
    // Edits, should another program append some, begin right after all this; without the barrier
    // the reference library would look for them in the wrong place.
    header.editOffset = PtxHeader::kBytes + PtxHeader::kExtendedBytes +
                        std::uint64_t{header.faceInfoBytes} + header.constantBytes +
                        header.levelInfoBytes + header.levelDataBytes + header.metadataZippedBytes +
                        kBarrier.size() + header.largeHeaderZippedBytes + header.largeDataBytes;
    return header;
}

Tables packTables(const PtxFaces& faces, const PtxContents& contents, Threads threads)
{
    Tables tables;
    const auto levelCount = static_cast<std::size_t>(faces.levelCount);
    tables.levels.resize(levelCount);
    tables.levelHeaders.resize(levelCount);
    const auto packPart = [&](std::size_t part) {
        if (part == 0) {
            tables.faceInfos = zipped(std::as_bytes(std::span(faces.infos)), kTableDeflateLevel);
        } else if (part == 1) {
            tables.constants = zipped(faces.constants, kTableDeflateLevel);
        } else if (part == 2) {
            packMetadata(contents.metadata, tables);
        } else {
            packLevel(faces, static_cast<int>(part) - 3, tables);
        }
    };
    parallelFor(levelCount + 3, 1, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t part = begin; part < end; ++part) {
            packPart(part);
        }
    });
    tables.header = headerOf(tables, contents);
    return tables;
}

// Keeps the first error and does nothing after it.
class Sequence
{
public:
    explicit Sequence(FileWriter& file)
        : m_file(file)
    {
    }

    void write(std::span<const std::byte> bytes)
    {
        if (m_status) {
            m_status = m_file.write(bytes);
        }
    }
    const Status& status() const { return m_status; }

private:
    FileWriter& m_file;
    Status m_status;
};

Status writeParts(FileWriter& file, const Tables& tables, const PtxFaces& faces, Progress& progress)
{
    Sequence out(file);
    out.write(bytesOf(tables.header));
    out.write(tables.faceInfos);
    out.write(tables.constants);
    out.write(std::as_bytes(std::span(tables.levels)));
    for (int reduction = 0; reduction < faces.levelCount; ++reduction) {
        out.write(tables.levelHeaders[static_cast<std::size_t>(reduction)]);
        faces.forEachBlocks(reduction, [&](const PtxBlocks& blocks) { out.write(blocks.bytes); });
        if (out.status() &&
            !progress.report(static_cast<double>(reduction + 1) / faces.levelCount)) {
            return cancelled();
        }
    }
    out.write(tables.metadata);
    out.write(kBarrier);
    out.write(tables.largeTable);
    for (const Bytes& item : tables.largeItems) {
        out.write(item);
    }
    return out.status();
}

// What no .ptx can hold is refused before any work is done.
Status checkContents(const PtxContents& contents)
{
    const std::uint64_t faces = contents.texels.faceCount();
    const std::size_t texelBytes = contents.texels.format().texelBytes();
    if (faces == 0) {
        return contentsError("a .ptx needs at least one face");
    }
    if (faces > kMaxPtxFaces || faces * texelBytes >= kMaxPtxFaceBytes) {
        return contentsError(std::to_string(faces) + " faces of " + std::to_string(texelBytes) +
                             " bytes a texel are more than a .ptx can hold");
    }
    std::unordered_set<std::string_view> keys;
    for (const PtxMetadata& item : contents.metadata) {
        if (std::string why = faultOf(item); !why.empty()) {
            return contentsError(std::move(why));
        }
        if (!keys.insert(item.key).second) {
            return contentsError("the metadata key \"" + item.key + "\" is there twice");
        }
    }
    return {};
}

} // namespace

Status writePtx(const std::filesystem::path& path,
                const PtxContents& contents,
                const PtxWriteOptions& options,
                Progress& progress)
{
    if (Status status = checkContents(contents); !status) {
        return prefixed(path.string(), status.error());
    }
    StageProgress packing(progress, 0, 0.5);
    Result<PtxFaces> faces =
        packPtxFaces(contents.texels, contents.adjacency, options.mips, options.threads, packing);
    if (!faces) {
        return faces.error().kind == ErrorKind::Cancelled ? tl::unexpected(faces.error())
                                                          : prefixed(path.string(), faces.error());
    }
    const auto write = [&](FileWriter& file) {
        const Tables tables = packTables(*faces, contents, options.threads);
        StageProgress writing(progress, 0.5, 0.6);
        const Status status = writeParts(file, tables, *faces, writing);
        for (PtxChunk& chunk : faces->chunks) {
            chunk.texels = {}; // verified by their texels
        }
        return status;
    };
    const auto verify = [&](const std::filesystem::path& written) {
        StageProgress verifying(progress, 0.6, 1);
        return verifyPtx(written, contents, *faces, options.threads, verifying);
    };
    return commitFile(path, write, verify);
}

} // namespace trixel
