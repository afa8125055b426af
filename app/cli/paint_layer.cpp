// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/paint_layer.h"

#include "core/layers/compose.h"
#include "core/layers/layer_edits.h"

#include <utility>

namespace trixel::app {
namespace {

/// What turns the texels before into those after.
TexelPatch difference(const TexelStore& before, const TexelStore& after)
{
    TexelPatch patch;
    for (std::size_t k = 0; k < after.faceCount(); ++k) {
        const FaceTexels& face = after.face(faceId(k));
        if (!face.sharesBytesWith(before.face(faceId(k))) && face != before.face(faceId(k))) {
            patch.addFace(faceId(k), face);
        }
    }
    return patch;
}

} // namespace

Status takePaint(Project& project, TexelStore painted, std::string name, Progress& progress)
{
    if (project.layers.isPlain()) {
        project.texels = std::move(painted);
        return {};
    }
    if (!project.layers.hasRoom()) {
        return contentsError("there is no room for a layer with the paint; merge some first");
    }
    const TexelPatch patch = difference(project.texels, painted);
    LayerStack layers = std::move(project.layers);
    layers.insert(layers.layers().size(), {std::move(name)}, layerOfPatch(patch, project.texels));
    return composed(std::move(layers), Threads::all(), progress).map([&](Layered&& layered) {
        project.texels = std::move(layered.shown);
        project.layers = std::move(layered.layers);
    });
}

} // namespace trixel::app
