// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/map_legend.h"

#include <QPainter>

#include <algorithm>

namespace trixel::ui {

namespace {

constexpr int kMargin = 8; // to the view's edge
constexpr int kInset = 10;
constexpr int kWidth = 380;
constexpr int kBarHeight = 12;
constexpr int kTick = 4;
constexpr int kGap = 5;
// Readable over any texels, in either theme.
constexpr QColor kGround(22, 22, 24, 225);
constexpr QColor kInk(0xe2, 0xe2, 0xe2);
constexpr QColor kFaint(0xa8, 0xa8, 0xac);

bool hasScale(ViewMapKind map)
{
    return map != ViewMapKind::None && map != ViewMapKind::Filtered;
}

} // namespace

MapLegend::MapLegend(QWidget* view)
    : QWidget(view)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAccessibleName(tr("What the colours of the map mean"));
    hide();
}

void MapLegend::setMap(ViewMapKind map, const QString& title)
{
    setMap(map, title, hasScale(map) ? MapScale::of(map) : m_scale);
}

void MapLegend::setMap(ViewMapKind map, const QString& title, const MapScale& scale)
{
    m_map = map;
    m_title = title;
    m_scale = scale;
    m_value.reset();
    setVisible(map != ViewMapKind::None);
    describe();
    place();
}

void MapLegend::setState(const QString& state)
{
    if (state != m_state) {
        m_state = state;
        describe();
        update();
    }
}

void MapLegend::setValue(std::optional<float> value)
{
    if (value != m_value) {
        m_value = value;
        update();
    }
}

QString MapLegend::valueText() const
{
    return m_value && hasScale(m_map) ? MapScale::text(m_map, double{*m_value}) : QString();
}

void MapLegend::describe()
{
    setAccessibleDescription(m_state.isEmpty() ? m_title : m_title + " " + m_state);
}

int MapLegend::titleLines() const
{
    const QRect wrapped = fontMetrics().boundingRect(
        QRect(0, 0, kWidth - 2 * kInset, 1000), Qt::TextWordWrap, m_title);
    return std::max(
        1, (wrapped.height() + fontMetrics().lineSpacing() / 2) / fontMetrics().lineSpacing());
}

void MapLegend::place()
{
    const int line = fontMetrics().lineSpacing();
    const int scale = hasScale(m_map) ? kGap + kBarHeight + kTick + line : 0;
    const int width = std::min(kWidth, parentWidget()->width() - 2 * kMargin);
    resize(width, 2 * kInset + titleLines() * line + scale + kGap + line);
    move(parentWidget()->width() - width - kMargin, kMargin);
    update();
}

void MapLegend::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(kGround);
    painter.drawRoundedRect(rect(), 4, 4);

    const int line = fontMetrics().lineSpacing();
    QRect text = rect().adjusted(kInset, kInset, -kInset, -kInset);
    painter.setPen(kInk);
    painter.drawText(text, Qt::TextWordWrap, m_title);
    int top = text.top() + titleLines() * line;
    if (hasScale(m_map)) {
        paintScale(painter, top + kGap);
    }
    const QRect bottom(text.left(), rect().bottom() - kInset - line, text.width(), line);
    painter.setPen(kFaint);
    painter.drawText(bottom, Qt::AlignLeft | Qt::AlignVCenter, m_state);
    painter.setPen(kInk);
    if (const QString value = valueText(); !value.isEmpty()) {
        painter.drawText(
            bottom, Qt::AlignRight | Qt::AlignVCenter, tr("Under the pointer: %1").arg(value));
    }
}

void MapLegend::paintScale(QPainter& painter, int top) const
{
    const QRect bar(kInset, top, width() - 2 * kInset, kBarHeight);
    for (int x = 0; x < bar.width(); ++x) {
        const auto color = render::mapColor(static_cast<double>(x) / (bar.width() - 1));
        painter.fillRect(bar.left() + x, top, 1, kBarHeight, QColor(color[0], color[1], color[2]));
    }
    const auto placeOf = [&](double value) {
        const double position = std::clamp(m_scale.position(value), 0.0, 1.0);
        return bar.left() + static_cast<int>(position * (bar.width() - 1));
    };
    painter.setPen(kFaint);
    for (const MapScale::Tick& tick : m_scale.ticks()) {
        const int x = placeOf(tick.value);
        painter.drawLine(x, bar.bottom() + 1, x, bar.bottom() + kTick);
        // The texts at the ends stay within the bar.
        const int textWidth = fontMetrics().horizontalAdvance(tick.text);
        const int left = std::clamp(x - textWidth / 2, bar.left(), bar.right() + 1 - textWidth);
        painter.drawText(left, bar.bottom() + kTick + fontMetrics().ascent() + 1, tick.text);
    }
    if (m_value && *m_value == *m_value) {
        const int x = placeOf(double{*m_value});
        painter.setPen(Qt::black);
        painter.setBrush(Qt::white);
        painter.drawRect(x - 2, top - 2, 4, kBarHeight + 3);
    }
}

} // namespace trixel::ui
