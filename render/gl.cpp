// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gl.h"

#include <QOpenGLContext>

namespace trixel::render {

std::unique_ptr<Gl> currentGl()
{
    auto gl = std::make_unique<Gl>();
    const bool usable = QOpenGLContext::currentContext() && gl->initializeOpenGLFunctions();
    return usable ? std::move(gl) : nullptr;
}

} // namespace trixel::render
