// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/haloed_text.h"

#include <QFontMetricsF>
#include <QPaintEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <QPixmapCache>

#include <cmath>

namespace trixel::ui {

namespace {

void drawAsShapes(QPainter& painter, const HaloedInk& ink, QPointF centre, const QString& text)
{
    const QFontMetricsF metrics(ink.font);
    const QRectF bounds = metrics.tightBoundingRect(text);
    QPainterPath path;
    path.addText(centre - bounds.center(), ink.font, text);
    painter.strokePath(path, QPen(ink.halo, ink.width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.fillPath(path, ink.color);
}

QPixmap pictureOf(const HaloedInk& ink, const QString& text, double ratio)
{
    const QString key = QString("haloed|%1|%2|%3|%4|%5|%6")
                            .arg(text, ink.font.key())
                            .arg(ink.color.rgba())
                            .arg(ink.halo.rgba())
                            .arg(ink.width)
                            .arg(ratio);
    QPixmap picture;
    if (QPixmapCache::find(key, &picture)) {
        return picture;
    }
    // Of an odd size, so that its centre is the middle of a pixel.
    const QRectF bounds = QFontMetricsF(ink.font).tightBoundingRect(text);
    const auto odd = [&](double extent) {
        return 2 * static_cast<int>(std::ceil(ratio * (extent / 2 + ink.width))) + 1;
    };
    picture = QPixmap(odd(bounds.width()), odd(bounds.height()));
    picture.setDevicePixelRatio(ratio);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    const QSizeF size = picture.deviceIndependentSize();
    drawAsShapes(painter, ink, {size.width() / 2, size.height() / 2}, text);
    painter.end();
    QPixmapCache::insert(key, picture);
    return picture;
}

} // namespace

void drawHaloed(QPainter& painter, const HaloedInk& ink, QPointF centre, const QString& text)
{
    const bool isMoved = painter.worldTransform().type() <= QTransform::TxTranslate;
    if (painter.paintEngine()->type() != QPaintEngine::Raster || !isMoved) {
        drawAsShapes(painter, ink, centre, text);
        return;
    }
    const QPixmap picture = pictureOf(ink, text, painter.device()->devicePixelRatioF());
    const QSizeF size = picture.deviceIndependentSize();
    const QPointF corner = centre - QPointF(size.width(), size.height()) / 2;
    painter.drawPixmap(QPointF(std::round(corner.x()), std::round(corner.y())), picture);
}

} // namespace trixel::ui
