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

    /// Forgets all: so many faces whose texels have not been sent.
    void clear(std::size_t faceCount);
    /// Whether there is something to draw.
    bool isEmpty() const { return !m_texels || m_texels->size() == 0; }

    /// Makes room for what an update holds; `upload` does so, too.
    void begin(const DisplayUpdate& update, DisplayFormat format);
    /// Sends what an update holds. \param records  all of them, as they are now
    void
    upload(const DisplayUpdate& update, std::span<const FaceRecord> records, DisplayFormat format);

    /// Makes them readable at two texture units.
    void bind(GLuint records, GLuint texels);

private:
    Gl& m_gl;
    TextureBuffer m_records;
    std::unique_ptr<TextureBuffer> m_texels;
    DisplayFormat m_format = DisplayFormat::Rgba8;
};

} // namespace trixel::render
