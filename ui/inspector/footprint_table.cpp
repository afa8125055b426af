// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/footprint_table.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QKeyEvent>
#include <QStyledItemDelegate>

#include "ui/viewport/surface_lines.h"

#include <algorithm>

namespace trixel::ui {

namespace {

/// From here on the frozen numbers stand beside the live ones.
constexpr int kWide = 460;
constexpr int kCellPadding = 8;
constexpr int kRowPadding = 2;
constexpr int kLeastRows = 4;

/// The frozen numbers in the colour of its lines, as dark as paper needs it.
class Delegate : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        if (index.data(FootprintModel::kFrozenRole).toBool()) {
            const bool dark = option->palette.color(QPalette::Base).lightness() < 128;
            option->palette.setColor(
                QPalette::Text,
                dark ? QColor::fromRgbF(kFrozenColor.r, kFrozenColor.g, kFrozenColor.b)
                     : QColor(0x9c, 0x1f, 0x8a));
        }
    }
};

} // namespace

FootprintTable::FootprintTable(QWidget* parent)
    : QTableView(parent)
    , m_model(new FootprintModel(this))
{
    setModel(m_model);
    setItemDelegate(new Delegate(this));
    setAccessibleName(tr("The footprint in numbers"));
    setToolTip(tr("Numbers of the footprint; Ctrl+C copies those that are selected"));
    setFrameShape(QFrame::NoFrame);
    setShowGrid(false);
    setWordWrap(true);
    setAlternatingRowColors(true);
    setTabKeyNavigation(false);
    setSelectionBehavior(SelectRows);
    setEditTriggers(NoEditTriggers);
    setVerticalScrollMode(ScrollPerPixel);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    horizontalHeader()->hide();
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->hide();
    verticalHeader()->setMinimumSectionSize(1);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    connect(m_model, &QAbstractItemModel::modelReset, this, &FootprintTable::arrange);
    arrange();
}

QSize FootprintTable::minimumSizeHint() const
{
    return {160, kLeastRows * (fontMetrics().lineSpacing() + kRowPadding)};
}

void FootprintTable::arrange()
{
    // As if the scroll bar stood there always: whether it does must not change what is shown.
    const int room = width() - style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, this);
    const QFontMetrics metrics = fontMetrics();
    int names = 0;
    for (int line = 0; line < m_model->rowCount(); ++line) {
        const QString name = m_model->index(line, FootprintModel::Name).data().toString();
        names = std::max(names, metrics.horizontalAdvance(name));
    }
    names += kCellPadding;
    const int columns = m_model->columnCount() - 1;
    const int values = std::max(1, (room - names) / columns);
    setColumnWidth(FootprintModel::Name, names);
    for (int column = 1; column <= columns; ++column) {
        setColumnWidth(column, values);
    }
    const QRect inside(0, 0, std::max(1, values - kCellPadding), 1000);
    for (int line = 0; line < m_model->rowCount(); ++line) {
        const QRect text = metrics.boundingRect(
            inside, Qt::TextWordWrap, footprintRowSample(m_model->rowAt(line)));
        verticalHeader()->resizeSection(line, text.height() + kRowPadding);
    }
}

void FootprintTable::changeEvent(QEvent* event)
{
    QTableView::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) {
        arrange();
    }
}

void FootprintTable::resizeEvent(QResizeEvent* event)
{
    QTableView::resizeEvent(event);
    m_model->setFrozenBeside(width() >= kWide);
    arrange();
}

void FootprintTable::keyPressEvent(QKeyEvent* event)
{
    if (event->matches(QKeySequence::Copy)) {
        copySelected();
        return;
    }
    QTableView::keyPressEvent(event);
}

void FootprintTable::copySelected() const
{
    QString lines;
    for (const QModelIndex& row : selectionModel()->selectedRows()) {
        QStringList cells;
        for (int column = 0; column < m_model->columnCount(); ++column) {
            cells += row.siblingAtColumn(column).data().toString().trimmed().replace('\n', ' ');
        }
        lines += cells.join('\t') + '\n';
    }
    QApplication::clipboard()->setText(lines);
}

} // namespace trixel::ui
