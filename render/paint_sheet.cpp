// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/paint_sheet.h"

#include <QVector2D>

#include "core/lattice/paint_projection.h"
#include "render/matrices.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

namespace trixel::render {

namespace {

/// 16.7 million texels; with what is drawn aside, 134 MB.
constexpr std::uint32_t kMostRows = 4096;

/// Remembers what a frame is being drawn with, and brings it back.
class KeptState
{
public:
    explicit KeptState(Gl& gl)
        : m_gl(gl)
        , m_isScissored(gl.glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE)
    {
        gl.glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &m_drawn);
        gl.glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &m_read);
        gl.glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &m_vertexArray);
        gl.glGetIntegerv(GL_VIEWPORT, m_viewport.data());
        gl.glDisable(GL_SCISSOR_TEST);
    }
    ~KeptState()
    {
        m_gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(m_drawn));
        m_gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(m_read));
        m_gl.glBindVertexArray(static_cast<GLuint>(m_vertexArray));
        m_gl.glViewport(m_viewport[0], m_viewport[1], m_viewport[2], m_viewport[3]);
        if (m_isScissored) {
            m_gl.glEnable(GL_SCISSOR_TEST);
        }
    }
    KeptState(const KeptState&) = delete;
    KeptState& operator=(const KeptState&) = delete;

private:
    Gl& m_gl;
    bool m_isScissored;
    GLint m_drawn = 0;
    GLint m_read = 0;
    GLint m_vertexArray = 0;
    std::array<GLint, 4> m_viewport{};
};

} // namespace

PaintTarget::PaintTarget(Gl& gl)
    : m_gl(gl)
{
    m_gl.glGenTextures(1, &m_texture);
    m_gl.glGenFramebuffers(1, &m_framebuffer);
}

PaintTarget::~PaintTarget()
{
    if (m_gl.isCurrent()) {
        m_gl.glDeleteFramebuffers(1, &m_framebuffer);
        m_gl.glDeleteTextures(1, &m_texture);
    }
}

bool PaintTarget::allocate(GLenum format, std::uint32_t rows)
{
    const KeptState kept(m_gl);
    while (m_gl.glGetError() != GL_NO_ERROR) { // of others
    }
    m_gl.glActiveTexture(GL_TEXTURE0);
    m_gl.glBindTexture(GL_TEXTURE_2D, m_texture);
    m_gl.glTexImage2D(GL_TEXTURE_2D,
                      0,
                      static_cast<GLint>(format),
                      static_cast<GLsizei>(PaintSquares::kWidth),
                      static_cast<GLsizei>(rows),
                      0,
                      GL_RED,
                      GL_FLOAT,
                      nullptr);
    m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    m_gl.glBindTexture(GL_TEXTURE_2D, 0);
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    m_gl.glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_texture, 0);
    return m_gl.glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE &&
           m_gl.glGetError() == GL_NO_ERROR;
}

Result<std::unique_ptr<PaintSheet>> PaintSheet::create(Gl& gl, GLenum coverage)
{
    auto dabs = loadProgram(QStringLiteral("paint.vert"), QStringLiteral("paint_dabs.frag"));
    if (!dabs) {
        return tl::unexpected(dabs.error());
    }
    auto copy = loadProgram(QStringLiteral("paint.vert"), QStringLiteral("paint_copy.frag"));
    if (!copy) {
        return tl::unexpected(copy.error());
    }
    std::unique_ptr<PaintSheet> sheet(
        new PaintSheet(gl, coverage, std::move(*dabs), std::move(*copy)));
    if (!sheet->reserve(kFewestRows)) {
        return contentsError("The graphics card cannot draw into textures of numbers.");
    }
    return sheet;
}

