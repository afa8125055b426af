// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/overlay_pass.h"

#include "render/matrices.h"

namespace trixel::render {

namespace {

constexpr glm::vec4 kOutline{0.03F, 0.035F, 0.05F, 0.75F};
constexpr float kOutlineWidth = 1.0F; // logical pixels on either side

} // namespace

Result<std::unique_ptr<OverlayPass>> OverlayPass::create(Gl& gl)
{
    auto program = loadProgram(QStringLiteral("line.vert"), QStringLiteral("line.frag"));
    if (!program) {
        return tl::unexpected(program.error());
    }
    return std::unique_ptr<OverlayPass>(new OverlayPass(gl, std::move(*program)));
}

OverlayPass::OverlayPass(Gl& gl, std::unique_ptr<QOpenGLShaderProgram> program)
    : m_gl(gl)
    , m_program(std::move(program))
{
    m_gl.glGenVertexArrays(1, &m_vertexArray);
    m_gl.glGenBuffers(1, &m_points);
    m_gl.glBindVertexArray(m_vertexArray);
    m_gl.glBindBuffer(GL_ARRAY_BUFFER, m_points);
    // A segment is an instance: it starts at one point and ends at the next.
    const auto point = [&](const char* name, std::size_t offset) {
        const auto location = static_cast<GLuint>(m_program->attributeLocation(name));
        m_gl.glEnableVertexAttribArray(location);
        m_gl.glVertexAttribPointer(location,
                                   3,
                                   GL_FLOAT,
                                   GL_FALSE,
                                   sizeof(glm::vec3),
                                   reinterpret_cast<const void*>(offset));
        m_gl.glVertexAttribDivisor(location, 1);
    };
    point("from", 0);
    point("to", sizeof(glm::vec3));
    m_gl.glBindVertexArray(0);
    m_gl.glBindBuffer(GL_ARRAY_BUFFER, 0);
}

OverlayPass::~OverlayPass()
{
    if (m_gl.isCurrent()) {
        m_gl.glDeleteBuffers(1, &m_points);
        m_gl.glDeleteVertexArrays(1, &m_vertexArray);
    }
}

void OverlayPass::draw(const Camera& camera, const std::vector<Polyline>& lines, float pixelRatio)
{
    if (lines.empty()) {
        return;
    }
    m_program->bind();
    m_program->setUniformValue("view", toQt(camera.view()));
    m_program->setUniformValue("projection", toQt(camera.projection()));
    m_program->setUniformValue("viewport",
                               QVector2D(static_cast<float>(camera.viewport().x),
                                         static_cast<float>(camera.viewport().y)));
    m_gl.glEnable(GL_DEPTH_TEST);
    m_gl.glDepthMask(GL_FALSE);
    m_gl.glEnable(GL_BLEND);
    m_gl.glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    m_gl.glDisable(GL_CULL_FACE);
    GLint before = 0;
    m_gl.glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &before);
    m_gl.glBindVertexArray(m_vertexArray);
    for (const Polyline& line : lines) {
        drawLine(line, pixelRatio);
    }
    m_gl.glBindVertexArray(static_cast<GLuint>(before));
    m_gl.glDisable(GL_BLEND);
    m_gl.glDepthMask(GL_TRUE);
    m_gl.glDepthFunc(GL_LESS);
    m_program->release();
}

void OverlayPass::drawLine(const Polyline& line, float pixelRatio)
{
    if (line.points.size() < 2) {
        return;
    }
    std::vector<glm::vec3> points = line.points;
    if (line.closed) {
        points.push_back(points.front());
    }
    m_gl.glBindBuffer(GL_ARRAY_BUFFER, m_points);
    m_gl.glBufferData(GL_ARRAY_BUFFER,
                      static_cast<GLsizeiptr>(points.size() * sizeof(glm::vec3)),
                      points.data(),
                      GL_STREAM_DRAW);
    m_gl.glBindBuffer(GL_ARRAY_BUFFER, 0);

    const float half = 0.5F * line.width * pixelRatio;
    const std::size_t segments = points.size() - 1;
    glm::vec4 outline = kOutline;
    outline.a *= line.color.a;
    const auto both = [&](float opacity) {
        const auto faded = [&](glm::vec4 color) {
            return glm::vec4(color.r, color.g, color.b, color.a * opacity);
        };
        if (line.outlined) {
            stroke(segments, faded(outline), half + kOutlineWidth * pixelRatio);
        }
        stroke(segments, faded(line.color), half);
    };
    m_gl.glDepthFunc(GL_LEQUAL);
    both(1.0F);
    if (line.hiddenOpacity > 0) {
        m_gl.glDepthFunc(GL_GREATER);
        both(line.hiddenOpacity);
    }
}

void OverlayPass::stroke(std::size_t segments, glm::vec4 color, float halfWidth)
{
    m_program->setUniformValue("lineColor", QVector4D(color.r, color.g, color.b, color.a));
    m_program->setUniformValue("halfWidth", halfWidth);
    m_gl.glDrawArraysInstanced(GL_TRIANGLES, 0, 6, static_cast<GLsizei>(segments));
}

} // namespace trixel::render
