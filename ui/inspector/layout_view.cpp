// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/layout_view.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QStyleOptionFocusRect>

#include "ui/document/document.h"
#include "ui/inspector/net_filter.h"
#include "ui/inspector/texel_lines.h"
#include "ui/viewport/method_title.h"
#include "ui/viewport/view_settings.h"

#include <algorithm>
#include <cmath>

namespace trixel::ui {

namespace {

/// Around faces, for the names of vertices and edges.
constexpr double kRoomForNames = 20;
/// What is followed comes so far into the view, at most.
constexpr double kMargin = 36;
/// Lower views have no room for more than a line of heading.
constexpr double kRoomForCaption = 190;

QString fixed(double value)
{
    return QString::number(value, 'f', 4);
}

glm::dvec2 toVector(QPointF p)
{
    return {p.x(), p.y()};
}

} // namespace

QString titleOf(LayoutKind kind)
{
    switch (kind) {
    case LayoutKind::Net:
        return LayoutView::tr("Net");
    case LayoutKind::Packed:
        return LayoutView::tr("Packed");
    case LayoutKind::Rectilinear:
        break;
    }
    return LayoutView::tr("Rectilinear");
}

QString captionOf(LayoutKind kind)
{
    switch (kind) {
    case LayoutKind::Net:
        return LayoutView::tr(
            "Texels as they lie on the mesh, the neighbours unfolded around them");
    case LayoutKind::Packed:
        return LayoutView::tr(
            "As the file stores them: upper texels lie beyond the diagonal, turned over");
    case LayoutKind::Rectilinear:
        break;
    }
    return LayoutView::tr("x = u + v/2, y = v: in rows, as filters that work along rows read them");
}

bool splitsNet(const ViewSettings& settings)
{
    switch (settings.comparison().by) {
    case ComparedBy::Level:
    case ComparedBy::Before:
        return true;
    case ComparedBy::Method:
        return settings.view().map == ViewMapKind::Filtered;
    default:
        return false;
    }
}

LayoutView::LayoutView(LayoutKind kind, const LayoutSources& sources, QWidget* parent)
    : QWidget(parent)
    , m_kind(kind)
    , m_sources(sources)
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAccessibleName(titleOf(kind));
    setAccessibleDescription(captionOf(kind));
    setToolTipDuration(-1);
}

void LayoutView::clear()
{
    m_scene.reset();
    m_drag = Drag::None;
    refresh();
}

void LayoutView::setScene(const LayoutScene& scene, Follow follow)
{
    const bool first = !m_scene;
    if (m_scene == scene) {
        return;
    }
    m_scene = scene;
    fitSight();
    if (first || follow == Follow::GoHome) {
        m_sight.goHomeTo(scene.home, scene.nearest());
    } else {
        m_sight.stay();
        m_sight.setHome(scene.home, scene.nearest());
    }
    refresh();
}

void LayoutView::setOther(const std::optional<LayoutScene>& scene)
{
    if (scene != m_other) {
        m_other = scene;
        refresh();
    }
}

void LayoutView::setNumbers(const std::shared_ptr<const FaceNumbers>& numbers)
{
    if (numbers != m_numbers) {
        m_numbers = numbers;
        refresh();
    }
}

void LayoutView::setFilter(NetFilter& filter)
{
    m_filter = &filter;
    connect(&filter, &NetFilter::changed, this, &LayoutView::refresh);
}

void LayoutView::setMarks(const LayoutMarks& marks)
{
    if (m_marks != marks) {
        m_marks = marks;
        refresh();
    }
}

void LayoutView::refresh()
{
    m_isStale = true;
    update();
}

