// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/histogram_view.h"

#include <QHelpEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>

#include "ui/look/look_words.h"
#include "ui/look/value_axis.h"

#include <algorithm>
#include <cmath>

namespace trixel::ui {

namespace {

constexpr int kInset = 7; // room for half a handle at either side
constexpr int kStrip = 9;
constexpr int kHandle = 7; // half its width
constexpr double kReach = 9;
constexpr int kTickRoom = 56;
constexpr double kPad = 0.04;
/// Handles further from the values than this times their extent would squeeze them too much.
constexpr double kNear = 2.0;
constexpr double kZoomPerNotch = 1.25;

// Readable in either theme: colours add up to white over it.
constexpr QColor kGround(0x1b, 0x1b, 0x1d);
constexpr QColor kOutside(0, 0, 0, 110);

struct Extent
{
    double low = 0;
    double high = 1;

    void include(double value)
    {
        if (std::isfinite(value)) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
};

/// All but the farthest thousandths: one value far off would squeeze all others into a line.
Extent extentOf(const std::vector<HistogramView::Curve>& curves, bool isUnit)
{
    Extent extent;
    if (isUnit) {
        return extent;
    }
    bool isFirst = true;
    for (const HistogramView::Curve& curve : curves) {
        const auto low = curve.histogram->quantile(0.002);
        const auto high = curve.histogram->quantile(0.998);
        if (low && high) {
            if (std::exchange(isFirst, false)) {
                extent = {double{*low}, double{*high}};
            }
            extent.include(double{*low});
            extent.include(double{*high});
        }
    }
    return extent;
}

} // namespace

HistogramView::HistogramView(QWidget* parent)
    : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::MinimumExpanding);
    setAccessibleName(tr("Histogram of the values"));
    setToolTip(tr("How many texels have each value; drag the handles of black and white"));
}

void HistogramView::setCurves(std::vector<Curve> curves, bool isUnit)
{
    m_curves = std::move(curves);
    m_isUnit = isUnit;
    if (!m_isZoomed && m_held == Grip::None) {
        showAll();
    }
    redraw();
}

void HistogramView::setLook(const render::Look& look)
{
    if (m_look == look) {
        return;
    }
    m_look = look;
    if (!m_isZoomed && m_held == Grip::None) {
        showAll();
    }
    update();
}

void HistogramView::setLogarithmic(bool logarithmic)
{
    m_isLogarithmic = logarithmic;
    redraw();
}

void HistogramView::showAll()
{
    m_isZoomed = false;
    Extent extent = extentOf(m_curves, m_isUnit);
    const double near = kNear * (extent.high - extent.low);
    for (const float end : {m_look.blackValue(), m_look.whiteValue()}) {
        if (extent.low == extent.high ||
            (double{end} > extent.low - near && double{end} < extent.high + near)) {
            extent.include(double{end});
        }
    }
    if (!(extent.low < extent.high)) {
        const double around = std::max(std::abs(extent.low) * 0.01, 1e-6);
        extent = {extent.low - around, extent.high + around};
    }
    const double pad = kPad * (extent.high - extent.low);
    setAxis(extent.low - pad, extent.high + pad);
}

void HistogramView::setAxis(double low, double high)
{
    constexpr double kFarthest = 3e38;
    low = std::clamp(low, -kFarthest, kFarthest);
    high = std::clamp(high, -kFarthest, kFarthest);
    const double least = 1e-6 * std::max({std::abs(low), std::abs(high), 1e-30});
    if (high - low > least) {
        m_low = low;
        m_high = high;
        redraw();
    }
}

void HistogramView::redraw()
{
    m_picture = {};
    update();
}

QRect HistogramView::plot() const
{
    const int below = kStrip + kHandle + 4 + fontMetrics().height();
    return rect().adjusted(kInset, 1, -kInset, -below);
}

double HistogramView::placeOf(double value) const
{
    const QRect area = plot();
    return area.left() + (value - m_low) / (m_high - m_low) * area.width();
}

double HistogramView::valueAt(double x) const
{
    const QRect area = plot();
    return m_low + (x - area.left()) / area.width() * (m_high - m_low);
}

HistogramView::Grip HistogramView::gripAt(QPointF position) const
{
    const double black = std::abs(position.x() - placeOf(double{m_look.blackValue()}));
    const double white = std::abs(position.x() - placeOf(double{m_look.whiteValue()}));
    if (std::min(black, white) > kReach) {
        return Grip::Axis;
    }
    return black < white ? Grip::Black : Grip::White;
}

