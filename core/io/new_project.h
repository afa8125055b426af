// SPDX-License-Identifier: GPL-3.0-or-later
//
// A project before anything is painted on it, and the colour it began with.
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/project.h"
#include "core/mesh/triangle_mesh.h"
#include "core/texture/level_plan.h"
#include "core/texture/texel_format.h"

#include <cstdint>
#include <span>
#include <vector>

namespace trixel {

/// A project in which every face holds one colour, at the level the plan gives it. The colour is
/// kept in the metadata, so that the eraser finds it when the project is opened again.
/// \param fill  one value a channel (checked); see `encode` for what they mean
Result<Project> newProject(TriangleMesh mesh,
                           const LevelPlan& plan,
                           const TexelFormat& format,
                           std::span<const float> fill,
                           Progress& progress);

/// Texels in all for a mesh whose user asked for nothing: four million, more where the mesh has so
/// many faces that this would leave fewer than sixteen a face.
std::uint64_t defaultTexelTotal(std::size_t faceCount);

/// The bytes of one texel of the colour the project began with: as its metadata say, else as its
/// first constant face (of the base, below layers), else 1 in every channel.
std::vector<std::byte> fillOf(const Project& project);

} // namespace trixel
