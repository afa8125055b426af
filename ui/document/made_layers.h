// SPDX-License-Identifier: GPL-3.0-or-later
//
// Layers made of a project's on another thread, for `Document::replaceLayers`.
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/project.h"
#include "core/texture/level_change.h"
#include "ui/document/document.h"

namespace trixel::ui {

/// What a patch would do to the texels shown, as one more layer above another, to be painted from
/// then on. Fails when cancelled and when there is no room for a layer.
/// \param project  with layers (checked)
/// \param patch    to come; keeps levels (checked)
/// \param file     that it is made of: the layer is called so, without its ending
Result<LayersEdit> withPatchAsLayer(const Project& project,
                                    LayerId below,
                                    const TexelPatch& patch,
                                    const QString& file,
                                    Progress& progress);

/// A layer merged into the layer below it or the base, which is the active one then. Fails as
/// `mergedDown`. \param layer  of the project's, shown (checked)
Result<LayersEdit> withLayerMerged(const Project& project, LayerId layer, Progress& progress);

/// All layers at other levels. Fails as `withLevels`. \param project  with layers (checked)
Result<LayersEdit> withOtherLevels(const Project& project,
                                   LayerId active,
                                   const FaceMap<Level>& levels,
                                   Progress& progress);

/// `levelCost` of all layers together.
LevelCost costOfLevels(const Project& project, const FaceMap<Level>& levels);

} // namespace trixel::ui