void HistogramView::moveEnd(Grip end, double value)
{
    const float black = end == Grip::Black ? static_cast<float>(value) : m_look.blackValue();
    const float white = end == Grip::White ? static_cast<float>(value) : m_look.whiteValue();
    if (black != white && std::isfinite(black) && std::isfinite(white)) {
        emit rangeEdited(black, white);
    }
}

void HistogramView::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        QWidget::mousePressEvent(event);
        return;
    }
    m_held = gripAt(event->position());
    const double value = valueAt(event->position().x());
    m_heldFrom = m_held == Grip::Black   ? double{m_look.blackValue()} - value
                 : m_held == Grip::White ? double{m_look.whiteValue()} - value
                                         : value;
}

void HistogramView::mouseMoveEvent(QMouseEvent* event)
{
    const double value = valueAt(event->position().x());
    switch (m_held) {
    case Grip::None:
        setCursor(gripAt(event->position()) == Grip::Axis ? Qt::ArrowCursor : Qt::SizeHorCursor);
        break;
    case Grip::Axis: {
        const double by = m_heldFrom - value;
        m_isZoomed = true;
        setAxis(m_low + by, m_high + by);
        break;
    }
    case Grip::Black:
    case Grip::White:
        moveEnd(m_held, value + m_heldFrom);
        break;
    }
}

void HistogramView::mouseReleaseEvent(QMouseEvent* /*event*/)
{
    m_held = Grip::None;
    if (!m_isZoomed) {
        showAll(); // a handle may have been dragged out of it
    }
}

void HistogramView::mouseDoubleClickEvent(QMouseEvent* /*event*/)
{
    showAll();
}

void HistogramView::wheelEvent(QWheelEvent* event)
{
    constexpr double kUnitsPerNotch = 120.0;
    const double factor = std::pow(kZoomPerNotch, -event->angleDelta().y() / kUnitsPerNotch);
    const double about = valueAt(event->position().x());
    m_isZoomed = true;
    setAxis(about + (m_low - about) * factor, about + (m_high - about) * factor);
    event->accept();
}

void HistogramView::keyPressEvent(QKeyEvent* event)
{
    const int key = event->key();
    if (key == Qt::Key_Left || key == Qt::Key_Right) {
        const double pixel = (m_high - m_low) / std::max(1, plot().width());
        const bool isBlack = (event->modifiers() & Qt::ShiftModifier) != 0;
        const double from = double{isBlack ? m_look.blackValue() : m_look.whiteValue()};
        moveEnd(isBlack ? Grip::Black : Grip::White, from + (key == Qt::Key_Left ? -pixel : pixel));
    } else if (key == Qt::Key_Home) {
        showAll();
    } else {
        QWidget::keyPressEvent(event);
    }
}

bool HistogramView::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<const QHelpEvent*>(event);
        QToolTip::showText(help->globalPos(), textAt(help->pos()), this);
        return true;
    }
    return QWidget::event(event);
}

QString HistogramView::textAt(QPointF position) const
{
    if (!plot().contains(position.toPoint()) || m_curves.empty()) {
        return toolTip();
    }
    // What stands in one column.
    const auto low = static_cast<float>(valueAt(std::floor(position.x())));
    const auto high = static_cast<float>(valueAt(std::floor(position.x()) + 1));
    QStringList lines{valueText(valueAt(position.x()))};
    for (const Curve& curve : m_curves) {
        const double count = low < high ? curve.histogram->parts(low, high, 1).front() : 0;
        lines +=
            tr("%1: %2 texels")
                .arg(curve.name, QLocale().toString(static_cast<qlonglong>(std::llround(count))));
    }
    return lines.join("\n");
}

void HistogramView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    redraw();
}

