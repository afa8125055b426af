// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/mip_work.h"

#include <QPromise>

#include "core/io/ptx_reductions.h"
#include "ui/document/run_within_memory.h"

#include <utility>

namespace trixel::ui {

namespace {

/// Goes on as long as somebody waits.
template <class Answer>
class WaitedFor : public Progress
{
public:
    explicit WaitedFor(const QPromise<Answer>& promise)
        : m_promise(promise)
    {
    }
    bool report(double /*fraction*/) override { return !m_promise.isCanceled(); }

private:
    const QPromise<Answer>& m_promise;
};

} // namespace

MipWork::MipWork(QObject* parent)
    : QObject(parent)
{
    connect(&m_watcher, &QFutureWatcherBase::resultReadyAt, this, &MipWork::take);
    connect(&m_watcher, &QFutureWatcherBase::finished, this, [this] {
        const bool answered = !m_watcher.isCanceled();
        start();
        if (answered && isIdle()) {
            emit finished();
        }
    });
}

MipWork::~MipWork()
{
    m_watcher.disconnect(this);
    m_watcher.cancel();
    m_watcher.waitForFinished();
}

void MipWork::ask(const TexelFormat& format, const FaceTexels& face, bool reduce)
{
    m_watcher.cancel();
    m_question = Question{format, face, reduce};
    start();
}

void MipWork::drop()
{
    m_question.reset();
    m_watcher.cancel();
}

void MipWork::start()
{
    if (!m_question || m_watcher.isRunning()) {
        return;
    }
    m_watcher.setFuture(
        runWithinMemory<Answer>([question = *std::exchange(m_question, std::nullopt)](
                                    QPromise<Answer>& promise) { compute(promise, question); }));
}

void MipWork::take(int index)
{
    if (m_watcher.isCanceled()) {
        return;
    }
    const Answer answer = m_watcher.resultAt(index);
    if (answer.levels) {
        emit reduced(answer.levels);
    } else {
        emit measured(answer.level, answer.bytes);
    }
}

void MipWork::compute(QPromise<Answer>& promise, const Question& question)
{
    WaitedFor progress(promise);
    if (question.reduce) {
        Result<MipComparison> levels =
            MipComparison::build(question.format, question.face, progress);
        if (!levels) {
            return;
        }
        promise.addResult(
            Answer{std::make_shared<const MipComparison>(*std::move(levels)), Level(), 0});
    }
    // A block too large for the format is no news to a panel: the export says so.
    std::ignore = measurePtxLevels(
        question.format,
        question.face,
        [&](Level level, std::uint64_t bytes) {
            promise.addResult(Answer{nullptr, level, bytes});
        },
        progress);
}

} // namespace trixel::ui
