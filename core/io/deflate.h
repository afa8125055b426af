// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/buffer.h"
#include "core/io/small_deflate.h"

#include <cstddef>
#include <memory>
#include <span>

struct libdeflate_compressor;

namespace trixel {

/// Zips bytes into zlib streams (RFC 1950): short ones by an encoder made for them, others by a
/// library. One per thread. Equal bytes give equal streams.
class Deflater
{
public:
    /// About as small as zlib's own default.
    static constexpr int kDefaultLevel = 6;

    /// \param level  1 (fast) to 12 (small)
    explicit Deflater(int level = kDefaultLevel);

    /// The stream; valid until the next call.
    std::span<const std::byte> zip(std::span<const std::byte> bytes);

private:
    struct Free
    {
        void operator()(libdeflate_compressor* state) const;
    };
    std::unique_ptr<libdeflate_compressor, Free> m_state;
    std::unique_ptr<SmallDeflater> m_small = std::make_unique<SmallDeflater>();
    Buffer m_zipped;
};

} // namespace trixel
