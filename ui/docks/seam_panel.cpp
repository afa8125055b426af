// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/seam_panel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSplitter>
#include <QTableView>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "core/study/views/view_footprints.h"
#include "render/camera_view.h"
#include "ui/docks/method_box.h"
#include "ui/docks/seam_model.h"
#include "ui/document/document.h"
#include "ui/document/filter_scene_source.h"
#include "ui/viewport/method_title.h"
#include "ui/viewport/view_settings.h"

#include <utility>

namespace trixel::ui {

namespace {

enum FootprintKind { InTexels, OfTheView };

constexpr int kSortArrow = 14;

QString percent(double part)
{
    return QString::number(100 * part, 'g', 3) + " %";
}

QString counted(std::size_t number)
{
    return QLocale().toString(static_cast<qulonglong>(number));
}

} // namespace

SeamPanel::SeamPanel(const Document& document,
                     ViewSettings& settings,
                     FilterSceneSource& source,
                     BackgroundJobs& jobs,
                     const Viewport& viewport,
                     QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_settings(settings)
    , m_source(source)
    , m_jobs(jobs)
    , m_viewport(viewport)
    , m_summary(new QLabel)
    , m_comparison(new QTreeWidget)
    , m_model(new SeamModel(this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    layout->addWidget(makeChoices());
    m_summary->setWordWrap(true);
    m_summary->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_summary->setToolTip(tr("How far the method jumps across the edges, in % of the value range"));
    layout->addWidget(m_summary);
    makeComparison();
    auto* parts = new QSplitter(Qt::Vertical);
    parts->setChildrenCollapsible(false);
    parts->addWidget(makeTable());
    parts->addWidget(m_comparison);
    parts->setStretchFactor(0, 3);
    parts->setStretchFactor(1, 2);
    layout->addWidget(parts, 1);

    connect(&document, &Document::opened, this, &SeamPanel::forget);
    connect(&document, &Document::changed, this, [this] {
        if (!std::exchange(m_isOutdated, true)) {
            showState();
        }
    });
    connect(&source, &FilterSceneSource::changed, this, [this] {
        if (m_isWaiting) {
            next();
        }
    });
    connect(&source, &FilterSceneSource::refused, this, [this] {
        m_tasks.clear();
        m_isWaiting = false;
        showState();
    });
    // Whoever looks at the seams of one method and chooses another wants to see the other's.
    connect(&settings, &ViewSettings::methodChanged, this, [this] {
        if (m_report && isVisible() && m_reported != m_settings.method()) {
            measure();
        }
    });
    forget();
}

QWidget* SeamPanel::makeChoices()
{
    auto* whole = new QWidget;
    auto* form = new QFormLayout(whole);
    form->setContentsMargins(0, 0, 0, 0);
    form->setSpacing(6);
    form->addRow(tr("Method"), new MethodBox(m_settings));
    m_footprints = new QComboBox;
    m_footprints->setAccessibleName(tr("Footprints to measure with"));
    m_footprints->setToolTip(
        tr("In texels: round ones 1 and 4 texels wide, and one 4 texels wide and 16 long. "
           "Of the view: what the pixels of the view average, on the edges it shows."));
    m_footprints->addItem(tr("1 and 4 texels wide"));
    m_footprints->addItem(tr("Of the view's pixels"));
    form->addRow(tr("Footprints"), m_footprints);
    auto* buttons = new QHBoxLayout;
    m_measure = new QPushButton(tr("&Measure"));
    m_measure->setAccessibleName(tr("Measure the seams"));
    m_measure->setToolTip(tr("Measure the jump of the method across every edge"));
    m_compare = new QPushButton(tr("&Compare methods"));
    m_compare->setAccessibleName(tr("Compare methods"));
    m_compare->setToolTip(tr("Measure every method, one after the other; the slow ones last"));
    buttons->addWidget(m_measure);
    buttons->addWidget(m_compare);
    form->addRow(buttons);
    connect(m_measure, &QPushButton::clicked, this, &SeamPanel::measure);
    connect(m_compare, &QPushButton::clicked, this, &SeamPanel::compareAll);
    return whole;
}

QTableView* SeamPanel::makeTable()
{
    m_table = new QTableView;
    m_table->setAccessibleName(tr("Edges by their jump"));
    m_table->setToolTip(tr("Click an edge, or press Enter, to go there"));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setShowGrid(false);
    m_table->setAlternatingRowColors(true);
    m_table->setWordWrap(false);
    m_table->setTabKeyNavigation(false);
    m_table->setVerticalScrollMode(QAbstractItemView::ScrollPerItem);
    // Rows of one height, so that a million of them need no measuring.
    QHeaderView* rows = m_table->verticalHeader();
    rows->hide();
    rows->setSectionResizeMode(QHeaderView::Fixed);
    rows->setDefaultSectionSize(fontMetrics().height() + 4);
    m_table->setModel(m_model);
    QHeaderView* columns = m_table->horizontalHeader();
    columns->setSectionResizeMode(QHeaderView::Interactive);
    columns->setStretchLastSection(true);
    columns->setHighlightSections(false);
    // The numbers are of known length: no row needs to be measured.
    const auto widthOf = [this](const QString& text) {
        constexpr int kPadding = 8;
        return fontMetrics().horizontalAdvance(text) + kPadding;
    };
    columns->resizeSection(SeamModel::Jump, widthOf("Jump %") + kSortArrow);
    m_table->setColumnHidden(SeamModel::Mean, true); // the dock is narrow; tool tips tell it
    columns->resizeSection(SeamModel::Face, widthOf("000000"));
    columns->resizeSection(SeamModel::Edge, widthOf("e0|e0"));
    columns->resizeSection(SeamModel::Neighbour, widthOf("000000"));
    columns->resizeSection(SeamModel::Levels, widthOf("Levels"));
    columns->setSortIndicator(SeamModel::Jump, Qt::DescendingOrder);
    columns->setMinimumSectionSize(36);
    m_table->setSortingEnabled(true);
    connect(m_table, &QTableView::clicked, this, [this](const QModelIndex& index) {
        choose(index.row());
    });
    connect(m_table, &QTableView::activated, this, [this](const QModelIndex& index) {
        choose(index.row());
    });
    return m_table;
}

void SeamPanel::makeComparison()
{
    m_comparison->setAccessibleName(tr("Methods compared"));
    m_comparison->setToolTip(tr("Choose a method to see its edges"));
    m_comparison->setRootIsDecorated(false);
    m_comparison->setUniformRowHeights(true);
    m_comparison->setAlternatingRowColors(true);
    m_comparison->setHeaderLabels({tr("Method"), tr("Worst"), tr("p99"), tr("Seams")});
    m_comparison->headerItem()->setToolTip(1, tr("Largest jump of all edges"));
    m_comparison->headerItem()->setToolTip(2, tr("99 of 100 edges jump no further"));
    m_comparison->headerItem()->setToolTip(
        3, tr("Edges that jump by more than %1").arg(percent(kSeamless)));
    for (int column = 1; column < 4; ++column) {
        m_comparison->headerItem()->setTextAlignment(column, Qt::AlignRight);
    }
    QHeaderView* header = m_comparison->header();
    header->setStretchLastSection(false);
    header->setSectionResizeMode(0, QHeaderView::Stretch);
    for (int column = 1; column < 4; ++column) {
        header->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    }
    const auto choose = [this](const QTreeWidgetItem* item) {
        const auto method = parseMethod(item->data(0, Qt::UserRole).toString().toStdString());
        if (method) {
            m_settings.setMethod(*method);
        }
    };
    connect(m_comparison, &QTreeWidget::itemClicked, this, choose);
    connect(m_comparison, &QTreeWidget::itemActivated, this, choose);
}

/// Another document: nothing is known of it.
void SeamPanel::forget()
{
    ++m_generation;
    m_tasks.clear();
    m_isWaiting = false;
    if (m_job) {
        m_job->cancel();
    }
    m_job = nullptr;
    m_report.reset();
    m_model->setReport(nullptr);
    emit reported(nullptr);
    m_comparison->clear();
    m_isOutdated = false;
    m_source.want(*this, false);
    showState();
}

void SeamPanel::measure()
{
    begin({{m_settings.method(), true}});
}

void SeamPanel::compareAll()
{
    std::deque<Task> tasks{{m_settings.method(), true}};
    for (const MethodEntry& entry : filterMethods()) {
        if (entry.name != m_settings.method().name) {
            tasks.push_back({{std::string(entry.name), std::nullopt}, false});
        }
    }
    begin(std::move(tasks));
}

void SeamPanel::begin(std::deque<Task> tasks)
{
    if (!m_document.isOpen()) {
        return;
    }
    ++m_generation;
    if (m_job) {
        m_job->cancel();
        m_job = nullptr;
    }
    if (std::exchange(m_isOutdated, false)) {
        m_comparison->clear(); // of other texels
    }
    m_tasks = std::move(tasks);
    m_isWaiting = true;
    m_source.want(*this, true);
    next();
}

void SeamPanel::next()
{
    if (!m_source.isCurrent()) {
        showState();
        return; // again when the scene is there
    }
    m_isWaiting = false;
    if (m_tasks.empty()) {
        showState();
        return;
    }
    const Task task = m_tasks.front();
    m_tasks.pop_front();
    m_job = &m_jobs.run(
        tr("Seams of %1…").arg(methodTitle(task.method)),
        [scene = m_source.scene(), settings = footprints(), method = task.method](
            Progress& progress) {
            return measureSeams(*scene, *makeMethod(method), settings, Threads::all(), progress);
        },
        [this, task, generation = m_generation](const Result<SeamReport>& report) {
            if (generation == m_generation) {
                take(task, report);
            }
        });
    showState();
}

void SeamPanel::take(const Task& task, const Result<SeamReport>& report)
{
    m_job = nullptr;
    if (!report) {
        m_tasks.clear();
        showState();
        return;
    }
    if (task.lists) {
        m_report = std::make_shared<const SeamReport>(*report);
        m_reported = task.method;
        m_table->horizontalHeader()->setSortIndicator(SeamModel::Jump, Qt::DescendingOrder);
        m_model->setReport(m_report);
        emit reported(m_report);
    }
    addToComparison(task.method, summarize(report->jumps));
    if (m_tasks.empty()) {
        showState();
    } else {
        next();
    }
}

void SeamPanel::addToComparison(const MethodChoice& method, const SeamSummary& summary)
{
    const QString name = QString::fromStdString(toText(method));
    QTreeWidgetItem* item = nullptr;
    for (int row = 0; row < m_comparison->topLevelItemCount(); ++row) {
        if (m_comparison->topLevelItem(row)->data(0, Qt::UserRole) == name) {
            item = m_comparison->topLevelItem(row);
        }
    }
    if (item == nullptr) {
        item = new QTreeWidgetItem(m_comparison);
    }
    item->setData(0, Qt::UserRole, name);
    const QStringList cells{
        methodTitle(method), percent(summary.worst), percent(summary.p99), counted(summary.broken)};
    for (int column = 0; column < cells.size(); ++column) {
        item->setText(column, cells[column]);
        item->setTextAlignment(column,
                               (column == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
        item->setToolTip(column,
                         tr("%1: worst %2, 99th percentile %3, median %4; %5 of %6 edges jump")
                             .arg(methodTitle(method),
                                  percent(summary.worst),
                                  percent(summary.p99),
                                  percent(summary.median),
                                  counted(summary.broken),
                                  counted(summary.edges)));
    }
}

void SeamPanel::showState()
{
    const bool open = m_document.isOpen();
    m_measure->setEnabled(open);
    m_compare->setEnabled(open);
    m_table->setVisible(m_report != nullptr);
    m_comparison->setVisible(m_comparison->topLevelItemCount() > 0);
    if (!open) {
        m_summary->setText(tr("No mesh is open."));
        return;
    }
    QString text;
    if (isMeasuring() && !m_report) {
        text = tr("Measuring…");
    } else if (!m_report) {
        text = tr("A seam is an edge where the filtered value differs between its two faces.");
    } else {
        const SeamSummary summary = summarize(m_report->jumps);
        text = tr("%1: %2 of %3 edges jump.\nWorst %4 · p99 %5 · median %6")
                   .arg(methodTitle(m_reported),
                        counted(summary.broken),
                        counted(summary.edges),
                        percent(summary.worst),
                        percent(summary.p99),
                        percent(summary.median));
        if (m_report->refused > 0) {
            text +=
                "\n" +
                tr("%1 comparisons were refused by the method.").arg(counted(m_report->refused));
        }
        if (m_isOutdated) {
            text += "\n" + tr("The texels have changed since.");
        }
    }
    m_summary->setText(text);
}

void SeamPanel::choose(int row)
{
    const SeamJump& jump = m_model->jumpAt(row);
    emit edgeChosen({jump.face, jump.edge});
}

SeamSettings SeamPanel::footprints() const
{
    SeamSettings settings;
    if (m_footprints->currentIndex() == OfTheView) {
        settings.view = footprintsOf(m_document.surface(), render::viewOf(m_viewport.camera()));
    }
    return settings;
}

} // namespace trixel::ui
