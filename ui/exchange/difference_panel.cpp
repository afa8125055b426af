// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/exchange/difference_panel.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include "ui/dialogs/format_choice.h"
#include "ui/exchange/difference_model.h"

#include <cmath>
#include <utility>

namespace trixel::ui {

namespace {

constexpr int kSortArrow = 14;

QString percent(double part)
{
    return std::isinf(part) ? QString::fromUtf8("∞") : QString::number(100 * part, 'g', 3) + " %";
}

QString decibels(double psnr)
{
    return std::isfinite(psnr) ? QString::number(psnr, 'f', 1) + " dB" : QString::fromUtf8("–");
}

QPushButton* makeButton(const QString& text, const QString& name, const QString& toolTip)
{
    auto* button = new QPushButton(text);
    button->setAccessibleName(name);
    button->setToolTip(toolTip);
    return button;
}

} // namespace

DifferencePanel::DifferencePanel(Document& document, BackgroundJobs& jobs, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_jobs(jobs)
    , m_summary(new QLabel)
    , m_table(new QTableView)
    , m_other(makeButton(
          tr("C&hoose…"), tr("Choose another file"), tr("Choose the file to compare with")))
    , m_again(makeButton(tr("&Again"),
                         tr("Compare again"),
                         tr("Compare with the same file, as it and the texels are now")))
    , m_select(makeButton(tr("&Select all"),
                          tr("Select all faces that differ"),
                          tr("Select every face that differs")))
    , m_model(new DifferenceModel(this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    auto* buttons = new QHBoxLayout;
    for (QPushButton* button : {m_other, m_again, m_select}) {
        buttons->addWidget(button);
    }
    layout->addLayout(buttons);
    layout->addWidget(m_summary);
    layout->addWidget(m_table, 1);
    layout->addStretch(0);
    m_summary->setWordWrap(true);
    m_summary->setAccessibleName(tr("What differs"));
    m_summary->setToolTip(tr("Figures over all faces, in % of the value range"));
    m_summary->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    makeTable();

    connect(m_other, &QPushButton::clicked, this, &DifferencePanel::chooseWanted);
    connect(m_again, &QPushButton::clicked, this, [this] { compare(m_path, m_matches); });
    connect(m_select, &QPushButton::clicked, this, &DifferencePanel::chooseAll);
    connect(&document, &Document::opened, this, &DifferencePanel::forget);
    connect(&document.undoStack(), &QUndoStack::indexChanged, this, &DifferencePanel::showState);
    forget();
}

void DifferencePanel::makeTable()
{
    m_table->setAccessibleName(tr("Faces by their difference"));
    m_table->setToolTip(tr("Click a face, or press Enter, to go there"));
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
    columns->setStretchLastSection(true);
    columns->setHighlightSections(false);
    columns->setMinimumSectionSize(36);
    const auto widthOf = [this](const QString& text) {
        constexpr int kPadding = 10;
        return fontMetrics().horizontalAdvance(text) + kPadding;
    };
    columns->resizeSection(DifferenceModel::Face, widthOf("00000"));
    columns->resizeSection(DifferenceModel::Rms, widthOf("RMS %") + kSortArrow);
    columns->resizeSection(DifferenceModel::Largest, widthOf("Max %"));
    columns->resizeSection(DifferenceModel::Texels, widthOf("Texels"));
    columns->resizeSection(DifferenceModel::Levels, widthOf("0 | 00"));
    columns->setSortIndicator(DifferenceModel::Rms, Qt::DescendingOrder);
    m_table->setSortingEnabled(true);
    const auto choose = [this](const QModelIndex& index) {
        emit faceChosen(m_model->differenceAt(index.row()).face);
    };
    connect(m_table, &QTableView::clicked, this, choose);
    connect(m_table, &QTableView::activated, this, choose);
}

/// Another document: nothing is known of it.
void DifferencePanel::forget()
{
    ++m_generation;
    if (m_job) {
        m_job->cancel();
    }
    m_job = nullptr;
    m_path.clear();
    show(nullptr);
}

void DifferencePanel::compare(const QString& path, bool matches)
{
    m_path = path;
    m_matches = matches;
    m_document.endStroke();
    m_document.whenSettled([this, path, matches] { compareNow(path, matches); });
}

void DifferencePanel::compareNow(const QString& path, bool matches)
{
    if (!m_document.isOpen() || path != m_path) {
        return;
    }
    ++m_generation;
    if (m_job) {
        m_job->cancel();
    }
    m_madeFor = m_document.state().texels;
    m_job = &m_jobs.run(
        tr("Comparing with %1…").arg(QFileInfo(path).fileName()),
        [project = m_document.snapshot(), path, matches](Progress& progress) {
            return compareWithOther(project, path, matches, progress);
        },
        [this, generation = m_generation](
            const Result<std::shared_ptr<const FileComparison>>& comparison) {
            if (generation == m_generation) {
                take(comparison);
            }
        });
    showState();
}

void DifferencePanel::take(const Result<std::shared_ptr<const FileComparison>>& comparison)
{
    m_job = nullptr;
    if (comparison) {
        show(*comparison);
        return;
    }
    showState();
    if (comparison.error().kind != ErrorKind::Cancelled) {
        emit failed(sentenceOf(comparison.error(), m_path));
    }
}

void DifferencePanel::show(std::shared_ptr<const FileComparison> comparison)
{
    m_comparison = std::move(comparison);
    m_model->setComparison(m_comparison);
    showState();
    emit compared(m_comparison);
}

QString DifferencePanel::figures() const
{
    const TexelDiff& diff = m_comparison->diff;
    QStringList lines;
    if (diff.faces.empty()) {
        lines += tr("%1: no texel differs.").arg(QFileInfo(m_comparison->path).fileName());
    } else {
        lines +=
            tr("%1: %2 of %3 faces differ, %4 of another level.")
                .arg(QFileInfo(m_comparison->path).fileName(),
                     countText(diff.faces.size()),
                     countText(m_comparison->rms.size()),
                     diff.levelDifferences == 0 ? tr("none") : countText(diff.levelDifferences));
        lines += tr("RMS %1 · PSNR %2 · Max %3")
                     .arg(percent(diff.rms / diff.peak),
                          decibels(diff.psnr()),
                          percent(diff.maxAbs / diff.peak));
    }
    if (m_comparison->match.by != MatchedBy::Order) {
        lines += tr("Matched %1.").arg(QString::fromStdString(m_comparison->match.describe()));
    }
    if (!m_comparison->notes.isEmpty()) {
        lines += m_comparison->notes;
    }
    if (m_madeFor != m_document.state().texels) {
        lines += tr("The texels have changed since.");
    }
    return lines.join('\n');
}

void DifferencePanel::showState()
{
    const bool isOpen = m_document.isOpen();
    m_other->setEnabled(isOpen);
    m_again->setEnabled(isOpen && !m_path.isEmpty() && m_job == nullptr);
    m_select->setEnabled(m_comparison && !m_comparison->diff.faces.empty());
    m_table->setVisible(m_comparison && !m_comparison->diff.faces.empty());
    if (m_job) {
        m_summary->setText(tr("Comparing with %1…").arg(QFileInfo(m_path).fileName()));
    } else if (m_comparison) {
        m_summary->setText(figures());
    } else {
        m_summary->setText(isOpen ? tr("Choose a .ptx or a project of the same mesh: every face "
                                       "is measured and shown over the surface.")
                                  : tr("No mesh is open."));
    }
}

void DifferencePanel::chooseAll()
{
    std::vector<FaceId> faces;
    faces.reserve(m_comparison->diff.faces.size());
    for (const FaceDifference& face : m_comparison->diff.faces) {
        faces.push_back(face.face);
    }
    emit facesChosen(std::move(faces));
}

} // namespace trixel::ui
