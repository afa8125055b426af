// SPDX-License-Identifier: GPL-3.0-or-later
//
// Metadata of a .ptx: keys with values of six types, small ones in one block, large ones apart.
#pragma once

#include "core/base/result.h"
#include "core/io/ptx.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trixel {

/// The item of that key, or null.
const PtxMetadata* findMetadata(std::span<const PtxMetadata> items, std::string_view key);

/// Adds the item, or puts it in the place of the one with its key.
void putMetadata(std::vector<PtxMetadata>& items, PtxMetadata item);

/// Puts the last item of each key in the place of the first: later duplicates replace earlier ones.
void mergeDuplicates(std::vector<PtxMetadata>& items);

/// Removes the item of that key, if there is one.
void removeMetadata(std::vector<PtxMetadata>& items, std::string_view key);

/// Bytes of the value as the file stores them; a string with its closing NUL.
std::vector<std::byte> valueBytes(const PtxMetadata& item);
std::size_t valueByteCount(const PtxMetadata& item);

/// Whether the item can be written: a key of 1 to 254 bytes without NUL, a value below 4 GiB.
/// \return  what is wrong with it as a sentence; empty if nothing
std::string faultOf(const PtxMetadata& item);

/// What the table of the large items says about one of them.
struct PtxLargeItem
{
    std::string key;
    std::uint8_t type = 0;
    std::uint32_t bytes = 0;
    std::uint32_t zippedBytes = 0;
};

/// The item with that value. Errors name the key and what is wrong with its type or size.
Result<PtxMetadata>
makeMetadata(std::string key, std::uint8_t type, std::span<const std::byte> value);

/// Reads an unzipped block of small items and appends them.
Status parseMetadata(std::span<const std::byte> block, std::vector<PtxMetadata>& items);

/// Reads the unzipped table of large items.
Result<std::vector<PtxLargeItem>> parseLargeMetadata(std::span<const std::byte> table);

/// Appends an item as the block of small items holds it.
void appendMetadata(const PtxMetadata& item, std::vector<std::byte>& block);

/// Appends the entry of a large item.
void appendLargeMetadata(const PtxMetadata& item,
                         std::uint32_t zippedBytes,
                         std::vector<std::byte>& table);

} // namespace trixel
