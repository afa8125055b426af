// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/project.h"
#include "core/mapping/bake.h"
#include "ui/document/document.h"
#include "ui/import/import_images.h"
#include "ui/import/import_mapping.h"

#include <memory>
#include <optional>
#include <vector>

namespace trixel::ui {

/// All that an import is made from; nothing of it changes meanwhile.
struct ImportInput
{
    Project project;
    std::vector<FaceId> faces; ///< each once
    ImportSettings settings;
    std::shared_ptr<const ImportImages> images;
    std::shared_ptr<ImportSamplers> samplers;
};

/// What stands ready before the texels are made.
struct PreparedImport
{
    ImportMapping mapping;
    std::shared_ptr<const ImageTiles> tiles;
    BakeOptions options;
    std::vector<FaceId> faces; ///< of those asked for the ones in reach
};

/// Fails, in one sentence, where the settings make no mapping or the uvs lead beyond the image.
Result<PreparedImport> prepareImport(const ImportInput& input, Progress& progress);

/// The texels to come of every face that the image reaches. Fails as `bake` does.
Result<TexelPatch> importImage(const ImportInput& input, Progress& progress);

/// What an import changes.
struct Imported
{
    TexelPatch patch;                 ///< none where there are layers
    std::optional<LayersEdit> layers; ///< of a project that has layers: the image is one more
    std::size_t faces = 0;            ///< that the image reaches
};

/// The same, as a layer of its own where there are layers. Fails also as `withPatchAsLayer`.
/// \param below  the layer under it
/// \param name   of the image's file
Result<Imported>
importIntoProject(const ImportInput& input, LayerId below, const QString& name, Progress& progress);

} // namespace trixel::ui
