// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/layout_painter.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QPen>

#include "ui/inspector/texel_labels.h"
#include "ui/inspector/texel_lines.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace trixel::ui {

namespace {

// Sides of a texel, in the painter's units, at which marks appear and are fully there.
constexpr double kGridFrom = 4;
constexpr double kGridTo = 9;
constexpr double kCentresFrom = 9;
constexpr double kCentresTo = 15;
constexpr double kTrianglesFrom = 16;
constexpr double kTrianglesTo = 26;
/// Beyond the coloured edges of the main face, which lie on it.
constexpr double kSelectionWidth = 5.5;
constexpr std::size_t kMostShapes = 6000;

QString tr(const char* text)
{
    return QCoreApplication::translate("trixel::ui::LayoutPainter", text);
}

glm::dvec2 toVector(QPointF p)
{
    return {p.x(), p.y()};
}

/// Qt shares out long lines that let something through to threads, and waits: that takes longer
/// than drawing them.
QColor solid(QColor color)
{
    color.setAlpha(255);
    return color;
}

glm::dvec2 centroidOf(const FaceLayout& layout)
{
    return (layout.corner(0) + layout.corner(1) + layout.corner(2)) / 3.0;
}

} // namespace

LayoutPainter::LayoutPainter(ShownFaces& faces,
                             const TexelFormat& format,
                             const LayoutScene& scene,
                             const PlaneMap& toView,
                             const QRectF& area,
                             const LayoutInk& ink,
                             const LayoutMarks& marks)
    : m_faces(faces)
    , m_format(format)
    , m_scene(scene)
    , m_toView(toView)
    , m_area(area)
    , m_ink(ink)
    , m_marks(marks)
{
}

void LayoutPainter::drawTexels(QImage& picture, double ratio) const
{
    const PlaneMap toPixels = PlaneMap{{0, 0}, {ratio, 0}, {0, ratio}}.after(m_toView);
    const QRect clip = QRectF(m_area.topLeft() * ratio, m_area.size() * ratio).toAlignedRect();
    TexelPaint paint;
    paint.unit = ratio;
    for (const SceneFace& face : m_scene.faces) {
        const auto number = numberColor(face.face);
        paint.lowerTint = number ? *number : m_marks.tint ? m_ink.lowerTint : 0;
        paint.upperTint = number ? *number : m_marks.tint ? m_ink.upperTint : 0;
        paint.grid = gridStrength(face);
        m_faces.paint(picture, clip, face.layout.moved(toPixels), face.face, paint);
    }
}

bool LayoutPainter::drawTexelShapes(QPainter& painter) const
{
    std::size_t count = 0;
    for (const SceneFace& face : m_scene.faces) {
        const FaceLayout layout = placed(face);
        // Before they are counted one by one.
        const double seen = m_area.width() * m_area.height() /
                            std::max(1e-9, std::pow(texelSide(layout, face.level), 2));
        if (std::min(seen, static_cast<double>(face.level.texelCount())) > kMostShapes ||
            m_faces.texels(face.face) == nullptr) {
            return false;
        }
        forEachTexel(layout, face.level, m_area, [&](TexelCoord) { ++count; });
    }
    if (count > kMostShapes) {
        return false;
    }
    for (const SceneFace& face : m_scene.faces) {
        const FaceLayout layout = placed(face);
        const auto number = numberColor(face.face);
        forEachTexel(layout, face.level, m_area, [&](TexelCoord texel) {
            const QRgb shown = number ? *number : m_faces.color(face.face, texel).value_or(0);
            const QColor color = QColor::fromRgba(qUnpremultiply(shown));
            // A thin line of its own colour: no gaps between shapes.
            painter.setPen(QPen(color, 0.3));
            painter.setBrush(color);
            painter.drawPolygon(toPolygon(layout.outline(face.level, texel)));
            const QRgb tint = !m_marks.tint || number          ? 0
                              : texel.half == TexelHalf::Lower ? m_ink.lowerTint
                                                               : m_ink.upperTint;
            if (tint != 0) {
                painter.setPen(Qt::NoPen);
                painter.setBrush(QColor::fromRgba(qUnpremultiply(tint)));
                painter.drawPolygon(toPolygon(layout.outline(face.level, texel)));
            }
        });
    }
    painter.setBrush(Qt::NoBrush);
    drawGrid(painter);
    return true;
}

