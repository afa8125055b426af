// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/project.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace trixel {

/// Which faces, channels and layer of a project are meant; empty lists mean all.
struct ProjectPart
{
    std::vector<FaceId> faces;           ///< ascending, each once
    std::vector<std::uint16_t> channels; ///< in the order they are wanted in
    /// One layer alone, shown or not, or the base; nothing for what all look like together. The
    /// channels are then those of the layer, its coverage the last.
    std::optional<LayerId> layer = {};

    bool isWhole() const { return faces.empty() && channels.empty() && !layer; }
};

/// A project without layers of that part: the faces in their order on a mesh of theirs, vertices
/// that none of them has left out. A layer's coverage, its opacity in it, is the texels' opacity.
/// Metadata go with it, what channels mean in their new order; but for those of the channels' fill
/// where these are not the project's. A cheap copy where the part is the whole. Fails when
/// cancelled, when a face cannot be read, and, naming it, on a face, channel or layer that does not
/// exist.
Result<Project>
partOf(const Project& project, const ProjectPart& part, Threads threads, Progress& progress);

} // namespace trixel
