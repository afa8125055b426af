// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/surface_texels.h"

#include <array>
#include <vector>

namespace trixel::render {

namespace {

std::unique_ptr<TextureBuffer> texelBuffer(Gl& gl, DisplayFormat format)
{
    constexpr std::array<GLenum, 4> kFormats{GL_RGBA8, GL_RGBA16, GL_RGBA16F, GL_RGBA32F};
    return std::make_unique<TextureBuffer>(
        gl, kFormats[static_cast<std::size_t>(format)], texelBytes(format));
}

} // namespace

SurfaceTexels::SurfaceTexels(Gl& gl)
    : m_gl(gl)
    , m_records(gl, GL_RG32UI, sizeof(FaceRecord))
{
}

void SurfaceTexels::clear(std::size_t faceCount)
{
    const std::vector<FaceRecord> pending(faceCount);
    m_records.fill(std::as_bytes(std::span(pending)));
    m_texels.reset();
}

void SurfaceTexels::begin(const DisplayUpdate& update, DisplayFormat format)
{
    if (!m_texels || m_format != format) {
        m_texels = texelBuffer(m_gl, format);
        m_format = format;
    }
    if (update.capacity > m_texels->size()) {
        m_texels->grow(update.capacity);
    }
}

void SurfaceTexels::upload(const DisplayUpdate& update,
                           std::span<const FaceRecord> records,
                           DisplayFormat format)
{
    if (!m_texels || m_format != format) {
        m_texels = texelBuffer(m_gl, format);
        m_format = format;
    }
    if (update.fresh) {
        m_texels->allocate(update.capacity);
        m_records.fill(std::as_bytes(records));
    } else if (update.capacity > m_texels->size()) {
        m_texels->grow(update.capacity);
    }
    for (const CardBlocks::Move& move : update.moves) {
        m_texels->copy(move.from, move.to, move.count);
    }
    std::span<const std::byte> bytes(update.bytes);
    for (const DisplayUpdate::Range& range : update.texels) {
        const std::size_t size = range.count * texelBytes(format);
        m_texels->write(range.first, bytes.first(size));
        bytes = bytes.subspan(size);
    }
    for (const DisplayUpdate::Range& range : update.records) {
        m_records.write(range.first, std::as_bytes(records.subspan(range.first, range.count)));
    }
}

void SurfaceTexels::bind(GLuint records, GLuint texels)
{
    m_records.bind(records);
    m_texels->bind(texels);
}

} // namespace trixel::render
