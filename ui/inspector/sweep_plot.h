// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/inspector/footprint_sweep.h"

#include <vector>

namespace trixel::ui {

/// Four small curves over the angle of a tilted view: anisotropy, level, taps and error, with the
/// numbers at the angle that is looked at.
class SweepPlot : public QWidget
{
    Q_OBJECT

public:
    explicit SweepPlot(QWidget* parent = nullptr);

    void setPoints(const std::vector<SweepPoint>& points);
    const std::vector<SweepPoint>& points() const { return m_points; }
    void setDegrees(double degrees);

    QSize sizeHint() const override { return {280, 104}; }
    QSize minimumSizeHint() const override { return {160, 92}; }

signals:
    /// The pointer chose an angle.
    void chosen(double degrees);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    QRectF cell(int index) const;
    void choose(QPointF position);

    std::vector<SweepPoint> m_points;
    double m_degrees = 0;
};

} // namespace trixel::ui
