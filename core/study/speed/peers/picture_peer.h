// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/speed/peers/peers.h"

namespace trixel {

/// OpenImageIO's TextureSystem, over its limit of anisotropy, with derivatives as
/// they are and widened to the variance of our Gaussian. Fails only when cancelled.
Status addPicturePeer(const std::vector<StudySubject>& subjects,
                      const std::filesystem::path& modules,
                      Progress& progress,
                      Peers& peers);

} // namespace trixel
