// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/inflate.h"

#include "core/base/check.h"

#include <libdeflate.h>

namespace trixel {

void Inflater::Free::operator()(libdeflate_decompressor* state) const
{
    libdeflate_free_decompressor(state);
}

Inflater::Inflater()
    : m_state(libdeflate_alloc_decompressor())
{
    check(m_state != nullptr, "memory for a decompressor");
}

bool Inflater::unzip(std::span<const std::byte> zipped, std::span<std::byte> out)
{
    if (out.size() <= SmallInflater::kMaxBytes) {
        return m_small.unzip(zipped, out);
    }
    return libdeflate_zlib_decompress(
               m_state.get(), zipped.data(), zipped.size(), out.data(), out.size(), nullptr) ==
           LIBDEFLATE_SUCCESS;
}

} // namespace trixel
