// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/sweep_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace trixel::ui {

namespace {

constexpr int kMostDegrees = 89;
constexpr int kFrameMs = 40;
constexpr double kDegreesPerFrame = 1.0;

} // namespace

SweepBar::SweepBar(QWidget* parent)
    : QWidget(parent)
    , m_play(new QToolButton)
    , m_slider(new QSlider(Qt::Horizontal))
    , m_angle(new QLabel)
    , m_plot(new SweepPlot)
{
    m_play->setCheckable(true);
    m_play->setAccessibleName(tr("Play the sweep"));
    m_play->setToolTip(tr("Tilt the view over this texel from face-on to grazing and back; the "
                          "view on the surface stays as it is"));
    m_play->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_slider->setRange(0, kMostDegrees);
    m_slider->setPageStep(10);
    m_slider->setAccessibleName(tr("Angle of the tilted view"));
    m_slider->setToolTip(tr("Degrees between the view and the normal of the face: 0 is face-on, "
                            "90 grazing"));
    m_angle->setMinimumWidth(m_angle->fontMetrics().horizontalAdvance("88°"));
    m_angle->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    auto* row = new QHBoxLayout;
    row->addWidget(m_play);
    row->addWidget(m_slider, 1);
    row->addWidget(m_angle);
    layout->addLayout(row);
    layout->addWidget(m_plot);
    m_clock.setInterval(kFrameMs);
    connect(&m_clock, &QTimer::timeout, this, &SweepBar::step);
    connect(m_play, &QToolButton::toggled, this, &SweepBar::setPlaying);
    connect(m_slider, &QSlider::valueChanged, this, [this](int degrees) {
        m_degrees = degrees;
        emit degreesChosen(degrees);
    });
    connect(m_plot, &SweepPlot::chosen, this, &SweepBar::degreesChosen);
    setPlaying(false);
    setDegrees(0);
}

void SweepBar::setPlaying(bool plays)
{
    const QSignalBlocker quiet(m_play);
    m_play->setChecked(plays);
    m_play->setText(plays ? tr("Pause") : tr("Play"));
    m_play->setIcon(style()->standardIcon(plays ? QStyle::SP_MediaPause : QStyle::SP_MediaPlay));
    if (plays == m_clock.isActive()) {
        return;
    }
    if (plays) {
        m_clock.start();
        emit degreesChosen(m_degrees);
    } else {
        m_clock.stop();
    }
    emit playingChanged(plays);
}

void SweepBar::setDegrees(double degrees)
{
    m_degrees = degrees;
    const QSignalBlocker quiet(m_slider);
    m_slider->setValue(qRound(degrees));
    m_angle->setText(QString("%1°").arg(qRound(degrees)));
    m_plot->setDegrees(degrees);
}

void SweepBar::step()
{
    double next = m_degrees + m_direction * kDegreesPerFrame;
    if (next >= kMostDegrees || next <= 0) {
        m_direction = next <= 0 ? 1 : -1;
        next = std::clamp(next, 0.0, double{kMostDegrees});
    }
    m_degrees = next;
    emit degreesChosen(next);
}

} // namespace trixel::ui
