// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace trixel {

/// Unzips short zlib streams (RFC 1950, 1951). The libraries fill tables of thousands of entries
/// before the first byte, which for a face of 8 by 8 texels takes longer than all the rest; this
/// one keeps its tables small. One per thread.
class SmallInflater
{
public:
    /// Longest output worth unzipping here rather than by a library.
    static constexpr std::size_t kMaxBytes = 2048;

    /// Whether `zipped` starts with a whole, undamaged stream that gives exactly out.size() bytes;
    /// `out` is then filled, and otherwise holds anything.
    [[nodiscard]] bool unzip(std::span<const std::byte> zipped, std::span<std::byte> out);

private:
    static constexpr unsigned kTableBits = 9;
    static constexpr std::size_t kMaxSymbols = 288;

    /// A prefix code: codes of up to kTableBits bits are looked up, longer ones counted out.
    struct Code
    {
        /// Of the next tableBits bits: symbol << 4 | length; 0 where the code is longer or none is
        std::array<std::uint16_t, std::size_t{1} << kTableBits> table;
        std::array<std::uint16_t, 16> counts;           ///< codes of each length
        std::array<std::uint16_t, kMaxSymbols> symbols; ///< by length, then by symbol
        unsigned longest = 0;
        unsigned tableBits = 1;
    };

    /// The input as a row of bits, lowest bit of each byte first; zeros after its end.
    class Bits;

    static bool makeCode(std::span<const std::uint8_t> lengths, Code& code);
    static int decode(const Code& code, Bits& bits);
    static int decodeLong(const Code& code, Bits& bits);
    bool readCodes(Bits& shared);
    void setFixedCodes();
    bool copyStored(Bits& bits, std::span<std::byte> out, std::size_t& at);
    bool inflateBlock(Bits& shared, std::span<std::byte> out, std::size_t& end);

    Code m_literals;
    Code m_distances;
    Code m_lengths;
};

} // namespace trixel