void LayoutView::refreshInspected(bool follow)
{
    const auto& texel = m_sources.inspection.texel();
    if (follow && texel && m_scene && !m_sight.isHome() && m_drag == Drag::None) {
        for (auto face = m_scene->faces.rbegin(); face != m_scene->faces.rend(); ++face) {
            if (face->face == texel->place.face && isValid(face->level, texel->place.texel)) {
                const glm::dvec2 centre = face->layout.centre(face->level, texel->place.texel);
                if (m_sight.bringIntoSight(centre, kMargin)) {
                    refresh();
                }
                break;
            }
        }
    }
    update();
}

void LayoutView::frame()
{
    m_sight.goHome();
    refresh();
}

void LayoutView::showPixelForTexel()
{
    if (!m_scene) {
        return;
    }
    const SceneFace& main = m_scene->main();
    const double side =
        texelSide(main.layout.moved(m_sight.map()), main.level) * devicePixelRatioF();
    zoomBy(1 / side);
}

void LayoutView::zoomBy(double factor)
{
    const auto& texel = m_sources.inspection.texel();
    const auto at = texel ? positionOf(texel->place) : std::nullopt;
    const bool inSight = at && rect().contains(at->toPoint());
    m_sight.zoomBy(factor, inSight ? toVector(*at) : m_sight.middleOfView());
    refresh();
}

std::optional<QPointF> LayoutView::positionOf(const TexelPlace& place) const
{
    if (m_scene) {
        for (auto face = m_scene->faces.rbegin(); face != m_scene->faces.rend(); ++face) {
            if (face->face == place.face && isValid(face->level, place.texel)) {
                return toPoint(m_sight.toView(face->layout.centre(face->level, place.texel)));
            }
        }
    }
    return std::nullopt;
}

QSize LayoutView::sizeHint() const
{
    return {300, 300};
}

QSize LayoutView::minimumSizeHint() const
{
    return {90, 90};
}

LayoutView::Rooms LayoutView::roomsIn(const QRectF& area, const LayoutInk& ink) const
{
    const QFontMetricsF title(ink.bold);
    const QFontMetricsF small(ink.small);
    constexpr double kPadding = 6;
    const QRectF inside = area.adjusted(kPadding, 4, -kPadding, -4);
    double headingHeight = title.height();
    if (area.height() >= kRoomForCaption) {
        headingHeight +=
            small.boundingRect(QRectF(0, 0, inside.width(), 1000), Qt::TextWordWrap, caption())
                .height();
    }
    Rooms rooms;
    rooms.heading = {inside.left(), inside.top(), inside.width(), headingHeight};
    rooms.footer = {
        inside.left(), inside.bottom() - small.height(), inside.width(), small.height()};
    rooms.plane = QRectF(QPointF(area.left(), rooms.heading.bottom() + 3),
                         QPointF(area.right(), rooms.footer.top() - 3));
    return rooms;
}

void LayoutView::fitSight()
{
    m_rooms = roomsIn(rect(), LayoutInk(palette(), font()));
    const QRectF plane = m_rooms.plane;
    const double room = std::min({kRoomForNames, plane.width() / 6, plane.height() / 6});
    const QRectF inside = plane.adjusted(room, room, -room, -room);
    m_sight.setView({inside.left(), inside.top()},
                    {std::max(inside.width(), 1.0), std::max(inside.height(), 1.0)});
}

QString LayoutView::caption() const
{
    if (m_numbers && m_scene && indexOf(m_scene->main().face) < m_numbers->values.size()) {
        const float value = m_numbers->values[indexOf(m_scene->main().face)];
        return tr("Each face in the colour of the map; this one: %1")
            .arg(MapScale::text(m_sources.settings.view().map, double{value}));
    }
    if (m_filter != nullptr && m_filter->isWanted()) {
        return tr("Every pixel filtered by %1, as the view is")
            .arg(methodTitle(m_sources.settings.method()));
    }
    if (m_kind == LayoutKind::Net && m_sources.settings.comparison().by == ComparedBy::Filtering) {
        return tr("Texels as they are stored, on both sides of the view's line: A and B differ in "
                  "how the graphics card draws them, which is seen in the view alone");
    }
    return captionOf(m_kind);
}

