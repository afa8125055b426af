// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/io/ptx.h"
#include "core/io/ptx_file.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <span>

namespace trixel {

/// Opens the structure of a file on disk. Errors name the file.
Result<PtxFile> openPtxFile(const std::filesystem::path& path, MemoryBudget& budget);

/// Decodes one level of every face that is stored or constant there, in parallel, a batch at a
/// time. \param visit  called from this thread with the first face of a batch and the batch's
/// faces, in
///               order; nothing stands for a face without that reduction
Status decodePtxFaces(
    const PtxFile& file,
    int reduction,
    Threads threads,
    Progress& progress,
    const std::function<void(FaceId first, std::span<std::optional<FaceTexels>>)>& visit);

/// The links of the file's face infos that hold from both sides; others become borders.
Adjacency adjacencyOf(const PtxFile& file);

/// The texels of every face at full resolution. Equal constant faces in a row share their value.
Result<TexelStore> readTexels(const PtxFile& file, MemoryBudget& budget, Progress& progress);

/// All that the file holds at full resolution.
Result<PtxContents> readContents(const PtxFile& file, MemoryBudget& budget, Progress& progress);

} // namespace trixel
