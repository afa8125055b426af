// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/program.h"

#include <QFile>

namespace trixel::render {

namespace {

/// Text of an embedded shader with lines put after its first, which has to stay `#version`; empty
/// when there is no such file.
QByteArray shaderSource(const QString& name, const QByteArray& defines)
{
    QFile file(QStringLiteral(":/shaders/") + name);
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    QByteArray source = file.readAll();
    return source.insert(source.indexOf('\n') + 1, defines);
}

} // namespace

Result<std::unique_ptr<QOpenGLShaderProgram>> loadProgram(const QString& vertex,
                                                          const QString& fragment,
                                                          const QByteArray& defines,
                                                          const QStringList& pieces,
                                                          const QByteArray& ofVertex,
                                                          const QStringList& vertexPieces)
{
    auto program = std::make_unique<QOpenGLShaderProgram>();
    const auto add = [&](QOpenGLShader::ShaderType type,
                         const QString& name,
                         const QByteArray& lines,
                         const QStringList& more) -> Status {
        QByteArray source = shaderSource(name, lines);
        bool isWhole = !source.isEmpty();
        for (const QString& piece : more) {
            QFile file(QStringLiteral(":/shaders/") + piece);
            isWhole = isWhole && file.open(QIODevice::ReadOnly);
            source += file.readAll();
        }
        if (!isWhole) {
            return contentsError("shader " + name.toStdString() + " is not in the program");
        }
        if (!program->addShaderFromSourceCode(type, source)) {
            return contentsError("shader " + name.toStdString() + ": " +
                                 program->log().toStdString());
        }
        return {};
    };
    if (const Status added = add(QOpenGLShader::Vertex, vertex, ofVertex, vertexPieces); !added) {
        return tl::unexpected(added.error());
    }
    if (const Status added = add(QOpenGLShader::Fragment, fragment, defines, pieces); !added) {
        return tl::unexpected(added.error());
    }
    if (!program->link()) {
        return contentsError("shaders " + vertex.toStdString() + " and " + fragment.toStdString() +
                             " do not link: " + program->log().toStdString());
    }
    return program;
}

} // namespace trixel::render
