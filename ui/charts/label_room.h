// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineF>
#include <QRectF>

#include <vector>

namespace trixel::ui {

/// Which parts of a plot are taken: a coarse grid of cells, so that finding room for a name costs
/// the same however many points there are.
class LabelRoom
{
public:
    explicit LabelRoom(const QRectF& area);

    void take(const QRectF& box) { mark(box, kTaken); }
    void take(const QLineF& line);
    /// Lines may be written over where there is nowhere else, other things may not.
    double cost(const QRectF& box) const;
    /// Whether the box is inside and holds nothing.
    bool isFree(const QRectF& box) const { return cost(box) == 0; }

    /// The cost of a box over something that must not be covered, or outside.
    static constexpr double kImpossible = 1e9;

private:
    enum Cell : unsigned char { kFree, kCrossed, kTaken };
    void mark(const QRectF& box, Cell value);
    QRect cellsOf(const QRectF& box) const;

    QRectF m_area;
    int m_columns;
    int m_rows;
    std::vector<unsigned char> m_cells;
};

} // namespace trixel::ui
