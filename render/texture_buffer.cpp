// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/texture_buffer.h"

#include "core/base/check.h"

#include <algorithm>

namespace trixel::render {

namespace {

/// Of GL_AMD_pinned_memory.
constexpr GLenum kExternalVirtualMemory = 0x9160;

} // namespace

TextureBuffer::TextureBuffer(Gl& gl, GLenum format, std::size_t elementBytes)
    : TextureBuffer(gl,
                    format,
                    elementBytes,
                    takesMappedMemory(gl) ? BufferMemory::Mapped : BufferMemory::Drivers)
{
}

TextureBuffer::TextureBuffer(Gl& gl, GLenum format, std::size_t elementBytes, BufferMemory memory)
    : m_gl(gl)
    , m_format(format)
    , m_elementBytes(elementBytes)
    , m_memory(memory == BufferMemory::Mapped ? std::make_unique<MappedMemory>() : nullptr)
{
    m_gl.glGenBuffers(1, &m_buffer);
    m_gl.glGenTextures(1, &m_texture);
}

TextureBuffer::~TextureBuffer()
{
    if (m_gl.isCurrent()) {
        if (m_memory) {
            m_gl.glFinish(); // it may be drawn from yet
        }
        m_gl.glDeleteTextures(1, &m_texture);
        m_gl.glDeleteBuffers(1, &m_buffer);
    } else if (m_memory && !m_gl.isGone()) {
        m_memory->leave(); // as all that the context holds
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

/// The same memory again, larger, in the place of what the buffer had.
/// \return  false where it must be the driver's
bool TextureBuffer::mapRoom(std::size_t elements)
{
    if (!m_memory) {
        return false;
    }
    const std::size_t bytes = elements * m_elementBytes;
    m_gl.glFinish(); // it may move, and be drawn from yet
    if (!m_memory->resize(bytes)) {
        return false;
    }
    m_elements = elements;
    m_gl.glBindBuffer(kExternalVirtualMemory, m_buffer);
    m_gl.glBufferData(
        kExternalVirtualMemory, static_cast<GLsizeiptr>(bytes), m_memory->data(), GL_DYNAMIC_DRAW);
    m_gl.glBindBuffer(kExternalVirtualMemory, 0);
    attach();
    return true;
}

/// The driver's.
void TextureBuffer::takeRoom(std::size_t elements, const void* bytes)
{
    m_elements = elements;
    m_gl.glBindBuffer(GL_TEXTURE_BUFFER, m_buffer);
    m_gl.glBufferData(GL_TEXTURE_BUFFER,
                      static_cast<GLsizeiptr>(elements * m_elementBytes),
                      bytes,
                      GL_DYNAMIC_DRAW);
    attach();
}

void TextureBuffer::allocate(std::size_t elements)
{
    if (!mapRoom(elements)) {
        takeRoom(elements, nullptr);
        m_memory.reset();
    }
}

void TextureBuffer::grow(std::size_t elements)
{
    check(elements >= m_elements, "room for what is there");
    if (mapRoom(elements)) {
        return;
    }
    const GLuint old = m_buffer;
    const std::size_t kept = m_elements;
    m_gl.glGenBuffers(1, &m_buffer);
    takeRoom(elements, nullptr);
    m_gl.glBindBuffer(GL_COPY_READ_BUFFER, old);
    m_gl.glCopyBufferSubData(GL_COPY_READ_BUFFER,
                             GL_TEXTURE_BUFFER,
                             0,
                             0,
                             static_cast<GLsizeiptr>(kept * m_elementBytes));
    if (m_memory) {
        m_gl.glFinish();
    }
    m_gl.glDeleteBuffers(1, &old);
    m_memory.reset();
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
    const std::size_t elements = bytes.size() / m_elementBytes;
    if (mapRoom(elements)) {
        write(0, bytes);
    } else {
        takeRoom(elements, bytes.data());
        m_memory.reset();
    }
}

void TextureBuffer::bind(GLuint unit)
{
    m_gl.glActiveTexture(GL_TEXTURE0 + unit);
    m_gl.glBindTexture(GL_TEXTURE_BUFFER, m_texture);
}

} // namespace trixel::render