std::vector<LayoutView::Part> LayoutView::partsOf(const QRectF& plane, const QRectF& whole) const
{
    const ComparedBy by = m_sources.settings.comparison().by;
    if (m_kind != LayoutKind::Net || !splitsNet(m_sources.settings)) {
        return {{plane, &m_sources.faces, &*m_scene, render::Side::A}};
    }
    const double line =
        std::clamp(whole.left() + m_sources.settings.comparison().split * whole.width(),
                   plane.left(),
                   plane.right());
    QRectF left = plane;
    left.setRight(line);
    QRectF right = plane;
    right.setLeft(line);
    const bool hasOther = by != ComparedBy::Method && m_other;
    return {{left, &m_sources.faces, &*m_scene, render::Side::A},
            {right,
             hasOther ? &m_sources.others : &m_sources.faces,
             hasOther ? &*m_other : &*m_scene,
             render::Side::B}};
}

LayoutPainter
LayoutView::painterFor(const Part& part, const PlaneMap& toView, const LayoutInk& ink) const
{
    LayoutPainter painter(*part.faces,
                          m_sources.document.texels().format(),
                          *part.scene,
                          toView,
                          part.area,
                          ink,
                          m_marks);
    painter.setNumbers(m_numbers.get());
    return painter;
}

/// Tells the filter what is seen now, so that it can follow.
void LayoutView::askFilter(const QRectF& plane)
{
    if (m_filter == nullptr) {
        return;
    }
    if (!m_scene || !m_filter->isWanted()) {
        m_filter->show(std::nullopt);
        return;
    }
    const double ratio = devicePixelRatioF();
    const PlaneMap dense{{0, 0}, {ratio, 0}, {0, ratio}};
    const QSize size = (QSizeF(this->size()) * ratio).toSize();
    const QRect area = QRectF(plane.topLeft() * ratio, plane.size() * ratio).toAlignedRect();
    m_filter->show(NetFilter::Place{
        *m_scene, dense.after(m_sight.map()), size, area & QRect(QPoint(), size), ratio});
}

/// What there is of the filtered picture, wherever its plane lies now. Whether there was any.
bool LayoutView::drawFiltered(QPainter& painter, const Part& part, const PlaneMap& toView) const
{
    if (m_filter == nullptr || !m_filter->place()) {
        return false;
    }
    const bool isB =
        part.side == render::Side::B && m_sources.settings.comparison().by == ComparedBy::Method;
    const QImage* picture = part.side == render::Side::B && !isB
                                ? nullptr // B shows texels of its own
                                : m_filter->picture(part.side);
    if (picture == nullptr) {
        return false;
    }
    const PlaneMap back = toView.after(m_filter->place()->toPixels.inverse());
    const glm::dvec2 low = back.point({0, 0});
    const glm::dvec2 high = back.point({picture->width(), picture->height()});
    painter.save();
    painter.setClipRect(part.area);
    painter.drawImage(QRectF(toPoint(low), toPoint(high)), *picture);
    painter.restore();
    return true;
}

/// On paper, where no line can be dragged.
void LayoutView::drawSplit(QPainter& painter,
                           const std::vector<Part>& parts,
                           const LayoutInk& ink) const
{
    if (parts.size() < 2) {
        return;
    }
    const QRectF right = parts[1].area;
    painter.setPen(QPen(ink.text, 1));
    painter.drawLine(right.topLeft(), right.bottomLeft());
    constexpr QPointF kAside(14, 12);
    drawHaloed(painter, ink, ink.bold, right.topLeft() + QPointF(-14, 12), "A", ink.text);
    drawHaloed(painter, ink, ink.bold, right.topLeft() + kAside, "B", ink.text);
}

