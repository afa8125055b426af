// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "render/gl.h"
#include "render/program.h"

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <span>

namespace trixel::render {

/// Lays a picture over what was drawn, pixel on pixel: what was computed elsewhere for this view.
/// Pixels are four bytes, R G B A, rows from the top.
class PicturePass
{
public:
    static Result<std::unique_ptr<PicturePass>> create(Gl& gl);
    ~PicturePass();

    /// Takes another picture. \param pixels  width × height of them (checked)
    void set(std::span<const std::uint32_t> pixels, glm::ivec2 size);
    /// Takes some rows anew, of the size that was set. \param pixels  whole rows (checked)
    void setRows(std::span<const std::uint32_t> pixels, int firstRow);
    void clear() { m_size = {0, 0}; }
    bool isEmpty() const { return m_size.x == 0; }

    /// Draws it into the lower left of the viewport that is set; does nothing when empty.
    void draw();

private:
    PicturePass(Gl& gl, std::unique_ptr<QOpenGLShaderProgram> program);

    Gl& m_gl;
    std::unique_ptr<QOpenGLShaderProgram> m_program;
    GLuint m_texture = 0;
    glm::ivec2 m_size{0};
};

} // namespace trixel::render
