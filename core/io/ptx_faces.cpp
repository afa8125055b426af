// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ptx_faces.h"

#include "core/base/check.h"
#include "core/io/ptx_average.h"
#include "core/io/ptx_encode.h"
#include "core/io/ptx_neighbourhood.h"
#include "core/mesh/shared_progress.h"
#include "core/texture/pinned_face.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <mutex>
#include <string>
#include <utility>

namespace trixel {

namespace {

// A chunk ends after so many faces or bytes of texels, whichever comes first.
constexpr std::size_t kChunkFaces = 1024;
constexpr std::uint64_t kChunkBytes = std::uint64_t{8} << 20U;

// First faces of the chunks and, at the end, the number of faces.
std::vector<std::size_t> chunkBegins(const TexelStore& store)
{
    std::vector<std::size_t> begins{0};
    std::uint64_t bytes = 0;
    for (std::size_t face = 0; face < store.faceCount(); ++face) {
        bytes += store.face(faceId(face)).byteCount();
        if (face + 1 - begins.back() == kChunkFaces || bytes >= kChunkBytes) {
            begins.push_back(face + 1);
            bytes = 0;
        }
    }
    if (begins.back() != store.faceCount()) {
        begins.push_back(store.faceCount());
    }
    return begins;
}

bool isConstant(const FaceTexels& face)
{
    const std::span<const std::byte> bytes = face.bytes();
    return face.isConstant() || std::memcmp(bytes.data(),
                                            bytes.data() + face.texelBytes(),
                                            bytes.size() - face.texelBytes()) == 0;
}

PtxFaceInfo infoOf(FaceId face, Level level, const Adjacency& adjacency)
{
    PtxFaceInfo info;
    info.uLog2 = info.vLog2 = static_cast<std::int8_t>(level.log2());
    for (const LocalEdge edge : kLocalEdges) {
        if (const auto neighbour = adjacency.neighbour(face, edge)) {
            info.adjacentFaces[indexOf(edge)] = static_cast<std::int32_t>(neighbour->face);
            info.adjacentEdges |=
                static_cast<std::uint8_t>(indexOf(neighbour->edge) << (2 * indexOf(edge)));
        }
    }
    return info;
}

// Packs one face after the other into a chunk; one per thread.
class ChunkPacker
{
public:
    ChunkPacker(const TexelFormat& format, bool mips)
        : m_format(format)
        , m_mips(mips)
        , m_reducer(format)
    {
    }

    /// False when the face is larger than the format can hold.
    bool pack(const FaceTexels& face, PtxFaceInfo& info, std::span<std::byte> constant)
    {
        if (isConstant(face)) {
            info.flags |= PtxFaceInfo::kConstant;
            std::ranges::copy(face.bytes().first(face.texelBytes()), constant.begin());
            m_chunk.texels.headers.emplace_back();
            return true;
        }
        averageTexel(m_format, face.bytes(), constant);
        return packBlock(face.level(), face.bytes(), m_chunk.texels) &&
               (!m_mips || packReductions(face));
    }

    /// What was packed since the last call, in memory of just its size.
    PtxChunk take()
    {
        PtxChunk chunk;
        chunk.texels = taken(m_chunk.texels);
        for (std::size_t level = 0; level < m_chunk.reductions.size(); ++level) {
            for (PtxBlocks& blocks : m_chunk.reductions[level]) {
                chunk.reductions[level].push_back(taken(blocks));
            }
        }
        return chunk;
    }

private:
    static PtxBlocks taken(PtxBlocks& blocks)
    {
        PtxBlocks copy = blocks;
        blocks.bytes.clear();
        blocks.headers.clear();
        return copy;
    }

    bool packBlock(Level level, std::span<const std::byte> texels, PtxBlocks& blocks)
    {
        blocks.headers.push_back(encodePtxBlock(m_format, level, texels, m_encoder, blocks.bytes));
        return blocks.headers.back().size() > 0;
    }

    bool packReductions(const FaceTexels& face)
    {
        std::vector<PtxBlocks>& bins =
            m_chunk.reductions[static_cast<std::size_t>(face.level().log2())];
        bins.resize(static_cast<std::size_t>(ptxReductions(face.level())));
        auto bin = bins.begin();
        return m_reducer.forEach(face, [&](Level level, std::span<const std::byte> texels) {
            return packBlock(level, texels, *bin++);
        });
    }

    TexelFormat m_format;
    bool m_mips;
    PtxEncoder m_encoder;
    PtxReducer m_reducer;
    PtxChunk m_chunk;
};

int levelCountOf(const std::vector<PtxFaceInfo>& infos, bool mips)
{
    int reductions = 0;
    for (const PtxFaceInfo& info : infos) {
        if (!info.isConstant()) {
            reductions = std::max(reductions, ptxReductions(info.level()));
        }
    }
    return mips ? reductions + 1 : 1;
}

} // namespace

Result<PtxFaces> packPtxFaces(const TexelStore& store,
                              const Adjacency& adjacency,
                              bool mips,
                              Threads threads,
                              Progress& progress)
{
    check(adjacency.faceCount() == store.faceCount(), "links of every face");
    const std::size_t texelBytes = store.format().texelBytes();
    const std::vector<std::size_t> begins = chunkBegins(store);
    PtxFaces faces;
    faces.chunks.resize(begins.size() - 1);
    faces.infos.resize(store.faceCount());
    faces.constants.resize(store.faceCount() * texelBytes);

    SharedProgress shared(progress, faces.chunks.size());
    std::mutex mutex;
    std::size_t tooLarge = store.faceCount();
    std::atomic<bool> damaged = false;
    const auto packChunk = [&](std::size_t k, ChunkPacker& packer) {
        for (std::size_t f = begins[k]; f < begins[k + 1]; ++f) {
            const PinnedFace pin(store.face(faceId(f)));
            const FaceTexels& face = *pin;
            faces.infos[f] = infoOf(faceId(f), face.level(), adjacency);
            const auto constant = std::span(faces.constants).subspan(f * texelBytes, texelBytes);
            if (face.isDamaged()) {
                damaged = true;
                return;
            }
            const bool fits =
                face.byteCount() < kMaxPtxFaceBytes && packer.pack(face, faces.infos[f], constant);
            if (!fits) {
                const std::scoped_lock lock(mutex);
                tooLarge = std::min(tooLarge, f);
                return;
            }
        }
        faces.chunks[k] = packer.take();
        shared.step();
    };
    // One long range a thread, so that each keeps its packer; chunks are dealt out by a counter.
    std::atomic<std::size_t> next{0};
    const std::size_t workers = std::min<std::size_t>(threads.count, faces.chunks.size());
    parallelFor(workers, 1, threads, [&](std::size_t, std::size_t) {
        ChunkPacker packer(store.format(), mips);
        for (std::size_t k = next++; k < faces.chunks.size() && shared.goesOn() && !damaged;
             k = next++) {
            packChunk(k, packer);
        }
    });
    if (damaged) {
        return tl::unexpected(store.checkWhole().error());
    }
    if (tooLarge < store.faceCount()) {
        return contentsError("the texels of face " + std::to_string(tooLarge) +
                             " take more bytes than a .ptx can hold in one face");
    }
    if (!shared.goesOn()) {
        return cancelled();
    }
    faces.levelCount = levelCountOf(faces.infos, mips);
    flagConstantNeighbourhoods(faces.infos, faces.constants, texelBytes, threads);
    return faces;
}

} // namespace trixel
