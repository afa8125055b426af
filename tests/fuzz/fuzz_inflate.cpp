// SPDX-License-Identifier: GPL-3.0-or-later
//
// Any bytes as a raw DEFLATE stream: SmallInflater and zlib must agree on it.
#include "core/io/small_inflate.h"
#include "tests/core/io/inflate_oracle.h"

#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace trixel;
    static SmallInflater inflater;
    std::span<const std::byte> raw = std::as_bytes(std::span(data, size));
    const auto expected = samples::inflatedByZlib(raw, SmallInflater::kMaxBytes);
    if (expected) {
        raw = raw.first(expected->used);
    }
    std::vector<std::byte> out(expected ? expected->bytes.size() : 64);
    const auto stream = samples::wrapped(raw, expected ? expected->bytes : out);
    const bool accepted = inflater.unzip(stream, out);
    if (accepted != expected.has_value() || (expected && out != expected->bytes)) {
        std::abort();
    }
    return 0;
}
