// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace trixel {

/// Zips short stretches of bytes into zlib streams (RFC 1950, 1951). The libraries are made for
/// long ones: for the few hundred bytes of a face of 8 by 8 texels they spend nearly all their time
/// on preparing tables for what might follow. One per thread; equal bytes give equal streams.
class SmallDeflater
{
public:
    static constexpr std::size_t kMaxBytes = 2048;

    /// Room that the stream of so many bytes needs at most.
    static constexpr std::size_t roomFor(std::size_t bytes) { return bytes + 32; }

    /// \param bytes  1 to kMaxBytes (checked)
    /// \param out    roomFor(bytes.size()) bytes or more (checked)
    /// \return       size of the stream
    std::size_t zip(std::span<const std::byte> bytes, std::span<std::byte> out);

private:
    static constexpr std::size_t kLiterals = 286; ///< literals, end of block, lengths
    static constexpr std::size_t kDistances = 30;
    static constexpr unsigned kHashBits = 10;

    /// A literal (length 0), or a stretch that was there `distance` bytes before.
    struct Token
    {
        std::uint16_t literalOrLength;
        std::uint16_t distance;
    };

    void findTokens(std::span<const std::byte> bytes);

    std::array<Token, kMaxBytes> m_tokens;
    std::size_t m_tokenCount = 0;
    std::uint32_t m_extraBits = 0; ///< of lengths and distances
    std::array<std::uint16_t, kLiterals> m_literalCounts;
    std::array<std::uint16_t, kDistances> m_distanceCounts;

    // Last position of each hash, counted on from call to call so that it needs no clearing.
    std::array<std::uint32_t, std::size_t{1} << kHashBits> m_lastAt{};
    std::uint32_t m_base = 1;
};

} // namespace trixel
