// SPDX-License-Identifier: GPL-3.0-or-later
//
// A base and its layers as the texels of one file: the base's channels, then those of each layer
// from the bottom up, its coverage last. The opacity is the base's, if it has one.
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/ptx_file.h"
#include "core/layers/layer_stack.h"

#include <cstddef>
#include <span>
#include <vector>

namespace trixel {

/// All in one store. A face is put together when it is asked for, and then not kept: to be written
/// out this takes no memory beside that of the layers. Where base and layers are constant, so is
/// the face. \param layers  not plain (checked); what it shares with others may change afterwards
TexelStore sideBySide(const LayerStack& layers);

/// Reads them apart again, batch by batch. Faces that hold one value, of the base or of a layer,
/// keep one, and those where a layer holds nothing but 0 share it.
/// \param settings  of the layers in the file, bottom to top, at least one (checked)
/// Errors do not name the file: texels that are no base and so many layers, or take more memory
/// than is left, damaged faces; Cancelled.
Result<LayerStack> readLayers(const PtxFile& file,
                              std::vector<LayerSettings> settings,
                              MemoryBudget& budget,
                              Threads threads,
                              Progress& progress);

} // namespace trixel
