// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/mip_cells.h"

#include <algorithm>
#include <cmath>

namespace trixel::ui {

namespace {

constexpr double kGap = 8;
constexpr double kSmallestCell = 8;
constexpr double kNarrowestTrueSize = 16; // of a level's place, for its number and a ring
constexpr double kRoomForRing = 8;
constexpr double kNarrowGap = 4;

double heightOf(double side, FaceLayout::Texels texels)
{
    return texels == FaceLayout::Texels::Triangles ? side * std::sqrt(0.75) : side;
}

/// V0 at the lower left, V1 at the lower right, as in the face's own plane.
FaceLayout layoutIn(const QRectF& picture, FaceLayout::Texels texels)
{
    const glm::dvec2 v0(picture.left(), picture.bottom());
    if (texels == FaceLayout::Texels::Triangles) {
        return FaceLayout::triangle(
            v0, {picture.right(), picture.bottom()}, {picture.center().x(), picture.top()});
    }
    return FaceLayout::packed().moved({v0, {picture.width(), 0}, {0, -picture.height()}});
}

MipCell cellAt(
    Level level, QPointF corner, double width, double side, double label, FaceLayout::Texels texels)
{
    MipCell cell;
    cell.level = level;
    cell.label = {corner.x(), corner.y(), width, label};
    cell.picture = {
        corner.x() + (width - side) / 2, corner.y() + label, side, heightOf(side, texels)};
    cell.layout = layoutIn(cell.picture, texels);
    return cell;
}

/// Side of a cell with that many beside each other.
double sideFor(int columns, int count, QSizeF room, double label, FaceLayout::Texels texels)
{
    const int rows = (count + columns - 1) / columns;
    const double wide = (room.width() - (columns + 1) * kGap) / columns;
    const double high = (room.height() - (rows + 1) * kGap) / rows - label;
    return std::min(wide, high / heightOf(1, texels));
}

std::vector<MipCell> placeAlike(Level base, QSizeF room, FaceLayout::Texels texels, double label)
{
    const int count = base.log2() + 1;
    int columns = 1;
    for (int more = 2; more <= count; ++more) {
        if (sideFor(more, count, room, label, texels) >
            sideFor(columns, count, room, label, texels)) {
            columns = more;
        }
    }
    // A whole number of pixels: edges along pixels are sharp.
    const double side =
        std::max(kSmallestCell, std::floor(sideFor(columns, count, room, label, texels)));
    // The last row is as full as the others where that takes no more rows.
    const int rows = (count + columns - 1) / columns;
    columns = (count + rows - 1) / rows;
    const double place = (room.width() - kGap) / columns;
    std::vector<MipCell> cells;
    for (int k = 0; k < count; ++k) {
        const QPointF corner(
            std::round(kGap + (k % columns) * place),
            std::round(kGap + (k / columns) * (label + heightOf(side, texels) + kGap)));
        cells.push_back(
            cellAt(base.coarser(k), corner, std::floor(place - kGap), side, label, texels));
    }
    return cells;
}

double trueSide(double finest, int steps)
{
    return std::max(1.0, std::ldexp(finest, -steps));
}

/// Width of all levels beside each other.
double trueWidth(double finest, int count)
{
    double width = kNarrowGap;
    for (int k = 0; k < count; ++k) {
        width += std::max(kNarrowestTrueSize, trueSide(finest, k)) + kNarrowGap;
    }
    return width;
}

std::vector<MipCell>
placeTrueSizes(Level base, QSizeF room, FaceLayout::Texels texels, double label)
{
    const int count = base.log2() + 1;
    double side = std::floor(std::min(
        room.width(), (room.height() - 2 * kGap - kRoomForRing - label) / heightOf(1, texels)));
    while (side > kSmallestCell && trueWidth(side, count) > room.width()) {
        --side;
    }
    side = std::max(side, kSmallestCell);
    std::vector<MipCell> cells;
    double left = kNarrowGap;
    const double bottom = kGap + kRoomForRing + label + heightOf(side, texels);
    for (int k = 0; k < count; ++k) {
        const double own = trueSide(side, k);
        const double width = std::max(kNarrowestTrueSize, own);
        const double top = bottom - label - heightOf(own, texels);
        // A texel too small to see has a ring around it: see the painter.
        const double lift = k > 0 && own < 2 * kRoomForRing ? kRoomForRing : 0;
        cells.push_back(cellAt(base.coarser(k), {left, top}, width, own, label, texels));
        cells.back().label.translate(0, -lift);
        left += width + kNarrowGap;
    }
    return cells;
}

} // namespace

std::vector<MipCell>
placeMips(Level base, QSizeF room, const MipArrangement& arrangement, double lineHeight, int lines)
{
    return arrangement.trueSize ? placeTrueSizes(base, room, arrangement.texels, lineHeight)
                                : placeAlike(base, room, arrangement.texels, lines * lineHeight);
}

} // namespace trixel::ui
