// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texture/face_texels.h"

namespace trixel {

/// A face to be read here and now, as `FaceTexels::pinned` gives it, without a copy where the
/// texels are in memory: for loops over many faces.
class PinnedFace
{
public:
    /// \param face  must outlive this
    explicit PinnedFace(const FaceTexels& face)
        : m_pinned(face.isStored() ? face.pinned() : FaceTexels())
        , m_face(face.isStored() ? m_pinned : face)
    {
    }
    PinnedFace(const PinnedFace&) = delete;
    PinnedFace& operator=(const PinnedFace&) = delete;

    const FaceTexels& operator*() const { return m_face; }
    const FaceTexels* operator->() const { return &m_face; }

private:
    FaceTexels m_pinned;
    const FaceTexels& m_face;
};

} // namespace trixel
