// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/limit_buffers.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace trixel::render {

namespace {

const void* offset(std::size_t bytes)
{
    return reinterpret_cast<const void*>(bytes); // as OpenGL takes offsets
}

} // namespace

LimitBuffers::LimitBuffers(Gl& gl)
    : m_gl(gl)
{
}

LimitBuffers::~LimitBuffers()
{
    if (m_gl.isCurrent()) {
        destroy(m_shown);
        destroy(m_next);
    }
}

void LimitBuffers::set(std::shared_ptr<const LimitTessellation> tessellation)
{
    destroy(m_next);
    if (!tessellation) {
        destroy(m_shown);
        return;
    }
    m_next.tessellation = std::move(tessellation);
    make(m_next);
}

void LimitBuffers::make(Buffers& buffers)
{
    const LimitTessellation& cut = *buffers.tessellation;
    m_gl.glGenVertexArrays(1, &buffers.vertexArray);
    m_gl.glGenBuffers(1, &buffers.vertices);
    m_gl.glGenBuffers(1, &buffers.triangles);
    m_gl.glBindVertexArray(buffers.vertexArray);
    m_gl.glBindBuffer(GL_ARRAY_BUFFER, buffers.vertices);
    m_gl.glBufferData(GL_ARRAY_BUFFER,
                      static_cast<GLsizeiptr>(cut.vertices().size_bytes()),
                      nullptr,
                      GL_STATIC_DRAW);
    m_gl.glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers.triangles);
    m_gl.glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                      static_cast<GLsizeiptr>(cut.triangles().size_bytes()),
                      nullptr,
                      GL_STATIC_DRAW);
    constexpr GLsizei kStride = sizeof(LimitVertex);
    for (GLuint attribute = 0; attribute < 4; ++attribute) {
        m_gl.glEnableVertexAttribArray(attribute);
    }
    m_gl.glVertexAttribPointer(
        0, 3, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(LimitVertex, position)));
    m_gl.glVertexAttribIPointer(
        1, 1, GL_UNSIGNED_INT, kStride, offset(offsetof(LimitVertex, normal)));
    m_gl.glVertexAttribPointer(
        2, 2, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(LimitVertex, uv)));
    m_gl.glVertexAttribIPointer(
        3, 1, GL_UNSIGNED_INT, kStride, offset(offsetof(LimitVertex, face)));
    m_gl.glBindVertexArray(0);
    m_gl.glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void LimitBuffers::destroy(Buffers& buffers)
{
    m_gl.glDeleteVertexArrays(1, &buffers.vertexArray);
    m_gl.glDeleteBuffers(1, &buffers.vertices);
    m_gl.glDeleteBuffers(1, &buffers.triangles);
    buffers = {};
}

bool LimitBuffers::send(std::size_t bytes)
{
    if (!hasWork()) {
        return false;
    }
    // Through a target that no vertex array keeps: an element binding would be written into one.
    const auto vertices = std::as_bytes(m_next.tessellation->vertices());
    const auto triangles = std::as_bytes(m_next.tessellation->triangles());
    std::size_t first = 0; // of the array, among all bytes
    for (const auto& [data, buffer] :
         {std::pair(vertices, m_next.vertices), std::pair(triangles, m_next.triangles)}) {
        const std::size_t done = std::max(m_next.sent, first) - first;
        const std::size_t now = done < data.size() ? std::min(bytes, data.size() - done) : 0;
        if (now > 0) {
            m_gl.glBindBuffer(GL_ARRAY_BUFFER, buffer);
            m_gl.glBufferSubData(GL_ARRAY_BUFFER,
                                 static_cast<GLintptr>(done),
                                 static_cast<GLsizeiptr>(now),
                                 data.data() + done);
            m_gl.glBindBuffer(GL_ARRAY_BUFFER, 0);
            m_next.sent += now;
            bytes -= now;
        }
        first += data.size();
    }
    if (m_next.sent < first) {
        return true;
    }
    destroy(m_shown);
    m_shown = std::exchange(m_next, {});
    return false;
}

void LimitBuffers::draw()
{
    m_gl.glBindVertexArray(m_shown.vertexArray);
    m_gl.glDrawElements(GL_TRIANGLES,
                        static_cast<GLsizei>(3 * m_shown.tessellation->triangles().size()),
                        GL_UNSIGNED_INT,
                        nullptr);
    m_gl.glBindVertexArray(0);
}

} // namespace trixel::render
