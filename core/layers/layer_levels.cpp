// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/coverage.h"
#include "core/layers/layer_edits.h"
#include "core/texture/level_change.h"

#include <utility>
#include <vector>

namespace trixel {

namespace {

/// Changes each texel's values, which end with its coverage, on the way to another type.
template <class Change>
FaceTexels
changed(const FaceTexels& face, const TexelFormat& from, const TexelFormat& to, Change&& change)
{
    const std::size_t channels = from.channels;
    std::vector<float> values(face.byteCount() / byteSize(from.type));
    decode(from.type, face.bytes(), values);
    for (std::size_t k = 0; k < values.size(); k += channels) {
        change(std::span(values).subspan(k, channels));
    }
    std::vector<std::byte> texels(values.size() * byteSize(to.type));
    encode(to.type, values, texels);
    return face.isConstant() ? FaceTexels::constant(face.level(), texels)
                             : FaceTexels::full(face.level(), to.texelBytes(), texels);
}

void weigh(std::span<float> texel)
{
    const float coverage = coverageOf(texel.back());
    for (float& value : texel) {
        value = coverage > 0.0F ? value * coverage : 0.0F; // whatever lies uncovered
    }
    texel.back() = coverage;
}

void unweigh(std::span<float> texel)
{
    const float coverage = texel.back();
    for (float& value : texel) {
        value = coverage > 0.0F ? value / coverage : 0.0F;
    }
    texel.back() = coverage;
}

/// Values times coverage, in float: their means are those of paint.
AveragedAs weighedByCoverage(const TexelFormat& layer)
{
    TexelFormat format = layer;
    format.type = TexelType::Float;
    return {format,
            [=](const FaceTexels& face) { return changed(face, layer, format, weigh); },
            [=](const FaceTexels& face) { return changed(face, format, layer, unweigh); }};
}

} // namespace

Result<LayerStack> withLevels(LayerStack layers,
                              const Adjacency& adjacency,
                              const FaceMap<Level>& levels,
                              Threads threads,
                              Progress& progress)
{
    const auto stores = static_cast<double>(layers.layers().size() + 1);
    StageProgress ofBase(progress, 0, 1 / stores);
    auto done = changeLevels(layers.texels(kBaseLayer), adjacency, levels, threads, ofBase);
    for (std::size_t k = 0; done && k < layers.layers().size(); ++k) {
        const auto before = static_cast<double>(k + 1);
        StageProgress ofLayer(progress, before / stores, (before + 1) / stores);
        TexelStore& texels = layers.texels(layers.layers()[k].id);
        const AveragedAs weighed = weighedByCoverage(texels.format());
        done = changeLevels(texels, adjacency, levels, threads, ofLayer, &weighed);
    }
    if (!done) {
        return tl::unexpected(done.error());
    }
    return layers;
}

} // namespace trixel
