// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/inspector/footprint_net_painter.h"
#include "ui/inspector/picture_source.h"

#include <optional>

namespace trixel::ui {

/// A footprint laid flat, to be looked into and dragged.
///
/// | what | how |
/// |---|---|
/// | change W1 or W2 | drag its handle |
/// | go to another texel | click it |
/// | move the picture | drag elsewhere |
/// | zoom | wheel, or + and - |
/// | see the whole footprint again | double-click, or 0 |
class FootprintNetView : public QWidget, public PictureSource
{
    Q_OBJECT

public:
    explicit FootprintNetView(QWidget* parent = nullptr);

    /// Nothing shows the hint instead.
    void show(const std::optional<NetPicture>& picture);
    /// What the empty view says.
    void setHint(const QString& hint);
    const std::optional<NetPicture>& picture() const { return m_picture; }

    /// Where a handle is on the widget; nothing while there is no footprint.
    std::optional<QPointF> handleAt(NetHandle handle) const;
    /// Plane → widget.
    NetView view() const;
    /// The whole footprint is in sight again.
    void fit();
    void zoom(double factor, QPointF about);

    /// What is seen, with its scale of weights, by vectors.
    QString pictureName() const override { return "footprint"; }
    QSize pictureSize() const override { return m_picture ? size() : QSize(); }
    bool isVectorPicture() const override { return true; }
    void paintPicture(QPainter& painter, QSize size) override;

    QSize sizeHint() const override { return {300, 260}; }
    QSize minimumSizeHint() const override { return {160, 160}; }

signals:
    /// A handle was dragged: the vectors in (u,v) of the footprint's face.
    void dragged(glm::dvec2 w1, glm::dvec2 w2);
    /// A place of the surface was clicked.
    void clicked(trixel::FaceId face, glm::dvec2 uv);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    QRectF area() const;
    void drawInto(QPainter& painter, const QRectF& area) const;
    std::optional<NetHandle> handleUnder(QPointF position) const;
    void dragTo(QPointF position);
    QString tipAt(QPointF position) const;
    void paintScale(QPainter& painter, const QRectF& area) const;

    std::optional<NetPicture> m_picture;
    QString m_hint;
    double m_zoom = 1; ///< of the fitted view
    QPointF m_shift;   ///< of its centre, pixels
    std::optional<NetHandle> m_under;
    std::optional<NetHandle> m_dragged;
    NetView m_draggedIn; ///< stays while a handle is dragged
    std::optional<QPointF> m_pressed;
    QPointF m_last;
    bool m_pans = false;
};

} // namespace trixel::ui
