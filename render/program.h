// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QOpenGLShaderProgram>
#include <QString>
#include <QStringList>

#include "core/base/result.h"

#include <memory>

namespace trixel::render {

/// Compiles and links the embedded shaders `:/shaders/<vertex>` and `:/shaders/<fragment>` in the
/// current context. Errors name the file and hold the compiler's words.
/// \param defines  lines put after `#version` of the fragment shader
/// \param pieces   other files that follow the fragment shader's own text
/// \param ofVertex  lines put after `#version` of the vertex shader
/// \param vertexPieces  other files that follow the vertex shader's own text
Result<std::unique_ptr<QOpenGLShaderProgram>> loadProgram(const QString& vertex,
                                                          const QString& fragment,
                                                          const QByteArray& defines = {},
                                                          const QStringList& pieces = {},
                                                          const QByteArray& ofVertex = {},
                                                          const QStringList& vertexPieces = {});

} // namespace trixel::render
