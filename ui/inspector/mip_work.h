// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFutureWatcher>
#include <QObject>

#include "core/texture/mip_comparison.h"

#include <memory>
#include <optional>

namespace trixel::ui {

/// Reduces and measures the levels of one face in the background; the newest question counts, and
/// an older one is stopped.
class MipWork : public QObject
{
    Q_OBJECT

public:
    explicit MipWork(QObject* parent = nullptr);
    ~MipWork() override;

    /// \param reduce  whether the levels are wanted, too, before their bytes
    void ask(const TexelFormat& format, const FaceTexels& face, bool reduce);
    /// No answer is wanted any more; the texels asked about are let go of as soon as may be.
    void drop();
    bool isIdle() const { return !m_question && !m_watcher.isRunning(); }

signals:
    void reduced(std::shared_ptr<const trixel::MipComparison> levels);
    /// Bytes of a level's block in a .ptx; the coarsest comes first.
    void measured(trixel::Level level, quint64 bytes);
    /// All that was asked is answered.
    void finished();

private:
    struct Question
    {
        TexelFormat format;
        FaceTexels face;
        bool reduce = false;
    };
    struct Answer
    {
        std::shared_ptr<const MipComparison> levels; ///< or the bytes of one
        Level level;
        std::uint64_t bytes = 0;
    };

    void start();
    void take(int index);
    static void compute(QPromise<Answer>& promise, const Question& question);

    QFutureWatcher<Answer> m_watcher;
    std::optional<Question> m_question; ///< the newest, not begun
};

} // namespace trixel::ui
