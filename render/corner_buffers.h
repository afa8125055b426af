// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/gl.h"
#include "render/shared_corners.h"

namespace trixel::render {

/// What surface.vert draws faces from: shared corners, 12 bytes each, and 12 bytes a face; until
/// they come three corners a face, by their numbers. Needs the context it was made in to be
/// current; where that was lost, so is what it held.
class CornerBuffers
{
public:
    explicit CornerBuffers(Gl& gl);
    ~CornerBuffers();
    CornerBuffers(const CornerBuffers&) = delete;
    CornerBuffers& operator=(const CornerBuffers&) = delete;

    /// Of the mesh that is drawn; none forgets those of another.
    void set(const SharedCorners& corners);
    bool areShared() const { return m_vertexArray != 0; }

    /// With a program of surface.vert bound. \param faceCount  of the mesh
    void draw(std::size_t faceCount);

private:
    void destroy();

    Gl& m_gl;
    GLuint m_vertexArray = 0;
    GLuint m_corners = 0;
    GLuint m_faces = 0;
};

} // namespace trixel::render
