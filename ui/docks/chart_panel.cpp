// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/chart_panel.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>

#include "ui/charts/write_chart.h"
#include "ui/docks/chart_advice.h"
#include "ui/docks/chart_export.h"
#include "ui/docks/chart_view.h"
#include "ui/docks/value_row.h"
#include "ui/document/background_job.h"
#include "ui/document/document.h"
#include "ui/viewport/view_settings.h"

#include <algorithm>

namespace trixel::ui {

namespace {

/// From this width on the controls stand beside the chart.
constexpr int kWide = 560;
constexpr int kControlsWidth = 300;
constexpr int kSpace = 6;

enum Subject { kThisProject, kStored };

QComboBox* makeChoice(const QString& name, const QString& toolTip)
{
    auto* choice = new QComboBox;
    choice->setAccessibleName(name);
    choice->setToolTip(toolTip);
    choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    choice->setMinimumContentsLength(6);
    choice->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    return choice;
}

void addLabel(QGridLayout& grid, int row, const QString& text, QWidget* buddy)
{
    auto* label = new QLabel(text);
    label->setBuddy(buddy);
    label->setToolTip(buddy->toolTip());
    grid.addWidget(label, row, 0);
}

} // namespace

ChartPanel::ChartPanel(const Document& document,
                       ViewSettings& settings,
                       BackgroundJobs& jobs,
                       std::vector<StudyOffer> offers,
                       QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_settings(settings)
    , m_jobs(jobs)
    , m_offers(std::move(offers))
    , m_run(jobs)
    , m_layout(new QBoxLayout(QBoxLayout::TopToBottom, this))
    , m_controls(new QWidget)
    , m_view(new ChartView)
{
    m_layout->setContentsMargins(8, 8, 8, 8);
    m_layout->setSpacing(8);
    m_layout->addWidget(m_controls);
    m_layout->addWidget(m_view, 1);
    m_view->setAccessibleName(tr("Chart"));
    m_view->setToolTip(tr("Click a point to use its method. Keys: arrows go along and between "
                          "curves, Ctrl+arrows and Home along the front, Enter chooses."));
    makeControls();
    connectRun();
    listSubjects();
    showStudy();
    showRun();
    connect(&m_settings, &ViewSettings::methodChanged, this, &ChartPanel::showChosen);
    connect(&m_document, &Document::opened, this, [this] {
        listSubjects();
        m_subject->setCurrentIndex(0); // what was just opened is of most interest
    });
    connect(m_view, &ChartView::chosen, this, &ChartPanel::choose);
}

void ChartPanel::makeControls()
{
    auto* column = new QVBoxLayout(m_controls);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(kSpace);
    grid->setVerticalSpacing(kSpace);
    grid->setColumnStretch(1, 1);
    column->addLayout(grid);
    makeStudies(*grid);
    makeFilters(*grid);

    m_progress = new QProgressBar;
    m_progress->setAccessibleName(tr("Progress of the study"));
    m_progress->setToolTip(tr("How much of the study is done"));
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(6);
    m_progress->setRange(0, 1000);
    m_advice = new QLabel;
    m_advice->setWordWrap(true);
    m_advice->setAccessibleName(tr("Method for the tolerance"));
    m_advice->setToolTip(tr("Measured by this study, for the footprints shown"));
    m_advice->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column->addWidget(m_progress);
    column->addWidget(m_advice);
    column->addStretch(1);
}

void ChartPanel::makeStudies(QGridLayout& grid)
{
    m_study = makeChoice(tr("Study"), tr("What to measure"));
    for (const StudyOffer& offer : m_offers) {
        m_study->addItem(offer.title);
        m_study->setItemData(m_study->count() - 1, offer.about, Qt::ToolTipRole);
    }
    m_subject = makeChoice(tr("Subject of the study"), tr("What to measure it on"));
    m_start = new QPushButton;
    m_export = new QToolButton;
    makeExports();
    addLabel(grid, 0, tr("Stud&y"), m_study);
    grid.addWidget(m_study, 0, 1);
    grid.addWidget(m_export, 0, 2);
    addLabel(grid, 1, tr("O&n"), m_subject);
    grid.addWidget(m_subject, 1, 1);
    grid.addWidget(m_start, 1, 2);
    const auto tellAbout = [this] {
        m_study->setToolTip(offer() != nullptr ? offer()->about : tr("What to measure"));
    };
    tellAbout();
    connect(m_study, &QComboBox::currentIndexChanged, this, tellAbout);
    connect(m_study, &QComboBox::currentIndexChanged, this, &ChartPanel::listSubjects);
    connect(m_start, &QPushButton::clicked, this, &ChartPanel::startOrCancel);
}

void ChartPanel::makeFilters(QGridLayout& grid)
{
    m_class = makeChoice(tr("Class of footprints"),
                         tr("Footprints by their width in texels and by how long they are for it"));
    m_measure = makeChoice(tr("Measure of error"), tr("What the height of a point says"));
    m_measure->addItem(tr("RMS"), QVariant::fromValue(int(ErrorMeasure::Rms)));
    m_measure->addItem(tr("99th pct."), QVariant::fromValue(int(ErrorMeasure::P99)));
    m_measure->setItemData(1, tr("99 of 100 errors are smaller"), Qt::ToolTipRole);
    m_tolerance = new ScaledSpinBox(Scale::Logarithmic);
    m_tolerance->setRange(1e-6, 100);
    m_tolerance->setValue(1);
    m_tolerance->setSuffix(tr(" %"));
    m_tolerance->setAccessibleName(tr("Tolerance"));
    m_tolerance->setToolTip(tr("Largest error that will do, of the range of the values"));
    m_use = new QPushButton(tr("Use"));
    m_use->setAccessibleName(tr("Use the method for the tolerance"));
    m_use->setToolTip(tr("Filter with the cheapest method within the tolerance"));
    addLabel(grid, 2, tr("Sho&w"), m_class);
    grid.addWidget(m_class, 2, 1);
    grid.addWidget(m_measure, 2, 2);
    addLabel(grid, 3, tr("W&ithin"), m_tolerance);
    grid.addWidget(m_tolerance, 3, 1);
    grid.addWidget(m_use, 3, 2);
    connect(m_class, &QComboBox::currentIndexChanged, this, &ChartPanel::showStudy);
    connect(m_measure, &QComboBox::currentIndexChanged, this, &ChartPanel::showStudy);
    connect(m_tolerance, &QDoubleSpinBox::valueChanged, this, &ChartPanel::showStudy);
    connect(m_use, &QPushButton::clicked, this, &ChartPanel::chooseAdvised);
}

void ChartPanel::makeExports()
{
    m_export->setText(tr("E&xport"));
    m_export->setAccessibleName(tr("Export the study"));
    m_export->setToolTip(tr("Write the chart or its points to a file"));
    m_export->setPopupMode(QToolButton::InstantPopup);
    m_export->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    m_export->setFocusPolicy(Qt::StrongFocus);
    m_export->setMenu(makeExportMenu(kChartFormats, *m_export, [this](const ExportFormat& format) {
        askForExport(format, QString::fromStdString(m_run.study().name), *this, [this](auto path) {
            write(path);
        });
    }));
}

void ChartPanel::connectRun()
{
    connect(&m_run, &ChartRun::started, this, &ChartPanel::showRun);
    connect(&m_run, &ChartRun::ended, this, &ChartPanel::showRun);
    connect(&m_run, &ChartRun::failed, this, &ChartPanel::failed);
    connect(&m_run, &ChartRun::grew, this, [this] {
        listClasses();
        showStudy();
    });
    connect(&m_run, &ChartRun::progressed, this, [this] {
        m_progress->setValue(static_cast<int>(m_run.fraction() * m_progress->maximum()));
    });
}

const StudyOffer* ChartPanel::offer() const
{
    const int index = m_study->currentIndex();
    return index >= 0 ? &m_offers[static_cast<std::size_t>(index)] : nullptr;
}

void ChartPanel::listSubjects()
{
    const QVariant before = m_subject->currentData();
    m_subject->clear();
    const StudyOffer* chosen = offer();
    if (chosen != nullptr && chosen->onProject && m_document.isOpen()) {
        m_subject->addItem(tr("This project"), kThisProject);
    }
    if (chosen != nullptr && !chosen->stored.isEmpty()) {
        m_subject->addItem(chosen->stored, kStored);
    }
    m_subject->setCurrentIndex(std::max(0, m_subject->findData(before)));
    showRun();
}

/// Keeps the chosen class as long as there is anything to see of it.
void ChartPanel::listClasses()
{
    const auto classes = classesOf(m_run.study());
    const QSignalBlocker quiet(m_class);
    const QVariant before = m_class->currentData();
    m_class->clear();
    for (const auto& one : classes) {
        m_class->addItem(nameOf(one), one ? static_cast<int>(*one) : -1);
    }
    m_class->setCurrentIndex(classes.empty() ? -1 : std::max(0, m_class->findData(before)));
    m_class->setEnabled(classes.size() > 1);
}

StudyView ChartPanel::studyView() const
{
    StudyView view;
    const QVariant shown = m_class->currentData();
    if (shown.isValid() && shown.toInt() >= 0) {
        view.footprintClass = static_cast<FootprintClass>(shown.toInt());
    }
    view.measure = static_cast<ErrorMeasure>(m_measure->currentData().toInt());
    view.tolerance = m_tolerance->value() / 100;
    return view;
}

void ChartPanel::startOrCancel()
{
    if (m_run.isRunning()) {
        m_run.cancel();
        m_start->setEnabled(false); // until the work has heard
        return;
    }
    StudyInput input{std::nullopt, m_subject->currentText()};
    if (m_subject->currentData().toInt() == kThisProject) {
        input = {m_document.snapshot(), m_document.title()};
    }
    m_run.start(*offer(), std::move(input));
}

void ChartPanel::showRun()
{
    const bool running = m_run.isRunning();
    m_start->setText(running ? tr("Cancel") : tr("R&un"));
    m_start->setAccessibleName(running ? tr("Cancel the study") : tr("Run the study"));
    m_start->setToolTip(running ? tr("Stop measuring; what was measured stays")
                                : tr("Measure in the background"));
    m_start->setEnabled(running || (offer() != nullptr && m_subject->count() > 0));
    m_progress->setValue(0);
    m_progress->setVisible(running);
    m_export->setEnabled(!running && !m_run.study().points.empty());
    m_view->setEmptyText(running ? tr("Measuring… the first points come in a moment.")
                                 : tr("Nothing is measured yet: choose a study and press Run."));
}

void ChartPanel::showStudy()
{
    const Study& study = m_run.study();
    m_view->setPlot(plotOf(study, studyView()), [this](std::size_t point) {
        QStringList lines = describe(m_run.study(), point);
        if (m_run.study().points[point].method) {
            lines += tr("Click to filter with it");
        }
        return lines;
    });
    showChosen();
    showAdvice();
}

void ChartPanel::showChosen()
{
    const auto mark = markOf(m_run.study(), m_view->plot(), m_settings.method());
    m_view->setChosen(mark ? ChartView::Source(pointOf(m_view->plot(), *mark).source)
                           : ChartView::Source());
}

void ChartPanel::showAdvice()
{
    const Study& study = m_run.study();
    const auto best = cheapestWithin(study, studyView());
    m_use->setEnabled(best && study.points[*best].method);
    m_advice->setVisible(!study.points.empty());
    const ToleranceAdvice advice = adviceOf(study, studyView());
    m_advice->setText(advice.text);
    m_advice->setToolTip(advice.details.isEmpty() ? tr("As this study measured it")
                                                  : advice.details);
}

void ChartPanel::choose(std::size_t point)
{
    if (const auto& method = m_run.study().points[point].method) {
        m_settings.setMethod(*method);
    }
}

void ChartPanel::chooseAdvised()
{
    if (const auto best = cheapestWithin(m_run.study(), studyView())) {
        choose(*best);
    }
}

void ChartPanel::write(const QString& path)
{
    ChartOptions options;
    options.view = studyView();
    options.chosen = m_settings.method();
    const auto work = [study = m_run.study(), path, options](Progress& /*progress*/) -> Status {
        return writeChart(study, path.toStdU16String(), options);
    };
    m_jobs.run(tr("Exporting the study…"), work, [self = QPointer(this), path](Status status) {
        if (self) {
            status ? emit self->written(tr("Exported %1").arg(path))
                   : emit self->failed(QString::fromStdString(status.error().message));
        }
    });
}

void ChartPanel::resizeEvent(QResizeEvent* event)
{
    const bool wide = width() >= kWide;
    m_layout->setDirection(wide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    m_controls->setFixedWidth(wide ? kControlsWidth : QWIDGETSIZE_MAX);
    QWidget::resizeEvent(event);
}

} // namespace trixel::ui
