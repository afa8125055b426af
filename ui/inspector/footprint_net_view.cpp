// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/footprint_net_view.h"

#include <QApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLinearGradient>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include "core/lattice/texel.h"
#include "core/texture/texel_address.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace trixel::ui {

namespace {

constexpr double kHandleReach = 11; // pixels
constexpr double kLeastZoom = 0.02;
constexpr double kMostZoom = 200;
constexpr double kZoomStep = 1.25;
constexpr double kScaleHeight = 22;

} // namespace

FootprintNetView::FootprintNetView(QWidget* parent)
    : QWidget(parent)
{
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAccessibleName(tr("Footprint laid flat"));
    setAccessibleDescription(tr("The faces about the footprint in one plane, their texels coloured "
                                "by weight, with W1, W2 and the ellipse"));
    setToolTip(tr("Drag W1 or W2. Click a texel to go there. Drag elsewhere to move, turn the "
                  "wheel to zoom, double-click to see the whole footprint."));
}

void FootprintNetView::show(const std::optional<NetPicture>& picture)
{
    m_picture = picture;
    update();
}

void FootprintNetView::setHint(const QString& hint)
{
    m_hint = hint;
    update();
}

QRectF FootprintNetView::area() const
{
    return QRectF(rect()).adjusted(0, 0, 0, -kScaleHeight);
}

NetView FootprintNetView::view() const
{
    if (m_dragged) {
        return m_draggedIn;
    }
    NetView view = m_picture ? fittedView(m_picture->net, area()) : NetView{};
    view.scale *= m_zoom;
    view.centre += m_shift;
    return view;
}

void FootprintNetView::fit()
{
    m_zoom = 1;
    m_shift = {};
    update();
}

void FootprintNetView::zoom(double factor, QPointF about)
{
    const double before = m_zoom;
    m_zoom = std::clamp(m_zoom * factor, kLeastZoom, kMostZoom);
    // What lies under the point stays there.
    const QPointF middle = area().center() + m_shift;
    m_shift += (about - middle) * (1 - m_zoom / before);
    update();
}

std::optional<QPointF> FootprintNetView::handleAt(NetHandle handle) const
{
    if (!m_picture) {
        return std::nullopt;
    }
    return view().toPicture(handlePosition(m_picture->net, handle));
}

std::optional<NetHandle> FootprintNetView::handleUnder(QPointF position) const
{
    std::optional<NetHandle> nearest;
    double least = kHandleReach;
    for (const NetHandle handle : {NetHandle::W1, NetHandle::W2}) {
        const auto at = handleAt(handle);
        if (at && QLineF(*at, position).length() <= least) {
            least = QLineF(*at, position).length();
            nearest = handle;
        }
    }
    return nearest;
}

void FootprintNetView::dragTo(QPointF position)
{
    const FootprintNet& net = m_picture->net;
    const glm::dvec2 w = 2.0 * view().toPlane(position);
    const glm::dvec2 w1 = m_dragged == NetHandle::W1 ? w : net.w1;
    const glm::dvec2 w2 = m_dragged == NetHandle::W2 ? w : net.w2;
    emit dragged(net.shape.toUv(w1), net.shape.toUv(w2));
}

void FootprintNetView::mousePressEvent(QMouseEvent* event)
{
    if (!m_picture || (event->button() != Qt::LeftButton && event->button() != Qt::MiddleButton)) {
        return;
    }
    m_pressed = m_last = event->position();
    m_pans = event->button() == Qt::MiddleButton;
    if (event->button() == Qt::LeftButton) {
        const NetView now = view();
        m_dragged = handleUnder(event->position());
        m_draggedIn = now;
    }
    update();
}

void FootprintNetView::mouseMoveEvent(QMouseEvent* event)
{
    if (!m_picture) {
        return;
    }
    if (m_dragged) {
        dragTo(event->position());
        return;
    }
    if (m_pressed) {
        m_pans = m_pans || (event->position() - *m_pressed).manhattanLength() >=
                               QApplication::startDragDistance();
        if (m_pans) {
            m_shift += event->position() - m_last;
            m_last = event->position();
            update();
        }
        return;
    }
    const auto under = handleUnder(event->position());
    if (under != m_under) {
        m_under = under;
        setCursor(under ? Qt::SizeAllCursor : Qt::ArrowCursor);
        update();
    }
}

void FootprintNetView::mouseReleaseEvent(QMouseEvent* event)
{
    const bool wasClick = m_pressed && !m_pans && !m_dragged && event->button() == Qt::LeftButton;
    if (m_dragged) {
        dragTo(event->position());
    }
    m_dragged.reset();
    m_pressed.reset();
    m_pans = false;
    if (wasClick && m_picture) {
        if (const auto place = m_picture->net.placeAt(view().toPlane(event->position()))) {
            emit clicked(m_picture->net.faces[place->face].face, place->uv);
        }
    }
    update();
}

void FootprintNetView::mouseDoubleClickEvent(QMouseEvent* /*event*/)
{
    fit();
}

