// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/program.h"

namespace trixel::render {

Result<std::unique_ptr<QOpenGLShaderProgram>> loadProgram(const QString& vertex,
                                                          const QString& fragment)
{
    auto program = std::make_unique<QOpenGLShaderProgram>();
    const auto add = [&](QOpenGLShader::ShaderType type, const QString& file) {
        return program->addShaderFromSourceFile(type, QStringLiteral(":/shaders/") + file);
    };
    if (!add(QOpenGLShader::Vertex, vertex)) {
        return contentsError("shader " + vertex.toStdString() + ": " +
                             program->log().toStdString());
    }
    if (!add(QOpenGLShader::Fragment, fragment)) {
        return contentsError("shader " + fragment.toStdString() + ": " +
                             program->log().toStdString());
    }
    if (!program->link()) {
        return contentsError("shaders " + vertex.toStdString() + " and " + fragment.toStdString() +
                             " do not link: " + program->log().toStdString());
    }
    return program;
}

} // namespace trixel::render
