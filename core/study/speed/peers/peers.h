// SPDX-License-Identifier: GPL-3.0-or-later
//
// Other people's filters, in the same run as ours.
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/study/speed/contest.h"

#include <filesystem>
#include <string>
#include <vector>

namespace trixel {

struct Peers
{
    Contestants contestants;
    /// What they read, and who is missing and why.
    std::vector<std::string> notes;
};

/// Where the program's modules lie: beside it, or in ../lib/trixel from there.
std::filesystem::path peerFolder();

/// OpenImageIO's TextureSystem on an atlas of the same content, and the reference Ptex library on
/// a .ptx of it where this program was built with it. Takes a moment: the libraries are loaded and
/// textures are written to a temporary folder, which goes with the peers.
/// \param subjects  outlive the peers
/// A peer that cannot be had is no error; fails only when cancelled.
Result<Peers> makePeers(const std::vector<StudySubject>& subjects,
                        const std::filesystem::path& modules,
                        Progress& progress);

} // namespace trixel
