// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/mapping/mapping.h"
#include "core/mapping/projection.h"
#include "core/mesh/surface.h"
#include "ui/import/import_settings.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace trixel::ui {

/// A way of laying an image onto a surface, ready to be asked.
struct ImportMapping
{
    std::shared_ptr<const Surface> surface; ///< that the mapping refers to
    std::unique_ptr<const Mapping> mapping;
    std::optional<Projection> projection; ///< where it is one
};

/// Fails, in one sentence, where the settings make no mapping: uvs that the mesh does not have, a
/// quadrilateral that is a line or crosses itself, an axis without direction.
Result<ImportMapping> makeImportMapping(const ImportSettings& settings,
                                        const std::shared_ptr<const Surface>& surface);

/// Of the faces those that it may reach.
std::vector<FaceId> facesToBake(const ImportMapping& mapping, std::span<const FaceId> faces);

/// Of a plane's image: along its width, along its height, and towards who looks at it. Unit
/// vectors.
struct PlaneAxes
{
    glm::dvec3 right{1, 0, 0};
    glm::dvec3 up{0, 1, 0};
    glm::dvec3 front{0, 0, 1};
};
PlaneAxes axesOf(const PlaneSettings& plane);

} // namespace trixel::ui
