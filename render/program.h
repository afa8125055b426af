// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QOpenGLShaderProgram>
#include <QString>

#include "core/base/result.h"

#include <memory>

namespace trixel::render {

/// Compiles and links the embedded shaders `:/shaders/<vertex>` and `:/shaders/<fragment>` in the
/// current context. Errors name the file and hold the compiler's words.
/// \param defines  lines put after `#version` of the fragment shader
Result<std::unique_ptr<QOpenGLShaderProgram>>
loadProgram(const QString& vertex, const QString& fragment, const QByteArray& defines = {});

} // namespace trixel::render
