// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/difference_legend.h"

#include <QPainter>

#include "ui/inspector/difference_colors.h"
#include "ui/inspector/mip_text.h"

namespace trixel::ui {

namespace {

constexpr int kBarHeight = 10;
constexpr int kGap = 2;
constexpr int kWidth = 200;

} // namespace

DifferenceLegend::DifferenceLegend(QWidget* parent)
    : QWidget(parent)
{
    setAccessibleName(tr("Colours of differences"));
    setToolTip(tr("What the 2×2 box makes of a texel less what is right, in parts of 255, of the "
                  "channel that differs most or that the look shows alone"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void DifferenceLegend::setRange(double range)
{
    m_range = range;
    setAccessibleDescription(
        range > 0
            ? tr("From blue, %1 of 255, to vermilion, %2").arg(partsText(-range), partsText(range))
            : tr("Both reductions agree"));
    update();
}

QSize DifferenceLegend::sizeHint() const
{
    return {kWidth, kBarHeight + kGap + fontMetrics().lineSpacing()};
}

void DifferenceLegend::paint(QPainter& painter, const QRectF& place, const QColor& ink) const
{
    const QRectF bar(place.left(), place.top(), place.width(), kBarHeight);
    const int steps = static_cast<int>(bar.width());
    for (int x = 0; x < steps; ++x) {
        const QRgb color = differenceColor(2.0 * x / std::max(1, steps - 1) - 1);
        painter.fillRect(QRectF(bar.left() + x, bar.top(), 1, bar.height()), QColor(color));
    }
    painter.setPen(ink);
    const QRectF text(
        place.left(), bar.bottom() + kGap, place.width(), fontMetrics().lineSpacing());
    if (m_range > 0) {
        painter.drawText(text, Qt::AlignLeft, tr("box lower, %1").arg(partsText(-m_range)));
        painter.drawText(text, Qt::AlignRight, tr("box higher, %1").arg(partsText(m_range)));
    }
    painter.drawText(text, Qt::AlignHCenter, m_range > 0 ? QString("0") : tr("no difference"));
}

void DifferenceLegend::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    paint(painter, rect(), palette().color(QPalette::WindowText));
}

} // namespace trixel::ui
