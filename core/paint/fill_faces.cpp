// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/check.h"
#include "core/paint/stroke.h"

#include <algorithm>

namespace trixel {

TexelPatch
fillFaces(TexelStore& store, std::span<const FaceId> faces, std::span<const std::byte> texel)
{
    check(texel.size() == store.format().texelBytes(), "a fill of one texel");
    std::vector<FaceId> once(faces.begin(), faces.end());
    std::ranges::sort(once);
    once.erase(std::unique(once.begin(), once.end()), once.end());

    TexelPatch patch;
    const FaceTexels value = FaceTexels::constant(Level(), texel); // one texel for all of them
    for (const FaceId face : once) {
        const FaceTexels& now = store.face(face);
        if (now.isConstant() && std::ranges::equal(now.bytes(), texel)) {
            continue;
        }
        const Level level = now.level();
        patch.addFace(face, store.exchange(face, value.atLevel(level)));
    }
    return patch;
}

} // namespace trixel
