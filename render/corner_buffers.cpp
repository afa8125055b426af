// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/corner_buffers.h"

#include <array>
#include <cstddef>

namespace trixel::render {

namespace {

/// Where surface.vert has them.
constexpr GLuint kVertex = 0;
constexpr GLuint kBits = 1;
constexpr GLuint kNormal = 2;

} // namespace

CornerBuffers::CornerBuffers(Gl& gl)
    : m_gl(gl)
{
}

CornerBuffers::~CornerBuffers()
{
    if (m_gl.isCurrent()) {
        destroy();
    }
}

void CornerBuffers::destroy()
{
    m_gl.glDeleteVertexArrays(1, &m_vertexArray);
    m_gl.glDeleteBuffers(1, &m_corners);
    m_gl.glDeleteBuffers(1, &m_faces);
    m_vertexArray = 0;
    m_corners = 0;
    m_faces = 0;
}

void CornerBuffers::set(const SharedCorners& corners)
{
    destroy();
    if (corners.faces.empty()) {
        return;
    }
    m_gl.glGenVertexArrays(1, &m_vertexArray);
    m_gl.glGenBuffers(1, &m_corners);
    m_gl.glGenBuffers(1, &m_faces);
    m_gl.glBindVertexArray(m_vertexArray);
    m_gl.glBindBuffer(GL_ARRAY_BUFFER, m_corners);
    m_gl.glBufferData(GL_ARRAY_BUFFER,
                      static_cast<GLsizeiptr>(corners.corners.size() * sizeof(SharedCorner)),
                      corners.corners.data(),
                      GL_STATIC_DRAW);
    m_gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_faces);
    m_gl.glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                      static_cast<GLsizeiptr>(corners.faces.size() * sizeof(corners.faces[0])),
                      corners.faces.data(),
                      GL_STATIC_DRAW);
    constexpr std::array<std::size_t, 3> kOffsets{offsetof(SharedCorner, vertex),
                                                  offsetof(SharedCorner, bits),
                                                  offsetof(SharedCorner, normal)};
    for (const GLuint attribute : {kVertex, kBits, kNormal}) {
        m_gl.glEnableVertexAttribArray(attribute);
        m_gl.glVertexAttribIPointer(
            attribute,
            1,
            GL_UNSIGNED_INT,
            sizeof(SharedCorner),
            reinterpret_cast<const void*>(kOffsets[attribute])); // as OpenGL takes offsets
    }
    m_gl.glBindVertexArray(0);
    m_gl.glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void CornerBuffers::draw(std::size_t faceCount)
{
    const auto count = static_cast<GLsizei>(3 * faceCount);
    if (!areShared()) {
        m_gl.glDrawArrays(GL_TRIANGLES, 0, count);
        return;
    }
    m_gl.glBindVertexArray(m_vertexArray);
    m_gl.glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr);
    m_gl.glBindVertexArray(0);
}

} // namespace trixel::render
