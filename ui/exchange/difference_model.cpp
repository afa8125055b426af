// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/exchange/difference_model.h"

#include "ui/document/sorted_rows.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace trixel::ui {

namespace {

std::vector<std::uint32_t>
orderOf(const std::vector<FaceDifference>& faces, int column, Qt::SortOrder order)
{
    std::vector<std::uint32_t> rows(faces.size());
    std::iota(rows.begin(), rows.end(), 0U);
    switch (column) {
    case DifferenceModel::Face:
        sortRows(rows, order, [&](std::uint32_t r) { return faces[r].face; });
        break;
    case DifferenceModel::Largest:
        sortRows(rows, order, [&](std::uint32_t r) { return faces[r].maxAbs; });
        break;
    case DifferenceModel::Texels:
        sortRows(rows, order, [&](std::uint32_t r) { return faces[r].texels; });
        break;
    case DifferenceModel::Levels: // how far the levels are apart, then how fine
        sortRows(rows, order, [&](std::uint32_t r) {
            const int a = faces[r].levelOfA.log2();
            const int b = faces[r].levelOfB.log2();
            return std::tuple(std::abs(a - b), a, b);
        });
        break;
    default:
        sortRows(rows, order, [&](std::uint32_t r) { return faces[r].rms; });
        break;
    }
    return rows;
}

QString percent(double part)
{
    return std::isinf(part) ? QString::fromUtf8("∞") : QString::number(100 * part, 'g', 3);
}

} // namespace

DifferenceModel::DifferenceModel(QObject* parent)
    : QAbstractTableModel(parent)
{
}

void DifferenceModel::setComparison(std::shared_ptr<const FileComparison> comparison)
{
    ++m_generation;
    beginResetModel();
    m_comparison = std::move(comparison);
    m_order.clear();
    m_rows = 0;
    endResetModel();
    if (m_comparison) {
        sort(m_column, m_direction);
    }
}

const FaceDifference& DifferenceModel::differenceAt(int row) const
{
    check(row >= 0 && row < m_rows, "a row of the table");
    return m_comparison->diff.faces[m_order[static_cast<std::size_t>(row)]];
}

std::size_t DifferenceModel::faceCount() const
{
    return m_order.size();
}

int DifferenceModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : m_rows;
}

int DifferenceModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

bool DifferenceModel::canFetchMore(const QModelIndex& parent) const
{
    return !parent.isValid() && static_cast<std::size_t>(m_rows) < faceCount();
}

void DifferenceModel::fetchMore(const QModelIndex& parent)
{
    if (canFetchMore(parent)) {
        const int rows =
            static_cast<int>(std::min(faceCount(), static_cast<std::size_t>(m_rows) + kRowsAtOnce));
        beginInsertRows({}, m_rows, rows - 1);
        m_rows = rows;
        endInsertRows();
    }
}

QVariant DifferenceModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid()) {
        return {};
    }
    const FaceDifference& face = differenceAt(index.row());
    const double peak = m_comparison->diff.peak;
    const bool sameLevel = face.levelOfA == face.levelOfB;
    if (role == Qt::TextAlignmentRole) {
        return int(Qt::AlignRight | Qt::AlignVCenter);
    }
    if (role == Qt::ToolTipRole) {
        return sameLevel
                   ? tr("Face %1, level %2: %3 of its %4 texels differ. Click to go there")
                         .arg(indexOf(face.face))
                         .arg(face.levelOfA.log2())
                         .arg(face.texels)
                         .arg(face.levelOfA.texelCount())
                   : tr("Face %1: level %2 here, %3 in the file; measured at the finer one. Click "
                        "to go there")
                         .arg(indexOf(face.face))
                         .arg(face.levelOfA.log2())
                         .arg(face.levelOfB.log2());
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (index.column()) {
    case Face:
        return static_cast<uint>(face.face);
    case Rms:
        return percent(face.rms / peak);
    case Largest:
        return percent(face.maxAbs / peak);
    case Texels:
        return sameLevel ? QVariant::fromValue(static_cast<qulonglong>(face.texels))
                         : QVariant(QString::fromUtf8("–"));
    case Levels:
        return sameLevel ? QString::number(face.levelOfA.log2())
                         : QString("%1 | %2").arg(face.levelOfA.log2()).arg(face.levelOfB.log2());
    default:
        return {};
    }
}

QVariant DifferenceModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount) {
        return {};
    }
    const std::pair<QString, QString> columns[ColumnCount] = {
        {tr("Face"), tr("Number of the face")},
        {tr("RMS %"), tr("Over all texels and channels of the face, in % of the value range")},
        {tr("Max %"), tr("The texel that differs most, in % of the value range")},
        {tr("Texels"), tr("Texels that differ")},
        {tr("Levels"), tr("Level here, and in the file where it is another")},
    };
    if (role == Qt::DisplayRole) {
        return columns[section].first;
    }
    return role == Qt::ToolTipRole ? QVariant(columns[section].second) : QVariant();
}

void DifferenceModel::sort(int column, Qt::SortOrder order)
{
    if (column < 0 || column >= ColumnCount) {
        return;
    }
    m_column = column;
    m_direction = order;
    if (!m_comparison) {
        return;
    }
    const quint64 generation = ++m_generation;
    m_jobs.run(
        QString(),
        [comparison = m_comparison, column, order](Progress& /*progress*/) -> Result<Order> {
            return orderOf(comparison->diff.faces, column, order);
        },
        [this, generation](Result<Order> sorted) {
            if (generation == m_generation && sorted) {
                takeOrder(std::move(*sorted));
            }
        });
}

void DifferenceModel::takeOrder(Order order)
{
    beginResetModel();
    m_order = std::move(order);
    m_rows = static_cast<int>(std::min<std::size_t>(m_order.size(), kRowsAtOnce));
    endResetModel();
}

} // namespace trixel::ui
