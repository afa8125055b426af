// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/small_inflate.h"

#include <cstddef>
#include <memory>
#include <span>

struct libdeflate_decompressor;

namespace trixel {

/// Unzips zlib streams (RFC 1950) of known unzipped size: short ones by a decoder made for them,
/// others by a library. One per thread.
class Inflater
{
public:
    /// No stream of `zippedBytes` holds more than this many bytes.
    static constexpr std::size_t kMaxRatio = 4096;

    Inflater();

    /// Whether `zipped` is a whole, undamaged stream that gives exactly out.size() bytes; `out` is
    /// then filled.
    [[nodiscard]] bool unzip(std::span<const std::byte> zipped, std::span<std::byte> out);

private:
    struct Free
    {
        void operator()(libdeflate_decompressor* state) const;
    };
    std::unique_ptr<libdeflate_decompressor, Free> m_state;
    SmallInflater m_small;
};

} // namespace trixel
