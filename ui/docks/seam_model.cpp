// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/seam_model.h"

#include "ui/document/sorted_rows.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace trixel::ui {

namespace {

QString percent(float part)
{
    return QString::number(100.0 * static_cast<double>(part), 'g', 4);
}

QString edgeName(LocalEdge edge)
{
    return QString("e%1").arg(indexOf(edge));
}

std::vector<std::uint32_t>
orderOf(const std::vector<SeamJump>& jumps, int column, Qt::SortOrder order)
{
    std::vector<std::uint32_t> rows(jumps.size());
    std::iota(rows.begin(), rows.end(), 0U);
    switch (column) {
    case SeamModel::Jump:
        if (order == Qt::AscendingOrder) {
            std::ranges::reverse(rows);
        }
        break;
    case SeamModel::Mean:
        sortRows(rows, order, [&](std::uint32_t r) { return jumps[r].mean; });
        break;
    case SeamModel::Face:
        sortRows(
            rows, order, [&](std::uint32_t r) { return std::pair(jumps[r].face, jumps[r].edge); });
        break;
    case SeamModel::Edge:
        sortRows(rows, order, [&](std::uint32_t r) {
            return std::pair(jumps[r].edge, jumps[r].neighbourEdge);
        });
        break;
    case SeamModel::Neighbour:
        sortRows(rows, order, [&](std::uint32_t r) { return jumps[r].neighbour; });
        break;
    default: // how far the levels are apart, then how fine
        sortRows(rows, order, [&](std::uint32_t r) {
            const int own = jumps[r].level.log2();
            const int other = jumps[r].neighbourLevel.log2();
            return std::tuple(std::abs(own - other), std::max(own, other), own);
        });
        break;
    }
    return rows;
}

} // namespace

SeamModel::SeamModel(QObject* parent)
    : QAbstractTableModel(parent)
{
}

void SeamModel::setReport(std::shared_ptr<const SeamReport> report)
{
    ++m_generation;
    beginResetModel();
    m_report = std::move(report);
    m_order.clear();
    m_rows = std::min(edgeCount(), kRowsAtOnce);
    endResetModel();
}

const SeamJump& SeamModel::jumpAt(int row) const
{
    check(row >= 0 && row < rowCount(), "a row of the table");
    const auto shown = static_cast<std::size_t>(row);
    return m_report->jumps[m_order.empty() ? shown : m_order[shown]];
}

int SeamModel::edgeCount() const
{
    return m_report ? static_cast<int>(m_report->jumps.size()) : 0;
}

int SeamModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : m_rows;
}

bool SeamModel::canFetchMore(const QModelIndex& parent) const
{
    return !parent.isValid() && m_rows < edgeCount();
}

void SeamModel::fetchMore(const QModelIndex& parent)
{
    if (canFetchMore(parent)) {
        const int rows = std::min(edgeCount(), m_rows + kRowsAtOnce);
        beginInsertRows({}, m_rows, rows - 1);
        m_rows = rows;
        endInsertRows();
    }
}

int SeamModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant SeamModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid()) {
        return {};
    }
    const SeamJump& jump = jumpAt(index.row());
    if (role == Qt::TextAlignmentRole) {
        return int(Qt::AlignRight | Qt::AlignVCenter);
    }
    if (role == Qt::ToolTipRole) {
        return tr("Largest jump %1 % of the value range, %2 % of the way along the edge; mean %3 "
                  "%. Click to go there")
            .arg(percent(jump.jump))
            .arg(100 * jump.along, 0, 'f', 0)
            .arg(percent(jump.mean));
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (index.column()) {
    case Jump:
        return percent(jump.jump);
    case Mean:
        return percent(jump.mean);
    case Face:
        return static_cast<uint>(jump.face);
    case Edge:
        return edgeName(jump.edge) + "|" + edgeName(jump.neighbourEdge);
    case Neighbour:
        return static_cast<uint>(jump.neighbour);
    case Levels:
        return QString("%1 | %2").arg(jump.level.log2()).arg(jump.neighbourLevel.log2());
    default:
        return {};
    }
}

QVariant SeamModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount) {
        return {};
    }
    const std::pair<QString, QString> columns[ColumnCount] = {
        {tr("Jump %"), tr("Largest difference between the two sides, in % of the value range")},
        {tr("Mean"),
         tr("Mean over the points and footprints of the edge, in % of the value range")},
        {tr("Face"), tr("The lower of the two faces")},
        {tr("Edge"), tr("The edge as each of the two faces numbers it")},
        {tr("Beside"), tr("The face on the other side")},
        {tr("Levels"), tr("Levels of the two faces")},
    };
    if (role == Qt::DisplayRole) {
        return columns[section].first;
    }
    return role == Qt::ToolTipRole ? QVariant(columns[section].second) : QVariant();
}

void SeamModel::sort(int column, Qt::SortOrder order)
{
    if (!m_report || column < 0 || column >= ColumnCount) {
        return;
    }
    const quint64 generation = ++m_generation;
    if (column == Jump && order == Qt::DescendingOrder) {
        takeOrder({}); // as the report has it
        return;
    }
    m_jobs.run(
        QString(),
        [report = m_report, column, order](Progress& /*progress*/) -> Result<Order> {
            return orderOf(report->jumps, column, order);
        },
        [this, generation](Result<Order> sorted) {
            if (generation == m_generation && sorted) {
                takeOrder(std::move(*sorted));
            }
        });
}

/// Persistent indices are those of the current row and the selection: few.
void SeamModel::takeOrder(Order order)
{
    emit layoutAboutToBeChanged({}, QAbstractItemModel::VerticalSortHint);
    const QModelIndexList before = persistentIndexList();
    const auto rowInReport = [this](int row) {
        return m_order.empty() ? static_cast<std::uint32_t>(row)
                               : m_order[static_cast<std::size_t>(row)];
    };
    QModelIndexList after;
    int lastRow = -1; // the cells of a row come together
    std::ptrdiff_t newRow = 0;
    for (const QModelIndex& index : before) {
        if (std::exchange(lastRow, index.row()) != index.row()) {
            const std::uint32_t wanted = rowInReport(index.row());
            newRow = order.empty() ? static_cast<std::ptrdiff_t>(wanted)
                                   : std::ranges::find(order, wanted) - order.begin();
        }
        after +=
            newRow < m_rows ? createIndex(static_cast<int>(newRow), index.column()) : QModelIndex();
    }
    m_order = std::move(order);
    changePersistentIndexList(before, after);
    emit layoutChanged({}, QAbstractItemModel::VerticalSortHint);
}

} // namespace trixel::ui
