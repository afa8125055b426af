// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture/opacity.h"

#include "core/base/check.h"

#include <vector>

namespace trixel {

namespace {

/// Changes each texel's values on the way to another type.
template <class Change>
FaceTexels changed(const FaceTexels& face,
                   const TexelFormat& from,
                   const TexelFormat& to,
                   const Change& change)
{
    check(from.alpha && from.alpha == to.alpha && from.channels == to.channels,
          "texels that know their opacity");
    std::vector<float> values(face.byteCount() / byteSize(from.type));
    decode(from.type, face.bytes(), values);
    for (std::size_t k = 0; k < values.size(); k += from.channels) {
        change(std::span(values).subspan(k, from.channels), *from.alpha);
    }
    std::vector<std::byte> texels(values.size() * byteSize(to.type));
    encode(to.type, values, texels);
    return face.isConstant() ? FaceTexels::constant(face.level(), texels)
                             : FaceTexels::full(face.level(), to.texelBytes(), texels);
}

void weigh(std::span<float> texel, std::size_t opacity)
{
    const float whole = opacityOf(texel[opacity]);
    for (float& value : texel) {
        value = whole > 0.0F ? value * whole : 0.0F; // whatever lies unseen, be it NaN
    }
    texel[opacity] = whole;
}

} // namespace

TexelFormat weighedFormat(const TexelFormat& format)
{
    TexelFormat weighed = format;
    weighed.type = TexelType::Float;
    return weighed;
}

FaceTexels weighed(const FaceTexels& face, const TexelFormat& format)
{
    return changed(face, format, weighedFormat(format), weigh);
}

FaceTexels unweighed(const FaceTexels& face, const TexelFormat& format)
{
    return changed(face, weighedFormat(format), format, unweigh);
}

Result<TexelStore> weighed(const TexelStore& store, Threads threads, Progress& progress)
{
    const TexelFormat& format = store.format();
    if (!format.alpha) {
        return store;
    }
    return store.transformed(
        weighedFormat(format),
        [&](const FaceTexels& face) { return weighed(face, format); },
        threads,
        progress);
}

} // namespace trixel
