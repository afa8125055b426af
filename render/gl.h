// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOpenGLFunctions_4_1_Core>

#include <memory>

namespace trixel::render {

/// All of OpenGL that Trixel uses: 4.1 core, which every desktop since 2010 has.
using Gl = QOpenGLFunctions_4_1_Core;

/// Functions of the current context, and only of it; null when there is none or it is older.
std::unique_ptr<Gl> currentGl();

} // namespace trixel::render
