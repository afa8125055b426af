// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOpenGLWidget>

#include <functional>

namespace trixel::ui {

/// The picture inside the viewport: only draws; pointer and keys go to the viewport around it.
class Canvas : public QOpenGLWidget
{
    Q_OBJECT

public:
    /// What the canvas calls, each with its context current.
    struct Hooks
    {
        std::function<void()> contextMade;
        std::function<void()> contextEnds; ///< with none current where it was lost or never made
        std::function<void()> draw;
    };

    Canvas(const QSurfaceFormat& format, Hooks hooks, QWidget* parent);
    ~Canvas() override;

protected:
    void initializeGL() override;
    void paintGL() override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void endContext();

    Hooks m_hooks;
    bool m_isResizing = false;
};

} // namespace trixel::ui
