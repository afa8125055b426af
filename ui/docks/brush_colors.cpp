// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/brush_colors.h"

#include "ui/viewport/view_settings.h"

#include <algorithm>
#include <utility>

namespace trixel::ui {

namespace {

QColor asShown(const std::array<float, 4>& color)
{
    const auto channel = [&](std::size_t k) { return std::clamp(color[k], 0.0F, 1.0F); };
    return QColor::fromRgbF(channel(0), channel(1), channel(2), channel(3));
}

} // namespace

BrushColors::BrushColors(ViewSettings& settings, QObject* parent)
    : QObject(parent)
    , m_settings(settings)
{
    connect(&settings, &ViewSettings::brushChanged, this, &BrushColors::changed);
}

QColor BrushColors::color() const
{
    return asShown(m_settings.brush().color);
}

void BrushColors::choose(const QColor& color)
{
    setColor(usable(color));
}

void BrushColors::remember(const std::array<float, 4>& color)
{
    const QColor used = asShown(color);
    if (!m_recent.empty() && m_recent.front() == used) {
        return;
    }
    std::erase(m_recent, used);
    m_recent.insert(m_recent.begin(), used);
    m_recent.resize(std::min(m_recent.size(), kRecentMax));
    emit changed();
}

void BrushColors::choose(const std::array<float, 4>& color)
{
    // Values beyond [0,1], or finer than a QColor holds, are painted as they were picked.
    Brush brush = m_settings.brush();
    brush.color = color;
    m_settings.setBrush(brush);
}

void BrushColors::swap()
{
    const QColor front = color();
    setColor(std::exchange(m_other, front));
}

void BrushColors::reset()
{
    m_other = Qt::white;
    setColor(Qt::black);
}

void BrushColors::setGreyOnly(bool greyOnly)
{
    m_greyOnly = greyOnly;
    m_other = usable(m_other);
    setColor(usable(color()));
}

void BrushColors::restore(const std::vector<QColor>& recent)
{
    m_recent = recent;
    m_recent.resize(std::min(m_recent.size(), kRecentMax));
    emit changed();
}

void BrushColors::setColor(const QColor& color)
{
    Brush brush = m_settings.brush();
    brush.color = {color.redF(), color.greenF(), color.blueF(), color.alphaF()};
    m_settings.setBrush(brush); // tells of the change
}

QColor BrushColors::usable(const QColor& color) const
{
    if (!m_greyOnly) {
        return color;
    }
    const int grey = qGray(color.rgb());
    return {grey, grey, grey, color.alpha()};
}

} // namespace trixel::ui
