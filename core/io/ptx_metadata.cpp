// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/ptx_metadata.h"

#include "core/io/byte_reader.h"

#include <algorithm>
#include <array>
#include <limits>
#include <unordered_map>

namespace trixel {

namespace {

constexpr std::array<std::size_t, 6> kValueBytes{1, 1, 2, 4, 4, 8};
constexpr std::size_t kMaxKeyBytes = 254;

template <class T>
PtxMetadata::Value arrayOf(std::span<const std::byte> bytes)
{
    std::vector<T> values(bytes.size() / sizeof(T));
    if (!values.empty()) {
        std::memcpy(values.data(), bytes.data(), bytes.size());
    }
    return values;
}

std::string stringOf(std::span<const std::byte> bytes)
{
    std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (!text.empty() && text.back() == '\0') {
        text.pop_back();
    }
    return text;
}

PtxMetadata::Value valueOf(std::uint8_t type, std::span<const std::byte> bytes)
{
    switch (type) {
    case 0:
        return stringOf(bytes);
    case 1:
        return arrayOf<std::int8_t>(bytes);
    case 2:
        return arrayOf<std::int16_t>(bytes);
    case 3:
        return arrayOf<std::int32_t>(bytes);
    case 4:
        return arrayOf<float>(bytes);
    default:
        return arrayOf<double>(bytes);
    }
}

// The key stands with its closing NUL after a byte that counts both.
std::optional<std::string> takeKey(ByteReader& reader)
{
    const auto size = reader.take<std::uint8_t>();
    const auto bytes = size ? reader.takeBytes(*size) : std::nullopt;
    if (!bytes || bytes->size() < 2 || bytes->back() != std::byte{0}) {
        return std::nullopt;
    }
    std::string key = stringOf(*bytes);
    return key.find('\0') == std::string::npos ? std::optional(std::move(key)) : std::nullopt;
}

template <class T>
void append(T value, std::vector<std::byte>& to)
{
    const auto* bytes = reinterpret_cast<const std::byte*>(&value);
    to.insert(to.end(), bytes, bytes + sizeof(T));
}

void appendHead(const PtxMetadata& item, std::vector<std::byte>& to)
{
    append(static_cast<std::uint8_t>(item.key.size() + 1), to);
    const auto key = std::as_bytes(std::span(item.key.c_str(), item.key.size() + 1));
    to.insert(to.end(), key.begin(), key.end());
    append(static_cast<std::uint8_t>(item.value.index()), to);
    append(static_cast<std::uint32_t>(valueByteCount(item)), to);
}

} // namespace

const PtxMetadata* findMetadata(std::span<const PtxMetadata> items, std::string_view key)
{
    const auto found = std::ranges::find(items, key, &PtxMetadata::key);
    return found == items.end() ? nullptr : &*found;
}

void putMetadata(std::vector<PtxMetadata>& items, PtxMetadata item)
{
    const auto found = std::ranges::find(items, item.key, &PtxMetadata::key);
    if (found == items.end()) {
        items.push_back(std::move(item));
    } else {
        *found = std::move(item);
    }
}

void mergeDuplicates(std::vector<PtxMetadata>& items)
{
    std::unordered_map<std::string, std::size_t> places;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < items.size(); ++k) {
        const auto [place, isNew] = places.try_emplace(items[k].key, kept);
        if (place->second != k) {
            items[place->second] = std::move(items[k]);
        }
        kept += isNew ? 1 : 0;
    }
    items.resize(kept);
}

void removeMetadata(std::vector<PtxMetadata>& items, std::string_view key)
{
    std::erase_if(items, [key](const PtxMetadata& item) { return item.key == key; });
}

std::size_t valueByteCount(const PtxMetadata& item)
{
    const std::size_t count =
        std::visit([](const auto& value) { return value.size(); }, item.value);
    return item.value.index() == 0 ? count + 1 : count * kValueBytes[item.value.index()];
}

std::vector<std::byte> valueBytes(const PtxMetadata& item)
{
    return std::visit(
        [&](const auto& value) {
            std::vector<std::byte> bytes(valueByteCount(item)); // a string's NUL is already there
            const auto stored = std::as_bytes(std::span(value));
            std::ranges::copy(stored, bytes.begin());
            return bytes;
        },
        item.value);
}

std::string faultOf(const PtxMetadata& item)
{
    if (item.key.empty() || item.key.size() > kMaxKeyBytes ||
        item.key.find('\0') != std::string::npos) {
        return "the metadata key \"" + item.key + "\" has " + std::to_string(item.key.size()) +
               " bytes, a .ptx keeps 1 to 254 without a zero among them";
    }
    if (valueByteCount(item) > std::numeric_limits<std::uint32_t>::max()) {
        return "the metadata \"" + item.key + "\" is larger than the 4 GiB a .ptx can hold";
    }
    return {};
}

Result<PtxMetadata>
makeMetadata(std::string key, std::uint8_t type, std::span<const std::byte> value)
{
    if (type >= kValueBytes.size()) {
        return contentsError("the metadata \"" + key + "\" is of the unknown type " +
                             std::to_string(type) + ", expected 0 to 5");
    }
    if (value.size() % kValueBytes[type] != 0) {
        return contentsError("the metadata \"" + key + "\" has " + std::to_string(value.size()) +
                             " bytes, not a multiple of " + std::to_string(kValueBytes[type]));
    }
    return PtxMetadata{std::move(key), valueOf(type, value)};
}

Status parseMetadata(std::span<const std::byte> block, std::vector<PtxMetadata>& items)
{
    ByteReader reader(block);
    while (reader.remaining() > 0) {
        const std::size_t at = block.size() - reader.remaining();
        const std::optional<std::string> key = takeKey(reader);
        const auto type = reader.take<std::uint8_t>();
        const auto size = reader.take<std::uint32_t>();
        const auto value = size ? reader.takeBytes(*size) : std::nullopt;
        if (!key || !type || !value) {
            return contentsError("the metadata item at byte " + std::to_string(at) +
                                 " of its block is damaged or does not end inside it");
        }
        Result<PtxMetadata> item = makeMetadata(*key, *type, *value);
        if (!item) {
            return tl::unexpected(item.error());
        }
        items.push_back(std::move(*item));
    }
    return {};
}

Result<std::vector<PtxLargeItem>> parseLargeMetadata(std::span<const std::byte> table)
{
    std::vector<PtxLargeItem> items;
    ByteReader reader(table);
    while (reader.remaining() > 0) {
        const std::size_t at = table.size() - reader.remaining();
        const std::optional<std::string> key = takeKey(reader);
        const auto type = reader.take<std::uint8_t>();
        const auto bytes = reader.take<std::uint32_t>();
        const auto zipped = reader.take<std::uint32_t>();
        if (!key || !type || !bytes || !zipped) {
            return contentsError("the entry at byte " + std::to_string(at) +
                                 " of the table of large metadata is damaged");
        }
        items.push_back({*key, *type, *bytes, *zipped});
    }
    return items;
}

void appendMetadata(const PtxMetadata& item, std::vector<std::byte>& block)
{
    appendHead(item, block);
    const std::vector<std::byte> value = valueBytes(item);
    block.insert(block.end(), value.begin(), value.end());
}

void appendLargeMetadata(const PtxMetadata& item,
                         std::uint32_t zippedBytes,
                         std::vector<std::byte>& table)
{
    appendHead(item, table);
    append(zippedBytes, table);
}

} // namespace trixel
