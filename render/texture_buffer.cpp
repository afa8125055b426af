// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/texture_buffer.h"

#include "core/base/check.h"

#include <algorithm>

namespace trixel::render {

TextureBuffer::TextureBuffer(Gl& gl, GLenum format, std::size_t elementBytes)
    : m_gl(gl)
    , m_format(format)
    , m_elementBytes(elementBytes)
{
    m_gl.glGenBuffers(1, &m_buffer);
    m_gl.glGenTextures(1, &m_texture);
}

TextureBuffer::~TextureBuffer()
{
    if (m_gl.isCurrent()) {
        m_gl.glDeleteTextures(1, &m_texture);
        m_gl.glDeleteBuffers(1, &m_buffer);
    }
}

std::size_t TextureBuffer::maxElements(Gl& gl)
{
    GLint most = 0;
    gl.glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    return static_cast<std::size_t>(most);
}

void TextureBuffer::attach()
{
    m_gl.glBindTexture(GL_TEXTURE_BUFFER, m_texture);
    m_gl.glTexBuffer(GL_TEXTURE_BUFFER, m_format, m_buffer);
    m_gl.glBindTexture(GL_TEXTURE_BUFFER, 0);
}

void TextureBuffer::allocate(std::size_t elements)
{
    m_elements = elements;
    m_gl.glBindBuffer(GL_TEXTURE_BUFFER, m_buffer);
    m_gl.glBufferData(GL_TEXTURE_BUFFER,
                      static_cast<GLsizeiptr>(elements * m_elementBytes),
                      nullptr,
                      GL_DYNAMIC_DRAW);
    attach();
}

void TextureBuffer::grow(std::size_t elements)
{
    check(elements >= m_elements, "room for what is there");
    const GLuint old = m_buffer;
    const std::size_t kept = m_elements;
    m_gl.glGenBuffers(1, &m_buffer);
    allocate(elements);
    m_gl.glBindBuffer(GL_COPY_READ_BUFFER, old);
    m_gl.glCopyBufferSubData(GL_COPY_READ_BUFFER,
                             GL_TEXTURE_BUFFER,
                             0,
                             0,
                             static_cast<GLsizeiptr>(kept * m_elementBytes));
    m_gl.glDeleteBuffers(1, &old);
}

void TextureBuffer::write(std::size_t first, std::span<const std::byte> bytes)
{
    check(first * m_elementBytes + bytes.size() <= m_elements * m_elementBytes, "within the room");
    m_gl.glBindBuffer(GL_TEXTURE_BUFFER, m_buffer);
    m_gl.glBufferSubData(GL_TEXTURE_BUFFER,
                         static_cast<GLintptr>(first * m_elementBytes),
                         static_cast<GLsizeiptr>(bytes.size()),
                         bytes.data());
}

void TextureBuffer::copy(std::size_t from, std::size_t to, std::size_t count)
{
    check(std::max(from, to) + count <= m_elements, "within the room");
    m_gl.glBindBuffer(GL_COPY_READ_BUFFER, m_buffer);
    m_gl.glBindBuffer(GL_TEXTURE_BUFFER, m_buffer);
    m_gl.glCopyBufferSubData(GL_COPY_READ_BUFFER,
                             GL_TEXTURE_BUFFER,
                             static_cast<GLintptr>(from * m_elementBytes),
                             static_cast<GLintptr>(to * m_elementBytes),
                             static_cast<GLsizeiptr>(count * m_elementBytes));
}

void TextureBuffer::fill(std::span<const std::byte> bytes)
{
    check(bytes.size() % m_elementBytes == 0, "whole elements");
    m_elements = bytes.size() / m_elementBytes;
    m_gl.glBindBuffer(GL_TEXTURE_BUFFER, m_buffer);
    m_gl.glBufferData(
        GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_DYNAMIC_DRAW);
    attach();
}

void TextureBuffer::bind(GLuint unit)
{
    m_gl.glActiveTexture(GL_TEXTURE0 + unit);
    m_gl.glBindTexture(GL_TEXTURE_BUFFER, m_texture);
}

} // namespace trixel::render
