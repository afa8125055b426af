// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/speed/peers/peers.h"

namespace trixel {

/// The reference Ptex library. Fails only when cancelled.
Status addPtexPeer(const std::vector<StudySubject>& subjects,
                   const std::filesystem::path& modules,
                   Progress& progress,
                   Peers& peers);

} // namespace trixel
