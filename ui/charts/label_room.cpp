// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/label_room.h"

#include <algorithm>
#include <cmath>

namespace trixel::ui {

namespace {

constexpr double kCell = 3;

}

LabelRoom::LabelRoom(const QRectF& area)
    : m_area(area)
    , m_columns(std::max(1, static_cast<int>(std::ceil(area.width() / kCell))))
    , m_rows(std::max(1, static_cast<int>(std::ceil(area.height() / kCell))))
    , m_cells(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows), kFree)
{
}

QRect LabelRoom::cellsOf(const QRectF& box) const
{
    const QPointF from = (box.topLeft() - m_area.topLeft()) / kCell;
    const QPointF to = (box.bottomRight() - m_area.topLeft()) / kCell;
    const QPoint first(static_cast<int>(std::floor(from.x())),
                       static_cast<int>(std::floor(from.y())));
    const QPoint last(static_cast<int>(std::ceil(to.x())) - 1,
                      static_cast<int>(std::ceil(to.y())) - 1);
    return QRect(first, last).intersected(QRect(0, 0, m_columns, m_rows));
}

void LabelRoom::mark(const QRectF& box, Cell value)
{
    const QRect cells = cellsOf(box);
    for (int y = cells.top(); y <= cells.bottom(); ++y) {
        for (int x = cells.left(); x <= cells.right(); ++x) {
            unsigned char& cell = m_cells[static_cast<std::size_t>(y * m_columns + x)];
            cell = std::max<unsigned char>(cell, value);
        }
    }
}

void LabelRoom::take(const QLineF& line)
{
    const int steps = static_cast<int>(line.length() / kCell) + 1;
    for (int k = 0; k <= steps; ++k) {
        const QPointF at = line.pointAt(static_cast<double>(k) / steps);
        mark(QRectF(at.x() - 0.5, at.y() - 0.5, 1, 1), kCrossed);
    }
}

double LabelRoom::cost(const QRectF& box) const
{
    if (!m_area.contains(box)) {
        return kImpossible;
    }
    const QRect cells = cellsOf(box);
    int crossed = 0;
    for (int y = cells.top(); y <= cells.bottom(); ++y) {
        for (int x = cells.left(); x <= cells.right(); ++x) {
            const unsigned char cell = m_cells[static_cast<std::size_t>(y * m_columns + x)];
            if (cell == kTaken) {
                return kImpossible;
            }
            crossed += cell == kCrossed ? 1 : 0;
        }
    }
    return crossed;
}

} // namespace trixel::ui
