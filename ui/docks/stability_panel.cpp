// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/stability_panel.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <QTreeWidget>

#include "ui/charts/stability_plot.h"
#include "ui/charts/write_chart.h"
#include "ui/docks/chart_export.h"
#include "ui/docks/chart_view.h"
#include "ui/docks/stability_export.h"
#include "ui/document/background_job.h"
#include "ui/document/document.h"

#include <algorithm>

namespace trixel::ui {

namespace {

constexpr int kWide = 700;
constexpr int kListWidth = 400;
constexpr int kSpace = 6;
constexpr int kNameRole = Qt::UserRole;
constexpr int kFaceRole = Qt::UserRole + 1;

enum Column { kHazard, kOurs, kTextbook, kColumns };

/// Said by a sign and a word, never by colour alone.
QString verdict(bool holds)
{
    return holds ? QString::fromUtf8("✓ holds") : QString::fromUtf8("✗ fails");
}

} // namespace

StabilityPanel::StabilityPanel(const Document& document,
                               BackgroundJobs& jobs,
                               StabilityWork work,
                               QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_jobs(jobs)
    , m_run(jobs, std::move(work))
    , m_layout(new QBoxLayout(QBoxLayout::TopToBottom, this))
    , m_controls(new QWidget)
    , m_view(new ChartView)
    , m_about(new QLabel)
    , m_list(new QTreeWidget)
{
    auto* right = new QVBoxLayout;
    right->setSpacing(kSpace);
    right->addWidget(m_about);
    right->addWidget(m_view, 1);
    m_layout->setContentsMargins(8, 8, 8, 8);
    m_layout->setSpacing(8);
    m_layout->addWidget(m_controls);
    m_layout->addLayout(right, 1);
    m_about->setWordWrap(true);
    m_about->setAccessibleName(tr("What has to hold, and what goes wrong"));
    m_about->setToolTip(m_about->accessibleName());
    m_view->setAccessibleName(tr("Errors along the sweep"));
    m_view->setToolTip(tr("How far each formula is from the truth; arrows go from point to point"));
    makeControls();
    connectRun();
    listSubjects();
    showRun();
    connect(&m_document, &Document::opened, this, &StabilityPanel::listSubjects);
}

void StabilityPanel::makeControls()
{
    auto* column = new QVBoxLayout(m_controls);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace);
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace);
    m_subject = new QComboBox;
    m_subject->setAccessibleName(tr("Faces to look at"));
    m_subject->setToolTip(
        tr("The sweeps are the same; a project's own worst faces come with them"));
    m_subject->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_start = new QPushButton;
    m_export = new QToolButton;
    row->addWidget(m_subject, 1);
    row->addWidget(m_start);
    row->addWidget(m_export);
    column->addLayout(row);
    m_progress = new QProgressBar;
    m_progress->setAccessibleName(tr("Progress of the sweeps"));
    m_progress->setToolTip(tr("How many of the sweeps are done"));
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(6);
    m_progress->setRange(0, 1000);
    column->addWidget(m_progress);
    column->addWidget(m_list, 1);
    makeList();
    makeExports();
    connect(m_start, &QPushButton::clicked, this, &StabilityPanel::startOrCancel);
}

void StabilityPanel::makeList()
{
    m_list->setAccessibleName(tr("Hazards"));
    m_list->setToolTip(tr("Choose a hazard to see its sweep, a face to look at it"));
    m_list->setHeaderLabels({tr("Hazard"), tr("Ours"), tr("Textbook")});
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setMinimumHeight(90);
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setSectionResizeMode(kHazard, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(kOurs, QHeaderView::ResizeToContents);
    m_list->header()->setSectionResizeMode(kTextbook, QHeaderView::ResizeToContents);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &StabilityPanel::activate);
    connect(m_list, &QTreeWidget::itemActivated, this, &StabilityPanel::activate);
    connect(m_list, &QTreeWidget::itemClicked, this, &StabilityPanel::activate);
}

void StabilityPanel::makeExports()
{
    m_export->setText(tr("Export"));
    m_export->setAccessibleName(tr("Export the report"));
    m_export->setToolTip(tr("Write the report, or the chart shown, to a file"));
    m_export->setPopupMode(QToolButton::InstantPopup);
    m_export->setFocusPolicy(Qt::StrongFocus);
    m_export->setMenu(
        makeExportMenu(kStabilityFormats, *m_export, [this](const ExportFormat& format) {
            const QString name = isOfOneSweep(format) ? m_shown : QString("stability");
            askForExport(
                format, name, *this, [this, format](const QString& path) { write(path, format); });
        }));
}

void StabilityPanel::connectRun()
{
    connect(&m_run, &StabilityRun::started, this, &StabilityPanel::showRun);
    connect(&m_run, &StabilityRun::ended, this, &StabilityPanel::showRun);
    connect(&m_run, &StabilityRun::failed, this, &StabilityPanel::failed);
    connect(&m_run, &StabilityRun::grew, this, &StabilityPanel::listSweeps);
    connect(&m_run, &StabilityRun::progressed, this, [this] {
        m_progress->setValue(static_cast<int>(m_run.fraction() * m_progress->maximum()));
    });
}

void StabilityPanel::listSubjects()
{
    m_subject->clear();
    if (m_document.isOpen()) {
        m_subject->addItem(tr("Sweeps and this project's faces"), true);
    }
    m_subject->addItem(tr("Sweeps alone"), false);
}

