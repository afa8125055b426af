// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <QThreadPool>

#include "core/base/result.h"
#include "core/layers/compose.h"
#include "ui/document/change.h"

#include <memory>
#include <optional>

namespace trixel::ui {

/// Works out on another thread what layers look like while the GUI thread goes on. Asked for others
/// meanwhile it finishes what it is at, which is something to look at while a slider is dragged,
/// and then does the last ones asked for. Destroyed or dropped it leaves nothing and waits for
/// nothing.
class LayerComposer : public QObject
{
    Q_OBJECT

public:
    /// \param thread  runs the work; outlives it
    explicit LayerComposer(QThreadPool& thread);
    ~LayerComposer() override;

    /// \param now  what is shown, and the layers it was made of; not asked for while this runs
    void start(LayerStack next, const Layered& now);
    bool isRunning() const { return m_work != nullptr; }
    /// Nothing of it is told any more.
    void drop();

signals:
    /// What to show from now on; the last time, what was asked for last.
    /// \param change  nothing where it is as before
    void composed(const trixel::TexelStore& shown, const std::optional<trixel::ui::Change>& change);
    /// Of all that was asked for.
    void finished();
    /// What was asked for last cannot be shown. \param why  a sentence
    void failed(const QString& why);

private:
    struct Work;
    void begin();
    void takeResult();

    QThreadPool& m_thread;
    std::shared_ptr<Work> m_work;       ///< belongs to the other thread until it is done
    Layered m_now;                      ///< told last
    std::optional<LayerStack> m_wanted; ///< after the present work
    std::unique_ptr<QFutureWatcher<void>> m_watcher;
};

/// Whether layers are worked out so quickly that the window may wait: in a few milliseconds.
bool isQuicklyComposed(const LayerStack& layers);

/// What differs between two looks of one mesh; nothing where nothing does.
std::optional<Change> changeBetween(const TexelStore& before, const TexelStore& after);

} // namespace trixel::ui
