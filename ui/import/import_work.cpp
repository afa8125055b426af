// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/import_work.h"

#include "core/io/channel_colors.h"
#include "core/mapping/uv_mapping.h"

#include <utility>

namespace trixel::ui {

Result<PreparedImport> prepareImport(const ImportInput& input)
{
    auto mapping = makeImportMapping(input.settings, input.project.surface);
    if (!mapping) {
        return tl::unexpected(mapping.error());
    }
    auto tiles = input.samplers->make(input.images, input.settings);
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
    const auto prepared = prepareImport(input);
    if (!prepared) {
        return tl::unexpected(prepared.error());
    }
    TexelStore texels = input.project.texels;
    auto patch = bake(texels,
                      prepared->faces,
                      *prepared->mapping.mapping,
                      *prepared->tiles,
                      prepared->options,
                      progress);
    if (patch) {
        patch->swap(texels); // now it holds the texels to come
    }
    return patch;
}

} // namespace trixel::ui
