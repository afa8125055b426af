// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/graphics_probe.h"

#include <QByteArray>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>

#include <algorithm>
#include <array>

namespace trixel::ui {

namespace {

constexpr int kSamples = 4;

/// Whether widgets can hold pictures of OpenGL here. Platforms without windows of their own make
/// contexts where a display happens to be told, but a QOpenGLWidget then draws into nothing and
/// ends the program.
bool hasCanvases()
{
    const QString platform = QGuiApplication::platformName();
    return platform != "offscreen" && !platform.startsWith("minimal");
}

QSurfaceFormat plainFormat()
{
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(4, 1);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setOption(QSurfaceFormat::ResetNotification); // or a lost context would stay unnoticed
    return format;
}

std::optional<QSurfaceFormat> probe()
{
    if (!hasCanvases()) {
        return std::nullopt;
    }
    QSurfaceFormat format = plainFormat();
    QOffscreenSurface surface;
    surface.setFormat(format);
    surface.create();
    QOpenGLContext context;
    context.setFormat(format);
    if (!context.create() || !context.makeCurrent(&surface)) {
        return std::nullopt;
    }
    const bool recent = context.format().version() >= format.version();
    const auto* text = reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
    const QByteArray name = QByteArray(text).toLower();
    context.doneCurrent();
    constexpr std::array kSoftware{"llvmpipe", "softpipe", "swrast", "software", "swiftshader"};
    const bool software =
        std::ranges::any_of(kSoftware, [&](const char* part) { return name.contains(part); });
    format.setSamples(software ? 0 : kSamples);
    return recent ? std::optional(format) : std::nullopt;
}

} // namespace

std::optional<QSurfaceFormat> usableFormat()
{
    static const std::optional<QSurfaceFormat> kFormat = probe();
    return kFormat;
}

} // namespace trixel::ui
