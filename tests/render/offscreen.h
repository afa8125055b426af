// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions>

#include "render/renderer.h"

#include <memory>

namespace trixel::render {

/// A context of its own and a picture to draw into.
class Offscreen
{
public:
    explicit Offscreen(int width = 1024, int height = 1024)
    {
        QSurfaceFormat format;
        format.setVersion(4, 1);
        format.setProfile(QSurfaceFormat::CoreProfile);
        format.setDepthBufferSize(24);
        format.setOption(QSurfaceFormat::DebugContext);
        m_surface.setFormat(format);
        m_surface.create();
        m_context.setFormat(format);
        m_valid = m_context.create() && m_context.makeCurrent(&m_surface);
        if (m_valid) {
            m_target = std::make_unique<QOpenGLFramebufferObject>(
                width, height, QOpenGLFramebufferObject::Depth);
        }
    }
    ~Offscreen()
    {
        m_context.makeCurrent(&m_surface);
        m_target.reset();
        m_context.doneCurrent();
    }

    bool isValid() const { return m_valid; }
    QOpenGLContext& context() { return m_context; }

    /// Makes the context and the picture current.
    void bind()
    {
        m_context.makeCurrent(&m_surface);
        m_target->bind();
    }

    /// Draws and waits until it is done, without looking at the picture.
    void drawOnly(Renderer& renderer, const Scene& scene)
    {
        bind();
        renderer.draw(scene);
        m_context.functions()->glFinish();
    }

    QImage draw(Renderer& renderer, Scene scene)
    {
        bind();
        scene.camera.setViewport(m_target->width(), m_target->height());
        renderer.draw(scene);
        m_errors = m_errors || m_context.functions()->glGetError() != GL_NO_ERROR;
        QImage image = m_target->toImage().convertToFormat(QImage::Format_RGB32);
        m_target->release();
        return image;
    }
    /// Whether OpenGL complained about anything drawn.
    bool hadErrors() const { return m_errors; }

private:
    QOffscreenSurface m_surface;
    QOpenGLContext m_context;
    std::unique_ptr<QOpenGLFramebufferObject> m_target;
    bool m_valid = false;
    bool m_errors = false;
};

} // namespace trixel::render
