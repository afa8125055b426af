// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/texture/texel_store.h"

#include <functional>
#include <span>

namespace trixel {

/// What is said of a face that layers are made of and that its file does not give.
tl::unexpected<Error> unreadFace(FaceId face);

/// Fails if one of the faces, which were asked for, could not be read.
Status checkRead(const TexelStore& store, std::span<const FaceId> faces);

/// Puts make(face), called from several threads, in the place of faces of a store; neighbours of
/// the same one value share it. Fails when cancelled; the store is then partly changed.
Status replaceFaces(TexelStore& store,
                    std::span<const FaceId> faces,
                    const std::function<FaceTexels(FaceId)>& make,
                    Threads threads,
                    Progress& progress);

} // namespace trixel
