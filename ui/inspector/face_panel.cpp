// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/face_panel.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/io/face_csv.h"
#include "ui/document/document.h"
#include "ui/document/face_selection.h"
#include "ui/inspector/face_listing.h"
#include "ui/inspector/face_table_model.h"
#include "ui/inspector/face_table_view.h"
#include "ui/inspector/save_dialog.h"

#include <algorithm>
#include <string>
#include <utility>

namespace trixel::ui {

namespace {

/// Typing rests so long before the filter is read: half a number is no filter.
constexpr int kTypingMs = 250;

QString counted(std::size_t number)
{
    return QLocale().toString(static_cast<qulonglong>(number));
}

/// What a background job reads of a listing.
struct ListedFaces
{
    std::shared_ptr<const FaceFigures> figures;
    std::shared_ptr<const FaceRows> rows;
    std::shared_ptr<const std::vector<float>> jumps;

    FaceFacts facts() const
    {
        return {*figures, jumps ? std::span<const float>(*jumps) : std::span<const float>(), {}};
    }
};

ListedFaces listed(const FaceListing& listing)
{
    return {listing.figures(), listing.rows(), listing.jumps()};
}

/// Lines of the selected faces in the order of their rows, for spreadsheets.
QString selectedText(const ListedFaces& faces, const std::vector<FaceId>& selected)
{
    std::vector<std::size_t> rows;
    for (const FaceId face : selected) {
        if (const auto row = faces.rows->rowOf(face)) {
            rows.push_back(*row);
        }
    }
    std::ranges::sort(rows);
    std::string text = faceTableHeader('\t');
    for (const std::size_t row : rows) {
        appendFaceRow(text, faces.facts(), faces.rows->faces()[row], '\t');
    }
    return QString::fromStdString(text);
}

} // namespace

FacePanel::FacePanel(const Document& document,
                     FaceSelection& selection,
                     Inspection& inspection,
                     const ViewSettings& settings,
                     BackgroundJobs& jobs,
                     QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_selection(selection)
    , m_jobs(jobs)
    , m_listing(new FaceListing(document, selection, settings, jobs, this))
    , m_model(new FaceTableModel(*m_listing, selection, this))
    , m_table(new FaceTableView(*m_model, selection, inspection))
    , m_filter(new QLineEdit)
    , m_summary(new QLabel)
    , m_empty(new QLabel)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    layout->addWidget(makeFilter());
    m_summary->setWordWrap(true);
    m_summary->setAccessibleName(tr("Faces listed"));
    layout->addWidget(m_summary);
    m_empty->setWordWrap(true);
    m_empty->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    layout->addWidget(m_empty, 1);
    makeTable();
    layout->addWidget(m_table, 1);

    m_typing.setSingleShot(true);
    m_typing.setInterval(kTypingMs);
    connect(&m_typing, &QTimer::timeout, this, &FacePanel::applyFilter);
    connect(&document, &Document::opened, this, &FacePanel::showState);
    connect(m_listing, &FaceListing::busyChanged, this, &FacePanel::showState);
    connect(m_listing, &FaceListing::rearranged, this, [this] {
        m_notice.clear();
        showState();
    });
    connect(&selection, &FaceSelection::changed, this, [this] {
        if (isVisible()) {
            // The table's own clicks must not take rows away from under the pointer.
            if (!m_table->hasFocus()) {
                m_listing->takeSelection();
            }
            showState();
        }
    });
    showState();
}

QWidget* FacePanel::makeFilter()
{
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    auto* terms = new QToolButton;
    terms->setText(tr("&Filter"));
    terms->setAccessibleName(tr("Add a condition to the filter"));
    terms->setToolTip(tr("Conditions to choose from"));
    terms->setPopupMode(QToolButton::InstantPopup);
    terms->setFocusPolicy(Qt::StrongFocus);
    auto* menu = new QMenu(terms);
    const std::pair<QString, QString> offers[] = {
        {tr("&Selected"), "selected"},
        {tr("&Painted: more than one value"), "!constant"},
        {tr("&Constant: one value"), "constant"},
        {tr("&Fine: level 6 or more"), "level>=6"},
        {tr("&Tiny: level 0, one texel"), "level=0"},
        {tr("&Jumps at an edge"), "jump>0.1%"},
        {tr("Holds &NaN"), "nan"},
        {tr("&Large: a megabyte or more"), "bytes>=1M"},
    };
    for (const auto& [text, term] : offers) {
        QAction* action = menu->addAction(text);
        action->setToolTip(tr("Add '%1' to the filter").arg(term));
        connect(action, &QAction::triggered, this, [this, added = term] { addTerm(added); });
    }
    menu->addSeparator();
    connect(menu->addAction(tr("List &all faces")), &QAction::triggered, this, [this] {
        m_filter->clear();
        applyFilter();
    });
    terms->setMenu(menu);
    layout->addWidget(terms);

    m_filter->setAccessibleName(tr("Filter"));
    m_filter->setPlaceholderText(tr("level>=5 density<100 !constant"));
    m_filter->setToolTip(
        tr("Conditions that all hold: face, level, texels, bytes, density, min, max, mean or jump, "
           "with = != < <= > >= and a number (10k, 1M, 5%); constant, selected, nan, also with ! "
           "for not"));
    m_filter->setClearButtonEnabled(true);
    connect(m_filter, &QLineEdit::textChanged, &m_typing, qOverload<>(&QTimer::start));
    connect(m_filter, &QLineEdit::returnPressed, this, [this] {
        applyFilter();
        if (m_fault.isEmpty()) {
            m_table->setFocus();
        }
    });
    layout->addWidget(m_filter, 1);

    m_save = new QToolButton;
    m_save->setText(tr("&Save…"));
    m_save->setAccessibleName(tr("Save the table"));
    m_save->setToolTip(tr("Write the listed rows to a .csv file; Ctrl+C copies the selected ones"));
    m_save->setFocusPolicy(Qt::StrongFocus);
    connect(m_save, &QToolButton::clicked, this, &FacePanel::askWhereToSave);
    layout->addWidget(m_save);
    return row;
}

void FacePanel::makeTable()
{
    m_table->setAccessibleName(tr("Faces"));
    m_table->setToolTip(
        tr("Click selects a face, Ctrl and Shift more; double click or Enter goes there; type a "
           "number to go to its row"));
    QHeaderView* columns = m_table->horizontalHeader();
    columns->setSectionResizeMode(QHeaderView::Interactive);
    columns->setStretchLastSection(true);
    columns->setHighlightSections(false);
    columns->setMinimumSectionSize(36);
    // Numbers of known length: no row needs to be measured.
    const char* const widest[FaceTableModel::kColumns] = {"10000000",
                                                          "Level",
                                                          "16,777,216",
                                                          "100,000,000",
                                                          "Constant",
                                                          "1.234e+05",
                                                          "-1.234e-05",
                                                          "-1.234e-05",
                                                          "-1.234e-05",
                                                          "Seam jump"};
    constexpr int kPadding = 22; // for the arrow of the sorted one
    for (int column = 0; column < FaceTableModel::kColumns; ++column) {
        columns->resizeSection(column, fontMetrics().horizontalAdvance(widest[column]) + kPadding);
    }
    columns->setSortIndicator(0, Qt::AscendingOrder);
    m_table->setSortingEnabled(true);
    m_table->setContextMenuPolicy(Qt::ActionsContextMenu);
    const auto add = [this](const QString& text, const QString& tip, auto work) {
        auto* action = new QAction(text, m_table);
        action->setToolTip(tip);
        connect(action, &QAction::triggered, this, work);
        m_table->addAction(action);
    };
    add(tr("&Go to Face"), tr("Look at the current face in the view"), [this] {
        if (m_table->currentIndex().isValid()) {
            emit faceChosen(m_model->faceAt(m_table->currentIndex().row()));
        }
    });
    add(tr("Select &All Listed"), tr("Select the faces of all rows"), [this] {
        m_table->selectAll();
    });
    add(tr("&Copy Selected Rows"), tr("For a spreadsheet"), [this] { copySelected(); });
    add(tr("&Save Listed Rows…"), tr("Write a .csv file"), [this] { askWhereToSave(); });
    connect(m_table, &FaceTableView::faceChosen, this, &FacePanel::faceChosen);
    connect(m_table, &FaceTableView::copyWanted, this, &FacePanel::copySelected);
    connect(m_table, &FaceTableView::notice, this, [this](const QString& sentence) {
        m_notice = sentence;
        showState();
    });
}

void FacePanel::addTerm(const QString& term)
{
    const QString typed = m_filter->text().trimmed();
    m_filter->setText(typed.isEmpty() ? term : typed + ' ' + term);
    applyFilter();
}

void FacePanel::applyFilter()
{
    m_typing.stop();
    const Result<FaceFilter> filter = parseFaceFilter(m_filter->text().toStdString());
    m_fault = filter ? QString() : QString::fromStdString(filter.error().message);
    m_notice.clear();
    if (filter) {
        m_listing->setFilter(*filter);
    }
    showState();
}

void FacePanel::setSeams(std::shared_ptr<const SeamReport> report)
{
    m_listing->setSeams(std::move(report));
}

void FacePanel::copySelected()
{
    if (!m_listing->figures()) {
        return;
    }
    m_jobs.run(
        tr("Copying rows…"),
        [faces = listed(*m_listing), selected = m_selection.snapshot()](
            Progress& /*progress*/) -> Result<QString> { return selectedText(faces, *selected); },
        [](const Result<QString>& text) {
            if (text) {
                QGuiApplication::clipboard()->setText(*text);
            }
        });
}

void FacePanel::askWhereToSave()
{
    if (m_listing->figures()) {
        ui::askWhereToSave(*this,
                           tr("Save the Table of Faces"),
                           tr("%1 faces").arg(m_document.title()),
                           {{tr("Tables (*.csv)"), "csv"}},
                           [this](const QString& path, int /*kind*/) { save(path); });
    }
}

void FacePanel::save(const QString& path)
{
    m_jobs.run(
        tr("Saving the table…"),
        [faces = listed(*m_listing),
         file = std::filesystem::path(path.toStdString())](Progress& progress) {
            return writeFaceCsv(faces.facts(), faces.rows->faces(), file, progress);
        },
        [this, path](const Status& status) {
            if (status) {
                emit written(tr("The faces were written to %1.").arg(path));
            } else if (status.error().kind != ErrorKind::Cancelled) {
                emit failed(QString::fromStdString(status.error().message));
            }
        });
}

QString FacePanel::summary() const
{
    if (!m_fault.isEmpty()) {
        return m_fault;
    }
    if (!m_notice.isEmpty()) {
        return m_notice;
    }
    const std::size_t faces = m_listing->figures()->faceCount();
    const std::size_t rows = m_listing->rows()->size();
    QString text = rows == faces ? tr("%1 faces").arg(counted(faces))
                                 : tr("%1 of %2 faces").arg(counted(rows), counted(faces));
    text += tr(", %1 selected").arg(counted(m_selection.faces().size()));
    if (m_listing->isBusy()) {
        text += tr(" – sorting…");
    }
    return text;
}

void FacePanel::showState()
{
    const bool measured = m_document.isOpen() && m_listing->figures() != nullptr;
    const bool any = measured && m_listing->rows()->size() > 0;
    m_save->setEnabled(any);
    m_filter->setEnabled(measured);
    m_summary->setVisible(measured);
    m_table->setVisible(any);
    m_empty->setVisible(!any);
    if (measured) {
        m_summary->setText(summary());
    }
    m_empty->setText(!m_document.isOpen()     ? tr("Open a mesh to list its faces.")
                     : m_listing->isStopped() ? tr("The faces were not measured. Close and open "
                                                   "the panel to measure them.")
                     : !measured              ? tr("Measuring the faces…")
                     : m_listing->isBusy()    ? tr("Sorting the faces…")
                                              : tr("No face passes the filter."));
}

void FacePanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_listing->setWatched(true);
    showState();
}

void FacePanel::hideEvent(QHideEvent* event)
{
    m_listing->setWatched(false);
    QWidget::hideEvent(event);
}

} // namespace trixel::ui
