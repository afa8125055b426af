// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/speed/peers/peers.h"

#include "core/study/speed/peers/picture_peer.h"
#include "core/study/speed/peers/ptex_peer.h"

#include <system_error>

namespace trixel {

std::filesystem::path peerFolder()
{
    std::error_code error;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
    const auto beside = program.parent_path();
    const auto installed = beside / ".." / "lib" / "trixel";
    return std::filesystem::exists(installed, error) ? installed : beside;
}

Result<Peers> makePeers(const std::vector<StudySubject>& subjects,
                        const std::filesystem::path& modules,
                        Progress& progress)
{
    Peers peers;
    StageProgress pictures(progress, 0, 0.7);
    if (const Status added = addPicturePeer(subjects, modules, pictures, peers); !added) {
        return tl::unexpected(added.error());
    }
    StageProgress files(progress, 0.7, 1);
    if (const Status added = addPtexPeer(subjects, modules, files, peers); !added) {
        return tl::unexpected(added.error());
    }
    return peers;
}

} // namespace trixel
