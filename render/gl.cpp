// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gl.h"

namespace trixel::render {

std::unique_ptr<Gl> currentGl()
{
    auto gl = std::make_unique<Gl>();
    gl->m_context = QOpenGLContext::currentContext();
    const bool usable = gl->m_context && gl->initializeOpenGLFunctions();
    return usable ? std::move(gl) : nullptr;
}

} // namespace trixel::render
