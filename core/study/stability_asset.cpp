// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/stability.h"

namespace trixel {

Result<std::vector<AssetFinding>>
findHazards(const StabilityAsset& /*asset*/, Threads /*threads*/, Progress& /*progress*/)
{
    return std::vector<AssetFinding>{};
}

} // namespace trixel