void LayoutPainter::drawGrid(QPainter& painter) const
{
    for (const SceneFace& face : m_scene.faces) {
        if (const double strength = gridStrength(face); strength > 0) {
            drawLines(painter, gridLines(placed(face), face.level, m_area), strength);
        }
    }
}

std::optional<QRgb> LayoutPainter::numberColor(FaceId face) const
{
    if (m_numbers == nullptr || indexOf(face) >= m_numbers->colors.size()) {
        return std::nullopt;
    }
    const auto color = std::bit_cast<std::array<std::uint8_t, 4>>(m_numbers->colors[indexOf(face)]);
    return qRgb(color[0], color[1], color[2]);
}

void LayoutPainter::drawMarks(QPainter& painter, std::optional<std::uint16_t> channel) const
{
    painter.save();
    painter.setClipRect(m_area);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const SceneFace& face : m_scene.faces) {
        const bool printed = drawNumbersOn(painter, face, channel);
        drawCentresOn(painter, face, printed);
    }
    painter.restore();
}

double LayoutPainter::gridStrength(const SceneFace& face) const
{
    return m_marks.grid ? fadeIn(texelSide(placed(face), face.level), kGridFrom, kGridTo) : 0;
}

bool LayoutPainter::drawNumbersOn(QPainter& painter,
                                  const SceneFace& face,
                                  std::optional<std::uint16_t> channel) const
{
    const FaceTexels* texels =
        m_marks.values || m_marks.indices ? m_faces.texels(face.face) : nullptr;
    if (texels == nullptr || texels->level() != face.level) {
        return false;
    }
    const auto number = numberColor(face.face);
    const auto background = [&](TexelCoord texel) {
        return QColor::fromRgb(number ? *number : m_faces.color(face.face, texel).value_or(0));
    };
    return drawTexelLabels(painter,
                           m_ink.font,
                           placed(face),
                           m_area,
                           m_format,
                           *texels,
                           {m_marks.values, m_marks.indices, channel},
                           background);
}

/// \param printed  numbers stand where the dots go
void LayoutPainter::drawCentresOn(QPainter& painter, const SceneFace& face, bool printed) const
{
    const FaceLayout layout = placed(face);
    const double side = texelSide(layout, face.level);
    const double strength = m_marks.centres ? fadeIn(side, kCentresFrom, kCentresTo) : 0;
    if (strength <= 0) {
        return;
    }
    const bool pixels = layout.texels() == FaceLayout::Texels::Pixels;
    const double triangles = pixels ? fadeIn(side, kTrianglesFrom, kTrianglesTo) : 0;
    std::vector<QPointF> dots;
    std::vector<QLineF> lines;
    forEachTexel(layout, face.level, m_area, [&](TexelCoord texel) {
        dots.push_back(toPoint(layout.centre(face.level, texel)));
        if (triangles > 0) {
            const auto corners = layout.triangleOf(face.level, texel);
            for (std::size_t k = 0; k < 3; ++k) {
                lines.emplace_back(toPoint(corners[k]), toPoint(corners[(k + 1) % 3]));
            }
        }
    });
    if (triangles > 0) {
        QColor color = m_ink.isDark ? QColor(255, 255, 255) : QColor(0, 0, 0);
        color.setAlphaF(static_cast<float>(0.45 * triangles));
        painter.setPen(QPen(color, 0.8));
        painter.drawLines(lines.data(), static_cast<int>(lines.size()));
    }
    constexpr double kBesideNumbers = 0.3;
    drawDots(painter, dots, std::clamp(side / 14, 1.2, 2.6), printed ? kBesideNumbers : strength);
}

