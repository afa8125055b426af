// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/check.h"
#include "core/base/ids.h"
#include "core/base/level.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace trixel {

/// One block of floats a face, many faces to a block: what is alike is stored once. A copy of the
/// whole shares every block; a block is copied before it is written to while others use it.
class SharedBlocks
{
public:
    struct Block
    {
        Level level;
        bool constant = false;
        std::uint32_t users = 0; ///< faces of this table
        std::size_t size = 0;    ///< floats
        std::shared_ptr<float[]> values;
    };

    SharedBlocks() = default;
    explicit SharedBlocks(std::size_t faceCount)
        : m_blockOf(faceCount, kNone)
    {
    }

    std::size_t faceCount() const { return m_blockOf.size(); }
    const Block& block(FaceId face) const
    {
        check(indexOf(face) < m_blockOf.size(), "face exists");
        return m_blocks[m_blockOf[indexOf(face)]];
    }
    std::uint32_t blockNumber(FaceId face) const { return m_blockOf[indexOf(face)]; }
    /// By number, those that nobody uses any more among them (users == 0).
    const std::vector<Block>& blocks() const { return m_blocks; }

    /// A block of its own for the face, values not yet set, in place of what it had.
    float* renew(FaceId face, Level level, bool constant, std::size_t size);
    /// The block of another face, which keeps it.
    void share(FaceId face, FaceId with);
    /// The same values in a block that nobody else uses.
    float* writable(FaceId face);

    std::size_t memoryBytes() const;

private:
    static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

    void release(FaceId face);

    std::vector<std::uint32_t> m_blockOf; // of each face
    std::vector<Block> m_blocks;
    std::vector<std::uint32_t> m_unused; // numbers to give again
};

} // namespace trixel
