// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/quad_overlay.h"

#include <QPainter>
#include <QTransform>

#include <utility>

namespace trixel::ui {

namespace {

// Orange, which no kind of colour blindness takes for white.
constexpr QColor kUnusable(0xff, 0xa0, 0x20);

void paintLine(QPainter& painter, const QPolygonF& line, const QPen& under, const QPen& over)
{
    painter.setPen(under);
    painter.drawPolyline(line);
    painter.setPen(over);
    painter.drawPolyline(line);
}

} // namespace

QuadOverlay::QuadOverlay(QWidget* view)
    : QWidget(view)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAccessibleName(tr("Outline of the image"));
    hide();
}

void QuadOverlay::setPlaces(std::vector<std::optional<QPointF>> points, bool isUsable)
{
    m_points = std::move(points);
    m_isUsable = isUsable;
    update();
}

void QuadOverlay::setImage(const QImage& image)
{
    m_image = image;
    update();
}

void QuadOverlay::setImageOpacity(double opacity)
{
    m_opacity = opacity;
    update();
}

const std::optional<QPointF>& QuadOverlay::at(int column, int row) const
{
    return m_points[static_cast<std::size_t>(row * (kCells + 1) + column)];
}

/// As far as it is in front of the eye.
QPolygonF QuadOverlay::along(bool isRow, int number) const
{
    QPolygonF line;
    for (int k = 0; k <= kCells; ++k) {
        if (const auto& point = isRow ? at(k, number) : at(number, k)) {
            line += *point;
        }
    }
    return line;
}

/// Cell by cell, each stretched between its corners.
void QuadOverlay::paintImage(QPainter& painter) const
{
    if (m_image.isNull() || !(m_opacity > 0)) {
        return;
    }
    painter.save();
    painter.setOpacity(m_opacity);
    painter.setRenderHint(QPainter::Antialiasing, false); // no seams between cells
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const QTransform unmoved = painter.transform();
    for (int row = 0; row < kCells; ++row) {
        for (int column = 0; column < kCells; ++column) {
            const auto& a = at(column, row);
            const auto& b = at(column + 1, row);
            const auto& c = at(column + 1, row + 1);
            const auto& d = at(column, row + 1);
            if (!a || !b || !c || !d) {
                continue;
            }
            const double left = m_image.width() * double(column) / kCells;
            const double right = m_image.width() * (column + 1.0) / kCells;
            const double lower = m_image.height() * (1 - double(row) / kCells);
            const double upper = m_image.height() * (1 - (row + 1.0) / kCells);
            const QRectF part(left, upper, right - left, lower - upper);
            const QPolygonF from(
                {part.bottomLeft(), part.bottomRight(), part.topRight(), part.topLeft()});
            QTransform stretch;
            if (QTransform::quadToQuad(from, QPolygonF({*a, *b, *c, *d}), stretch)) {
                painter.setTransform(stretch * unmoved);
                painter.drawImage(part, m_image, part);
            }
        }
    }
    painter.restore();
}

void QuadOverlay::paintEvent(QPaintEvent* /*event*/)
{
    if (m_points.empty()) {
        return;
    }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_isUsable) {
        paintImage(painter);
        for (int k = 1; k < kCells; ++k) {
            for (const bool isRow : {false, true}) {
                paintLine(painter,
                          along(isRow, k),
                          QPen(QColor(0, 0, 0, 70), 2),
                          QPen(QColor(255, 255, 255, 110), 1));
            }
        }
    }
    const QColor ink = m_isUsable ? QColor(Qt::white) : kUnusable;
    const QPen outline(ink, m_isUsable ? 1.5 : 2.5, m_isUsable ? Qt::SolidLine : Qt::DashLine);
    for (const int k : {0, kCells}) {
        for (const bool isRow : {false, true}) {
            paintLine(painter, along(isRow, k), QPen(QColor(0, 0, 0, 170), 3.5), outline);
        }
    }
}

} // namespace trixel::ui