void LayoutPainter::drawFrame(QPainter& painter, const FaceSelection& selection) const
{
    painter.save();
    painter.setClipRect(m_area);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF around = m_area.adjusted(-9, -9, 9, 9);
    const auto outline = [&](const SceneFace& face, const QPen& pen) {
        painter.setPen(pen);
        const TexelOutline whole = placed(face).outline();
        const auto corners = whole.corners();
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const QLineF side(toPoint(corners[k]), toPoint(corners[(k + 1) % corners.size()]));
            if (const auto line = clipped(side, around)) {
                painter.drawLine(*line);
            }
        }
    };
    for (const SceneFace& face : m_scene.faces) {
        outline(face, QPen(m_ink.rim, 1));
    }
    for (const SceneFace& face : m_scene.faces) {
        if (selection.contains(face.face)) {
            outline(face, QPen(m_ink.selection, kSelectionWidth, Qt::SolidLine, Qt::RoundCap));
        }
    }
    drawEdges(painter);
    painter.restore();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    drawNeighbourNames(painter);
    drawVertices(painter);
    painter.restore();
}

QLineF LayoutPainter::edgeLine(const FaceLayout& layout, LocalEdge edge) const
{
    return {toPoint(layout.corner(indexOf(edge))), toPoint(layout.corner(indexOf(nextEdge(edge))))};
}

void LayoutPainter::drawEdges(QPainter& painter) const
{
    const SceneFace& main = m_scene.main();
    const FaceLayout layout = placed(main);
    const QRectF around = m_area.adjusted(-9, -9, 9, 9);
    const bool packed = m_scene.kind == LayoutKind::Packed;
    constexpr double kStepsFrom = 3;
    for (const LocalEdge edge : kLocalEdges) {
        std::vector<QLineF> lines;
        if (packed && edge == LocalEdge::E1 && texelSide(layout, main.level) >= kStepsFrom) {
            lines = diagonalSteps(layout, main.level, around);
        } else if (const auto line = clipped(edgeLine(layout, edge), around)) {
            lines.push_back(*line);
        }
        painter.setPen(QPen(solid(m_ink.halo), 4.5, Qt::SolidLine, Qt::RoundCap));
        painter.drawLines(lines.data(), static_cast<int>(lines.size()));
        painter.setPen(QPen(m_ink.edge(edge), 2.5, Qt::SolidLine, Qt::RoundCap));
        painter.drawLines(lines.data(), static_cast<int>(lines.size()));
    }
    if (packed && m_marks.centres) {
        if (const auto line = clipped(diagonal(layout, main.level), around)) {
            painter.setPen(QPen(m_ink.edge(LocalEdge::E1), 1.3, Qt::DashLine));
            painter.drawLine(*line);
        }
    }
}

void LayoutPainter::drawVertices(QPainter& painter) const
{
    const FaceLayout layout = placed(m_scene.main());
    const QPointF middle = toPoint(centroidOf(layout));
    constexpr double kAside = 11;
    const auto beside = [&](QPointF at) {
        const glm::dvec2 away = toVector(at - middle);
        const double length = glm::length(away);
        return length > 0 ? at + toPoint(away * (kAside / length)) : at;
    };
    for (std::size_t k = 0; k < 3; ++k) {
        const QPointF corner = toPoint(layout.corner(k));
        if (m_area.contains(corner)) {
            drawHaloed(
                painter, m_ink, m_ink.bold, beside(corner), QString("V%1").arg(k), m_ink.text);
        }
    }
    for (const LocalEdge edge : kLocalEdges) {
        const auto line = clipped(edgeLine(layout, edge), m_area);
        constexpr double kLongEnough = 46;
        if (line && line->length() > kLongEnough) {
            // Beside the edge, on the outer side.
            const glm::dvec2 along = toVector(line->p2() - line->p1());
            glm::dvec2 out = glm::dvec2(along.y, -along.x) / glm::length(along);
            const QPointF centre = line->center();
            if (glm::dot(out, toVector(centre - middle)) < 0) {
                out = -out;
            }
            // Clear of the steps.
            const bool steps = m_scene.kind == LayoutKind::Packed && edge == LocalEdge::E1;
            const double aside =
                kAside +
                (steps ? 0.7 * std::min(texelSide(layout, m_scene.main().level), 40.0) : 0);
            drawHaloed(painter,
                       m_ink,
                       m_ink.bold,
                       centre + toPoint(out * aside),
                       QString("E%1").arg(indexOf(edge)),
                       m_ink.edge(edge));
        }
    }
}

