// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "render/camera.h"
#include "render/gl.h"
#include "render/program.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <vector>

namespace trixel::render {

/// A line through points in the world, drawn over a dark outline so that it shows on any texel.
struct Polyline
{
    std::vector<glm::vec3> points;
    bool closed = false;
    glm::vec4 color{1, 1, 1, 1};
    float width = 1.5F; ///< logical pixels
    /// How strongly what lies behind the surface still shows, in [0,1].
    float hiddenOpacity = 0.0F;
    bool outlined = true; ///< over a dark outline
};

/// Draws anti-aliased lines that lie on the surface, hidden by what is in front of it.
class OverlayPass
{
public:
    static Result<std::unique_ptr<OverlayPass>> create(Gl& gl);
    ~OverlayPass();

    /// \param pixelRatio  device pixels of a logical one
    void draw(const Camera& camera, const std::vector<Polyline>& lines, float pixelRatio);

private:
    OverlayPass(Gl& gl, std::unique_ptr<QOpenGLShaderProgram> program);
    void drawLine(const Polyline& line, float pixelRatio);
    void stroke(std::size_t segments, glm::vec4 color, float halfWidth);

    Gl& m_gl;
    std::unique_ptr<QOpenGLShaderProgram> m_program;
    GLuint m_vertexArray = 0;
    GLuint m_points = 0;
};

} // namespace trixel::render
