// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/plot_painter.h"

#include <QFontMetricsF>
#include <QImage>
#include <QPainter>
#include <QPolygonF>

#include "ui/charts/plot_text.h"

#include <algorithm>
#include <cmath>

namespace trixel::ui {

namespace {

constexpr double kFaded = 0.18;
constexpr double kLineWidth = 1.5;
constexpr double kFrontWidth = 5;
constexpr double kTickLength = 4;
constexpr double kGap = 4;
constexpr double kLegendLine = 20;

QColor seriesColor(const PlotSeries& series, const PlotTheme& theme)
{
    return series.isPeer ? theme.faint : colorOf(series.look, theme);
}

/// Between the series' colour and the text's: belongs to the curve and can be read.
QColor nameColor(const PlotSeries& series, const PlotTheme& theme)
{
    const QColor a = seriesColor(series, theme);
    const QColor& b = theme.text;
    constexpr double kOwn = 0.6;
    return QColor::fromRgbF(static_cast<float>(kOwn * a.redF() + (1 - kOwn) * b.redF()),
                            static_cast<float>(kOwn * a.greenF() + (1 - kOwn) * b.greenF()),
                            static_cast<float>(kOwn * a.blueF() + (1 - kOwn) * b.blueF()));
}

QPen linePen(const PlotSeries& series, const PlotTheme& theme, double width = kLineWidth)
{
    QPen pen(seriesColor(series, theme), width);
    pen.setCapStyle(Qt::FlatCap); // markers cover the joints; round caps cost more than the lines
    return pen;
}

/// Whether drawing each marker by itself would take more than a few milliseconds.
bool isCrowded(const Plot& plot)
{
    constexpr std::size_t kFew = 100;
    std::size_t points = 0;
    for (const PlotSeries& series : plot.series) {
        points += series.points.size();
    }
    return points > kFew;
}

/// Draws the parts of one plot, one after the other, from back to front.
class PlotPainter
{
public:
    PlotPainter(QPainter& painter,
                const Plot& plot,
                const PlotLayout& layout,
                const PlotFonts& fonts,
                const PlotLook& look)
        : m_painter(painter)
        , m_plot(plot)
        , m_layout(layout)
        , m_fonts(fonts)
        , m_look(look)
        , m_text(painter, look.lettering)
        , m_isCrowded(isCrowded(plot))
    {
    }

    void paintGrid();
    void paintAxisNames();
    void paintFront();
    void paintLevel();
    void paintSeries();
    void paintLabels();
    void paintLegend();
    void paintHeading();

private:
    double opacityOf(std::size_t series) const
    {
        return m_look.lifted && *m_look.lifted != series ? kFaded : 1;
    }
    const PlotTheme& theme() const { return m_look.theme; }
    void paintXNumber(double x, const QString& number);
    void paintMarkers(const PlotSeries& series);
    QImage stampOf(const PlotSeries& series) const;