void LayoutView::renderBase()
{
    const double ratio = devicePixelRatioF();
    const QSize size = (QSizeF(this->size()) * ratio).toSize();
    if (m_base.size() != size) {
        m_base = QImage(size, QImage::Format_RGB32);
    }
    m_base.setDevicePixelRatio(1);
    const LayoutInk ink(palette(), font());
    m_base.fill(ink.background);
    m_isStale = false;
    fitSight(); // the heading may have other lines
    const QRectF plane = m_rooms.plane;
    askFilter(plane);
    if (m_scene) {
        drawScene(ink, plane);
    }
    m_base.setDevicePixelRatio(ratio);
    QPainter painter(&m_base);
    drawHeading(painter, m_rooms.heading, ink);
}

/// What is seen of the faces, into the kept picture.
void LayoutView::drawScene(const LayoutInk& ink, const QRectF& plane)
{
    const double ratio = devicePixelRatioF();
    const std::vector<Part> parts = partsOf(plane, rect());
    const PlaneMap map = m_sight.map();
    for (const Part& part : parts) {
        painterFor(part, map, ink).drawTexels(m_base, ratio);
    }
    m_base.setDevicePixelRatio(ratio);
    QPainter painter(&m_base);
    for (const Part& part : parts) {
        const LayoutPainter drawn = painterFor(part, map, ink);
        if (drawFiltered(painter, part, map)) {
            painter.setClipRect(part.area);
            drawn.drawGrid(painter);
            painter.setClipping(false);
        }
        drawn.drawMarks(painter, m_sources.settings.look().channel);
    }
    painterFor({plane, &m_sources.faces, &*m_scene}, map, ink)
        .drawFrame(painter, m_sources.selection);
}

