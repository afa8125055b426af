// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QObject>

#include <array>
#include <vector>

namespace trixel::ui {

class ViewSettings;

/// The colour to paint with (kept in the brush), the other one to swap it with, and those used
/// before. Colours are channel values as stored, in [0,1].
class BrushColors : public QObject
{
    Q_OBJECT

public:
    static constexpr std::size_t kRecentMax = 11;

    explicit BrushColors(ViewSettings& settings, QObject* parent = nullptr);

    QColor color() const;
    QColor other() const { return m_other; }
    /// Latest first, each once.
    const std::vector<QColor>& recent() const { return m_recent; }

    /// Paints with this from now on.
    void choose(const QColor& color);
    /// The same with channel values as picked from a texel, to the last digit.
    void choose(const std::array<float, 4>& color);
    /// Puts a colour, as channel values, first among the recent ones.
    void remember(const std::array<float, 4>& color);
    void swap();
    /// Black to paint with, white to swap it with.
    void reset();

    /// With one channel only greys make sense: chosen colours become their lightness.
    void setGreyOnly(bool greyOnly);
    bool isGreyOnly() const { return m_greyOnly; }

    void restore(const std::vector<QColor>& recent);

signals:
    void changed();

private:
    void setColor(const QColor& color);
    QColor usable(const QColor& color) const;

    ViewSettings& m_settings;
    QColor m_other = Qt::white;
    std::vector<QColor> m_recent;
    bool m_greyOnly = false;
};

} // namespace trixel::ui
