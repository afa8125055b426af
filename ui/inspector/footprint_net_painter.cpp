// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/footprint_net_painter.h"

#include <QGuiApplication>
#include <QPainter>
#include <QPalette>

#include "core/lattice/texel.h"
#include "render/color_map.h"
#include "ui/inspector/haloed_text.h"
#include "ui/inspector/texel_lines.h"
#include "ui/viewport/surface_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <unordered_map>

namespace trixel::ui {

namespace {

constexpr double kMargin = 14;        // pixels
constexpr double kTexelsAround = 1.6; // shown about the centre, at least
constexpr double kSigmasShown = 1.9;
constexpr double kLeastGrid = 4; // pixels of a texel's edge from which on edges are drawn
/// From here on the ellipse of the vectors alone is drawn, too.
constexpr double kWidenedShown = 1.1;
constexpr int kEllipsePoints = 60;
constexpr std::size_t kMostFilled = 20'000; // texels of a face drawn by their values
constexpr double kLeastShare = 1e-3;        // of the largest weight, that is still drawn

QColor colorOf(glm::vec4 color)
{
    return QColor::fromRgbF(color.r, color.g, color.b);
}

/// Qt shares out large shapes that let something through to threads, and waits: that takes longer
/// than drawing them. What would be drawn so is mixed with the ground instead.
QColor mixed(const QColor& ground, const QColor& color, float part)
{
    const auto mix = [part](float a, float b) { return a + part * (b - a); };
    return QColor::fromRgbF(mix(ground.redF(), color.redF()),
                            mix(ground.greenF(), color.greenF()),
                            mix(ground.blueF(), color.blueF()));
}

constexpr QColor kHalo(30, 32, 36);

bool isDark(const QPalette& palette)
{
    return palette.color(QPalette::Base).lightness() < 128;
}

/// A line drawn as the area it covers: quicker than the same stroked.
void drawBar(QPainter& painter, const QLineF& line, double width)
{
    const double length = line.length();
    if (length > 0) {
        const QPointF aside = QPointF(-line.dy(), line.dx()) * (0.5 * width / length);
        const QPointF corners[] = {
            line.p1() + aside, line.p2() + aside, line.p2() - aside, line.p1() - aside};
        painter.drawConvexPolygon(corners, 4);
    }
}

class NetPainter
{
public:
    NetPainter(QPainter& painter,
               const QRectF& area,
               const NetPicture& picture,
               const NetView& view,
               const QPalette& palette)
        : m_painter(painter)
        , m_area(area)
        , m_picture(picture)
        , m_net(picture.net)
        , m_view(view)
        , m_palette(palette)
    {
    }

    void paint(std::optional<NetHandle> held)
    {
        m_painter.save();
        m_painter.setClipRect(m_area);
        m_painter.setRenderHint(QPainter::Antialiasing);
        m_painter.fillRect(m_area,
                           m_palette.color(QPalette::Window).darker(isDark(m_palette) ? 118 : 104));
        // Areas without smooth edges leave no seams between neighbours and are quick; the lines
        // over them are smooth.
        m_painter.setRenderHint(QPainter::Antialiasing, false);
        paintFaces();
        if (m_picture.fill == NetPicture::Fill::Values) {
            paintValues();
        } else {
            paintWeights();
        }
        m_painter.setRenderHint(QPainter::Antialiasing);
        paintTexelEdges();
        paintFaceEdges();
        if (m_picture.frozen) {
            paintFrozen();
        }
        paintFootprint();
        paintHandle(NetHandle::W1, held == NetHandle::W1);
        paintHandle(NetHandle::W2, held == NetHandle::W2);
        m_painter.restore();
    }

private:
    QPolygonF polygon(const std::array<glm::dvec2, 3>& corners) const
    {
        QPolygonF result;
        for (const glm::dvec2 corner : corners) {
            result += m_view.toPicture(corner);
        }
        return result;
    }
    QPolygonF texelPolygon(const FootprintNet::Face& face, Level level, TexelCoord texel) const
    {
        QPolygonF result;
        for (const glm::dvec2 uv : corners(level, texel)) {
            result += m_view.toPicture(face.pointOf(uv));
        }
        return result;
    }
    bool isSeen(const QPolygonF& shape) const { return shape.boundingRect().intersects(m_area); }

