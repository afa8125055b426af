// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/viewport/map_scale.h"

#include <optional>

namespace trixel::ui {

/// What the colours over the view mean: a title, the scale with its numbers, the number under the
/// pointer and how far the computing is. In the upper right corner of the view.
class MapLegend : public QWidget
{
    Q_OBJECT

public:
    explicit MapLegend(QWidget* view);

    /// \param title  what is shown; one sentence
    void setMap(ViewMapKind map, const QString& title);
    /// \param scale  of the map's numbers
    void setMap(ViewMapKind map, const QString& title, const MapScale& scale);
    /// How far the picture is; empty when it is complete.
    void setState(const QString& state);
    /// Nothing where the pointer is off the surface.
    void setValue(std::optional<float> value);
    /// Takes the corner again, after the view has changed its size.
    void place();

    QString title() const { return m_title; }
    QString state() const { return m_state; }
    /// The number under the pointer as written; empty when there is none.
    QString valueText() const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void describe();
    int titleLines() const;
    void paintScale(class QPainter& painter, int top) const;

    ViewMapKind m_map = ViewMapKind::None;
    MapScale m_scale = MapScale::of(ViewMapKind::Error);
    QString m_title;
    QString m_state;
    std::optional<float> m_value;
};

} // namespace trixel::ui
