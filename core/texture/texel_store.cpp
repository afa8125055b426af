// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/texel_store.h"

#include "core/texture/pinned_face.h"

#include <algorithm>
#include <string>
#include <unordered_map>
#include <utility>

namespace trixel {

TexelStore::TexelStore(std::uint32_t faceCount,
                       const TexelFormat& format,
                       Level level,
                       std::span<const std::byte> fill)
    : m_faceCount(faceCount)
    , m_format(format)
{
    check(fill.size() == format.texelBytes(), "a fill of one texel");
    auto block = std::make_shared<Block>();
    block->faces.fill(FaceTexels::constant(level, fill));
    m_blocks.assign((faceCount + kBlockFaces - 1) / kBlockFaces, block);
}

TexelStore::TexelStore(const TexelFormat& format,
                       const FaceMap<Level>& levels,
                       std::span<const std::byte> fill)
    : m_faceCount(static_cast<std::uint32_t>(levels.size()))
    , m_format(format)
{
    check(fill.size() == format.texelBytes(), "a fill of one texel");
    const FaceTexels value = FaceTexels::constant(Level(), fill);
    std::array<std::shared_ptr<Block>, Level::kMax + 1> uniform;
    for (std::size_t begin = 0; begin < levels.size(); begin += kBlockFaces) {
        const std::size_t count = std::min(kBlockFaces, levels.size() - begin);
        const std::span<const Level> some = levels.values().subspan(begin, count);
        const bool alike = std::ranges::all_of(some, [&](Level l) { return l == some.front(); });
        auto& shared = uniform[static_cast<std::size_t>(some.front().log2())];
        if (alike && shared) {
            m_blocks.push_back(shared);
            continue;
        }
        auto block = std::make_shared<Block>();
        block->faces.fill(value.atLevel(some.front()));
        for (std::size_t k = 0; k < count; ++k) {
            block->faces[k] = value.atLevel(some[k]);
        }
        if (alike) {
            shared = block;
        }
        m_blocks.push_back(std::move(block));
    }
}

const FaceTexels& TexelStore::face(FaceId face) const
{
    check(indexOf(face) < m_faceCount, "face exists");
    return m_blocks[indexOf(face) / kBlockFaces]->faces[indexOf(face) % kBlockFaces];
}

FaceTexels& TexelStore::ownFace(FaceId face)
{
    check(indexOf(face) < m_faceCount, "face exists");
    std::shared_ptr<Block>& block = m_blocks[indexOf(face) / kBlockFaces];
    if (block.use_count() > 1) {
        block = std::make_shared<Block>(*block);
    }
    return block->faces[indexOf(face) % kBlockFaces];
}

FaceTexels TexelStore::exchange(FaceId face, FaceTexels texels)
{
    check(texels.texelBytes() == m_format.texelBytes(), "texels in the store's format");
    return std::exchange(ownFace(face), std::move(texels));
}

std::span<std::byte> TexelStore::writable(FaceId face)
{
    return ownFace(face).writable();
}

TexelStore::Block
TexelStore::transformed(const Block& block,
                        std::size_t faceCount,
                        const std::function<FaceTexels(const FaceTexels&)>& convert)
{
    Block result;
    for (std::size_t k = 0; k < faceCount; ++k) {
        const PinnedFace pin(block.faces[k]);
        const FaceTexels& from = *pin;
        const bool seen = k > 0 && from.sharesBytesWith(block.faces[k - 1]);
        if (!seen) {
            result.faces[k] = convert(from);
        } else if (from.isConstant()) {
            result.faces[k] = result.faces[k - 1].atLevel(from.level());
        } else {
            result.faces[k] = result.faces[k - 1];
        }
        check(result.faces[k].level() == from.level(), "the face's own level");
    }
    return result;
}

Result<TexelStore>
TexelStore::transformed(const TexelFormat& format,
                        const std::function<FaceTexels(const FaceTexels&)>& convert,
                        Threads threads,
                        Progress& progress) const
{
    // Each distinct block once, at its first place; only the last block can be short.
    std::unordered_map<const Block*, std::size_t> placeOf;
    std::vector<std::size_t> firstUse;
    for (std::size_t k = 0; k < m_blocks.size(); ++k) {
        if (placeOf.emplace(m_blocks[k].get(), firstUse.size()).second) {
            firstUse.push_back(k);
        }
    }
    std::vector<std::shared_ptr<Block>> blocks(firstUse.size());
    constexpr std::size_t kStep = 32; // blocks between two looks at the progress
    for (std::size_t begin = 0; begin < blocks.size(); begin += kStep) {
        const auto whole = static_cast<double>(blocks.size());
        if (!progress.report(static_cast<double>(begin) / whole)) {
            return cancelled();
        }
        const std::size_t count = std::min(kStep, blocks.size() - begin);
        parallelFor(count, 1, threads, [&](std::size_t from, std::size_t to) {
            for (std::size_t k = begin + from; k < begin + to; ++k) {
                const std::size_t faces =
                    std::min(kBlockFaces, m_faceCount - firstUse[k] * kBlockFaces);
                blocks[k] =
                    std::make_shared<Block>(transformed(*m_blocks[firstUse[k]], faces, convert));
            }
        });
    }
    if (Status status = checkWhole(); !status) {
        return tl::unexpected(status.error());
    }
    TexelStore result;
    result.m_faceCount = m_faceCount;
    result.m_format = format;
    for (const std::shared_ptr<Block>& block : m_blocks) {
        result.m_blocks.push_back(blocks[placeOf.at(block.get())]);
    }
    return result;
}

std::uint64_t TexelStore::texelCount() const
{
    std::uint64_t count = 0;
    for (std::size_t k = 0; k < m_faceCount; ++k) {
        count += face(faceId(k)).level().texelCount();
    }
    return count;
}

std::uint64_t TexelStore::storedBytes() const
{
    std::uint64_t bytes = 0;
    for (std::size_t k = 0; k < m_faceCount; ++k) {
        const FaceTexels& texels = face(faceId(k));
        const bool seen = k % kBlockFaces != 0 && texels.sharesBytesWith(face(faceId(k - 1)));
        bytes += seen ? 0 : texels.byteCount();
    }
    return bytes;
}

void TexelStore::releaseHeld()
{
    for (std::size_t k = 0; k < m_faceCount; ++k) {
        const FaceTexels& texels = face(faceId(k));
        if (texels.isStored() && texels.isLoaded()) {
            exchange(faceId(k), texels.released());
        }
    }
}

Status TexelStore::checkWhole() const
{
    for (std::size_t k = 0; k < m_faceCount; ++k) {
        if (face(faceId(k)).isDamaged()) {
            return contentsError("face " + std::to_string(k) +
                                 " could not be read from its file, and the checks shown in its "
                                 "place must not be written out; fill the face to mend it");
        }
    }
    return {};
}

} // namespace trixel