PaintSheet::PaintSheet(Gl& gl, GLenum coverage, Program dabs, Program copy)
    : m_gl(gl)
    , m_coverage(coverage)
    , m_dabsProgram(std::move(dabs))
    , m_copyProgram(std::move(copy))
    , m_scratch(gl)
    , m_entries(gl, GL_RGBA32UI, sizeof(PaintEntry) / 4)
    , m_dabs(gl, GL_RGBA32F, sizeof(PaintDab) / 2)
{
    m_gl.glGenVertexArrays(1, &m_vertexArray);
    GLint most = 0;
    m_gl.glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    const bool isWide = most >= static_cast<GLint>(PaintSquares::kWidth);
    m_ableRows = isWide ? std::min(static_cast<std::uint32_t>(most), kMostRows) : 0;
    m_mostRows = m_ableRows;
    for (QOpenGLShaderProgram* program : {m_dabsProgram.get(), m_copyProgram.get()}) {
        program->bind();
        program->setUniformValue("entries", 0);
        program->setUniformValue("before", 1);
        program->setUniformValue("dabs", 2);
        program->setUniformValue("offset", static_cast<float>(kPaintOffset));
        program->release();
    }
}

PaintSheet::~PaintSheet()
{
    if (m_gl.isCurrent()) {
        m_gl.glDeleteVertexArrays(1, &m_vertexArray);
    }
}

void PaintSheet::setMost(std::uint64_t bytes)
{
    const std::uint64_t rows = std::max<std::uint64_t>(bytes / kRowBytes, kFewestRows);
    m_mostRows = static_cast<std::uint32_t>(std::min<std::uint64_t>(rows, m_ableRows));
}

bool PaintSheet::reserve(std::uint32_t rows)
{
    if (rows <= m_rows) {
        return true;
    }
    if (rows > m_mostRows) {
        return false;
    }
    const std::uint32_t more = std::clamp(std::max(rows, 2 * m_rows), kFewestRows, m_mostRows);
    auto larger = std::make_unique<PaintTarget>(m_gl);
    if (!larger->allocate(m_coverage, more) || !m_scratch.allocate(m_coverage, more)) {
        (void)m_scratch.allocate(m_coverage, m_rows); // as it was
        return false;
    }
    if (m_sheet) {
        const KeptState kept(m_gl);
        const auto width = static_cast<GLint>(PaintSquares::kWidth);
        const auto height = static_cast<GLint>(m_rows);
        m_gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, m_sheet->framebuffer());
        m_gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, larger->framebuffer());
        m_gl.glBlitFramebuffer(
            0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }
    m_sheet = std::move(larger);
    m_rows = more;
    return true;
}

void PaintSheet::shrink()
{
    if (m_rows > kFewestRows) {
        m_rows = 0;
        m_sheet.reset();
        m_pictures.reset();
        m_pictureRows = 0;
        (void)reserve(kFewestRows); // as it was once
    }
}

std::uint64_t PaintSheet::bytes() const
{
    const std::uint64_t coverage = std::uint64_t{m_rows} * PaintSquares::kWidth * sizeof(float) * 2;
    const std::uint64_t pictures = std::uint64_t{m_pictureRows} * PaintSquares::kWidth * 8;
    return coverage + (m_pictures ? pictures : 0);
}

void PaintSheet::drawInto(const PaintTarget& target,
                          GLuint from,
                          QOpenGLShaderProgram& program,
                          std::size_t entries)
{
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
    m_gl.glActiveTexture(GL_TEXTURE1);
    m_gl.glBindTexture(GL_TEXTURE_2D, from);
    program.bind();
    program.setUniformValue("sheetSize",
                            QVector2D(PaintSquares::kWidth, static_cast<float>(m_rows)));
    m_gl.glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(3 * entries));
    program.release();
}

void PaintSheet::withBatch(const PaintBatch& batch, const std::function<void()>& work)
{
    if (batch.entries().empty()) {
        return;
    }
    const KeptState kept(m_gl);
    m_entries.fill(std::as_bytes(batch.entries()));
    m_dabs.fill(std::as_bytes(batch.dabs()));
    m_gl.glBindVertexArray(m_vertexArray);
    m_gl.glViewport(0, 0, static_cast<GLsizei>(PaintSquares::kWidth), static_cast<GLsizei>(m_rows));
    for (const GLenum test : {GL_DEPTH_TEST, GL_BLEND, GL_CULL_FACE, GL_STENCIL_TEST}) {
        m_gl.glDisable(test); // the halves are wound in opposite ways
    }
    m_gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    for (GLenum plane = 0; plane < 4; ++plane) {
        m_gl.glEnable(GL_CLIP_DISTANCE0 + plane);
    }
    m_entries.bind(0);
    m_dabs.bind(2);
    work();
    for (GLenum plane = 0; plane < 4; ++plane) {
        m_gl.glDisable(GL_CLIP_DISTANCE0 + plane);
    }
    m_gl.glActiveTexture(GL_TEXTURE0);
}