void LayoutPainter::drawNeighbourNames(QPainter& painter) const
{
    constexpr double kToFarVertex = 0.25; // from the centroid
    const SceneFace& main = m_scene.main();
    const glm::dvec2 middle = centroidOf(placed(main));
    for (const SceneFace& face : m_scene.faces) {
        const FaceLayout layout = placed(face);
        if (&face == &main || texelSide(layout, face.level) >= kTrianglesTo) {
            continue;
        }
        glm::dvec2 farVertex = layout.corner(0);
        for (const std::size_t vertex : {1U, 2U}) {
            const glm::dvec2 other = layout.corner(vertex);
            if (glm::distance(other, middle) > glm::distance(farVertex, middle)) {
                farVertex = other;
            }
        }
        QPointF at = toPoint(glm::mix(centroidOf(layout), farVertex, kToFarVertex));
        // Of a neighbour that is cut off, where it begins.
        if (const auto way = clipped({toPoint(middle), at}, m_area.adjusted(50, 12, -50, -12))) {
            at = way->p2();
        }
        if (toPolygon(layout.outline()).containsPoint(at, Qt::OddEvenFill)) {
            // As much as there is room for.
            const double room = 0.8 * std::sqrt(std::abs(layout.map().area()));
            const QFontMetricsF metrics(m_ink.small);
            const QString brief = tr("face %1").arg(indexOf(face.face));
            const QString name = tr("%1 · level %2").arg(brief).arg(face.level.log2());
            if (metrics.horizontalAdvance(name) <= room) {
                drawHaloed(painter, m_ink, m_ink.small, at, name, m_ink.text);
            } else if (metrics.horizontalAdvance(brief) <= room) {
                drawHaloed(painter, m_ink, m_ink.small, at, brief, m_ink.text);
            }
        }
    }
}

void LayoutPainter::drawInspected(QPainter& painter, const InspectedTexel& texel, bool held) const
{
    painter.save();
    painter.setClipRect(m_area);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const SceneFace& face : m_scene.faces) {
        if (face.face != texel.place.face || !isValid(face.level, texel.place.texel)) {
            continue;
        }
        const FaceLayout layout = placed(face);
        const QPolygonF outline = toPolygon(layout.outline(face.level, texel.place.texel));
        if (!outline.boundingRect().adjusted(-9, -9, 9, 9).intersects(m_area)) {
            continue;
        }
        const bool tiny = texelSide(layout, face.level) < 5;
        if (tiny) {
            const QPointF at = toPoint(layout.centre(face.level, texel.place.texel));
            painter.setPen(QPen(Qt::black, 3.5));
            painter.drawEllipse(at, 6, 6);
            painter.setPen(QPen(Qt::white, 1.6));
            painter.drawEllipse(at, 6, 6);
            continue;
        }
        painter.setPen(QPen(Qt::black, 4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolygon(outline);
        painter.setPen(QPen(held ? QColor(255, 220, 60) : QColor(Qt::white),
                            2,
                            Qt::SolidLine,
                            Qt::RoundCap,
                            Qt::RoundJoin));
        painter.drawPolygon(outline);
    }
    painter.restore();
}

} // namespace trixel::ui
