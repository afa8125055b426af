// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>

class QLabel;
class QProgressBar;
class QToolButton;

namespace trixel::ui {

class BackgroundJob;
class BackgroundJobs;

/// Shows the work under way in the status bar, with its progress and Cancel; hidden when idle, and
/// for work that is done before anyone could read it.
class JobBar : public QWidget
{
    Q_OBJECT

public:
    explicit JobBar(BackgroundJobs& jobs, QWidget* parent = nullptr);

private:
    void follow();
    void update(const BackgroundJob& job);

    BackgroundJobs& m_jobs;
    QTimer m_delay;
    QLabel* m_title;
    QProgressBar* m_progress;
    QToolButton* m_cancel;
};

} // namespace trixel::ui
