// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/surface_atlas.h"

#include <array>
#include <vector>

namespace trixel::render {

namespace {

constexpr GLsizei kSide = DisplayAtlas::kLayerSize;
constexpr std::array<GLenum, 4> kFormats{GL_RGBA8, GL_RGBA16, GL_RGBA16F, GL_RGBA32F};
constexpr std::array<GLenum, 4> kTypes{
    GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_HALF_FLOAT, GL_FLOAT};

} // namespace

SurfaceAtlas::SurfaceAtlas(Gl& gl)
    : m_gl(gl)
    , m_records(gl, GL_RG32UI, sizeof(FaceRecord))
{
}

SurfaceAtlas::~SurfaceAtlas()
{
    if (m_gl.isCurrent()) { // else its texture went with its context
        release();
    }
}

void SurfaceAtlas::clear(std::size_t faceCount)
{
    release();
    const std::vector<FaceRecord> pending(faceCount);
    m_records.fill(std::as_bytes(std::span(pending)));
}

void SurfaceAtlas::begin(const AtlasUpdate& update, DisplayFormat format)
{
    if (update.fresh) {
        allocate(update.layers, format);
    }
}

void SurfaceAtlas::release()
{
    if (m_texture != 0) {
        m_gl.glDeleteTextures(1, &m_texture);
        m_texture = 0;
    }
    m_layers = 0;
}

std::uint64_t SurfaceAtlas::bytes() const
{
    return std::uint64_t{m_layers} * kSide * kSide * texelBytes(m_format);
}

void SurfaceAtlas::allocate(std::uint32_t layers, DisplayFormat format)
{
    release();
    m_layers = layers;
    m_format = format;
    const auto number = static_cast<std::size_t>(format);
    m_gl.glGenTextures(1, &m_texture);
    m_gl.glBindTexture(GL_TEXTURE_2D_ARRAY, m_texture);
    m_gl.glTexImage3D(GL_TEXTURE_2D_ARRAY,
                      0,
                      static_cast<GLint>(kFormats[number]),
                      kSide,
                      kSide,
                      static_cast<GLsizei>(layers),
                      0,
                      GL_RGBA,
                      kTypes[number],
                      nullptr);
    m_gl.glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    m_gl.glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    m_gl.glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    m_gl.glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void SurfaceAtlas::upload(const AtlasUpdate& update,
                          std::span<const FaceRecord> records,
                          DisplayFormat format)
{
    if (update.fresh) {
        allocate(update.layers, format);
        m_records.fill(std::as_bytes(records));
    }
    m_gl.glBindTexture(GL_TEXTURE_2D_ARRAY, m_texture);
    m_gl.glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const std::byte* bytes = update.bytes.data();
    for (const AtlasUpdate::Tile& tile : update.tiles) {
        m_gl.glTexSubImage3D(GL_TEXTURE_2D_ARRAY,
                             0,
                             static_cast<GLint>(tile.x),
                             static_cast<GLint>(tile.y),
                             static_cast<GLint>(tile.layer),
                             static_cast<GLsizei>(tile.size),
                             static_cast<GLsizei>(tile.size),
                             1,
                             GL_RGBA,
                             kTypes[static_cast<std::size_t>(format)],
                             bytes);
        bytes += std::size_t{tile.size} * tile.size * texelBytes(format);
    }
    m_gl.glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    for (const DisplayUpdate::Range& range : update.records) {
        m_records.write(range.first, std::as_bytes(records.subspan(range.first, range.count)));
    }
}

void SurfaceAtlas::bind(GLuint records, GLuint atlas)
{
    m_records.bind(records);
    m_gl.glActiveTexture(GL_TEXTURE0 + atlas);
    m_gl.glBindTexture(GL_TEXTURE_2D_ARRAY, m_texture);
}

} // namespace trixel::render
