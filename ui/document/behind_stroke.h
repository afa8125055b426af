// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <QThreadPool>

#include "core/paint/stroke.h"
#include "core/paint/stroke_dabs.h"
#include "ui/document/layer_paint.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace trixel::ui {

/// A change of a layer's texels, and of what they look like with the others, that is made on
/// another thread, in a copy of all, while the GUI thread goes on: a stroke, dab by dab as they are
/// placed, or a fill. What it has made so far comes back from time to time; the texels in the end
/// are those that `Stroke` and `fillFaces` make on the spot. Destroyed before the end it leaves
/// nothing, and waits for nothing.
class BehindStroke : public QObject
{
    Q_OBJECT

public:
    /// A stroke. \param layer  to be painted, of `before`
    /// \param fill  the bytes of one shown texel that Erase moves towards
    /// \param thread  runs the work; outlives it
    BehindStroke(std::shared_ptr<const Surface> surface,
                 Layered before,
                 LayerId layer,
                 const Brush& brush,
                 std::vector<std::byte> fill,
                 QThreadPool& thread);
    /// A fill, which has ended as soon as it is made.
    BehindStroke(Layered before,
                 LayerId layer,
                 std::vector<FaceId> faces,
                 std::vector<std::byte> texel,
                 QThreadPool& thread);
    ~BehindStroke() override;

    /// Adds a sample to a stroke; returns the dabs it completes, which will be painted.
    std::vector<PlacedDab> add(const StrokeSample& sample);
    void lift();
    /// No more samples.
    void end();
    bool hasEnded() const { return m_ended; }
    /// Whether anything is to be painted.
    bool isEmpty() const { return m_isEmpty; }

    /// What there was before the change.
    const Layered& before() const { return m_before; }
    /// What `advanced` told last.
    const Layered& told() const { return m_told; }
    /// What `advanced` has told so far; each face once.
    std::vector<TouchedRect> touched() const;

signals:
    /// The change so far. \param touched  since the last time
    void advanced(const trixel::Layered& all, const std::vector<trixel::TouchedRect>& touched);
    /// All of it is in the texels told last. \param applied  what it replaced
    void finished(trixel::ui::LayerPatch& applied);

private:
    struct Work;
    using Job = std::function<void(Work&)>;

    BehindStroke(Layered before, LayerId layer, QThreadPool& thread);
    void start(Job job);
    void paintMore();
    void takeResult();

    QThreadPool& m_thread;
    Layered m_before;
    Layered m_told;
    std::shared_ptr<Work> m_work; ///< belongs to the other thread while a job runs
    QFutureWatcher<void> m_watcher;
    std::optional<StrokeDabs> m_dabs; ///< of a stroke
    std::vector<PlacedDab> m_waiting; ///< for the job to come
    std::vector<FaceId> m_touched;    ///< in ascending order
    bool m_running = false;
    bool m_ended = false;
    bool m_isEmpty = true;
};

} // namespace trixel::ui
