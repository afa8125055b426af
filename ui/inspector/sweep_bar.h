// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>

#include "ui/inspector/sweep_plot.h"

class QLabel;
class QSlider;
class QToolButton;

namespace trixel::ui {

/// Plays the angle of a tilted view from face-on to grazing and back, again and again, until it is
/// paused; beside it the curves of what that does.
class SweepBar : public QWidget
{
    Q_OBJECT

public:
    explicit SweepBar(QWidget* parent = nullptr);

    SweepPlot& plot() { return *m_plot; }
    bool isPlaying() const { return m_clock.isActive(); }
    void setPlaying(bool plays);
    /// Shows an angle that was chosen elsewhere.
    void setDegrees(double degrees);

signals:
    /// The angle to look from, chosen or played.
    void degreesChosen(double degrees);
    void playingChanged(bool plays);

private:
    void step();

    QToolButton* m_play;
    QSlider* m_slider;
    QLabel* m_angle;
    SweepPlot* m_plot;
    QTimer m_clock;
    double m_degrees = 0;
    double m_direction = 1;
};

} // namespace trixel::ui