void StabilityPanel::startOrCancel()
{
    if (m_run.isRunning()) {
        m_run.cancel();
        m_start->setEnabled(false); // until the work has heard
        return;
    }
    StabilityInput input;
    if (m_subject->currentData().toBool()) {
        input = {m_document.snapshot(), m_document.title()};
    }
    m_run.start(std::move(input));
}

void StabilityPanel::showRun()
{
    const bool running = m_run.isRunning();
    m_start->setText(running ? tr("Cancel") : tr("Run"));
    m_start->setAccessibleName(running ? tr("Cancel the sweeps") : tr("Run the sweeps"));
    m_start->setToolTip(running ? tr("Stop; the sweeps that are done stay")
                                : tr("Sweep through every hazard in the background"));
    m_start->setEnabled(true);
    m_progress->setValue(0);
    m_progress->setVisible(running);
    m_export->setEnabled(!running && !m_run.report().sweeps.empty());
    m_view->setEmptyText(running ? tr("Sweeping… the first result comes in a moment.")
                                 : tr("Nothing was swept yet: press Run."));
}

/// The rows grow while the sweeps run; the chosen one stays.
void StabilityPanel::listSweeps()
{
    const StabilityReport& report = m_run.report();
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    for (const StabilitySweep& one : report.sweeps) {
        auto* row = new QTreeWidgetItem(m_list);
        row->setText(kHazard, QString::fromStdString(one.title));
        row->setToolTip(kHazard, QString::fromStdString(one.hazard));
        row->setText(kOurs, verdict(one.holds()));
        row->setToolTip(kOurs, tr("Largest error: %1").arg(worstText(one, false)));
        const bool hasNaive = std::ranges::any_of(one.curves, &StabilityCurve::naive);
        const std::size_t failures = one.naiveFailures();
        row->setText(kTextbook,
                     !hasNaive       ? QString(QChar(0x2013))
                     : failures == 0 ? verdict(true)
                                     : tr("✗ %1 of %2").arg(failures).arg(one.values.size()));
        row->setToolTip(kTextbook, tr("Values at which the textbook's formula leaves the bound"));
        row->setData(kHazard, kNameRole, QString::fromStdString(one.name));
        if (QString::fromStdString(one.name) == m_shown) {
            m_list->setCurrentItem(row);
        }
    }
    addFindings();
    if (m_list->currentItem() == nullptr && m_list->topLevelItemCount() > 0) {
        m_list->setCurrentItem(m_list->topLevelItem(0));
        m_shown = m_list->topLevelItem(0)->data(kHazard, kNameRole).toString();
    }
    showSweep();
}

/// Below the sweeps: what the project's own faces hold of the hazards.
void StabilityPanel::addFindings()
{
    for (const AssetFinding& finding : m_run.report().findings) {
        auto* row = new QTreeWidgetItem(m_list);
        row->setText(kHazard,
                     tr("On this mesh: %1: %2")
                         .arg(QString::fromStdString(finding.title))
                         .arg(finding.count));
        row->setText(kOurs, verdict(finding.holds()));
        row->setText(kTextbook, QString(QChar(0x2013)));
        row->setToolTip(
            kHazard,
            finding.face
                ? tr("Click to look at the worst, face %1").arg(static_cast<quint32>(*finding.face))
                : tr("There is none"));
        if (finding.face) {
            row->setData(kHazard, kFaceRole, static_cast<quint32>(*finding.face));
        }
    }
}

void StabilityPanel::activate(const QTreeWidgetItem* item)
{
    if (item == nullptr) {
        return;
    }
    const QVariant face = item->data(kHazard, kFaceRole);
    if (face.isValid()) {
        emit faceChosen(FaceId{face.toUInt()});
    } else if (const QVariant name = item->data(kHazard, kNameRole); name.isValid()) {
        m_shown = name.toString();
        showSweep();
    }
}

const StabilitySweep* StabilityPanel::sweep() const
{
    const auto& sweeps = m_run.report().sweeps;
    const auto found = std::ranges::find(sweeps, m_shown.toStdString(), &StabilitySweep::name);
    return found != sweeps.end() ? &*found : nullptr;
}

void StabilityPanel::showSweep()
{
    const StabilitySweep* shown = sweep();
    m_about->setVisible(shown != nullptr);
    if (shown == nullptr) {
        m_view->setPlot({}, {});
        return;
    }
    m_about->setText(QString::fromStdString(shown->property + " " + shown->hazard));
    m_view->setPlot(plotOf(*shown),
                    [copy = *shown](std::size_t source) { return describe(copy, source); });
}

void StabilityPanel::write(const QString& path, const ExportFormat& format)
{
    const StabilitySweep* shown = sweep();
    const auto work = [report = m_run.report(),
                       shown = shown != nullptr ? *shown : StabilitySweep(),
                       path,
                       format](Progress& /*progress*/) -> Status {
        return writeStability(report, shown, format, path.toStdU16String());
    };
    m_jobs.run(tr("Exporting the report…"), work, [self = QPointer(this), path](Status status) {
        if (self) {
            status ? emit self->written(tr("Exported %1").arg(path))
                   : emit self->failed(QString::fromStdString(status.error().message));
        }
    });
}

void StabilityPanel::resizeEvent(QResizeEvent* event)
{
    const bool wide = width() >= kWide;
    m_layout->setDirection(wide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    m_controls->setMaximumWidth(wide ? kListWidth : QWIDGETSIZE_MAX);
    m_controls->setMinimumWidth(wide ? kListWidth : 0);
    QWidget::resizeEvent(event);
}

} // namespace trixel::ui
