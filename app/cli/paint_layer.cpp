// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/paint_layer.h"

#include "core/layers/compose.h"
#include "core/layers/layer_edits.h"

#include <utility>

namespace trixel::app {

Status takePaint(Project& project, TexelStore painted, std::string name, Progress& progress)
{
    if (project.layers.isPlain()) {
        project.texels = std::move(painted);
        return {};
    }
    if (!project.layers.hasRoom()) {
        return contentsError("there is no room for a layer with the paint; merge some first");
    }
    const Layered before{project.texels, project.layers};
    LayerStack layers = before.layers;
    layers.insert(layers.layers().size(),
                  {std::move(name)},
                  layerOfPatch(patchTo(painted, before.shown), before.shown));
    return recomposed(std::move(layers), before, Threads::all(), progress)
        .map([&](Layered&& layered) {
            project.texels = std::move(layered.shown);
            project.layers = std::move(layered.layers);
        });
}

} // namespace trixel::app
