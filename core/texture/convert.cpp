// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/convert.h"

#include <algorithm>
#include <array>
#include <vector>

namespace trixel {

namespace {

void convertTexels(TexelType from,
                   std::span<const std::byte> source,
                   TexelType to,
                   std::span<std::byte> target)
{
    std::array<float, 1024> values;
    const std::size_t count = source.size() / byteSize(from);
    for (std::size_t done = 0; done < count; done += values.size()) {
        const std::size_t some = std::min(values.size(), count - done);
        const std::span<float> part = std::span(values).first(some);
        decode(from, source.subspan(done * byteSize(from), some * byteSize(from)), part);
        encode(to, part, target.subspan(done * byteSize(to), some * byteSize(to)));
    }
}

FaceTexels convertFace(const TexelFormat& from, const FaceTexels& face, const TexelFormat& to)
{
    std::vector<std::byte> texels(face.byteCount() / byteSize(from.type) * byteSize(to.type));
    convertTexels(from.type, face.bytes(), to.type, texels);
    return face.isConstant() ? FaceTexels::constant(face.level(), texels)
                             : FaceTexels::full(face.level(), to.texelBytes(), texels);
}

} // namespace

Result<TexelStore>
converted(const TexelStore& store, TexelType type, Threads threads, Progress& progress)
{
    if (store.format().type == type) {
        return store;
    }
    TexelFormat format = store.format();
    format.type = type;
    return store.transformed(
        format,
        [&](const FaceTexels& face) { return convertFace(store.format(), face, format); },
        threads,
        progress);
}

} // namespace trixel
