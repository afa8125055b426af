// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>

#include "core/lattice/texel.h"
#include "ui/document/document.h"
#include "ui/viewport/view_settings.h"
#include "ui/viewport/viewport.h"

#include <array>
#include <memory>
#include <vector>

namespace trixel::ui {

inline constexpr std::array<std::byte, 3> kFill{std::byte{200}, std::byte{150}, std::byte{100}};

/// A square of two faces in z = 0, from -1 to 1: face 0 has its right angle at the lower right,
/// face 1 at the upper left.
inline TriangleMesh squareMesh()
{
    return {{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {{1, 2, 0}, {3, 0, 2}}, {}};
}

inline Project squareProject(int level = 3)
{
    NoProgress progress;
    Project project;
    project.surface = Surface::build(squareMesh(), progress).value();
    project.texels = TexelStore(2, TexelFormat{}, Level(level), kFill);
    return project;
}

/// Moves the pointer within a widget. (QTest::mouseMove moves the server's cursor instead, and
/// when its events come is up to the server.)
inline void movePointer(QWidget& widget, QPoint to, Qt::MouseButtons buttons = Qt::NoButton)
{
    QMouseEvent move(QEvent::MouseMove,
                     QPointF(to),
                     QPointF(widget.mapToGlobal(to)),
                     Qt::NoButton,
                     buttons,
                     Qt::NoModifier);
    QCoreApplication::sendEvent(&widget, &move);
}

/// A shown view of the square, looked at straight, with a small hard red brush.
struct ViewFixture
{
    Document document;
    ViewSettings settings;
    std::unique_ptr<Viewport> viewport;

    bool show(Project project = squareProject())
    {
        Brush brush;
        brush.radius = 0.09F;
        brush.hardness = 1.0F;
        brush.color = {1, 0, 0, 1};
        settings.setBrush(brush);
        viewport = std::make_unique<Viewport>(document, settings);
        viewport->resize(480, 480);
        viewport->show();
        const bool shown = QTest::qWaitForWindowExposed(viewport.get());
        document.open(std::move(project), {}, "square");
        viewport->lookFrom(0, 0);
        viewport->settle();
        return shown && viewport->canDraw();
    }

    SurfacePoint pointOf(FaceId face, glm::dvec2 uv) const
    {
        const glm::vec2 single(uv);
        const auto corners = document.surface()->mesh().corners(face);
        return {face, single, pointAt(corners, single.x, single.y)};
    }

    /// Where the middle of a texel is seen.
    QPoint texelPosition(FaceId face, TexelCoord texel) const
    {
        const Level level = document.texels().face(face).level();
        return viewport->widgetPosition(pointOf(face, centroid(level, texel)))->toPoint();
    }

    std::array<int, 3> texel(FaceId face, TexelCoord at) const
    {
        const FaceTexels& texels = document.texels().face(face);
        const auto bytes = texels.texel(indexOf(texelIndex(texels.level(), at)));
        return {int(bytes[0]), int(bytes[1]), int(bytes[2])};
    }

    QColor seen(QPoint position) const
    {
        const QImage image = viewport->grabFramebuffer();
        const double ratio = viewport->devicePixelRatioF();
        return image.pixelColor(int(position.x() * ratio), int(position.y() * ratio));
    }
};

inline constexpr std::array<int, 3> kFillColor{200, 150, 100};
inline constexpr std::array<int, 3> kRed{255, 0, 0};
inline constexpr FaceId kFace0 = faceId(0);
inline constexpr FaceId kFace1 = faceId(1);

} // namespace trixel::ui
