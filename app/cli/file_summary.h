// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/ptx_summary.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace trixel::app {

/// Geometry of a mesh file.
struct MeshSummary
{
    std::uint64_t vertices = 0;
    std::array<float, 3> low{};  ///< bounding box, world units
    std::array<float, 3> high{}; ///< bounding box, world units
    std::uint64_t borderEdges = 0;
    std::vector<std::string> report; ///< one line a finding
};

/// What `trixel info` tells about a file.
struct FileSummary
{
    std::filesystem::path path;
    std::string kind; ///< "mesh", "ptx" or "project"
    std::uint64_t fileBytes = 0;
    std::uint64_t faces = 0;
    std::optional<MeshSummary> mesh; ///< of a mesh
    std::optional<PtxSummary> ptx;   ///< of a .ptx or a project
};

/// Reads no texels; a mesh is read whole, for its report. Errors name the file.
Result<FileSummary> summarise(const std::filesystem::path& path, Progress& progress);

nlohmann::json toJson(const FileSummary& summary);

/// A table for people, a line a fact.
std::string toText(const FileSummary& summary);

} // namespace trixel::app
