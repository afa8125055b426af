// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOpenGLContext>
#include <QOpenGLFunctions_4_1_Core>
#include <QPointer>

#include <memory>

namespace trixel::render {

/// All of OpenGL that Trixel uses: 4.1 core, which every desktop since 2010 has.
class Gl : public QOpenGLFunctions_4_1_Core
{
public:
    /// Whether the context they belong to is the current one. Names of objects mean nothing in
    /// another: what owns objects lets them go with a context that was lost, instead of deleting
    /// somebody else's.
    bool isCurrent() const { return m_context && m_context == QOpenGLContext::currentContext(); }
    /// Whether it is gone, with all that was drawn in it.
    bool isGone() const { return m_context.isNull(); }

private:
    friend std::unique_ptr<Gl> currentGl();

    QPointer<QOpenGLContext> m_context;
};

/// Functions of the current context, and only of it; null when there is none or it is older.
std::unique_ptr<Gl> currentGl();

} // namespace trixel::render
