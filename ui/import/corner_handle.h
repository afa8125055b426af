// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace trixel::ui {

/// A corner of an image in the view: dragged by the left button, or moved by the arrow keys, with
/// Shift ten times as far. Tab goes to the next.
class CornerHandle : public QWidget
{
    Q_OBJECT

public:
    /// \param view  the widget that it lies in
    CornerHandle(const QString& name, const QString& toolTip, QWidget* view);

    /// Where its middle is, in the view's own pixels.
    QPointF place() const { return m_place; }
    /// Tells nobody.
    void setPlace(QPointF place);

signals:
    /// By the user's hand. \param place  as `place`
    void moved(QPointF place);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    QPointF m_place;
    QPointF m_grabbedAt; ///< from its middle
};

} // namespace trixel::ui
