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
    const Layered before{project.texels, project.layers};
    Result<Layered> all = recomposed(std::move(next), before, Threads::all(), progress);
    if (!all) {
        return tl::unexpected(all.error());
    }
    return LayersEdit{std::move(*all), layer, false};
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
    StageProgress composing(progress, 0.7, 1);
    Result<Layered> all = composed(std::move(*next), Threads::all(), composing);
    if (!all) {
        return tl::unexpected(all.error());
    }
    return LayersEdit{std::move(*all), active, true};
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
