// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <QThreadPool>

#include "ui/import/preview_work.h"

#include <memory>
#include <optional>

namespace trixel::ui {

/// Makes previews on another thread. What is asked for while one is made takes its place: a coarse
/// one is still finished and told, so that something moves under the pointer, finer ones are not.
class ImportPreview : public QObject
{
    Q_OBJECT

public:
    explicit ImportPreview(QObject* parent = nullptr);
    ~ImportPreview() override;

    /// \param texelsState  equal ones mean equal texels
    void ask(ImportInput input, std::uint64_t texelsState);
    /// Nothing more is told.
    void stop();
    /// Whether more is to be told.
    bool isWorking() const { return m_isAsked && (m_isRunning || m_waiting); }

signals:
    void made(const std::shared_ptr<const trixel::ui::PreviewPicture>& picture);
    /// Why what was asked for last cannot be.
    void failed(const QString& sentence);

private:
    using Answer = std::shared_ptr<Result<std::shared_ptr<const PreviewPicture>>>;

    void begin();
    void run();
    void takeAnswer();

    QThreadPool m_thread;
    QFutureWatcher<Answer> m_watcher;
    std::shared_ptr<PreviewMaker> m_maker; ///< belongs to the other thread while a pass runs
    std::shared_ptr<CoarseFaces> m_coarse; ///< the same
    std::uint64_t m_coarseState = 0;
    std::optional<ImportInput> m_waiting;
    std::uint64_t m_waitingState = 0;
    bool m_isRunning = false;
    bool m_isAsked = false;
    bool m_isFirstPass = false;
};

} // namespace trixel::ui
