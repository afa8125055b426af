// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/large_ptx.h"

#include "core/base/progress.h"
#include "core/io/deflate.h"
#include "core/io/project_metadata.h"
#include "core/io/ptx_metadata.h"
#include "core/io/ptx_reader.h"
#include "core/io/ptx_reductions.h"
#include "core/lattice/texel.h"
#include "core/mesh/surface.h"
#include "tests/bench/sheet_mesh.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>

namespace trixel {
namespace {

constexpr std::uint32_t kPatterns = 6;
using Bytes = std::vector<std::byte>;

/// Waves under noise of a few bits: of natural pictures' compressibility.
FaceTexels pattern(const TexelFormat& format, Level level, unsigned seed)
{
    std::mt19937 random(seed);
    Bytes texels(level.texelCount() * format.texelBytes());
    const double step = 12.0 / level.resolution();
    for (std::uint32_t t = 0; t < level.texelCount(); ++t) {
        const TexelCoord at = texelAt(level, TexelIndex{t});
        for (std::uint32_t c = 0; c < format.channels; ++c) {
            const double wave =
                90 * std::sin(step * (at.i + 20 * c) + seed) * std::cos(step * at.j);
            texels[t * format.channels + c] = static_cast<std::byte>(
                std::lround(110 + wave + static_cast<double>(random() % 32)));
        }
    }
    return FaceTexels::full(level, format.texelBytes(), texels);
}

/// A small file with the faces that are repeated.
Result<PtxFile> patternFile(const std::filesystem::path& path, Level level)
{
    const TexelFormat format;
    NoProgress silent;
    PtxContents contents;
    contents.texels = TexelStore(kPatterns, format, Level(), Bytes(format.texelBytes()));
    contents.adjacency = Adjacency(kPatterns);
    for (std::uint32_t k = 0; k < kPatterns; ++k) {
        contents.texels.exchange(faceId(k), pattern(format, level, k));
    }
    return writePtx(path, contents, {}, silent).and_then([&] {
        MemoryBudget budget;
        return openPtxFile(path, budget);
    });
}

template <class T>
Bytes zipped(const std::vector<T>& values)
{
    Deflater deflater;
    const auto stream = deflater.zip(std::as_bytes(std::span(values)));
    return {stream.begin(), stream.end()};
}

void put(std::ofstream& out, std::span<const std::byte> bytes)
{
    out.write(reinterpret_cast<const char*>(bytes.data()),
              static_cast<std::streamsize>(bytes.size()));
}

std::vector<PtxFaceInfo> infosOf(const Adjacency& adjacency, Level level)
{
    std::vector<PtxFaceInfo> infos(adjacency.faceCount());
    for (std::size_t f = 0; f < infos.size(); ++f) {
        infos[f].uLog2 = infos[f].vLog2 = static_cast<std::int8_t>(level.log2());
        for (const LocalEdge edge : kLocalEdges) {
            if (const auto other = adjacency.neighbour(faceId(f), edge)) {
                infos[f].adjacentFaces[indexOf(edge)] = static_cast<std::int32_t>(other->face);
                infos[f].adjacentEdges |=
                    static_cast<std::uint8_t>(indexOf(other->edge) << (2 * indexOf(edge)));
            }
        }
    }
    return infos;
}

/// One level of the large file: its table, and the patterns' blocks.
struct LevelOut
{
    Bytes table;
    std::vector<Bytes> blocks;
    PtxLevelInfo info;
};

Result<LevelOut> levelOf(const PtxFile& patterns, int reduction, std::uint32_t faces)
{
    LevelOut level;
    Buffer scratch;
    std::vector<PtxBlockHeader> headers;
    for (std::uint32_t k = 0; k < kPatterns; ++k) {
        const PtxBlock block = patterns.block(faceId(k), reduction).value();
        const auto bytes = patterns.source().view(block.offset, block.header.size(), scratch);
        if (!bytes) {
            return tl::unexpected(bytes.error());
        }
        level.blocks.emplace_back(bytes->begin(), bytes->end());
        headers.push_back(block.header);
    }
    for (std::uint32_t f = kPatterns; f < faces; ++f) {
        headers.push_back(headers[f % kPatterns]);
    }
    level.table = zipped(headers);
    level.info = {level.table.size(), static_cast<std::uint32_t>(level.table.size()), faces};
    for (const PtxBlockHeader& header : headers) {
        level.info.dataBytes += header.size();
    }
    return level;
}

} // namespace

Status writeLargePtx(const std::filesystem::path& path, std::uint64_t bytes, int log2)
{
    const Level level(log2);
    const std::filesystem::path small = path.string() + ".patterns";
    const Result<PtxFile> patterns = patternFile(small, level);
    std::filesystem::remove(small);
    if (!patterns) {
        return tl::unexpected(patterns.error());
    }
    const std::uint64_t faceBytes = patterns->source().size() / kPatterns;
    const int side = std::max(
        2, static_cast<int>(std::lround(std::sqrt(static_cast<double>(bytes / faceBytes) / 2))));
    const TriangleMesh mesh = sheetMesh(side);
    NoProgress silent;
    TriangleMesh copy = mesh;
    copy.sourceFaces.resize(mesh.triangles.size());
    const auto surface = Surface::build(std::move(copy), silent);
    if (!surface) {
        return tl::unexpected(surface.error());
    }
    const auto faces = static_cast<std::uint32_t>(mesh.triangles.size());

    const Bytes infos = zipped(infosOf((*surface)->adjacency(), level));
    Bytes means;
    for (std::uint32_t f = 0; f < faces; ++f) {
        const auto mean = patterns->constantValue(faceId(f % kPatterns));
        means.insert(means.end(), mean.begin(), mean.end());
    }
    const Bytes constants = zipped(means);
    Bytes largeTable;
    Bytes large;
    for (const PtxMetadata& item : metadataOf((*surface)->mesh())) {
        const Bytes value = zipped(valueBytes(item));
        appendLargeMetadata(item, static_cast<std::uint32_t>(value.size()), largeTable);
        large.insert(large.end(), value.begin(), value.end());
    }
    const Bytes largeHeader = zipped(largeTable);

    std::vector<LevelOut> levels;
    for (int reduction = 0; reduction <= ptxReductions(level); ++reduction) {
        auto made = levelOf(*patterns, reduction, faces);
        if (!made) {
            return tl::unexpected(made.error());
        }
        levels.push_back(std::move(*made));
    }
    PtxHeader header = patterns->header();
    header.faces = faces;
    header.faceInfoBytes = static_cast<std::uint32_t>(infos.size());
    header.constantBytes = static_cast<std::uint32_t>(constants.size());
    header.levels = static_cast<std::uint16_t>(levels.size());
    header.levelInfoBytes = static_cast<std::uint32_t>(levels.size() * sizeof(PtxLevelInfo));
    header.levelDataBytes = 0;
    for (const LevelOut& one : levels) {
        header.levelDataBytes += one.info.dataBytes;
    }
    header.metadataZippedBytes = header.metadataBytes = 0;
    header.largeHeaderZippedBytes = static_cast<std::uint32_t>(largeHeader.size());
    header.largeHeaderBytes = static_cast<std::uint32_t>(largeTable.size());
    header.largeDataBytes = large.size();
    header.editBytes = 0;
    header.editOffset = PtxHeader::kBytes + PtxHeader::kExtendedBytes + infos.size() +
                        constants.size() + header.levelInfoBytes + header.levelDataBytes + 8 +
                        largeHeader.size() + large.size();

    std::ofstream out(path, std::ios::binary);
    put(out, bytesOf(header));
    put(out, infos);
    put(out, constants);
    for (const LevelOut& one : levels) {
        put(out, std::as_bytes(std::span(&one.info, 1)));
    }
    for (const LevelOut& one : levels) {
        put(out, one.table);
        for (std::uint32_t f = 0; f < faces; ++f) {
            put(out, one.blocks[f % kPatterns]);
        }
    }
    put(out, Bytes(8));
    put(out, largeHeader);
    put(out, large);
    out.close();
    return out.good() ? Status() : pathError(path.string() + ": cannot be written");
}

} // namespace trixel
