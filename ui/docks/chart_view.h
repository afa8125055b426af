// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPixmap>
#include <QStringList>
#include <QWidget>

#include "ui/charts/plot_layout.h"
#include "ui/charts/plot_painter.h"
#include "ui/charts/plot_walk.h"

#include <functional>
#include <optional>

namespace trixel::ui {

/// A plot to look into: a point under the pointer, or reached by keys, says what it is; a click or
/// Enter chooses it. Points are told by their `source`, which outlives a plot that takes another's
/// place.
class ChartView : public QWidget
{
    Q_OBJECT

public:
    using Source = std::optional<std::size_t>;

    explicit ChartView(QWidget* parent = nullptr);

    /// \param describe  lines about a point, by its source
    void setPlot(Plot plot, std::function<QStringList(std::size_t source)> describe);
    const Plot& plot() const { return m_plot; }
    /// Shown in place of an empty plot.
    void setEmptyText(const QString& sentence);
    /// Rings the point in use.
    void setChosen(Source source);
    /// The point that the pointer or the keyboard is at.
    Source current() const { return m_current; }
    /// Where a point is drawn, in the widget's coordinates.
    std::optional<QPointF> positionOf(std::size_t source) const;

    QSize sizeHint() const override { return {420, 300}; }
    QSize minimumSizeHint() const override { return {200, 130}; }

signals:
    /// By click or Enter.
    void chosen(std::size_t source);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void renew();
    void paintPicture();
    void paintCurrent(QPainter& painter);
    void setCurrent(Source source);
    void lift(std::optional<std::size_t> series);
    std::optional<PlotMark> markOf(Source source) const;
    PlotTheme theme() const;
    QString spoken() const;

    Plot m_plot;
    PlotLayout m_layout;
    std::function<QStringList(std::size_t)> m_describe;
    QString m_emptyText;
    QPixmap m_picture; ///< all but what follows the pointer; null when it has to be drawn anew
    Source m_chosen;
    Source m_current;
    std::optional<std::size_t> m_lifted;
};

} // namespace trixel::ui
