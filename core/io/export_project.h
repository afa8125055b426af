// SPDX-License-Identifier: GPL-3.0-or-later
//
// All ways out of a project under one name, for the command line and the window.
#pragma once

#include "core/io/atlas/export_atlas.h"
#include "core/io/export_uv_image.h"
#include "core/io/project_part.h"

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace trixel {

struct PtxExportOptions
{
    std::optional<TexelType> type; ///< empty for that of the texels
    bool mips = true;
};

using ExportOptions =
    std::variant<PtxExportOptions, PackedExportOptions, HandOffExportOptions, UvExportOptions>;

/// What is to be written where.
struct ExportRequest
{
    std::filesystem::path path; ///< its ending fits the options
    ExportOptions options;
    ProjectPart part;
};

/// What was written.
struct ExportOutcome
{
    std::vector<std::filesystem::path> files;
    std::uint64_t bytes = 0;           ///< of all of them
    std::optional<double> largestJump; ///< of a hand-off atlas, see `HandOffReport`
    std::uint32_t facesLost = 0;       ///< of images by uvs: too small there to hold a pixel
};

/// Writes what is asked for. Files take their names once all are written, read again and compared.
/// Errors name the file; what was there before stays then, and when it is cancelled.
Result<ExportOutcome> exportProject(const ImageWorker& worker,
                                    const Project& project,
                                    const ExportRequest& request,
                                    Progress& progress);

} // namespace trixel