void LayoutView::paintEvent(QPaintEvent* /*event*/)
{
    if (m_isStale) {
        renderBase();
    }
    const LayoutInk ink(palette(), font());
    QPainter painter(this);
    painter.drawImage(0, 0, m_base);
    if (m_scene) {
        if (const auto& texel = m_sources.inspection.texel()) {
            painterFor({m_rooms.plane, &m_sources.faces, &*m_scene}, m_sight.map(), ink)
                .drawInspected(painter, *texel, m_sources.inspection.isHeld());
        }
    }
    drawFooter(painter, m_rooms.footer, ink);
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

void LayoutView::paintInto(QPainter& painter,
                           const QRectF& area,
                           const LayoutInk& ink,
                           bool asShapes)
{
    painter.fillRect(area, ink.background);
    const Rooms rooms = roomsIn(area, ink);
    if (m_scene) {
        // The middle of the widget's view stays in the middle, and as much is seen around it.
        PlaneSight sight = m_sight;
        const double room =
            std::min({kRoomForNames, rooms.plane.width() / 6, rooms.plane.height() / 6});
        const QRectF inside = rooms.plane.adjusted(room, room, -room, -room);
        sight.setView({inside.left(), inside.top()}, {inside.width(), inside.height()});
        const std::vector<Part> parts = partsOf(rooms.plane, area);
        for (const Part& part : parts) {
            paintPart(painter, part, sight.map(), ink, asShapes);
        }
        const LayoutPainter whole =
            painterFor({rooms.plane, &m_sources.faces, &*m_scene}, sight.map(), ink);
        whole.drawFrame(painter, m_sources.selection);
        if (const auto& texel = m_sources.inspection.texel()) {
            whole.drawInspected(painter, *texel, m_sources.inspection.isHeld());
        }
        drawSplit(painter, parts, ink);
    }
    drawHeading(painter, rooms.heading, ink);
    drawFooter(painter, rooms.footer, ink);
}

void LayoutView::paintPart(QPainter& painter,
                           const Part& part,
                           const PlaneMap& toView,
                           const LayoutInk& ink,
                           bool asShapes) const
{
    for (const SceneFace& face : part.scene->faces) {
        part.faces->complete(face.face);
    }
    const LayoutPainter drawn = painterFor(part, toView, ink);
    painter.save();
    painter.setClipRect(part.area);
    painter.setRenderHint(QPainter::Antialiasing);
    if (!asShapes || !drawn.drawTexelShapes(painter)) {
        constexpr double kDensity = 2; // as sharp as a screen of twice the density
        QImage picture((part.area.size() * kDensity).toSize(), QImage::Format_RGB32);
        picture.fill(ink.background);
        const PlaneMap moved =
            PlaneMap{{-part.area.left(), -part.area.top()}, {1, 0}, {0, 1}}.after(toView);
        Part own = part;
        own.area = QRectF(QPointF(0, 0), part.area.size());
        painterFor(own, moved, ink).drawTexels(picture, kDensity);
        painter.drawImage(part.area, picture);
    }
    if (drawFiltered(painter, part, toView)) {
        drawn.drawGrid(painter);
    }
    painter.restore();
    drawn.drawMarks(painter, m_sources.settings.look().channel);
}

void LayoutView::drawHeading(QPainter& painter, const QRectF& area, const LayoutInk& ink) const
{
    const QFontMetricsF title(ink.bold);
    painter.setFont(ink.bold);
    painter.setPen(ink.text);
    painter.drawText(area, Qt::AlignLeft | Qt::AlignTop, titleOf(m_kind));
    const double used = title.horizontalAdvance(titleOf(m_kind)) + 10;
    const QRectF beside(
        area.left() + used, area.top(), std::max(0.0, area.width() - used), title.height());
    painter.setFont(ink.small);
    painter.setPen(ink.faint);
    if (m_scene) {
        const SceneFace& main = m_scene->main();
        const QString text = tr("face %1 · level %2 · %3 texels")
                                 .arg(indexOf(main.face))
                                 .arg(main.level.log2())
                                 .arg(main.level.texelCount());
        painter.drawText(beside,
                         Qt::AlignRight | Qt::AlignVCenter,
                         QFontMetricsF(ink.small).elidedText(text, Qt::ElideRight, beside.width()));
    }
    const QRectF below = area.adjusted(0, title.height(), 0, 0);
    if (below.height() > 1) {
        painter.drawText(below, Qt::TextWordWrap, caption());
    }
}

void LayoutView::drawFooter(QPainter& painter, const QRectF& area, const LayoutInk& ink) const
{
    painter.setFont(ink.small);
    painter.setPen(ink.text);
    painter.drawText(
        area,
        Qt::AlignLeft | Qt::AlignVCenter,
        QFontMetricsF(ink.small).elidedText(coordinates(), Qt::ElideRight, area.width()));
}

/// Of the texel looked at, in the numbers of this view.
QString LayoutView::coordinates() const
{
    const auto& texel = m_sources.inspection.texel();
    if (!texel || !m_scene || !m_scene->shows(texel->place.face) ||
        !isValid(texel->level, texel->place.texel)) {
        return {};
    }
    const TexelCoord at = texel->place.texel;
    const glm::dvec2 middle = centroid(texel->level, at);
    switch (m_kind) {
    case LayoutKind::Net:
        return tr("(%1, %2) %3 · u %4  v %5")
            .arg(at.i)
            .arg(at.j)
            .arg(at.half == TexelHalf::Lower ? tr("lower") : tr("upper"))
            .arg(fixed(middle.x), fixed(middle.y));
    case LayoutKind::Packed: {
        const PackedPixel pixel = packedPixel(texel->level, at);
        return tr("pixel %1, %2 · index %3")
            .arg(pixel.x)
            .arg(pixel.y)
            .arg(indexOf(texelIndex(texel->level, pixel)));
    }
    case LayoutKind::Rectilinear:
        break;
    }
    return tr("x %1  y %2 · row %3").arg(fixed(middle.x + middle.y / 2), fixed(middle.y)).arg(at.j);
}

} // namespace trixel::ui
