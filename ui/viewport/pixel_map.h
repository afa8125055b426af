// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <QSize>

#include "ui/viewport/map_work.h"
#include "ui/viewport/viewport.h"

#include <optional>
#include <vector>

namespace trixel::ui {

/// The numbers of one view's pixels and the picture they make on one side of the view, while they
/// are computed: first coarsely, then finer until every pixel is its own.
class PixelMap : public QObject
{
    Q_OBJECT

public:
    PixelMap(Viewport& viewport, render::Side side, QObject* parent);
    ~PixelMap() override;

    /// Computes in the background until `drop`, or until another begins.
    void begin(MapWork work);
    /// Throws away what there is.
    void drop();

    /// The finest step that covers the whole view: 1 when every pixel is its own, 0 while there is
    /// nothing yet.
    int completeStep() const { return m_completeStep; }
    /// The step that is under way, 0 when none is, and the part of its rows that are there.
    int step() const { return m_step; }
    double partOfStep() const;
    /// The number at a device pixel; nothing off the surface, and for pictures.
    std::optional<float> valueAt(QPoint pixel) const;

signals:
    /// Part of the picture is there.
    void progressed();

private:
    void take(const MapBand& band);

    Viewport& m_viewport;
    render::Side m_side;
    QFutureWatcher<MapBand> m_watcher;
    std::vector<float> m_values; ///< of every pixel of the view; empty for pictures
    QSize m_size;
    int m_completeStep = 0;
    int m_step = 0;
    int m_rows = 0; ///< of the step that are there
};

} // namespace trixel::ui
