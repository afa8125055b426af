// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/limit_tessellation.h"
#include "render/gl.h"

#include <array>
#include <cstddef>
#include <memory>

namespace trixel::render {

/// A tessellated limit surface on the card: 28 bytes a vertex and 12 a triangle. The next one is
/// sent over several frames while the one before stays. Needs the context it was made in to be
/// current; where that was lost, so is what it held.
class LimitBuffers
{
public:
    explicit LimitBuffers(Gl& gl);
    ~LimitBuffers();
    LimitBuffers(const LimitBuffers&) = delete;
    LimitBuffers& operator=(const LimitBuffers&) = delete;

    /// What is to be drawn as soon as it has been sent; nothing gives all up at once.
    void set(std::shared_ptr<const LimitTessellation> tessellation);
    /// Sends so many bytes more. \return  whether there is more to send
    bool send(std::size_t bytes);
    bool hasWork() const { return m_next.tessellation != nullptr; }

    /// What `draw` draws; null when there is nothing.
    const std::shared_ptr<const LimitTessellation>& shown() const { return m_shown.tessellation; }
    /// With a program of limit.vert bound.
    void draw();

private:
    struct Buffers
    {
        std::shared_ptr<const LimitTessellation> tessellation;
        GLuint vertexArray = 0;
        GLuint vertices = 0;
        GLuint triangles = 0;
        std::size_t sent = 0; ///< bytes: of the vertices, then of the triangles
    };
    void make(Buffers& buffers);
    void destroy(Buffers& buffers);

    Gl& m_gl;
    Buffers m_shown;
    Buffers m_next;
};

} // namespace trixel::render
