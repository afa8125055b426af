// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>

#include "core/resample/transfer_paint.h"
#include "ui/document/background_job.h"
#include "ui/document/document.h"

#include <memory>

namespace trixel::ui {

/// Brings paint from another project's surface onto the open one's, in the background and as one
/// undo step: as a layer of its own where the open project has layers.
class PaintTransfer : public QObject
{
    Q_OBJECT

public:
    PaintTransfer(Document& document, BackgroundJobs& jobs, QObject* parent = nullptr);

    /// Another transfer under way is given up.
    /// \param path  the file that `from` was opened from
    void
    begin(std::shared_ptr<const Project> from, const QString& path, const TransferOptions& options);

signals:
    /// One sentence about what was done.
    void transferred(const QString& sentence);
    /// One sentence that names the file; nothing is told of cancelled work.
    void failed(const QString& sentence);

private:
    void beginNow(std::shared_ptr<const Project> from,
                  const QString& path,
                  const TransferOptions& options);
    struct Made;
    static Result<Made> make(const Project& from,
                             const Project& to,
                             LayerId active,
                             const QString& file,
                             const TransferOptions& options,
                             Progress& progress);
    void take(Result<Made> made, const QString& path, StateId madeFor);

    Document& m_document;
    BackgroundJobs& m_jobs;
    QPointer<BackgroundJob> m_job;
};

} // namespace trixel::ui
