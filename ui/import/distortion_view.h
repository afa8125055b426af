// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <QThreadPool>

#include "ui/import/distortion_work.h"
#include "ui/viewport/hovered_texel.h"

#include <memory>
#include <optional>

namespace trixel::ui {

class MapLegend;
class Viewport;

/// How a mapping distorts the image, as colours over the surface, with a legend. Made on another
/// thread; what is asked for meanwhile follows.
class DistortionView : public QObject
{
    Q_OBJECT

public:
    /// \param viewport  outlives this
    DistortionView(Viewport& viewport, QObject* parent);
    ~DistortionView() override;

    void ask(ImportInput input, DistortionMeasure measure);
    /// Shows the surface itself again.
    void drop();
    bool isShown() const { return m_shown != nullptr; }
    const std::shared_ptr<const DistortionColors>& shown() const { return m_shown; }
    const MapLegend& legend() const { return *m_legend; }

signals:
    void changed();

private:
    struct Wanted
    {
        ImportInput input;
        DistortionMeasure measure{};
    };
    using Answer = std::shared_ptr<const DistortionColors>;

    void begin();
    void takeAnswer();
    void hover(const std::optional<HoveredTexel>& texel);

    Viewport& m_viewport;
    MapLegend* m_legend; ///< a child of the view
    QThreadPool m_thread;
    QFutureWatcher<Answer> m_watcher;
    std::optional<Wanted> m_waiting;
    bool m_isRunning = false;
    bool m_isAsked = false;
    std::shared_ptr<const DistortionColors> m_shown;
};

} // namespace trixel::ui
