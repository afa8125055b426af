// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/replace_faces.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace trixel {

tl::unexpected<Error> unreadFace(FaceId face)
{
    return contentsError("face " + std::to_string(indexOf(face)) +
                         " could not be read from its file; fill it before layers are put together "
                         "there");
}

Status checkRead(const TexelStore& store, std::span<const FaceId> faces)
{
    const auto damaged =
        std::ranges::find_if(faces, [&](FaceId face) { return store.face(face).isDamaged(); });
    return damaged == faces.end() ? Status() : Status(unreadFace(*damaged));
}

Status replaceFaces(TexelStore& store,
                    std::span<const FaceId> faces,
                    const std::function<FaceTexels(FaceId)>& make,
                    Threads threads,
                    Progress& progress)
{
    constexpr std::size_t kFacesBetweenReports = 2048;
    std::vector<FaceTexels> made(std::min(kFacesBetweenReports, faces.size()));
    FaceTexels last;
    for (std::size_t begin = 0; begin < faces.size(); begin += kFacesBetweenReports) {
        if (!progress.report(static_cast<double>(begin) / static_cast<double>(faces.size()))) {
            return cancelled();
        }
        const std::size_t count = std::min(kFacesBetweenReports, faces.size() - begin);
        parallelFor(count, 16, threads, [&](std::size_t from, std::size_t to) {
            for (std::size_t k = from; k < to; ++k) {
                made[k] = make(faces[begin + k]);
            }
        });
        for (std::size_t k = 0; k < count; ++k) {
            const bool isAlike = made[k].isConstant() && last.texelBytes() > 0 &&
                                 std::ranges::equal(made[k].bytes(), last.bytes());
            if (made[k].isConstant() && !isAlike) {
                last = made[k];
            }
            store.exchange(faces[begin + k],
                           isAlike ? last.atLevel(made[k].level()) : std::move(made[k]));
        }
    }
    return {};
}

} // namespace trixel
