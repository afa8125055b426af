// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/chart_view.h"

#include <QAccessible>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include "ui/charts/callout.h"

#include <utility>

namespace trixel::ui {

namespace {

constexpr double kReach = 12; ///< of the pointer, in pixels
constexpr PlotParts kParts{.heading = false, .note = false};

std::optional<PlotStep> stepOf(const QKeyEvent& event)
{
    const bool alongFront = event.modifiers().testFlag(Qt::ControlModifier);
    switch (event.key()) {
    case Qt::Key_Right:
        return alongFront ? PlotStep::NextOnFront : PlotStep::NextOnCurve;
    case Qt::Key_Left:
        return alongFront ? PlotStep::LastOnFront : PlotStep::LastOnCurve;
    case Qt::Key_Down:
        return PlotStep::NextCurve;
    case Qt::Key_Up:
        return PlotStep::LastCurve;
    case Qt::Key_Home:
        return PlotStep::FrontStart;
    case Qt::Key_End:
        return PlotStep::FrontEnd;
    default:
        return std::nullopt;
    }
}

} // namespace

ChartView::ChartView(QWidget* parent)
    : QWidget(parent)
{
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void ChartView::setPlot(Plot plot, std::function<QStringList(std::size_t)> describe)
{
    m_plot = std::move(plot);
    m_describe = std::move(describe);
    m_lifted.reset();
    if (!markOf(m_current)) {
        setCurrent({});
    }
    renew();
}

void ChartView::setEmptyText(const QString& sentence)
{
    m_emptyText = sentence;
    renew();
}

void ChartView::setChosen(Source source)
{
    if (m_chosen != source) {
        m_chosen = source;
        m_picture = {};
        update();
    }
}

std::optional<QPointF> ChartView::positionOf(std::size_t source) const
{
    const auto mark = markOf(source);
    return mark ? std::optional(m_layout.at(pointOf(m_plot, *mark))) : std::nullopt;
}

std::optional<PlotMark> ChartView::markOf(Source source) const
{
    for (std::size_t s = 0; source && s < m_plot.series.size(); ++s) {
        const auto& points = m_plot.series[s].points;
        for (std::size_t p = 0; p < points.size(); ++p) {
            if (points[p].source == *source) {
                return PlotMark{s, p};
            }
        }
    }
    return std::nullopt;
}

PlotTheme ChartView::theme() const
{
    constexpr int kMiddle = 128;
    const QColor paper = palette().color(QPalette::Base);
    PlotTheme theme = paper.lightness() < kMiddle ? darkPlotTheme() : lightPlotTheme();
    theme.background = paper;
    theme.text = palette().color(QPalette::Text);
    return theme;
}

void ChartView::renew()
{
    m_layout = layOut(m_plot, size(), PlotFonts(font()), kParts);
    m_picture = {};
    update();
}

void ChartView::paintPicture()
{
    const double ratio = devicePixelRatioF();
    m_picture = QPixmap((QSizeF(size()) * ratio).toSize());
    m_picture.setDevicePixelRatio(ratio);
    QPainter painter(&m_picture);
    const PlotLook look{.theme = theme(),
                        .lettering = Lettering::Text,
                        .lifted = m_lifted,
                        .chosen = markOf(m_chosen)};
    paintPlot(painter, m_plot, m_layout, PlotFonts(font()), look);
}

void ChartView::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    if (m_plot.isEmpty()) {
        painter.fillRect(rect(), theme().background);
        painter.setPen(theme().faint);
        painter.drawText(
            rect().adjusted(16, 8, -16, -8), Qt::AlignCenter | Qt::TextWordWrap, m_emptyText);
    } else {
        if (m_picture.isNull() || m_picture.devicePixelRatio() != devicePixelRatioF()) {
            paintPicture();
        }
        painter.drawPixmap(0, 0, m_picture);
        paintCurrent(painter);
    }
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

void ChartView::paintCurrent(QPainter& painter)
{
    const std::optional<PlotMark> mark = markOf(m_current);
    if (!mark) {
        return;
    }
    constexpr double kLarger = 1.5;
    const QPointF at = m_layout.at(pointOf(m_plot, *mark));
    const PlotFonts fonts{font()};
    painter.setRenderHint(QPainter::Antialiasing);
    paintMarker(painter, m_plot.series[mark->series], at, kLarger * m_layout.markRadius, theme());
    paintRing(painter, at, 2.1 * m_layout.markRadius, palette().color(QPalette::Highlight));
    const QStringList lines = m_describe(*m_current);
    paintCallout(painter, lines, fonts, theme(), calloutBox(lines, fonts, at, m_plot, m_layout));
}

QString ChartView::spoken() const
{
    return m_current && m_describe ? m_describe(*m_current).join(", ") : QString();
}

void ChartView::setCurrent(Source source)
{
    if (m_current == source) {
        return;
    }
    m_current = source;
    setAccessibleDescription(spoken());
    QAccessibleEvent changed(this, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&changed);
    update();
}

void ChartView::lift(std::optional<std::size_t> series)
{
    if (m_lifted != series) {
        m_lifted = series;
        m_picture = {};
        update();
    }
}

void ChartView::resizeEvent(QResizeEvent* /*event*/)
{
    renew();
}

void ChartView::mouseMoveEvent(QMouseEvent* event)
{
    const std::optional<PlotMark> mark = markAt(m_plot, m_layout, event->position(), kReach);
    setCurrent(mark ? Source(pointOf(m_plot, *mark).source) : Source());
    lift(legendSeriesAt(m_layout, event->position()));
    const bool canChoose = mark && !m_plot.series[mark->series].isPeer;
    setCursor(canChoose ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

void ChartView::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        return;
    }
    if (const auto mark = markAt(m_plot, m_layout, event->position(), kReach)) {
        emit chosen(pointOf(m_plot, *mark).source);
    }
}

void ChartView::leaveEvent(QEvent* /*event*/)
{
    setCurrent({});
    lift({});
}

void ChartView::keyPressEvent(QKeyEvent* event)
{
    if (const auto wanted = stepOf(*event)) {
        const Source from = m_current ? m_current : m_chosen;
        const auto mark = step(m_plot, markOf(from), *wanted);
        setCurrent(mark ? Source(pointOf(m_plot, *mark).source) : Source());
    } else if (m_current && (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)) {
        emit chosen(*m_current);
    } else if (m_current && event->key() == Qt::Key_Escape) {
        setCurrent({});
    } else {
        QWidget::keyPressEvent(event);
    }
}

void ChartView::focusOutEvent(QFocusEvent* event)
{
    setCurrent({});
    QWidget::focusOutEvent(event);
}

void ChartView::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange ||
        event->type() == QEvent::StyleChange) {
        renew();
    }
    QWidget::changeEvent(event);
}

} // namespace trixel::ui
