// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/io/project.h"
#include "core/texture/level_plan.h"
#include "core/texture/texel_format.h"

#include <array>

namespace trixel::ui {

/// How the resolution of a new project is asked for.
enum class SizeChoice { Level, Density, Total };

/// Everything about a new project but its mesh.
struct ProjectOptions
{
    SizeChoice size = SizeChoice::Total;
    int level = 5;                   ///< for SizeChoice::Level, in [0, Level::kMax]
    double density = 100;            ///< texels per world unit, for SizeChoice::Density
    std::uint64_t total = 4'000'000; ///< texels, for SizeChoice::Total
    TexelFormat format;
    std::array<float, 4> fill{0.8F, 0.8F, 0.8F, 1.0F}; ///< value per channel

    bool operator==(const ProjectOptions&) const = default;
};

/// The level of every face, as the options ask.
Result<LevelPlan> planFor(const TriangleMesh& mesh, const ProjectOptions& options);

/// A project whose faces all hold the fill colour.
Result<Project> makeProject(TriangleMesh mesh, const ProjectOptions& options, Progress& progress);

/// What a mesh opened without questions gets: uint8 RGB, about four million texels, more where the
/// mesh has so many faces that this would leave fewer than sixteen texels a face.
ProjectOptions defaultOptions(std::size_t faceCount);

} // namespace trixel::ui
