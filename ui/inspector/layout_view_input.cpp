// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pointer and keys of a view of layouts.
#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include "ui/inspector/layout_view.h"
#include "ui/viewport/inspect_keys.h"

#include <algorithm>
#include <cmath>

namespace trixel::ui {

namespace {

constexpr double kPerNotch = 0.15;       // e-folds, as in the 3D view
constexpr double kPerKey = 0.4;          // e-folds
constexpr double kPerWidthDragged = 4.0; // e-folds
constexpr double kMostNotches = 20;      // in one event
constexpr double kNotch = 120;           // of Qt's wheel angle

/// Keys that mean something here, whatever they mean to the window.
bool isOwn(const QKeyEvent& event)
{
    if ((event.modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier)) != Qt::NoModifier) {
        return false;
    }
    switch (event.key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Minus:
    case Qt::Key_F:
    case Qt::Key_Home:
    case Qt::Key_1:
    case Qt::Key_Space:
    case Qt::Key_Escape:
        return true;
    default:
        return inspectStepOf(event.key()).has_value();
    }
}

} // namespace

bool LayoutView::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride && isOwn(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    return QWidget::event(event);
}

void LayoutView::resizeEvent(QResizeEvent* /*event*/)
{
    fitSight();
    refresh();
}

void LayoutView::changeEvent(QEvent* event)
{
    const auto type = event->type();
    if (type == QEvent::PaletteChange || type == QEvent::FontChange) {
        fitSight();
        refresh();
    }
    QWidget::changeEvent(event);
}

std::optional<LayoutScene::Hit> LayoutView::hitAt(QPointF position) const
{
    const QRectF plane = roomsIn(rect(), LayoutInk(palette(), font())).plane;
    if (!m_scene || !plane.contains(position)) {
        return std::nullopt;
    }
    return m_scene->at(m_sight.toPlane({position.x(), position.y()}));
}

void LayoutView::hoverAt(QPointF position)
{
    if (const auto hit = hitAt(position)) {
        emit pointedAt(hit->place);
    } else {
        emit pointedAway();
    }
}

void LayoutView::mousePressEvent(QMouseEvent* event)
{
    m_pressed = event->position();
    m_last = m_pressed;
    const bool alt = event->modifiers().testFlag(Qt::AltModifier);
    if (event->button() == Qt::MiddleButton || (event->button() == Qt::LeftButton && alt)) {
        m_drag = Drag::Pan;
        setCursor(Qt::ClosedHandCursor);
    } else if (event->button() == Qt::LeftButton) {
        m_drag = Drag::Press;
    } else if (event->button() == Qt::RightButton && alt) {
        m_drag = Drag::Zoom;
    } else {
        QWidget::mousePressEvent(event);
    }
}

void LayoutView::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF position = event->position();
    const QPointF moved = position - m_last;
    m_last = position;
    if (m_drag == Drag::Press &&
        (position - m_pressed).manhattanLength() >= QApplication::startDragDistance()) {
        m_drag = Drag::Pan;
        setCursor(Qt::ClosedHandCursor);
        m_sight.panBy({position.x() - m_pressed.x(), position.y() - m_pressed.y()});
        refresh();
        return;
    }
    switch (m_drag) {
    case Drag::Pan:
        m_sight.panBy({moved.x(), moved.y()});
        refresh();
        break;
    case Drag::Zoom:
        zoomAt(std::exp(kPerWidthDragged * (moved.x() - moved.y()) / std::max(width(), 1)),
               m_pressed);
        break;
    case Drag::Press:
        break;
    case Drag::None:
        hoverAt(position);
        break;
    }
}

void LayoutView::mouseReleaseEvent(QMouseEvent* event)
{
    const Drag ended = m_drag;
    m_drag = Drag::None;
    unsetCursor();
    if (ended == Drag::Press) {
        if (const auto hit = hitAt(m_pressed)) {
            emit chosen(hit->place);
        }
    } else if (ended != Drag::None) {
        hoverAt(event->position());
    }
}

void LayoutView::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        return;
    }
    if (const auto hit = hitAt(event->position())) {
        emit framed(hit->place);
    } else {
        emit framedAll();
    }
}

void LayoutView::wheelEvent(QWheelEvent* event)
{
    const double notches =
        std::clamp(event->angleDelta().y() / kNotch, -kMostNotches, kMostNotches);
    if (notches != 0) {
        zoomAt(std::exp(kPerNotch * notches), event->position());
    }
    event->accept();
}

void LayoutView::zoomAt(double factor, QPointF position)
{
    const double before = m_sight.scale();
    m_sight.zoomBy(factor, {position.x(), position.y()});
    refresh();
    if (m_sight.scale() != before) {
        emit zoomed(m_sight.scale() / before);
    }
}

void LayoutView::leaveEvent(QEvent* /*event*/)
{
    if (m_drag == Drag::None) {
        emit pointedAway();
    }
}

void LayoutView::keyPressEvent(QKeyEvent* event)
{
    if (!isOwn(*event)) {
        QWidget::keyPressEvent(event);
        return;
    }
    if (const auto step = inspectStepOf(event->key())) {
        emit stepped(*step);
        return;
    }
    switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Minus: {
        const double before = m_sight.scale();
        zoomBy(std::exp(event->key() == Qt::Key_Minus ? -kPerKey : kPerKey));
        emit zoomed(m_sight.scale() / before);
        break;
    }
    case Qt::Key_1:
        showPixelForTexel();
        break;
    case Qt::Key_Space:
        emit holdToggled();
        break;
    case Qt::Key_Escape:
        emit letGo();
        break;
    default:
        emit framedAll();
        break;
    }
}

void LayoutView::focusInEvent(QFocusEvent* event)
{
    update();
    QWidget::focusInEvent(event);
}

void LayoutView::focusOutEvent(QFocusEvent* event)
{
    update();
    QWidget::focusOutEvent(event);
}

} // namespace trixel::ui
