// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/gl.h"
#include "render/mapped_memory.h"

#include <cstddef>
#include <memory>
#include <span>

namespace trixel::render {

/// What a buffer lies in.
enum class BufferMemory {
    Drivers, ///< the graphics driver's
    Mapped,  ///< our own, for drivers that `takesMappedMemory`
};

/// An array on the graphics card that shaders read with `texelFetch`. Everything
/// needs the context it was made in to be current; where that was lost, so is what it held.
class TextureBuffer
{
public:
    /// \param format        sized internal format of the elements, such as GL_RGBA8
    /// \param elementBytes  bytes of one
    TextureBuffer(Gl& gl, GLenum format, std::size_t elementBytes);
    TextureBuffer(Gl& gl, GLenum format, std::size_t elementBytes, BufferMemory memory);
    ~TextureBuffer();
    TextureBuffer(const TextureBuffer&) = delete;
    TextureBuffer& operator=(const TextureBuffer&) = delete;

    /// Most elements a texture buffer may have here.
    static std::size_t maxElements(Gl& gl);

    std::size_t size() const { return m_elements; }

    /// Makes room for so many elements; their values are undefined.
    void allocate(std::size_t elements);
    /// Makes room and keeps what is there (copied on the card). \param elements  not fewer
    void grow(std::size_t elements);
    /// Overwrites elements from `first` on.
    void write(std::size_t first, std::span<const std::byte> bytes);
    /// Copies elements on the card; the ranges don't overlap.
    void copy(std::size_t from, std::size_t to, std::size_t count);
    /// `allocate` and `write` in one.
    void fill(std::span<const std::byte> bytes);

    /// Makes it readable at a texture unit.
    void bind(GLuint unit);

private:
    void attach();
    bool mapRoom(std::size_t elements);
    void takeRoom(std::size_t elements, const void* bytes);

    Gl& m_gl;
    GLenum m_format;
    std::size_t m_elementBytes;
    std::size_t m_elements = 0;
    GLuint m_buffer = 0;
    GLuint m_texture = 0;
    std::unique_ptr<MappedMemory> m_memory; ///< none where it is the driver's
};

} // namespace trixel::render
