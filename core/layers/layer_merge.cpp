// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/check.h"
#include "core/layers/compose.h"
#include "core/layers/coverage.h"
#include "core/layers/face_layers.h"
#include "core/layers/known_blend.h"
#include "core/layers/layer_edits.h"
#include "core/layers/replace_faces.h"
#include "core/texture/pinned_face.h"

#include <algorithm>
#include <array>
#include <utility>

namespace trixel {

namespace {

/// One layer over another, both as they are shown.
struct Pair
{
    const Layer& upper;
    const Layer& lower;
};

/// A texel of the upper layer over one of the lower, which becomes both.
/// \param lower  its channels and its coverage, opacities not yet in either
template <LayerBlend kBlend>
void merge(std::span<const float> upper,
           float upperOpacity,
           float lowerOpacity,
           std::span<float> lower)
{
    const std::size_t last = lower.size() - 1;
    const float over = coverageOf(upper[last]) * upperOpacity;
    const float under = coverageOf(lower[last]) * lowerOpacity;
    const float both = over + under * (1.0F - over);
    const float part = over > 0.0F ? over / both : 0.0F;
    for (std::size_t c = 0; c < last && over > 0.0F; ++c) {
        // Blended as far as there is something to blend with, which what is uncovered is not.
        const float met = under > 0.0F ? blended<kBlend>(lower[c], upper[c]) : upper[c];
        const float mixed = upper[c] + under * (met - upper[c]);
        lower[c] = part < 1.0F ? lower[c] + part * (mixed - lower[c]) : mixed;
    }
    lower[last] = both;
}

void mergeRun(const Pair& pair, std::span<const float> upper, std::span<float> lower)
{
    const LayerSettings& settings = pair.upper.settings;
    const float opacity = pair.lower.settings.opacity;
    const std::size_t channels = pair.upper.texels.format().channels;
    withLayerBlend(settings.blend, [&](auto blend) {
        for (std::size_t k = 0; k < lower.size(); k += channels) {
            merge<decltype(blend)::value>(
                upper.subspan(k, channels), settings.opacity, opacity, lower.subspan(k, channels));
        }
    });
}

FaceTexels mergedFace(const Pair& pair, FaceId face)
{
    const TexelFormat& format = pair.lower.texels.format();
    const PinnedFace upper(pair.upper.texels.face(face));
    FaceTexels result = pair.lower.texels.face(face).pinned();
    check(upper->level() == result.level(), "layers of the same levels");
    const bool isConstant = upper->isConstant() && result.isConstant();
    std::vector<std::byte> one(result.bytes().begin(),
                               result.bytes().begin() + format.texelBytes());
    const std::span<std::byte> texels = isConstant ? std::span(one) : result.writable();
    const std::size_t texelBytes = format.texelBytes();
    constexpr std::size_t kRunTexels = 64;
    std::vector<float> above(kRunTexels * format.channels);
    std::vector<float> below(kRunTexels * format.channels);
    for (std::size_t first = 0; first < texels.size() / texelBytes; first += kRunTexels) {
        const std::size_t count = std::min(kRunTexels, texels.size() / texelBytes - first);
        const auto run = texels.subspan(first * texelBytes, count * texelBytes);
        const auto values = std::span(below).first(count * format.channels);
        for (std::size_t k = 0; k < count; ++k) {
            decode(format.type,
                   upper->texel(first + k),
                   std::span(above).subspan(k * format.channels, format.channels));
        }
        decode(format.type, run, values);
        mergeRun(pair, above, values);
        encode(format.type, values, run);
    }
    return isConstant ? FaceTexels::constant(result.level(), one) : result;
}

Result<LayerStack>
mergedIntoBase(LayerStack layers, LayerId layer, Threads threads, Progress& progress)
{
    LayerStack alone(layers.base());
    alone.insert(0, layers.settings(layer), layers.texels(layer));
    auto shown = composed(std::move(alone), threads, progress);
    if (!shown) {
        return tl::unexpected(shown.error());
    }
    layers.texels(kBaseLayer) = std::move(shown->shown);
    layers.remove(layer);
    return layers;
}

} // namespace

Result<LayerStack> mergedDown(LayerStack layers, LayerId layer, Threads threads, Progress& progress)
{
    check(layers.settings(layer).isVisible, "a layer that is shown");
    const std::size_t place = *layers.indexOf(layer);
    if (place == 0) {
        return mergedIntoBase(std::move(layers), layer, threads, progress);
    }
    const Pair pair{layers.layers()[place], layers.layers()[place - 1]};
    const bool isUpperShown = pair.upper.settings.opacity > 0.0F;
    const bool isLowerThinned = pair.lower.settings.opacity < 1.0F;
    std::vector<FaceId> due;
    for (std::uint32_t f = 0; f < layers.base().faceCount(); ++f) {
        if ((isUpperShown && mayCover(pair.upper, faceId(f))) ||
            (isLowerThinned && mayCover(pair.lower, faceId(f)))) {
            due.push_back(faceId(f));
        }
    }
    TexelStore merged = pair.lower.texels;
    const auto make = [&](FaceId face) { return mergedFace(pair, face); };
    if (const Status done = replaceFaces(merged, due, make, threads, progress); !done) {
        return tl::unexpected(done.error());
    }
    for (const Layer* read : {&pair.upper, &pair.lower}) {
        if (const Status whole = checkRead(read->texels, due); !whole) {
            return tl::unexpected(whole.error());
        }
    }
    LayerSettings settings = pair.lower.settings;
    settings.opacity = 1.0F;
    const LayerId lower = pair.lower.id;
    layers.texels(lower) = std::move(merged);
    layers.set(lower, std::move(settings));
    layers.remove(layer);
    return layers;
}

} // namespace trixel
