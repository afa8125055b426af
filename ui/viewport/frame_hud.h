// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>

#include "render/frame_figures.h"

#include <utility>
#include <vector>

namespace trixel::ui {

/// Figures of the frames, in the lower right corner of the view: times, what was drawn, what lies
/// on the graphics card. They change a few times a second, so that they can be read.
class FrameHud : public QWidget
{
    Q_OBJECT

public:
    explicit FrameHud(QWidget* view);

    /// One more frame was drawn.
    void take(const render::FrameFigures& figures);
    /// Takes the corner again, after the view has changed its size.
    void place();

    /// What is written: a name and a figure a line.
    using Line = std::pair<QString, QString>;
    const std::vector<Line>& lines() const { return m_lines; }

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void write(const render::FrameFigures& figures);

    render::FrameFigures m_latest;
    double m_longest = 0; ///< processor time of the slowest frame since the lines were written
    QTimer m_turn;        ///< until they are written again
    std::vector<Line> m_lines;
};

} // namespace trixel::ui
