// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/display_atlas.h"
#include "render/gl.h"
#include "render/texture_buffer.h"

#include <cstdint>
#include <span>

namespace trixel::render {

/// The packed atlas of a mesh's faces as it lies on the card: what `DisplayAtlas` lays out. Needs
/// the context it was made in to be current.
class SurfaceAtlas
{
public:
    explicit SurfaceAtlas(Gl& gl);
    ~SurfaceAtlas();
    SurfaceAtlas(const SurfaceAtlas&) = delete;
    SurfaceAtlas& operator=(const SurfaceAtlas&) = delete;

    /// Gives up all: so many faces whose tiles have not been sent.
    void clear(std::size_t faceCount);
    /// Whether there is something to draw.
    bool isEmpty() const { return m_layers == 0; }

    /// Makes the room that an update needs where it is the first of its layout.
    void begin(const AtlasUpdate& update, DisplayFormat format);
    /// Sends what an update holds. \param records  all of them, as they are now
    void
    upload(const AtlasUpdate& update, std::span<const FaceRecord> records, DisplayFormat format);

    /// Makes them readable at two texture units; the atlas is interpolated by the hardware.
    void bind(GLuint records, GLuint atlas);

    std::uint64_t bytes() const;

private:
    void release();
    void allocate(std::uint32_t layers, DisplayFormat format);

    Gl& m_gl;
    TextureBuffer m_records;
    GLuint m_texture = 0;
    std::uint32_t m_layers = 0;
    DisplayFormat m_format = DisplayFormat::Rgba8;
};

} // namespace trixel::render
