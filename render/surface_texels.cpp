// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/surface_texels.h"

#include <array>
#include <utility>

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
{
}

void SurfaceTexels::clear()
{
    m_shown = {};
    m_next = {};
}

SurfaceTexels::Buffers SurfaceTexels::begun(const DisplayUpdate& update,
                                            std::span<const FaceRecord> records,
                                            DisplayFormat format)
{
    Buffers made{std::make_unique<TextureBuffer>(m_gl, GL_RG32UI, sizeof(FaceRecord)),
                 texelBuffer(m_gl, format)};
    made.records->fill(std::as_bytes(records));
    made.texels->allocate(update.capacity);
    return made;
}

void SurfaceTexels::upload(const DisplayUpdate& update,
                           std::span<const FaceRecord> records,
                           DisplayFormat format)
{
    if (update.fresh) {
        if (!update.isPart) {
            m_shown = {}; // two take more room than one
        }
        m_next = begun(update, records, format);
    }
    Buffers& to = m_next.texels ? m_next : m_shown;
    if (!to.texels) {
        return;
    }
    if (update.capacity > to.texels->size()) {
        to.texels->grow(update.capacity);
    }
    for (const CardBlocks::Move& move : update.moves) {
        to.texels->copy(move.from, move.to, move.count);
    }
    std::span<const std::byte> bytes(update.bytes);
    for (const DisplayUpdate::Range& range : update.texels) {
        const std::size_t size = range.count * texelBytes(format);
        to.texels->write(range.first, bytes.first(size));
        bytes = bytes.subspan(size);
    }
    for (const DisplayUpdate::Range& range : update.records) {
        to.records->write(range.first, std::as_bytes(records.subspan(range.first, range.count)));
    }
    if (m_next.texels && !update.isPart) {
        m_shown = std::exchange(m_next, {});
    }
}

void SurfaceTexels::bind(GLuint records, GLuint texels)
{
    m_shown.records->bind(records);
    m_shown.texels->bind(texels);
}

} // namespace trixel::render