void PaintSheet::draw(const PaintBatch& batch, const Strength& strength)
{
    withBatch(batch, [&] {
        QOpenGLShaderProgram& program = *m_dabsProgram;
        program.bind();
        program.setUniformValue("hardness", strength.hardness);
        program.setUniformValue(
            "fallScale", strength.hardness < 1.0F ? 1.0F / (1.0F - strength.hardness) : 1e30F);
        program.setUniformValue("flow", strength.flow);
        drawInto(m_scratch, m_sheet->texture(), program, batch.entries().size());
        drawInto(*m_sheet, m_scratch.texture(), *m_copyProgram, batch.entries().size());
    });
}

bool PaintSheet::drawPicture(const PaintBatch& batch, const PictureProjection& picture)
{
    if (!m_pictureProgram) {
        auto made = loadProgram(QStringLiteral("paint.vert"), QStringLiteral("paint_picture.frag"));
        if (!made) {
            return false;
        }
        m_pictureProgram = std::move(*made);
    }
    if (!m_pictures || m_pictureRows != m_rows) {
        m_pictures = std::make_unique<PaintTarget>(m_gl);
        m_pictureRows = m_rows;
        if (!m_pictures->allocate(GL_RGBA16F, m_rows)) {
            m_pictures.reset();
            return false;
        }
    }
    GLuint pixels = 0;
    m_gl.glGenTextures(1, &pixels);
    m_gl.glActiveTexture(GL_TEXTURE1);
    m_gl.glBindTexture(GL_TEXTURE_2D, pixels);
    m_gl.glTexImage2D(GL_TEXTURE_2D,
                      0,
                      GL_RGBA32F,
                      picture.width,
                      picture.height,
                      0,
                      GL_RGBA,
                      GL_FLOAT,
                      picture.pixels.data());
    m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    withBatch(batch, [&] {
        QOpenGLShaderProgram& program = *m_pictureProgram;
        program.bind();
        program.setUniformValue("entries", 0);
        program.setUniformValue("picture", 1);
        program.setUniformValue("offset", static_cast<float>(kPaintOffset));
        program.setUniformValue("opacity", picture.opacity);
        const glm::dmat4 toClip = glm::translate(picture.toClip, batch.origin());
        program.setUniformValue("toClip", toQt(glm::mat4(toClip)));
        drawInto(*m_pictures, pixels, program, batch.entries().size());
    });
    m_gl.glDeleteTextures(1, &pixels);
    return m_gl.glGetError() == GL_NO_ERROR;
}

void PaintSheet::bindPicture(GLuint unit)
{
    m_gl.glActiveTexture(GL_TEXTURE0 + unit);
    m_gl.glBindTexture(GL_TEXTURE_2D, m_pictures->texture());
}

void PaintSheet::bind(GLuint unit)
{
    m_gl.glActiveTexture(GL_TEXTURE0 + unit);
    m_gl.glBindTexture(GL_TEXTURE_2D, m_sheet->texture());
}

std::vector<float> PaintSheet::read(const PaintSquare& square)
{
    return read(*m_sheet, square, GL_RED);
}

std::vector<float> PaintSheet::readPicture(const PaintSquare& square)
{
    return read(*m_pictures, square, GL_RGBA);
}

std::vector<float>
PaintSheet::read(const PaintTarget& target, const PaintSquare& square, GLenum format)
{
    const KeptState kept(m_gl);
    std::vector<float> values(square.level.texelCount() * (format == GL_RGBA ? 4U : 1U));
    const auto side = static_cast<GLsizei>(square.level.resolution());
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
    m_gl.glReadPixels(square.x, square.y, side, side, format, GL_FLOAT, values.data());
    return values;
}

} // namespace trixel::render
