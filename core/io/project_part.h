// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/io/project.h"

#include <cstdint>
#include <vector>

namespace trixel {

/// Which faces and channels of a project are meant; empty lists mean all.
struct ProjectPart
{
    std::vector<FaceId> faces;           ///< ascending, each once
    std::vector<std::uint16_t> channels; ///< in the order they are wanted in

    bool isWhole() const { return faces.empty() && channels.empty(); }
};

/// A project of that part: the faces in their order on a mesh of theirs, vertices that none of them
/// has left out. Metadata go with it, what channels mean in their new order; but for those of the
/// channels' fill where channels are left out. The project itself (a cheap copy) where the part is
/// the whole. Fails when cancelled, when a face cannot be read, and, naming it, on a face or
/// channel that does not exist.
Result<Project>
partOf(const Project& project, const ProjectPart& part, Threads threads, Progress& progress);

} // namespace trixel
