// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/job_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include "ui/document/background_job.h"

namespace trixel::ui {

namespace {

constexpr int kShowAfterMs = 250;
constexpr int kProgressWidth = 140;

} // namespace

JobBar::JobBar(BackgroundJobs& jobs, QWidget* parent)
    : QWidget(parent)
    , m_jobs(jobs)
    , m_title(new QLabel)
    , m_progress(new QProgressBar)
    , m_cancel(new QToolButton)
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addWidget(m_title);
    layout->addWidget(m_progress);
    layout->addWidget(m_cancel);

    m_title->setAccessibleName(tr("Work under way"));
    m_title->setToolTip(tr("What is being done in the background"));
    m_progress->setRange(0, 1000);
    m_progress->setFixedWidth(kProgressWidth);
    m_progress->setMaximumHeight(14);
    m_progress->setTextVisible(false);
    m_progress->setAccessibleName(tr("Progress"));
    m_progress->setToolTip(tr("How far the work is"));
    m_cancel->setText(tr("Cancel"));
    m_cancel->setAccessibleName(tr("Cancel the work under way"));
    m_cancel->setToolTip(tr("Stop the work; everything stays as it was before"));
    hide();

    m_delay.setSingleShot(true);
    m_delay.setInterval(kShowAfterMs);
    connect(&m_delay, &QTimer::timeout, this, &JobBar::show);
    connect(m_cancel, &QToolButton::clicked, this, [this] {
        if (BackgroundJob* job = m_jobs.latest()) {
            job->cancel();
        }
    });
    connect(&jobs, &BackgroundJobs::started, this, &JobBar::follow);
    connect(&jobs, &BackgroundJobs::ended, this, &JobBar::follow);
}

void JobBar::follow()
{
    BackgroundJob* job = m_jobs.latest();
    if (job == nullptr) {
        m_delay.stop();
        hide();
        return;
    }
    update(*job);
    connect(job, &BackgroundJob::progressed, this, &JobBar::follow, Qt::UniqueConnection);
    connect(job, &BackgroundJob::cancelRequested, this, &JobBar::follow, Qt::UniqueConnection);
    if (isHidden() && !m_delay.isActive()) {
        m_delay.start();
    }
}

void JobBar::update(const BackgroundJob& job)
{
    m_title->setText(job.isCancelled() ? tr("Stopping…") : job.title());
    m_progress->setValue(static_cast<int>(job.fraction() * m_progress->maximum()));
    m_cancel->setEnabled(!job.isCancelled());
}

} // namespace trixel::ui
