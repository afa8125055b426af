// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/deflate.h"

#include "core/base/check.h"

#include <libdeflate.h>

namespace trixel {

void Deflater::Free::operator()(libdeflate_compressor* state) const
{
    libdeflate_free_compressor(state);
}

Deflater::Deflater(int level)
    : m_state(libdeflate_alloc_compressor(level))
{
    check(m_state != nullptr, "memory for a compressor");
}

std::span<const std::byte> Deflater::zip(std::span<const std::byte> bytes)
{
    if (!bytes.empty() && bytes.size() <= SmallDeflater::kMaxBytes) {
        const std::span<std::byte> room = m_zipped.first(SmallDeflater::roomFor(bytes.size()));
        return room.first(m_small->zip(bytes, room));
    }
    const std::span<std::byte> room =
        m_zipped.first(libdeflate_zlib_compress_bound(m_state.get(), bytes.size()));
    const std::size_t size = libdeflate_zlib_compress(
        m_state.get(), bytes.data(), bytes.size(), room.data(), room.size());
    check(size > 0, "room for the stream");
    return room.first(size);
}

} // namespace trixel
