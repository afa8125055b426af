// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/display_texels.h"
#include "render/gl.h"
#include "render/texture_buffer.h"

#include <cstddef>
#include <memory>
#include <span>

namespace trixel::render {

/// The texels of a mesh's faces as they lie on the card, and where those of each face are: what
/// `DisplayTexels` lays out. Needs the context it was made in to be current.
class SurfaceTexels
{
public:
    explicit SurfaceTexels(Gl& gl);

    /// Forgets all.
    void clear();
    /// Whether there is something to draw.
    bool isEmpty() const { return !m_shown.texels || m_shown.texels->size() == 0; }

    /// Sends what an update holds. What begins afresh is shown once all of it has come, and what
    /// was there until then. \param records  all of them, as they are now
    void
    upload(const DisplayUpdate& update, std::span<const FaceRecord> records, DisplayFormat format);

    /// Makes them readable at two texture units.
    void bind(GLuint records, GLuint texels);

private:
    struct Buffers
    {
        std::unique_ptr<TextureBuffer> records;
        std::unique_ptr<TextureBuffer> texels;
    };
    Buffers
    begun(const DisplayUpdate& update, std::span<const FaceRecord> records, DisplayFormat format);

    Gl& m_gl;
    Buffers m_shown;
    Buffers m_next; ///< none but while it comes
};

} // namespace trixel::render