/// The curves, one column a device pixel; where several are, their colours add up.
QImage HistogramView::picture() const
{
    const double ratio = devicePixelRatioF();
    const QSize size = (QSizeF(plot().size()) * ratio).toSize();
    QImage image(size, QImage::Format_RGB32);
    image.fill(kGround);
    const auto low = static_cast<float>(m_low);
    const auto high = static_cast<float>(m_high);
    if (size.isEmpty() || !(low < high)) {
        return image;
    }
    const auto columns = static_cast<std::size_t>(size.width());
    std::vector<std::vector<double>> heights;
    double most = 0;
    for (const Curve& curve : m_curves) {
        heights.push_back(curve.histogram->parts(low, high, columns));
        for (double& height : heights.back()) {
            height = m_isLogarithmic ? std::log1p(height) : height;
            most = std::max(most, height);
        }
    }
    for (int x = 0; most > 0 && x < size.width(); ++x) {
        for (int y = 0; y < size.height(); ++y) {
            const double level = most * (size.height() - 1 - y) / size.height();
            int red = 0;
            int green = 0;
            int blue = 0;
            bool isFilled = false;
            for (std::size_t k = 0; k < m_curves.size(); ++k) {
                if (heights[k][static_cast<std::size_t>(x)] > level) {
                    const QColor& color = m_curves[k].color;
                    red += color.red();
                    green += color.green();
                    blue += color.blue();
                    isFilled = true;
                }
            }
            if (isFilled) {
                image.setPixel(
                    x, y, qRgb(std::min(red, 255), std::min(green, 255), std::min(blue, 255)));
            }
        }
    }
    return image;
}

void HistogramView::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    const QRect area = plot();
    if (m_picture.isNull()) {
        m_picture = picture();
    }
    painter.drawImage(area, m_picture);
    const double black = std::clamp(
        placeOf(double{m_look.blackValue()}), double(area.left()), double(area.right() + 1));
    const double white = std::clamp(
        placeOf(double{m_look.whiteValue()}), double(area.left()), double(area.right() + 1));
    const double left = std::min(black, white);
    const double right = std::max(black, white);
    painter.fillRect(QRectF(area.left(), area.top(), left - area.left(), area.height()), kOutside);
    painter.fillRect(QRectF(right, area.top(), area.right() + 1 - right, area.height()), kOutside);
    paintStrip(painter);
    paintAxis(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    paintHandle(painter, double{m_look.blackValue()}, true);
    paintHandle(painter, double{m_look.whiteValue()}, false);
    if (hasFocus()) {
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setPen(palette().color(QPalette::Highlight));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(area.adjusted(-1, -1, 0, 0));
    }
}

/// The colours of the values above it; a colour as its grey.
void HistogramView::paintStrip(QPainter& painter) const
{
    const QRect area = plot();
    const TexelFormat single{TexelType::Float, 1, {}};
    render::Look alone = m_look;
    alone.channel = 0;
    alone.marks = false;
    const render::LookRule rule = render::LookRule::of(single, alone);
    for (int x = area.left(); x <= area.right(); ++x) {
        const auto value = static_cast<float>(valueAt(x + 0.5));
        const render::Rgba color = render::shade(rule, {&value, 1});
        painter.fillRect(x, area.bottom() + 2, 1, kStrip, QColor(color[0], color[1], color[2]));
    }
}

void HistogramView::paintAxis(QPainter& painter) const
{
    const QRect area = plot();
    const QFontMetrics metrics = fontMetrics();
    const int base = rect().bottom() - metrics.descent();
    painter.setPen(palette().color(QPalette::WindowText));
    int free = 0;
    for (const AxisTick& tick : roundTicks(m_low, m_high, std::max(2, area.width() / kTickRoom))) {
        const int width = metrics.horizontalAdvance(tick.text);
        const int at = static_cast<int>(std::lround(placeOf(tick.value)));
        const int left = std::clamp(at - width / 2, 0, this->width() - width);
        if (left >= free) {
            painter.drawText(left, base, tick.text);
            free = left + width + 6;
        }
    }
}

void HistogramView::paintHandle(QPainter& painter, double value, bool isBlack) const
{
    const QRect area = plot();
    const double x = placeOf(value);
    if (x < area.left() - 1 || x > area.right() + 2) {
        return; // out of sight
    }
    painter.setPen(QPen(QColor(255, 255, 255, isBlack ? 120 : 220), 1));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom() + 1));
    const double top = area.bottom() + kStrip - 1;
    const QPolygonF shape{{QPointF(x, top),
                           QPointF(x + kHandle, top + kHandle + 4),
                           QPointF(x - kHandle, top + kHandle + 4)}};
    painter.setPen(QPen(isBlack ? QColor(0xd0, 0xd0, 0xd0) : QColor(0x30, 0x30, 0x30), 1.2));
    painter.setBrush(isBlack ? Qt::black : Qt::white);
    painter.drawPolygon(shape);
}

} // namespace trixel::ui
