// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/project.h"
#include "core/mapping/bake.h"
#include "ui/import/import_images.h"
#include "ui/import/import_mapping.h"

#include <memory>
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
Result<PreparedImport> prepareImport(const ImportInput& input);

/// The texels to come of every face that the image reaches. Fails as `bake` does.
Result<TexelPatch> importImage(const ImportInput& input, Progress& progress);

} // namespace trixel::ui
