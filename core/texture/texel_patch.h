// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ids.h"
#include "core/texture/texel_store.h"

#include <cstdint>
#include <span>
#include <vector>

namespace trixel {

/// What a change replaced, and nothing more: runs of texels, or whole faces where a level or a
/// constant face changed. Swapping it with the store undoes the change and makes the patch hold
/// what it replaced, so the same call redoes it.
class TexelPatch
{
public:
    /// Consecutive texels of one face, in packed order.
    struct Run
    {
        std::uint32_t first = 0;
        std::uint32_t count = 0;

        bool operator==(const Run&) const = default;
    };

    /// Texels of one face: the runs, and their bytes one run after the other.
    struct Texels
    {
        FaceId face{};
        std::vector<Run> runs;
        std::vector<std::byte> values;
    };

    /// All of one face.
    struct Whole
    {
        FaceId face{};
        FaceTexels texels;
    };

    /// Adds texels of a face as they were before the change. A face is added once (not checked).
    /// \param runs    ascending, not touching each other, none empty (checked)
    /// \param before  their bytes, one run after the other
    void addTexels(FaceId face, std::span<const Run> runs, std::span<const std::byte> before);

    /// Adds a whole face as it was before the change. A face is added once (not checked).
    void addFace(FaceId face, FaceTexels before);

    /// Exchanges the patch's texels with the store's. The store is at the state the patch was made
    /// for, or the one it leads to: runs lie inside their faces (checked).
    void swap(TexelStore& store);

    /// Makes the store keep one value for each touched face that the change left of one colour;
    /// swapping still brings back what was there before.
    void collapseFaces(TexelStore& store);

    /// The faces the patch touches, in the order they were added; each once.
    std::span<const FaceId> faces() const { return m_faces; }
    std::span<const Texels> texels() const { return m_texels; }
    std::span<const Whole> wholeFaces() const { return m_whole; }
    bool isEmpty() const { return m_faces.empty(); }
    /// Bytes the patch keeps alive; faces added one after the other that share them count once,
    /// those that lie in a file not at all.
    std::size_t byteSize() const;

private:
    std::vector<FaceId> m_faces;
    std::vector<Texels> m_texels;
    std::vector<Whole> m_whole;
};

} // namespace trixel
