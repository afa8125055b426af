// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/texel_store.h"

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
        bytes += seen ? 0 : texels.bytes().size();
    }
    return bytes;
}

} // namespace trixel
