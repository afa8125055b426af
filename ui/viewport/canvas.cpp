// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/canvas.h"

#include <QOpenGLContext>
#include <QScopedValueRollback>

#include <utility>

namespace trixel::ui {

Canvas::Canvas(const QSurfaceFormat& format, Hooks hooks, QWidget* parent)
    : QOpenGLWidget(parent)
    , m_hooks(std::move(hooks))
{
    setFormat(format);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    setAccessibleName(tr("Picture"));
}

/// The widget below this one ends its context when this one is gone: it must not be told of that.
Canvas::~Canvas()
{
    if (context() != nullptr) {
        disconnect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &Canvas::endContext);
    }
    endContext();
}

void Canvas::initializeGL()
{
    // Moving to another window or a driver's reset ends the context; a new one follows.
    connect(context(),
            &QOpenGLContext::aboutToBeDestroyed,
            this,
            &Canvas::endContext,
            Qt::DirectConnection);
    m_hooks.contextMade();
}

/// A context that was lost cannot be made current any more, but what was in it must be forgotten
/// all the same.
void Canvas::endContext()
{
    if (isValid()) {
        makeCurrent();
    }
    m_hooks.contextEnds();
    if (isValid()) {
        doneCurrent();
    }
}

void Canvas::paintGL()
{
    if (!m_isResizing) {
        m_hooks.draw();
    }
}

/// Which draws at once, for every step of a layout: one frame for the last of them is enough.
void Canvas::resizeEvent(QResizeEvent* event)
{
    const QScopedValueRollback resizing(m_isResizing, true);
    QOpenGLWidget::resizeEvent(event);
    update();
}

} // namespace trixel::ui
