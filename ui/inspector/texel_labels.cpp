// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/texel_labels.h"

#include <QFontMetricsF>
#include <QPainter>

#include "ui/inspector/face_painter.h"
#include "ui/inspector/texel_lines.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>
#include <vector>

namespace trixel::ui {

namespace {

constexpr int kSmallest = 8; ///< pixels of a font that can be read
constexpr int kLargest = 13;
/// Below this side of a texel no text fits, not even one digit.
constexpr double kNoText = 12;
constexpr std::size_t kMostValues = 4;

QString valueText(TexelType type, float value)
{
    const auto number = static_cast<double>(value);
    switch (type) {
    case TexelType::UInt8:
        return QString::number(std::lround(number * 255));
    case TexelType::UInt16:
        return QString::number(std::lround(number * 65535));
    case TexelType::Half:
    case TexelType::Float:
        break;
    }
    return QString::number(number, 'g', 3);
}

/// One way to set the lines of all texels.
struct Setting
{
    bool stacked = true;
    double room = 0;
};

QSizeF sizeOf(const QStringList& lines, bool stacked, const QFontMetricsF& metrics)
{
    if (!stacked) {
        return {metrics.horizontalAdvance(lines.join(' ')), metrics.ascent()};
    }
    double width = 0;
    for (const QString& line : lines) {
        width = std::max(width, metrics.horizontalAdvance(line));
    }
    const auto below = static_cast<double>(lines.size() - 1);
    return {width, metrics.ascent() + below * metrics.height()};
}

/// \param stacked  each line below the other, or all in one
void drawLinesOf(QPainter& painter, const QStringList& lines, bool stacked, QPointF centre)
{
    const QFontMetricsF metrics(painter.font());
    const QStringList set = stacked ? lines : QStringList(lines.join(' '));
    const QSizeF size = sizeOf(lines, stacked, metrics);
    // Digits have no descent: centred are their bodies.
    double baseline = centre.y() - size.height() / 2 + metrics.ascent() * 0.92;
    for (const QString& line : set) {
        painter.drawText(QPointF(centre.x() - metrics.horizontalAdvance(line) / 2, baseline), line);
        baseline += metrics.height();
    }
}

bool isDark(const QColor& color)
{
    constexpr double kMiddle = 0.5;
    return 0.299 * color.redF() + 0.587 * color.greenF() + 0.114 * color.blueF() < kMiddle;
}

} // namespace

QStringList linesOf(const TexelFormat& format,
                    const FaceTexels& texels,
                    TexelCoord texel,
                    const TexelWords& words)
{
    QStringList lines;
    const TexelIndex index = texelIndex(texels.level(), texel);
    if (words.indices) {
        lines += QString("#%1").arg(indexOf(index));
    }
    if (words.values) {
        std::vector<float> values(format.channels);
        decode(format.type, texels.texel(indexOf(index)), values);
        if (words.channel) {
            lines += valueText(format.type, values[*words.channel]);
        } else {
            for (std::size_t k = 0; k < std::min(values.size(), kMostValues); ++k) {
                lines += valueText(format.type, values[k]);
            }
        }
    }
    return lines;
}

double roomFor(const TexelOutline& outline, glm::dvec2 centre, QSizeF size)
{
    const auto corners = outline.corners();
    double room = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const glm::dvec2 from = corners[k];
        const glm::dvec2 along = corners[(k + 1) % corners.size()] - from;
        const double length = glm::length(along);
        if (!(length > 0)) {
            return 0;
        }
        const glm::dvec2 normal = glm::dvec2(along.y, -along.x) / length;
        const double distance = std::abs(glm::dot(normal, from - centre));
        const double needed =
            0.5 * (std::abs(normal.x) * size.width() + std::abs(normal.y) * size.height());
        room = std::min(room, distance / needed);
    }
    return room;
}

bool drawTexelLabels(QPainter& painter,
                     const QFont& font,
                     const FaceLayout& layout,
                     const QRectF& area,
                     const TexelFormat& format,
                     const FaceTexels& texels,
                     const TexelWords& words,
                     const std::function<QColor(TexelCoord)>& background)
{
    const Level level = texels.level();
    if ((!words.values && !words.indices) || texelSide(layout, level) < kNoText) {
        return false;
    }
    std::vector<std::pair<TexelCoord, QStringList>> all;
    forEachTexel(layout, level, area, [&](TexelCoord texel) {
        all.emplace_back(texel, linesOf(format, texels, texel, words));
    });
    QFont sized = font;
    sized.setPixelSize(kSmallest);
    const QFontMetricsF metrics(sized);
    // All texels are alike but for half a turn: what fits into one fits into all.
    const TexelCoord any{};
    const TexelOutline outline = layout.outline(level, any);
    const glm::dvec2 centre = layout.centre(level, any);
    Setting best;
    for (const bool stacked : {true, false}) {
        double room = std::numeric_limits<double>::infinity();
        for (const auto& [texel, lines] : all) {
            // A little air around the text.
            const QSizeF size = sizeOf(lines, stacked, metrics) + QSizeF(3, 2);
            room = std::min(room, roomFor(outline, centre, size));
        }
        if (room > best.room) {
            best = {stacked, room};
        }
    }
    if (best.room < 1 || all.empty()) {
        return false;
    }
    constexpr double kFullyIn = 1.15;
    const double strength = fadeIn(best.room, 1 - 1e-9, kFullyIn);
    sized.setPixelSize(std::clamp(static_cast<int>(kSmallest * best.room), kSmallest, kLargest));
    painter.setFont(sized);
    for (const auto& [texel, lines] : all) {
        QColor ink = isDark(background(texel)) ? QColor(255, 255, 255) : QColor(0, 0, 0);
        ink.setAlphaF(static_cast<float>(0.25 + 0.75 * strength));
        painter.setPen(ink);
        drawLinesOf(painter, lines, best.stacked, toPoint(layout.centre(level, texel)));
    }
    return true;
}

} // namespace trixel::ui
