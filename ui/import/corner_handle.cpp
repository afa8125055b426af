// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/corner_handle.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <optional>

namespace trixel::ui {

namespace {

constexpr int kSize = 23; // logical pixels that the pointer can take hold of
constexpr double kRing = 6;
constexpr double kFarStep = 10;

std::optional<QPointF> stepOf(const QKeyEvent& event)
{
    switch (event.key()) {
    case Qt::Key_Left:
        return QPointF(-1, 0);
    case Qt::Key_Right:
        return QPointF(1, 0);
    case Qt::Key_Up:
        return QPointF(0, -1);
    case Qt::Key_Down:
        return QPointF(0, 1);
    default:
        return std::nullopt;
    }
}

} // namespace

CornerHandle::CornerHandle(const QString& name, const QString& toolTip, QWidget* view)
    : QWidget(view)
{
    setAccessibleName(name);
    setToolTip(toolTip);
    setCursor(Qt::SizeAllCursor);
    setFocusPolicy(Qt::StrongFocus);
    resize(kSize, kSize);
    hide();
}

void CornerHandle::setPlace(QPointF place)
{
    m_place = place;
    move((place - QPointF(0.5 * kSize, 0.5 * kSize)).toPoint());
    setAccessibleDescription(
        tr("At %1, %2 pixels of the view").arg(qRound(place.x())).arg(qRound(place.y())));
}

/// The keys are the handle's before they are anybody's shortcut.
bool CornerHandle::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = static_cast<const QKeyEvent&>(*event);
        if (stepOf(key) || key.key() == Qt::Key_Tab || key.key() == Qt::Key_Backtab) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void CornerHandle::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF middle(0.5 * width(), 0.5 * height());
    // Light on dark, so that it is seen over any texels.
    painter.setPen(QPen(QColor(0, 0, 0, 190), 4.5));
    painter.drawEllipse(middle, kRing, kRing);
    const QColor ring = hasFocus() ? palette().color(QPalette::Highlight) : QColor(Qt::white);
    painter.setPen(QPen(ring, hasFocus() ? 3 : 2));
    painter.setBrush(QColor(255, 255, 255, 40));
    painter.drawEllipse(middle, kRing, kRing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ring);
    painter.drawEllipse(middle, 1.6, 1.6);
}

void CornerHandle::mousePressEvent(QMouseEvent* event)
{
    m_grabbedAt = mapTo(parentWidget(), event->position()) - m_place;
}

void CornerHandle::mouseMoveEvent(QMouseEvent* event)
{
    if (event->buttons().testFlag(Qt::LeftButton)) {
        emit moved(mapTo(parentWidget(), event->position()) - m_grabbedAt);
    }
}

void CornerHandle::keyPressEvent(QKeyEvent* event)
{
    if (const auto step = stepOf(*event)) {
        const bool isFar = event->modifiers().testFlag(Qt::ShiftModifier);
        emit moved(m_place + (isFar ? kFarStep : 1.0) * *step);
    } else if (event->key() == Qt::Key_Escape) {
        parentWidget()->setFocus();
    } else {
        QWidget::keyPressEvent(event);
    }
}

void CornerHandle::focusInEvent(QFocusEvent* event)
{
    QWidget::focusInEvent(event);
    update();
}

void CornerHandle::focusOutEvent(QFocusEvent* event)
{
    QWidget::focusOutEvent(event);
    update();
}

} // namespace trixel::ui
