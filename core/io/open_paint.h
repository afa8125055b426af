// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/memory_budget.h"
#include "core/io/ptx.h"
#include "core/io/ptx_file.h"
#include "core/io/ptx_stored_faces.h"
#include "core/layers/layer_stack.h"

#include <memory>
#include <span>
#include <string>

namespace trixel {

/// What is painted, as a file has it.
struct OpenedPaint
{
    TexelStore texels;                  ///< as shown
    std::shared_ptr<StoredFaces> faces; ///< null when all is in memory
    LayerStack layers;                  ///< plain where the metadata name none
};

/// The texels of a file as `openTexels` gives them; where the metadata name layers, these, read
/// whole, and what they look like together. Errors do not name the file.
/// \param metadata  the file's
Result<OpenedPaint> openPaint(PtxFile file,
                              const std::string& name,
                              std::span<const PtxMetadata> metadata,
                              const OpenOptions& options,
                              MemoryBudget& budget,
                              Progress& progress);

} // namespace trixel
