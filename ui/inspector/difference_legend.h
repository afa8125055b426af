// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace trixel::ui {

/// The scale of `differenceColor` with the numbers at its ends.
class DifferenceLegend : public QWidget
{
    Q_OBJECT

public:
    explicit DifferenceLegend(QWidget* parent = nullptr);

    /// \param range  at the scale's ends; 0 where nothing differs
    void setRange(double range);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }
    /// Draws it elsewhere, with letters of that colour.
    void paint(QPainter& painter, const QRectF& place, const QColor& ink) const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    double m_range = 0;
};

} // namespace trixel::ui
