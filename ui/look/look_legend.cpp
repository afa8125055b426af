// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/look_legend.h"

#include <QPainter>

#include "ui/look/look_words.h"
#include "ui/look/mark_brush.h"
#include "ui/look/value_axis.h"

#include <algorithm>
#include <cmath>

namespace trixel::ui {

namespace {

constexpr int kMargin = 8; // to the view's edge
constexpr int kInset = 10;
constexpr int kWidth = 400;
constexpr int kBarHeight = 12;
constexpr int kTick = 4;
constexpr int kTickRoom = 52;
constexpr int kGap = 5;
constexpr int kBetween = 12; // marks
constexpr QSize kSwatch(24, 14);
// Readable over any texels, in either theme.
constexpr QColor kGround(22, 22, 24, 225);
constexpr QColor kInk(0xe2, 0xe2, 0xe2);
constexpr QColor kFaint(0xa8, 0xa8, 0xac);

} // namespace

LookLegend::LookLegend(QWidget* view)
    : QWidget(view)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAccessibleName(tr("What false colours and marks mean"));
    hide();
}

void LookLegend::setLook(const TexelFormat& format, const render::Look& look)
{
    m_format = format;
    m_look = look;
    m_title = look.falseColor ? tr("%1 in false colour").arg(shownName(format, look)) : QString();
    m_value.reset();
    setAccessibleDescription(look.falseColor ? tr("%1, from %2 to %3")
                                                   .arg(m_title,
                                                        ui::valueText(double{look.blackValue()}),
                                                        ui::valueText(double{look.whiteValue()}))
                                             : QString());
    update();
}

void LookLegend::setValue(std::optional<float> value)
{
    if (value != m_value) {
        m_value = value;
        update();
    }
}

QString LookLegend::valueText() const
{
    return m_value && m_look.falseColor ? ui::valueText(double{*m_value}) : QString();
}

/// Those that texels of the format can deserve.
std::vector<render::Mark> LookLegend::marks() const
{
    if (!m_look.marks) {
        return {};
    }
    if (m_format.type == TexelType::UInt8 || m_format.type == TexelType::UInt16) {
        return {render::Mark::Clipped};
    }
    return {render::kMarks.begin(), render::kMarks.end()};
}

int LookLegend::marksWidth() const
{
    int width = 0;
    for (const render::Mark mark : marks()) {
        width += (width > 0 ? kBetween : 0) + kSwatch.width() + kGap +
                 fontMetrics().horizontalAdvance(markName(mark));
    }
    return width;
}

void LookLegend::place(int top)
{
    const int line = fontMetrics().lineSpacing();
    int height = 2 * kInset;
    if (m_look.falseColor) {
        height += line + kGap + kBarHeight + kTick + line;
    }
    if (m_look.marks) {
        height += (m_look.falseColor ? kGap : 0) + std::max(line, kSwatch.height());
    }
    const int wanted = std::max(m_look.falseColor ? kWidth : 0, marksWidth() + 2 * kInset);
    resize(std::min(wanted, parentWidget()->width() - 2 * kMargin), height);
    move(kMargin, top);
    update();
}

void LookLegend::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(kGround);
    painter.drawRoundedRect(rect(), 4, 4);
    painter.setRenderHint(QPainter::Antialiasing, false);
    const int line = fontMetrics().lineSpacing();
    int top = kInset;
    if (m_look.falseColor) {
        const QRect head(kInset, top, width() - 2 * kInset, line);
        painter.setPen(kInk);
        painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter, m_title);
        if (const QString value = valueText(); !value.isEmpty()) {
            painter.drawText(
                head, Qt::AlignRight | Qt::AlignVCenter, tr("Under the pointer: %1").arg(value));
        }
        paintScale(painter, top + line + kGap);
        top += line + kGap + kBarHeight + kTick + line + kGap;
    }
    paintMarks(painter, top);
}

void LookLegend::paintScale(QPainter& painter, int top) const
{
    const QRect bar(kInset, top, width() - 2 * kInset, kBarHeight);
    const double black = double{m_look.blackValue()};
    const double white = double{m_look.whiteValue()};
    const TexelFormat single{TexelType::Float, 1, {}};
    render::Look alone = m_look;
    alone.channel = 0;
    alone.marks = false;
    const render::LookRule rule = render::LookRule::of(single, alone);
    for (int x = 0; x < bar.width(); ++x) {
        const auto value =
            static_cast<float>(black + (white - black) * x / std::max(1, bar.width() - 1));
        const render::Rgba color = render::shade(rule, {&value, 1});
        painter.fillRect(bar.left() + x, top, 1, kBarHeight, QColor(color[0], color[1], color[2]));
    }
    const auto placeOf = [&](double value) {
        const double position = std::clamp((value - black) / (white - black), 0.0, 1.0);
        return bar.left() + static_cast<int>(std::lround(position * (bar.width() - 1)));
    };
    painter.setPen(kFaint);
    const int most = std::max(2, bar.width() / kTickRoom);
    const auto ticks = roundTicks(std::min(black, white), std::max(black, white), most);
    for (const AxisTick& tick : ticks) {
        const int x = placeOf(tick.value);
        painter.drawLine(x, bar.bottom() + 1, x, bar.bottom() + kTick);
        const int textWidth = fontMetrics().horizontalAdvance(tick.text);
        const int left = std::clamp(x - textWidth / 2, bar.left(), bar.right() + 1 - textWidth);
        painter.drawText(left, bar.bottom() + kTick + fontMetrics().ascent() + 1, tick.text);
    }
    if (m_value && !std::isnan(*m_value)) {
        painter.setPen(Qt::black);
        painter.setBrush(Qt::white);
        painter.drawRect(placeOf(double{*m_value}) - 2, top - 2, 4, kBarHeight + 3);
    }
}

void LookLegend::paintMarks(QPainter& painter, int top) const
{
    int x = kInset;
    const int line = fontMetrics().lineSpacing();
    for (const render::Mark mark : marks()) {
        const QRect swatch(QPoint(x, top + (line - kSwatch.height()) / 2), kSwatch);
        painter.setBrushOrigin(swatch.topLeft());
        painter.fillRect(swatch, markBrush(mark));
        const QString name = markName(mark);
        const int textWidth = fontMetrics().horizontalAdvance(name);
        painter.setPen(kInk);
        painter.drawText(swatch.right() + 1 + kGap, top + fontMetrics().ascent(), name);
        x = swatch.right() + 1 + kGap + textWidth + kBetween;
    }
}

} // namespace trixel::ui
