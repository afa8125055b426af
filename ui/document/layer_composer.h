// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>

#include "core/base/result.h"
#include "core/layers/compose.h"
#include "ui/document/background_job.h"
#include "ui/document/change.h"

#include <memory>
#include <optional>

namespace trixel::ui {

/// Works out on another thread what layers look like while the GUI thread goes on. Asked for others
/// meanwhile it finishes what it is at, which is something to look at while a slider is dragged,
/// and then does the last ones asked for. Dropped it leaves nothing and waits for nothing.
class LayerComposer : public QObject
{
    Q_OBJECT

public:
    ~LayerComposer() override;

    /// Has the work seen and cancelled there. \param jobs  outlives all that is begun
    void useJobs(BackgroundJobs& jobs) { m_jobs = &jobs; }

    /// \param now  what is shown, and the layers it was made of; not asked for while this runs
    void start(LayerStack next, const Layered& now);
    bool isRunning() const { return m_work != nullptr; }
    /// Whether what was told last is what was asked for last: not while this runs, and not where it
    /// failed, before it is dropped.
    bool isCurrent() const { return m_isCurrent; }
    /// Nothing of it is told any more, nor needs to be.
    void drop();

signals:
    /// What to show from now on; the last time, what was asked for last.
    /// \param change  nothing where it is as before
    void composed(const trixel::TexelStore& shown, const std::optional<trixel::ui::Change>& change);
    /// Of all that was asked for.
    void finished();
    /// What was asked for last cannot be shown, or is not to be: it was cancelled.
    void failed(const trixel::Error& why);

private:
    struct Work;
    void begin();
    void takeResult(Status made);

    BackgroundJobs m_ownJobs; ///< as long as no others are used
    BackgroundJobs* m_jobs = &m_ownJobs;
    QPointer<BackgroundJob> m_job;
    std::shared_ptr<Work> m_work;       ///< belongs to the other thread until it is done
    Layered m_now;                      ///< told last
    std::optional<LayerStack> m_wanted; ///< after the present work
    bool m_isCurrent = true;
};

/// Whether layers are worked out so quickly that the window may wait: in a few milliseconds. Reads
/// nothing.
bool isQuicklyComposed(const LayerStack& layers);

/// What differs between two looks of one mesh; nothing where nothing does.
std::optional<Change> changeBetween(const TexelStore& before, const TexelStore& after);

} // namespace trixel::ui
