// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

namespace trixel {

/// Lengths of a Huffman code for symbols used so often; 0 for symbols that are not used, 1 if only
/// one is.
/// \param counts     how often each symbol is used; at most 288, and below 65536 in all
/// \param maxLength  of any symbol, at least enough for their number (checked)
/// \param lengths    as many as counts
/// Source: Moffat and Katajainen, In-place calculation of minimum-redundancy codes, 1995.
void huffmanLengths(std::span<const std::uint16_t> counts,
                    int maxLength,
                    std::span<std::uint8_t> lengths);

/// The canonical code of those lengths as DEFLATE writes it, each code's first bit lowest.
/// \param lengths  up to 15
/// \param codes    of the symbols with a length; others are left as they are
void huffmanCodes(std::span<const std::uint8_t> lengths, std::span<std::uint16_t> codes);

} // namespace trixel
