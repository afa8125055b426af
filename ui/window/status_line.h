// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QTimer>

#include "ui/document/background_job.h"

namespace trixel::ui {

class Document;

/// What is open, in the status bar: faces, texels, memory, type and channels. The memory is
/// counted in the background a moment after painting pauses.
class StatusLine : public QLabel
{
    Q_OBJECT

public:
    explicit StatusLine(Document& document, QWidget* parent = nullptr);

private:
    void count();
    QString withoutCounts() const;
    QString channelsText() const;

    Document& m_document;
    QTimer m_pause;
    quint64 m_generation = 0;
    BackgroundJobs m_jobs;
};

} // namespace trixel::ui
