// SPDX-License-Identifier: GPL-3.0-or-later
//
// What zlib makes of a raw DEFLATE stream, to compare SmallInflater with.
#pragma once

#include <cstddef>
#include <libdeflate.h>
#include <optional>
#include <span>
#include <vector>
#include <zlib.h>

namespace trixel::samples {

struct Inflated
{
    std::vector<std::byte> bytes;
    std::size_t used = 0; ///< bytes of the input
};

/// The output, if the stream is whole and gives at most `limit` bytes.
inline std::optional<Inflated> inflatedByZlib(std::span<const std::byte> raw, std::size_t limit)
{
    z_stream stream{};
    inflateInit2(&stream, -15);
    Inflated result{std::vector<std::byte>(limit + 1), 0};
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(raw.data()));
    stream.avail_in = static_cast<uInt>(raw.size());
    stream.next_out = reinterpret_cast<Bytef*>(result.bytes.data());
    stream.avail_out = static_cast<uInt>(result.bytes.size());
    const int status = inflate(&stream, Z_FINISH);
    result.bytes.resize(stream.total_out);
    result.used = stream.total_in;
    inflateEnd(&stream);
    if (status != Z_STREAM_END || result.bytes.size() > limit) {
        return std::nullopt;
    }
    return result;
}

/// The raw stream as a zlib stream with the checksum of `bytes`.
inline std::vector<std::byte> wrapped(std::span<const std::byte> raw,
                                      std::span<const std::byte> bytes)
{
    std::vector<std::byte> stream{std::byte{0x78}, std::byte{0x9C}};
    stream.insert(stream.end(), raw.begin(), raw.end());
    const auto sum = libdeflate_adler32(1, bytes.data(), bytes.size());
    for (const unsigned shift : {24U, 16U, 8U, 0U}) {
        stream.push_back(static_cast<std::byte>(sum >> shift & 0xFFU));
    }
    return stream;
}

} // namespace trixel::samples
