// SPDX-License-Identifier: GPL-3.0-or-later
//
// A file of any kind as something to filter.
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/filter/filter_scene.h"
#include "core/mesh/triangle_mesh.h"

#include <filesystem>
#include <memory>
#include <optional>

namespace trixel::app {

/// What a file gave to filter.
struct FilterInput
{
    std::shared_ptr<const FilterScene> scene;
    std::optional<TriangleMesh> mesh; ///< nothing where faces count as equilateral
};

/// A project, or a .ptx on its mesh: the one given, the one it carries, or none, in which case its
/// faces count as equilateral. A mesh gets the stored solid texture, about four million texels.
/// Errors name the file.
Result<std::shared_ptr<const FilterScene>>
openFilterScene(const std::filesystem::path& path,
                const std::optional<std::filesystem::path>& mesh,
                Progress& progress);

/// The same with the mesh it is on.
Result<FilterInput> openFilterInput(const std::filesystem::path& path,
                                    const std::optional<std::filesystem::path>& mesh,
                                    Progress& progress);

} // namespace trixel::app