    void paintFaces();
    void paintWeights();
    void paintValues();
    void paintFaceValues(const FootprintNet::Face& face);
    void paintTexelEdges();
    void paintFaceEdges();
    void paintFrozen();
    void paintFootprint();
    void paintHandle(NetHandle handle, bool held);
    void strokeHaloed(const QPolygonF& line, const QColor& color, double width, bool dashed);
    QPolygonF ellipse(glm::dvec2 centre, glm::dvec2 major, glm::dvec2 minor) const;
    QPolygonF parallelogram(glm::dvec2 centre, glm::dvec2 w1, glm::dvec2 w2) const;

    QPainter& m_painter;
    QRectF m_area;
    const NetPicture& m_picture;
    const FootprintNet& m_net;
    NetView m_view;
    const QPalette& m_palette;
};

void NetPainter::paintFaces()
{
    m_painter.setPen(Qt::NoPen);
    for (std::size_t k = m_net.faces.size(); k-- > 0;) {
        const QPolygonF shape = polygon(m_net.faces[k].corners);
        if (isSeen(shape)) {
            m_painter.setBrush(m_palette.color(k == 0 ? QPalette::Base : QPalette::AlternateBase));
            m_painter.drawPolygon(shape);
        }
    }
}

void NetPainter::paintWeights()
{
    if (!m_picture.weights || m_picture.weights->texels.empty()) {
        return;
    }
    std::unordered_map<std::uint32_t, std::size_t> places;
    for (std::size_t k = 0; k < m_net.faces.size(); ++k) {
        places.emplace(static_cast<std::uint32_t>(m_net.faces[k].face), k);
    }
    // By density: a coarse texel that stands for many is not darker than they are.
    const auto density = [&](const Contribution& one) {
        const auto place = places.find(static_cast<std::uint32_t>(one.face));
        if (place == places.end()) {
            return 0.0;
        }
        const int joined = m_net.faces[place->second].level.log2() - one.level.log2();
        return one.weight * std::exp2(-2.0 * joined);
    };
    double most = 0;
    for (const Contribution& one : m_picture.weights->texels) {
        most = std::max(most, density(one));
    }
    m_painter.setPen(Qt::NoPen);
    for (const Contribution& one : m_picture.weights->texels) {
        const double share = most > 0 ? density(one) / most : 0;
        if (share < kLeastShare) {
            continue;
        }
        const FootprintNet::Face& face =
            m_net.faces[places.at(static_cast<std::uint32_t>(one.face))];
        const QPolygonF shape = texelPolygon(face, one.level, one.texel);
        if (isSeen(shape)) {
            const QColor color = weightColor(share);
            m_painter.setBrush(color);
            m_painter.drawPolygon(shape);
        }
    }
}

void NetPainter::paintValues()
{
    for (const FootprintNet::Face& face : m_net.faces) {
        if (isSeen(polygon(face.corners)) && indexOf(face.face) < m_picture.texels.faceCount()) {
            paintFaceValues(face);
        }
    }
}

/// The texels in sight, at a level whose texels can be told apart.
void NetPainter::paintFaceValues(const FootprintNet::Face& face)
{
    const FaceTexels& texels = m_picture.texels.face(face.face);
    const TexelFormat& format = m_picture.texels.format();
    std::vector<float> values(format.channels);
    const auto color = [&](std::size_t index) {
        decode(format.type, texels.texel(index), values);
        const render::Rgba shown = render::shade(format, values, m_picture.look);
        return QColor(shown[0], shown[1], shown[2]);
    };
    if (texels.isConstant()) {
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(color(0));
        m_painter.drawPolygon(polygon(face.corners));
        return;
    }
    // The part of the face in sight, in (u,v).
    glm::dvec2 low(1);
    glm::dvec2 high(0);
    for (const QPointF corner :
         {m_area.topLeft(), m_area.topRight(), m_area.bottomLeft(), m_area.bottomRight()}) {
        const glm::dvec2 uv = glm::clamp(face.uvOf(m_view.toPlane(corner)), 0.0, 1.0);
        low = glm::min(low, uv);
        high = glm::max(high, uv);
    }
    const Level level = texels.level();
    const double r = level.resolution();
    const auto cells = (high - low) * r + 1.0;
    if (2 * cells.x * cells.y > static_cast<double>(kMostFilled)) {
        return; // too small to tell apart anyway: the plain face stays
    }
    for (auto j = static_cast<std::uint32_t>(low.y * r); j < r && j <= high.y * r; ++j) {
        for (auto i = static_cast<std::uint32_t>(low.x * r); i + j < r && i <= high.x * r; ++i) {
            for (const TexelHalf half : {TexelHalf::Lower, TexelHalf::Upper}) {
                const TexelCoord texel{
                    static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j), half};
                if (isValid(level, texel)) {
                    const QColor shown = color(indexOf(texelIndex(level, texel)));
                    m_painter.setBrush(shown);
                    m_painter.setPen(Qt::NoPen);
                    m_painter.drawPolygon(texelPolygon(face, level, texel));
                }
            }
        }
    }
}

void NetPainter::paintTexelEdges()
{
    QColor color = m_palette.color(QPalette::Text);
    color.setAlphaF(0.16F);
    // So faint that their steps are not seen.
    m_painter.setRenderHint(QPainter::Antialiasing, false);
    m_painter.setPen(QPen(color, 0));
    QVector<QLineF> lines;
    for (const FootprintNet::Face& face : m_net.faces) {
        const double edge = m_view.scale * glm::distance(face.corners[0], face.corners[1]) /
                            face.level.resolution();
        if (edge < kLeastGrid || !isSeen(polygon(face.corners))) {
            continue;
        }
        const std::uint32_t r = face.level.resolution();
        const auto add = [&](glm::dvec2 from, glm::dvec2 to) {
            const QLineF line(m_view.toPicture(face.pointOf(from)),
                              m_view.toPicture(face.pointOf(to)));
            if (const auto seen = clipped(line, m_area)) {
                lines += *seen;
            }
        };
        for (std::uint32_t k = 1; k < r; ++k) {
            const double t = double(k) / r;
            add({t, 0}, {t, 1 - t});
            add({0, t}, {1 - t, t});
            add({t, 0}, {0, t});
        }
    }
    m_painter.drawLines(lines);
    m_painter.setRenderHint(QPainter::Antialiasing);
}

void NetPainter::paintFaceEdges()
{
    const QColor color =
        mixed(m_palette.color(QPalette::Base), m_palette.color(QPalette::Text), 0.7F);
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(color);
    std::vector<QLineF> drawn; // most are edges of two faces
    const auto isDrawn = [&drawn](const QLineF& edge) {
        constexpr double kSame = 0.5;
        return std::ranges::any_of(drawn, [&](const QLineF& other) {
            return QLineF(edge.p1(), other.p2()).length() < kSame &&
                   QLineF(edge.p2(), other.p1()).length() < kSame;
        });
    };
    for (const FootprintNet::Face& face : m_net.faces) {
        const QPolygonF shape = polygon(face.corners);
        for (qsizetype k = 0; k < 3; ++k) {
            const QLineF edge(shape[k], shape[(k + 1) % 3]);
            if (const auto seen = clipped(edge, m_area); seen && !isDrawn(edge)) {
                drawn.push_back(edge);
                drawBar(m_painter, *seen, 1.4);
            }
        }
    }
}

QPolygonF NetPainter::ellipse(glm::dvec2 centre, glm::dvec2 major, glm::dvec2 minor) const
{
    QPolygonF line;
    for (int k = 0; k <= kEllipsePoints; ++k) {
        const double angle = 2 * std::numbers::pi * k / kEllipsePoints;
        line += m_view.toPicture(centre + std::cos(angle) * major + std::sin(angle) * minor);
    }
    return line;
}

QPolygonF NetPainter::parallelogram(glm::dvec2 centre, glm::dvec2 w1, glm::dvec2 w2) const
{
    QPolygonF line;
    for (const glm::dvec2 corner : {-w1 - w2, w1 - w2, w1 + w2, w2 - w1, -w1 - w2}) {
        line += m_view.toPicture(centre + corner / 2.0);
    }
    return line;
}

void NetPainter::strokeHaloed(const QPolygonF& line, const QColor& color, double width, bool dashed)
{
    m_painter.setBrush(Qt::NoBrush);
    m_painter.setPen(QPen(kHalo, width + 2.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    m_painter.drawPolyline(line);
    m_painter.setPen(
        QPen(color, width, dashed ? Qt::DashLine : Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    m_painter.drawPolyline(line);
}

/// Where its face lies in this net.
void NetPainter::paintFrozen()
{
    const PlacedFootprint& frozen = *m_picture.frozen;
    const auto at = m_net.indexOfFace(frozen.face);
    if (!at) {
        return;
    }
    const FootprintNet::Face& face = m_net.faces[*at];
    const glm::dvec2 centre = face.pointOf(frozen.uv);
    const auto vector = [&](glm::dvec2 w) { return face.pointOf(w) - face.corners[0]; };
    const glm::dvec2 w1 = vector(frozen.footprint.w1);
    const glm::dvec2 w2 = vector(frozen.footprint.w2);
    const QColor color = colorOf(kFrozenColor);
    strokeHaloed(parallelogram(centre, w1, w2), color, 1.2, true);
    // Half of each vector: conjugate half axes of the ellipse.
    strokeHaloed(ellipse(centre, w1 / 2.0, w2 / 2.0), color, 1.6, false);
}

void NetPainter::paintFootprint()
{
    const glm::dvec2 centre(0);
    strokeHaloed(
        parallelogram(centre, m_net.w1, m_net.w2), colorOf(kParallelogramColor), 1.6, false);
    const double widened = glm::length(m_net.widenedMinor);
    if (widened > kWidenedShown * glm::length(m_net.minor)) {
        strokeHaloed(ellipse(centre, m_net.major, m_net.minor), colorOf(kEllipseColor), 1.1, true);
    }
    strokeHaloed(
        ellipse(centre, m_net.widenedMajor, m_net.widenedMinor), colorOf(kEllipseColor), 2, false);
}

void NetPainter::paintHandle(NetHandle handle, bool held)
{
    const QPointF from = m_view.toPicture({0, 0});
    const QPointF to = m_view.toPicture(handlePosition(m_net, handle));
    const QColor color = colorOf(kParallelogramColor);
    strokeHaloed(QPolygonF{from, to}, color, 1.6, false);
    const double radius = held ? 7 : 5.5;
    m_painter.setPen(QPen(QColor(10, 12, 16, 220), 1.6));
    m_painter.setBrush(held ? QColor(Qt::white) : color);
    m_painter.drawEllipse(to, radius, radius);

    // Beside the handle, away from the centre.
    const QLineF line(from, to);
    const double length = line.length();
    const QPointF away = length > 1 ? QPointF(line.dx(), line.dy()) / length : QPointF(0, -1);
    QFont font = m_painter.font();
    font.setBold(true);
    drawHaloed(m_painter,
               {font, color, QColor(10, 12, 16, 220), 3},
               to + 19 * away,
               handle == NetHandle::W1 ? "W1" : "W2");
}

} // namespace

NetView fittedView(const FootprintNet& net, const QRectF& area)
{
    glm::dvec2 reach(kTexelsAround * std::exp2(net.ellipse.log2Texel));
    const auto include = [&](glm::dvec2 point) { reach = glm::max(reach, glm::abs(point)); };
    include((net.w1 + net.w2) / 2.0);
    include((net.w1 - net.w2) / 2.0);
    for (int k = 0; k < kEllipsePoints; ++k) {
        const double angle = 2 * std::numbers::pi * k / kEllipsePoints;
        include(kSigmasShown *
                (std::cos(angle) * net.widenedMajor + std::sin(angle) * net.widenedMinor));
    }
    const double width = std::max(area.width() - 2 * kMargin, 10.0);
    const double height = std::max(area.height() - 2 * kMargin, 10.0);
    NetView view;
    view.scale = std::min(width / (2 * reach.x), height / (2 * reach.y));
    view.centre = area.center();
    return view;
}

glm::dvec2 handlePosition(const FootprintNet& net, NetHandle handle)
{
    return (handle == NetHandle::W1 ? net.w1 : net.w2) / 2.0;
}

QColor weightColor(double share)
{
    // The root brings out the tails; the scale beside the picture is drawn with the same.
    const render::Rgb color = render::mapColor(std::sqrt(std::clamp(share, 0.0, 1.0)));
    return {color[0], color[1], color[2]};
}

void paintNet(QPainter& painter,
              const QRectF& area,
              const NetPicture& picture,
              const NetView& view,
              const QPalette& palette,
              std::optional<NetHandle> held)
{
    NetPainter(painter, area, picture, view, palette).paint(held);
}

} // namespace trixel::ui