    QPainter& m_painter;
    const Plot& m_plot;
    const PlotLayout& m_layout;
    const PlotFonts& m_fonts;
    const PlotLook& m_look;
    PlotText m_text;
    bool m_isCrowded;
};

void PlotPainter::paintGrid()
{
    const QRectF& frame = m_layout.frame;
    const double height = QFontMetricsF(m_fonts.small).height();
    // Straight lines are sharper and quicker without; fine ones first, so that they never cross a
    // numbered one.
    m_painter.setRenderHint(QPainter::Antialiasing, false);
    for (const bool numbered : {false, true}) {
        m_painter.setPen(QPen(numbered ? theme().grid : theme().fineGrid, 1));
        for (const Tick& tick : m_layout.xTicks) {
            if (tick.text.isEmpty() != numbered) {
                const double x = frame.left() + tick.place * frame.width();
                m_painter.drawLine(QLineF(x, frame.top(), x, frame.bottom()));
            }
        }
        for (const Tick& tick : m_layout.yTicks) {
            if (tick.text.isEmpty() != numbered) {
                const double y = frame.bottom() - tick.place * frame.height();
                m_painter.drawLine(QLineF(frame.left(), y, frame.right(), y));
            }
        }
    }
    m_painter.setRenderHint(QPainter::Antialiasing);
    for (const Tick& tick : m_layout.xTicks) {
        if (!tick.text.isEmpty()) {
            paintXNumber(frame.left() + tick.place * frame.width(), tick.text);
        }
    }
    for (const Tick& tick : m_layout.yTicks) {
        if (!tick.text.isEmpty()) {
            const double y = frame.bottom() - tick.place * frame.height();
            m_text.draw(QRectF(0, y - height / 2, frame.left() - kGap, height),
                        Qt::AlignRight | Qt::AlignVCenter,
                        tick.text,
                        m_fonts.small,
                        theme().faint);
        }
    }
    m_painter.setPen(QPen(theme().faint, 1));
    m_painter.drawLine(frame.bottomLeft(), frame.bottomRight());
    m_painter.drawLine(frame.bottomLeft(), frame.topLeft());
}

void PlotPainter::paintXNumber(double x, const QString& number)
{
    const QFontMetricsF metrics(m_fonts.small);
    const double width = metrics.horizontalAdvance(number);
    const double bottom = m_layout.frame.bottom();
    // The outermost stay inside.
    const double left = std::clamp(x - width / 2, 0.0, m_layout.size.width() - width - 2);
    m_text.draw(QRectF(left, bottom + kGap, width, metrics.height()),
                Qt::AlignCenter,
                number,
                m_fonts.small,
                theme().faint);
    m_painter.setPen(QPen(theme().faint, 1));
    m_painter.drawLine(QLineF(x, bottom, x, bottom + kTickLength));
}

void PlotPainter::paintAxisNames()
{
    const QRectF& frame = m_layout.frame;
    const double height = QFontMetricsF(m_fonts.text).height();
    const double ticks = QFontMetricsF(m_fonts.small).height();
    m_text.draw(QRectF(m_layout.edge, frame.top() - height - kGap, frame.right(), height),
                Qt::AlignLeft | Qt::AlignVCenter,
                m_plot.y.title,
                m_fonts.text,
                theme().text);
    m_text.draw(QRectF(0, frame.bottom() + ticks + kGap, frame.right(), height),
                Qt::AlignRight | Qt::AlignVCenter,
                m_plot.x.title,
                m_fonts.text,
                theme().text);
}

void PlotPainter::paintFront()
{
    QPen pen(theme().front, kFrontWidth);
    pen.setJoinStyle(Qt::MiterJoin);
    pen.setCapStyle(Qt::FlatCap);
    m_painter.setPen(pen);
    m_painter.setBrush(Qt::NoBrush);
    m_painter.drawPolyline(frontLine(m_plot, m_layout));
}

void PlotPainter::paintLevel()
{
    if (!m_plot.level) {
        return;
    }
    const double y = m_layout.yAt(m_plot.level->y);
    QPen pen(theme().level, 1.2);
    pen.setStyle(Qt::DashDotLine);
    m_painter.setPen(pen);
    m_painter.drawLine(QLineF(m_layout.frame.left(), y, m_layout.frame.right(), y));
    m_text.draw(m_layout.levelName,
                Qt::AlignCenter,
                m_plot.level->name,
                m_fonts.small,
                theme().level,
                theme().background);
}

void PlotPainter::paintSeries()
{
    for (std::size_t s = 0; s < m_plot.series.size(); ++s) {
        const PlotSeries& series = m_plot.series[s];
        // One by one: stroking a curve that crosses itself often takes a hundred times as long.
        QList<QLineF> lines;
        for (std::size_t p = 1; isCurve(series) && p < series.points.size(); ++p) {
            lines += QLineF(m_layout.at(series.points[p - 1]), m_layout.at(series.points[p]));
        }
        m_painter.setOpacity(opacityOf(s));
        m_painter.setPen(linePen(series, theme(), m_layout.lineWidth));
        m_painter.drawLines(lines);
    }
    for (std::size_t s = 0; s < m_plot.series.size(); ++s) {
        m_painter.setOpacity(opacityOf(s));
        paintMarkers(m_plot.series[s]);
    }
    m_painter.setOpacity(1);
    if (m_look.chosen) {
        const QPointF at = m_layout.at(pointOf(m_plot, *m_look.chosen));
        paintRing(m_painter, at, 2.1 * m_layout.markRadius, theme().text);
    }
}

/// A series' marker, drawn once to be stamped many times.
QImage PlotPainter::stampOf(const PlotSeries& series) const
{
    const double ratio = m_painter.device()->devicePixelRatioF();
    const double half = std::ceil(2 * m_layout.markRadius);
    QImage stamp((QSizeF(2 * half, 2 * half) * ratio).toSize(),
                 QImage::Format_ARGB32_Premultiplied);
    stamp.setDevicePixelRatio(ratio);
    stamp.fill(Qt::transparent);
    QPainter painter(&stamp);
    painter.setRenderHint(QPainter::Antialiasing);
    paintMarker(painter, series, {half, half}, m_layout.markRadius, theme());
    return stamp;
}

void PlotPainter::paintMarkers(const PlotSeries& series)
{
    if (m_look.lettering == Lettering::Outlines || !m_isCrowded) {
        for (const PlotPoint& point : series.points) {
            paintMarker(m_painter, series, m_layout.at(point), m_layout.markRadius, theme());
        }
        return;
    }
    const QImage stamp = stampOf(series);
    const double ratio = stamp.devicePixelRatio();
    const QPointF middle = QRectF(QPointF(), QSizeF(stamp.size()) / ratio).center();
    for (const PlotPoint& point : series.points) {
        // On whole pixels a stamp is copied, elsewhere it is resampled.
        const QPointF corner = (m_layout.at(point) - middle) * ratio;
        m_painter.drawImage(QPointF(std::round(corner.x()), std::round(corner.y())) / ratio, stamp);
    }
}

void PlotPainter::paintLabels()
{
    for (const PlacedLabel& label : m_layout.labels) {
        m_painter.setOpacity(opacityOf(label.series));
        m_text.draw(label.box,
                    Qt::AlignCenter,
                    label.text,
                    m_fonts.small,
                    label.isTag ? theme().faint : nameColor(m_plot.series[label.series], theme()),
                    theme().background);
    }
    m_painter.setOpacity(1);
}

void PlotPainter::paintLegend()
{
    for (const LegendEntry& entry : m_layout.legend) {
        const QPointF left(entry.box.left(), entry.box.center().y());
        const QLineF sample(left, left + QPointF(kLegendLine, 0));
        QString name = m_plot.frontName;
        if (entry.series) {
            const PlotSeries& series = m_plot.series[*entry.series];
            m_painter.setOpacity(opacityOf(*entry.series));
            if (isCurve(series)) {
                m_painter.setPen(linePen(series, theme()));
                m_painter.drawLine(sample);
            }
            paintMarker(m_painter, series, sample.center(), m_layout.markRadius, theme());
            name = series.name;
        } else {
            m_painter.setPen(QPen(theme().front, kFrontWidth, Qt::SolidLine, Qt::FlatCap));
            m_painter.drawLine(sample);
        }
        m_text.draw(entry.box.adjusted(kLegendLine + kGap, 0, kGap, 0),
                    Qt::AlignLeft | Qt::AlignVCenter,
                    name,
                    m_fonts.small,
                    theme().text);
        m_painter.setOpacity(1);
    }
}

void PlotPainter::paintHeading()
{
    if (m_layout.heading.isValid()) {
        const double below =
            m_text.drawWrapped(m_layout.heading, m_plot.title, m_fonts.title, theme().text);
        m_text.drawWrapped(m_layout.heading.adjusted(0, below, 0, 0),
                           m_plot.subtitle,
                           m_fonts.text,
                           theme().faint);
    }
    if (m_layout.note.isValid()) {
        m_text.drawWrapped(m_layout.note, m_plot.note, m_fonts.small, theme().faint);
    }
}

} // namespace

void paintMarker(QPainter& painter,
                 const PlotSeries& series,
                 const QPointF& at,
                 double radius,
                 const PlotTheme& theme)
{
    const QColor color = seriesColor(series, theme);
    const QPainterPath shape =
        QTransform(radius, 0, 0, radius, at.x(), at.y()).map(shapeOf(series.look));
    // A rim of the background parts markers that overlap.
    painter.setPen(series.isPeer ? QPen(color, 1.4) : QPen(theme.background, 1));
    painter.setBrush(series.isPeer ? theme.background : color);
    painter.drawPath(shape);
}

void paintRing(QPainter& painter, const QPointF& at, double radius, const QColor& color)
{
    painter.setPen(QPen(color, 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(at, radius, radius);
}

void paintPlot(QPainter& painter,
               const Plot& plot,
               const PlotLayout& layout,
               const PlotFonts& fonts,
               const PlotLook& look)
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(QRectF(QPointF(), layout.size), look.theme.background);
    PlotPainter parts(painter, plot, layout, fonts, look);
    parts.paintHeading();
    parts.paintGrid();
    parts.paintAxisNames();
    parts.paintFront();
    parts.paintLevel();
    parts.paintSeries();
    parts.paintLabels();
    parts.paintLegend();
}

} // namespace trixel::ui
