// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/layer_edits.h"
#include "core/texture/level_change.h"
#include "core/texture/opacity.h"

#include <utility>

namespace trixel {

namespace {

/// Values times coverage, in float: their means are those of paint.
AveragedAs weighedByCoverage(const TexelFormat& layer)
{
    return {weighedFormat(layer),
            [=](const FaceTexels& face) { return weighed(face, layer); },
            [=](const FaceTexels& face) { return unweighed(face, layer); }};
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
        const AveragedAs averaged = weighedByCoverage(texels.format());
        done = changeLevels(texels, adjacency, levels, threads, ofLayer, &averaged);
    }
    if (!done) {
        return tl::unexpected(done.error());
    }
    return layers;
}

} // namespace trixel
