// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/import_work.h"

#include "core/io/channel_colors.h"
#include "core/mapping/uv_mapping.h"
#include "ui/document/made_layers.h"

#include <utility>

namespace trixel::ui {

namespace {

/// Part of an import's time that making coarser levels of its images takes, about.
constexpr double kPrepared = 0.2;

} // namespace

Result<PreparedImport> prepareImport(const ImportInput& input, Progress& progress)
{
    auto mapping = makeImportMapping(input.settings, input.project.surface);
    if (!mapping) {
        return tl::unexpected(mapping.error());
    }
    auto tiles = input.samplers->make(input.images, input.settings, progress);
    if (!tiles) {
        return tl::unexpected(tiles.error());
    }
    if (input.settings.kind == MapKind::Uvs) {
        const Status reach =
            checkUvs(input.project.surface->mesh(), (*tiles)->tiles(), input.settings.repeats);
        if (!reach) {
            return tl::unexpected(reach.error());
        }
    }
    PreparedImport prepared;
    prepared.faces = facesToBake(*mapping, input.faces);
    prepared.mapping = std::move(*mapping);
    prepared.tiles = std::move(*tiles);
    prepared.options.colors = channelColors(input.project).value_or(std::vector<ColorSpace>());
    prepared.options.opacity = static_cast<float>(input.settings.opacity);
    return prepared;
}

Result<TexelPatch> importImage(const ImportInput& input, Progress& progress)
{
    StageProgress preparing(progress, 0, kPrepared);
    const auto prepared = prepareImport(input, preparing);
    if (!prepared) {
        return tl::unexpected(prepared.error());
    }
    TexelStore texels = input.project.texels;
    StageProgress baking(progress, kPrepared, 1);
    auto patch = bake(texels,
                      prepared->faces,
                      *prepared->mapping.mapping,
                      *prepared->tiles,
                      prepared->options,
                      baking);
    if (patch) {
        patch->swap(texels); // now it holds the texels to come
    }
    return patch;
}

Result<Imported>
importIntoProject(const ImportInput& input, LayerId below, const QString& name, Progress& progress)
{
    const bool isPlain = input.project.layers.isPlain();
    StageProgress importing(progress, 0, isPlain ? 1 : 0.8);
    auto patch = importImage(input, importing);
    if (!patch) {
        return tl::unexpected(patch.error());
    }
    Imported imported{{}, std::nullopt, patch->faces().size()};
    if (isPlain) {
        imported.patch = std::move(*patch);
        return imported;
    }
    StageProgress layering(progress, 0.8, 1);
    auto edit = withPatchAsLayer(input.project, below, *patch, name, layering);
    if (!edit) {
        return tl::unexpected(edit.error());
    }
    imported.layers = std::move(*edit);
    return imported;
}

} // namespace trixel::ui
