// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/import/import_preview.h"

#include <QtConcurrent>

#include <new>
#include <utility>

namespace trixel::ui {

namespace {

template <class Answer>
class CancelOnly final : public Progress
{
public:
    explicit CancelOnly(const QPromise<Answer>& promise)
        : m_promise(promise)
    {
    }
    bool report(double /*fraction*/) override { return !m_promise.isCanceled(); }

private:
    const QPromise<Answer>& m_promise;
};

} // namespace

ImportPreview::ImportPreview(QObject* parent)
    : QObject(parent)
{
    m_thread.setMaxThreadCount(1);
    connect(&m_watcher, &QFutureWatcherBase::finished, this, &ImportPreview::takeAnswer);
}

ImportPreview::~ImportPreview()
{
    m_watcher.disconnect(this);
    m_watcher.cancel();
    m_watcher.waitForFinished();
}

void ImportPreview::ask(ImportInput input, std::uint64_t texelsState)
{
    m_isAsked = true;
    m_waiting = std::move(input);
    m_waitingState = texelsState;
    if (!m_isRunning) {
        begin();
    } else if (!m_isFirstPass) {
        m_watcher.cancel();
    }
}

void ImportPreview::stop()
{
    m_isAsked = false;
    m_waiting.reset();
    m_watcher.cancel();
    if (!m_isRunning) {
        m_maker.reset();
        m_coarse.reset();
    }
}

void ImportPreview::begin()
{
    if (!m_coarse || m_coarseState != m_waitingState) {
        m_coarse = std::make_shared<CoarseFaces>(m_waiting->project.texels);
        m_coarseState = m_waitingState;
    }
    m_maker = std::make_shared<PreviewMaker>(*std::exchange(m_waiting, {}), m_coarse);
    run();
}

void ImportPreview::run()
{
    m_isRunning = true;
    m_isFirstPass = m_maker->isFirst();
    m_watcher.setFuture(QtConcurrent::run(&m_thread, [maker = m_maker](QPromise<Answer>& promise) {
        CancelOnly progress(promise);
        try {
            promise.addResult(std::make_shared<Result<std::shared_ptr<const PreviewPicture>>>(
                maker->next(progress)));
        } catch (const std::bad_alloc&) {
            // No answer is told as want of memory.
        }
    }));
}

void ImportPreview::takeAnswer()
{
    m_isRunning = false;
    if (!m_isAsked) {
        m_maker.reset();
        m_coarse.reset();
        return;
    }
    const bool wasCancelled = m_watcher.isCanceled();
    const Answer answer = m_watcher.future().resultCount() > 0 ? m_watcher.result() : nullptr;
    if (answer && *answer) {
        emit made(**answer);
    }
    if (m_waiting) {
        begin();
    } else if (!answer && !wasCancelled) {
        emit failed(tr("There is not enough memory for this."));
    } else if (answer && !*answer) {
        emit failed(QString::fromStdString(answer->error().message));
    } else if (!m_maker->isDone()) {
        run();
    }
}

} // namespace trixel::ui
