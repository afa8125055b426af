// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/made_layers.h"

#include <QCoreApplication>
#include <QFileInfo>

#include "core/base/check.h"
#include "core/layers/layer_edits.h"

#include <utility>

namespace trixel::ui {

namespace {

tl::unexpected<Error> noRoom()
{
    return contentsError(QCoreApplication::translate("MadeLayers",
                                                     "There is no room for another layer: merge or "
                                                     "remove one first.")
                             .toStdString());
}

/// With what they look like: faces that are as they were show what they showed.
Result<LayersEdit>
shown(LayerStack next, LayersEdit edit, const Project& before, Progress& progress)
{
    const Layered now{before.texels, before.layers};
    return recomposed(std::move(next), now, Threads::all(), progress).map([&](Layered&& all) {
        edit.all = std::move(all);
        return edit;
    });
}

} // namespace

Result<LayersEdit> withPatchAsLayer(const Project& project,
                                    LayerId below,
                                    const TexelPatch& patch,
                                    const QString& file,
                                    Progress& progress)
{
    check(!project.layers.isPlain(), "a project with layers");
    if (!project.layers.hasRoom()) {
        return noRoom();
    }
    LayerStack next = project.layers;
    const auto place = next.indexOf(below);
    LayerSettings settings;
    settings.name = QFileInfo(file).completeBaseName().toStdString();
    const LayerId layer = next.insert(
        place ? *place + 1 : 0, std::move(settings), layerOfPatch(patch, project.texels));
    return shown(std::move(next), {{}, layer, false}, project, progress);
}

Result<LayersEdit> withLayerMerged(const Project& project, LayerId layer, Progress& progress)
{
    StageProgress merging(progress, 0, 0.6);
    Result<LayerStack> next = mergedDown(project.layers, layer, Threads::all(), merging);
    if (!next) {
        return tl::unexpected(next.error());
    }
    const std::size_t place = *project.layers.indexOf(layer);
    const LayerId below = place > 0 ? project.layers.layers()[place - 1].id : kBaseLayer;
    StageProgress showing(progress, 0.6, 1);
    return shown(std::move(*next), {{}, below, false}, project, showing);
}

Result<LayersEdit> withOtherLevels(const Project& project,
                                   LayerId active,
                                   const FaceMap<Level>& levels,
                                   Progress& progress)
{
    check(!project.layers.isPlain(), "a project with layers");
    StageProgress changing(progress, 0, 0.7);
    Result<LayerStack> next =
        withLevels(project.layers, project.surface->adjacency(), levels, Threads::all(), changing);
    if (!next) {
        return tl::unexpected(next.error());
    }
    StageProgress showing(progress, 0.7, 1);
    return shown(std::move(*next), {{}, active, true}, project, showing);
}

LevelCost costOfLevels(const Project& project, const FaceMap<Level>& levels)
{
    LevelCost cost = levelCost(project.texels, levels);
    for (const Layer& layer : project.layers.layers()) {
        const LevelCost more = levelCost(layer.texels, levels);
        cost.bytesBefore += more.bytesBefore;
        cost.bytesAfter += more.bytesAfter;
    }
    return cost;
}

} // namespace trixel::ui
