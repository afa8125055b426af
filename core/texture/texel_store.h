// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/face_map.h"
#include "core/base/ids.h"
#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/texture/face_texels.h"
#include "core/texture/texel_format.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace trixel {

/// The texels of every face of a mesh: the truth that everything shown and saved derives from.
///
/// Faces live in blocks that copies of the store share until one is written to, so a copy is a
/// cheap snapshot (for saving while painting goes on), and a store nobody painted holds one block
/// and one value however many faces it has.
class TexelStore
{
public:
    /// A store of no faces.
    TexelStore() = default;

    /// Every face constant at the same level.
    /// \param fill  the bytes of one texel in `format` (checked)
    TexelStore(std::uint32_t faceCount,
               const TexelFormat& format,
               Level level,
               std::span<const std::byte> fill);

    /// Every face constant, each at its own level; all share one value, and blocks of one level
    /// share one block.
    /// \param fill  the bytes of one texel in `format` (checked)
    TexelStore(const TexelFormat& format,
               const FaceMap<Level>& levels,
               std::span<const std::byte> fill);

    std::uint32_t faceCount() const { return m_faceCount; }
    const TexelFormat& format() const { return m_format; }

    const FaceTexels& face(FaceId face) const;

    /// Puts other texels in the place of a face's and returns what was there. The level may
    /// differ, the bytes of a texel may not (checked).
    FaceTexels exchange(FaceId face, FaceTexels texels);

    /// Every texel of the face, to be written to in place. Not for several threads at once; the
    /// spans of different faces may then be filled in parallel.
    std::span<std::byte> writable(FaceId face);

    /// A store of another format that holds convert(face) for every face. Blocks that are shared
    /// are converted once and stay shared, and so do values shared by neighbouring faces: convert
    /// may not depend on anything but the face's texels, keeps its level, and is called from
    /// several threads. Stored faces are converted one after the other, from memory they don't
    /// keep. Fails when cancelled and when a face cannot be read.
    Result<TexelStore> transformed(const TexelFormat& format,
                                   const std::function<FaceTexels(const FaceTexels&)>& convert,
                                   Threads threads,
                                   Progress& progress) const;

    /// Texels as addressed (4^n a face), whether stored or constant.
    std::uint64_t texelCount() const;
    /// Bytes of texel data, as they are in memory once read; faces that share a value count it once
    /// a block.
    std::uint64_t storedBytes() const;

    /// Gives back the memory of texels that stored faces hold because `bytes` was asked for. A
    /// change like any other: references and spans of those faces end, copies of the store keep
    /// theirs. Costs a look at every face.
    void releaseHeld();
    /// Fails, naming the face, if one that was asked for could not be read: what stands in for it
    /// must not be written out. To be asked after the texels were. Costs a look at every face.
    Status checkWhole() const;

private:
    static constexpr std::size_t kBlockFaces = 256;
    struct Block
    {
        std::array<FaceTexels, kBlockFaces> faces;
    };

    static Block transformed(const Block& block,
                             std::size_t faceCount,
                             const std::function<FaceTexels(const FaceTexels&)>& convert);
    FaceTexels& ownFace(FaceId face);

    std::uint32_t m_faceCount = 0;
    TexelFormat m_format;
    std::vector<std::shared_ptr<Block>> m_blocks;
};

} // namespace trixel
