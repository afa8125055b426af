// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/sweep_plot.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace trixel::ui {

namespace {

constexpr double kMostDegrees = 90.0;
constexpr double kGap = 8;

struct Curve
{
    const char* name;
    double SweepPoint::*value;
    bool logarithmic;
    bool percent;
};

constexpr std::array<Curve, 4> kCurves = {{
    {QT_TRANSLATE_NOOP("trixel::ui::SweepPlot", "Anisotropy"),
     &SweepPoint::anisotropy,
     true,
     false},
    {QT_TRANSLATE_NOOP("trixel::ui::SweepPlot", "Level"), &SweepPoint::level, false, false},
    {QT_TRANSLATE_NOOP("trixel::ui::SweepPlot", "Taps"), &SweepPoint::taps, true, false},
    {QT_TRANSLATE_NOOP("trixel::ui::SweepPlot", "Error"), &SweepPoint::error, false, true},
}};

double onScale(const Curve& curve, double value)
{
    return curve.logarithmic ? std::log2(std::max(value, 1.0)) : value;
}

} // namespace

SweepPlot::SweepPlot(QWidget* parent)
    : QWidget(parent)
{
    setAccessibleName(tr("Curves over the angle of the view"));
    setToolTip(tr("From face-on (left) to grazing (right): how elongated the footprint is, the "
                  "level and the taps of the chosen method, and its error in % of the value range. "
                  "Click an angle to go to it"));
}

void SweepPlot::setPoints(const std::vector<SweepPoint>& points)
{
    m_points = points;
    update();
}

void SweepPlot::setDegrees(double degrees)
{
    m_degrees = degrees;
    update();
}

/// Two by two, or four side by side where there is room.
QRectF SweepPlot::cell(int index) const
{
    const int columns = width() >= 520 ? 4 : 2;
    const int rows = 4 / columns;
    const double w = (width() - kGap * (columns - 1)) / columns;
    const double h = (height() - kGap * (rows - 1)) / rows;
    return {(index % columns) * (w + kGap), (index / columns) * (h + kGap), w, h};
}

void SweepPlot::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QFont font = painter.font();
    font.setPointSizeF(font.pointSizeF() * 0.85);
    painter.setFont(font);
    const QFontMetricsF metrics(font);
    for (int k = 0; k < 4; ++k) {
        const Curve& curve = kCurves[static_cast<std::size_t>(k)];
        const QRectF box = cell(k);
        painter.fillRect(box, palette().color(QPalette::Base));
        const QRectF plot = box.adjusted(3, metrics.height() + 2, -3, -3);
        double low = curve.percent || curve.logarithmic ? 0 : 1e30;
        double high = -1e30;
        const SweepPoint* now = nullptr;
        for (const SweepPoint& point : m_points) {
            const double value = onScale(curve, point.*curve.value);
            if (std::isfinite(value)) {
                low = std::min(low, value);
                high = std::max(high, value);
            }
            if (now == nullptr ||
                std::abs(point.degrees - m_degrees) < std::abs(now->degrees - m_degrees)) {
                now = &point;
            }
        }
        const double span = high > low ? high - low : 1;
        const auto place = [&](double degrees, double value) {
            return QPointF(plot.left() + plot.width() * degrees / kMostDegrees,
                           plot.bottom() - plot.height() * (value - low) / span);
        };
        if (m_points.empty()) {
            painter.setPen(palette().color(QPalette::PlaceholderText));
            painter.drawText(plot, Qt::AlignCenter, tr("over the angle"));
        }
        QPolygonF line;
        for (const SweepPoint& point : m_points) {
            const double value = onScale(curve, point.*curve.value);
            if (std::isfinite(value)) {
                line += place(point.degrees, value);
            }
        }
        painter.setPen(QPen(palette().color(QPalette::Mid), 1));
        const double x = plot.left() + plot.width() * m_degrees / kMostDegrees;
        painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1.6));
        painter.drawPolyline(line);
        painter.setPen(palette().color(QPalette::Text));
        const QRectF words = box.adjusted(4, 1, -4, 0);
        painter.drawText(words, Qt::AlignTop | Qt::AlignLeft, tr(curve.name));
        if (now != nullptr) {
            const double value = now->*curve.value;
            const QString text = !std::isfinite(value) ? tr("refused")
                                 : curve.percent       ? QString("%1 %").arg(100 * value, 0, 'g', 3)
                                                       : QString::number(value, 'g', 4);
            painter.drawText(words, Qt::AlignTop | Qt::AlignRight, text);
        }
    }
}

void SweepPlot::choose(QPointF position)
{
    for (int k = 0; k < 4; ++k) {
        const QRectF box = cell(k);
        if (box.contains(position)) {
            const QRectF plot = box.adjusted(3, 0, -3, 0);
            emit chosen(
                std::clamp(kMostDegrees * (position.x() - plot.left()) / plot.width(), 0.0, 89.0));
        }
    }
}

void SweepPlot::mousePressEvent(QMouseEvent* event)
{
    choose(event->position());
}

void SweepPlot::mouseMoveEvent(QMouseEvent* event)
{
    choose(event->position());
}

} // namespace trixel::ui
