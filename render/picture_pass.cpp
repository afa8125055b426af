// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/picture_pass.h"

#include "core/base/check.h"

namespace trixel::render {

Result<std::unique_ptr<PicturePass>> PicturePass::create(Gl& gl)
{
    auto program = loadProgram(QStringLiteral("background.vert"), QStringLiteral("picture.frag"));
    if (!program) {
        return tl::unexpected(program.error());
    }
    return std::unique_ptr<PicturePass>(new PicturePass(gl, std::move(*program)));
}

PicturePass::PicturePass(Gl& gl, std::unique_ptr<QOpenGLShaderProgram> program)
    : m_gl(gl)
    , m_program(std::move(program))
{
    m_gl.glGenTextures(1, &m_texture);
}

PicturePass::~PicturePass()
{
    if (m_gl.isCurrent()) {
        m_gl.glDeleteTextures(1, &m_texture);
    }
}

void PicturePass::set(std::span<const std::uint32_t> pixels, glm::ivec2 size)
{
    check(pixels.size() == static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y),
          "a whole picture");
    m_gl.glBindTexture(GL_TEXTURE_2D, m_texture);
    m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    m_gl.glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    m_gl.glTexImage2D(
        GL_TEXTURE_2D, 0, GL_RGBA8, size.x, size.y, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    m_gl.glBindTexture(GL_TEXTURE_2D, 0);
    m_size = size;
}

void PicturePass::setRows(std::span<const std::uint32_t> pixels, int firstRow)
{
    if (pixels.empty()) {
        return;
    }
    check(!isEmpty() && pixels.size() % static_cast<std::size_t>(m_size.x) == 0, "whole rows");
    const int rows = static_cast<int>(pixels.size() / static_cast<std::size_t>(m_size.x));
    check(firstRow >= 0 && firstRow + rows <= m_size.y, "rows of the picture");
    m_gl.glBindTexture(GL_TEXTURE_2D, m_texture);
    m_gl.glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    m_gl.glTexSubImage2D(
        GL_TEXTURE_2D, 0, 0, firstRow, m_size.x, rows, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    m_gl.glBindTexture(GL_TEXTURE_2D, 0);
}

void PicturePass::draw()
{
    if (isEmpty()) {
        return;
    }
    m_gl.glDisable(GL_DEPTH_TEST);
    m_gl.glEnable(GL_BLEND);
    m_gl.glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    m_gl.glActiveTexture(GL_TEXTURE0);
    m_gl.glBindTexture(GL_TEXTURE_2D, m_texture);
    m_program->bind();
    m_program->setUniformValue("picture", 0);
    m_gl.glDrawArrays(GL_TRIANGLES, 0, 3);
    m_program->release();
    m_gl.glBindTexture(GL_TEXTURE_2D, 0);
    m_gl.glDisable(GL_BLEND);
}

} // namespace trixel::render