void FootprintNetView::wheelEvent(QWheelEvent* event)
{
    zoom(std::pow(kZoomStep, event->angleDelta().y() / 120.0), event->position());
    event->accept();
}

void FootprintNetView::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        zoom(kZoomStep, area().center());
        return;
    case Qt::Key_Minus:
        zoom(1 / kZoomStep, area().center());
        return;
    case Qt::Key_0:
        fit();
        return;
    default:
        QWidget::keyPressEvent(event);
    }
}

void FootprintNetView::leaveEvent(QEvent* event)
{
    m_under.reset();
    update();
    QWidget::leaveEvent(event);
}

bool FootprintNetView::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip && m_picture) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const QString tip = tipAt(help->pos());
        if (!tip.isEmpty()) {
            QToolTip::showText(help->globalPos(), tip, this);
            return true;
        }
    }
    return QWidget::event(event);
}

/// The texel there and its weight.
QString FootprintNetView::tipAt(QPointF position) const
{
    const auto place = m_picture->net.placeAt(view().toPlane(position));
    if (!place || handleUnder(position)) {
        return {};
    }
    const FootprintNet::Face& face = m_picture->net.faces[place->face];
    const TexelCoord texel = texelAt(face.level, place->uv);
    QString tip = tr("Texel %1").arg(QString::fromStdString(toText(TexelPlace{face.face, texel})));
    if (!m_picture->weights) {
        return tip;
    }
    double weight = 0;
    int joined = 0;
    for (const Contribution& one : m_picture->weights->texels) {
        if (one.face == face.face && one.texel == texelAt(one.level, place->uv)) {
            weight = one.weight;
            joined = face.level.log2() - one.level.log2();
        }
    }
    tip += "\n" + (joined > 0 ? tr("Weight %1 %, together with %2 others")
                                    .arg(100 * weight, 0, 'g', 4)
                                    .arg((1U << (2U * static_cast<unsigned>(joined))) - 1)
                              : tr("Weight %1 %").arg(100 * weight, 0, 'g', 4));
    return tip;
}

void FootprintNetView::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    if (!m_picture) {
        painter.fillRect(rect(), palette().color(QPalette::Window));
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(
            rect().adjusted(16, 0, -16, 0), Qt::AlignCenter | Qt::TextWordWrap, m_hint);
    } else {
        drawInto(painter, rect());
    }
    if (hasFocus()) {
        painter.setPen(palette().color(QPalette::Highlight));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
}

void FootprintNetView::paintPicture(QPainter& painter, QSize size)
{
    drawInto(painter, QRectF(QPointF(), QSizeF(size)));
}

void FootprintNetView::drawInto(QPainter& painter, const QRectF& area) const
{
    if (!m_picture) {
        return;
    }
    NetView seen = view();
    if (area != QRectF(rect())) { // another size: as a copy of what is seen here
        const QRectF own = this->area();
        const QRectF other = area.adjusted(0, 0, 0, -kScaleHeight);
        const double factor = std::min(other.width() / own.width(), other.height() / own.height());
        seen.centre = other.center() + factor * (seen.centre - own.center());
        seen.scale *= factor;
    }
    paintNet(painter,
             area.adjusted(0, 0, 0, -kScaleHeight),
             *m_picture,
             seen,
             palette(),
             m_dragged ? m_dragged : m_under);
    paintScale(painter, area);
}

void FootprintNetView::paintScale(QPainter& painter, const QRectF& area) const
{
    const QRectF strip(area.left(), area.bottom() - kScaleHeight, area.width(), kScaleHeight);
    painter.fillRect(strip, palette().color(QPalette::Window));
    painter.setPen(palette().color(QPalette::WindowText));
    const QRectF text = strip.adjusted(4, 0, -4, 0);
    if (m_picture->fill == NetPicture::Fill::Values) {
        painter.drawText(
            text, Qt::AlignVCenter | Qt::AlignLeft, tr("Texels as the view shows them"));
        return;
    }
    if (!m_picture->weights || m_picture->weights->texels.empty()) {
        painter.drawText(text, Qt::AlignVCenter | Qt::AlignLeft, tr("Weights: …"));
        return;
    }
    const QString low = tr("Weight 0");
    const Contribution& heaviest = m_picture->weights->texels.front();
    const QString high = tr("%1 %").arg(100 * heaviest.weight, 0, 'g', 3);
    painter.drawText(text, Qt::AlignVCenter | Qt::AlignLeft, low);
    painter.drawText(text, Qt::AlignVCenter | Qt::AlignRight, high);
    const QFontMetricsF metrics(painter.font());
    const QRectF bar(text.left() + metrics.horizontalAdvance(low) + 8,
                     strip.center().y() - 5,
                     text.width() - metrics.horizontalAdvance(low) -
                         metrics.horizontalAdvance(high) - 16,
                     10);
    QLinearGradient gradient(bar.topLeft(), bar.topRight());
    constexpr int kStops = 16;
    for (int k = 0; k <= kStops; ++k) {
        gradient.setColorAt(double(k) / kStops, weightColor(double(k) / kStops));
    }
    painter.fillRect(bar, gradient);
}

} // namespace trixel::ui
