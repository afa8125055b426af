// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/surface_pass.h"

#include "render/matrices.h"

#include <algorithm>
#include <string>

namespace trixel::render {

namespace {

std::unique_ptr<TextureBuffer> texelBuffer(Gl& gl, DisplayFormat format)
{
    return std::make_unique<TextureBuffer>(
        gl, format == DisplayFormat::Rgba8 ? GL_RGBA8 : GL_RGBA16F, texelBytes(format));
}

} // namespace

Result<std::unique_ptr<SurfacePass>> SurfacePass::create(Gl& gl)
{
    auto program = loadProgram(QStringLiteral("surface.vert"), QStringLiteral("surface.frag"));
    if (!program) {
        return tl::unexpected(program.error());
    }
    return std::unique_ptr<SurfacePass>(new SurfacePass(gl, std::move(*program)));
}

SurfacePass::SurfacePass(Gl& gl, std::unique_ptr<QOpenGLShaderProgram> program)
    : m_gl(gl)
    , m_program(std::move(program))
    , m_positions(gl, GL_RGB32F, sizeof(glm::vec3))
    , m_triangles(gl, GL_RGB32UI, sizeof(Triangle))
    , m_normals(gl, GL_R32UI, sizeof(std::uint32_t))
    , m_records(gl, GL_RG32UI, sizeof(FaceRecord))
{
    m_program->bind();
    m_program->setUniformValue("positions", 0);
    m_program->setUniformValue("triangles", 1);
    m_program->setUniformValue("normals", 2);
    m_program->setUniformValue("records", 3);
    m_program->setUniformValue("texels", 4);
    m_program->release();
}

Status SurfacePass::setMesh(const TriangleMesh& mesh)
{
    m_faceCount = 0;
    m_normals.fill({});
    const std::size_t most = TextureBuffer::maxElements(m_gl);
    if (mesh.positions.size() > most || 3 * mesh.faceCount() > most) {
        return contentsError("The graphics card shows at most " + std::to_string(most / 3) +
                             " faces; the mesh has " + std::to_string(mesh.faceCount()) + ".");
    }
    m_positions.fill(std::as_bytes(std::span(mesh.positions)));
    m_triangles.fill(std::as_bytes(std::span(mesh.triangles)));
    const std::vector<FaceRecord> pending(mesh.faceCount());
    m_records.fill(std::as_bytes(std::span(pending)));
    m_faceCount = mesh.faceCount();
    return {};
}

void SurfacePass::setNormals(std::span<const std::uint32_t> normals)
{
    check(normals.size() == 3 * m_faceCount, "three normals a face");
    m_normals.fill(std::as_bytes(normals));
}

void SurfacePass::upload(const DisplayUpdate& update,
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

void SurfacePass::draw(const Camera& camera, const SurfaceStyle& style)
{
    if (m_faceCount == 0 || !m_texels || m_texels->size() == 0) {
        return;
    }
    m_program->bind();
    m_positions.bind(0);
    m_triangles.bind(1);
    m_normals.bind(2);
    m_records.bind(3);
    m_texels->bind(4);
    m_program->setUniformValue("view", toQt(camera.view()));
    m_program->setUniformValue("projection", toQt(camera.projection()));
    m_program->setUniformValue("hasNormals", m_normals.size() > 0);
    m_program->setUniformValue("lit", style.lit);
    m_program->setUniformValue("wireframe", style.wireframe);
    m_program->setUniformValue("texelGrid", style.texelGrid);
    m_program->setUniformValue("hasAlpha", style.hasAlpha);
    m_program->setUniformValue("lineWidth", style.pixelRatio);

    m_gl.glEnable(GL_DEPTH_TEST);
    m_gl.glDepthFunc(GL_LESS);
    m_gl.glDepthMask(GL_TRUE);
    m_gl.glDisable(GL_CULL_FACE);
    m_gl.glDisable(GL_BLEND);
    m_gl.glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(3 * m_faceCount));
    m_program->release();
}

} // namespace trixel::render
