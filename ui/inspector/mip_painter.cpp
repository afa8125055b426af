// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/mip_painter.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>

#include "ui/inspector/mip_family.h"
#include "ui/inspector/mip_focus.h"
#include "ui/inspector/mip_text.h"

#include <algorithm>

namespace trixel::ui {

namespace {

/// What is smaller on the screen gets a ring around it.
constexpr double kVisible = 6;
constexpr double kRing = 6;
/// Lights are seen on any texels by a dark edge.
/// No light comes through: Qt would share long lines out to threads, which takes longer.
constexpr QColor kCasing(30, 30, 30);
constexpr double kCasingWidth = 3.5;
constexpr double kLightWidth = 1.75;
constexpr int kChildAlpha = 70;

QColor lightOf(Kinship kinship)
{
    return kinship == Kinship::Itself   ? kItselfLight
           : kinship == Kinship::Parent ? kParentLight
                                        : kChildLight;
}

} // namespace

void MipPainter::paint(QPainter& painter, const std::vector<MipCell>& cells) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    for (const MipCell& cell : cells) {
        paintPicture(painter, cell);
        paintLabel(painter, cell);
    }
    for (const MipCell& cell : cells) {
        paintFamily(painter, cell);
    }
}

void MipPainter::paintPicture(QPainter& painter, const MipCell& cell) const
{
    if (const QImage* picture = m_pictures.picture(cell)) {
        painter.drawImage(cell.picture.topLeft(), *picture);
        return;
    }
    // To come: the shape is there at once.
    QPolygonF outline;
    const TexelOutline corners = cell.layout.outline();
    for (const glm::dvec2 corner : corners.corners()) {
        outline += QPointF(corner.x, corner.y);
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_ink.ground);
    painter.drawPolygon(outline);
}

void MipPainter::paintLabel(QPainter& painter, const MipCell& cell) const
{
    QFont font = m_ink.font;
    const double line = QFontMetricsF(font).lineSpacing();
    QRectF row(cell.label.left(), cell.label.top(), cell.label.width(), line);
    const auto put = [&](const QString& words, const QString& inShort) {
        const QFontMetricsF metrics(font);
        painter.setFont(font);
        painter.drawText(row,
                         Qt::AlignCenter,
                         metrics.horizontalAdvance(words) <= row.width() ? words : inShort);
        row.translate(0, line);
    };
    font.setBold(cell.level == m_focus.level());
    painter.setPen(m_ink.text);
    put(levelText(cell.level), QString::number(cell.level.log2()));
    font = m_ink.font;
    painter.setPen(m_ink.faint);
    const QString count = texelCountText(cell.level);
    if (row.bottom() <= cell.label.bottom() + 1) {
        put(cell.level.log2() == 0
                ? QCoreApplication::translate("MipPainter", "1 texel")
                : QCoreApplication::translate("MipPainter", "%1 texels").arg(count),
            count);
    }
    if (row.bottom() <= cell.label.bottom() + 1) {
        put(keepingText(keepingOf(m_focus, cell.level)), QString());
    }
}

void MipPainter::paintFamily(QPainter& painter, const MipCell& cell) const
{
    const Level level = m_focus.level();
    const ReductionRule rule =
        m_options.content == MipContent::Box ? ReductionRule::Box : ReductionRule::Triangles;
    const Kinship kinship = kinshipOf(level, cell.level);
    QPainterPath path = familyOutline(cell.layout, level, m_focus.texel(level), cell.level, rule);
    const QRectF bounds = path.boundingRect();
    if (std::max(bounds.width(), bounds.height()) < kVisible) {
        path = QPainterPath();
        path.addEllipse(bounds.center(), kRing, kRing);
    }
    const QColor light = lightOf(kinship);
    if (kinship == Kinship::Children) {
        QColor fill = light;
        fill.setAlpha(kChildAlpha);
        painter.fillPath(path, fill);
    }
    painter.setBrush(Qt::NoBrush);
    const std::pair<QColor, double> strokes[] = {{kCasing, kCasingWidth}, {light, kLightWidth}};
    for (const auto& [color, width] : strokes) {
        painter.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPath(path);
    }
}

} // namespace trixel::ui
