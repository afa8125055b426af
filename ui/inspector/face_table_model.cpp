// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/face_table_model.h"

#include <QLocale>

#include "ui/document/face_selection.h"
#include "ui/inspector/face_listing.h"

#include <array>
#include <cmath>
#include <utility>

namespace trixel::ui {

namespace {

struct ColumnText
{
    const char* title;
    const char* explanation;
};

constexpr std::array<ColumnText, FaceTableModel::kColumns> kTexts{{
    {QT_TR_NOOP("Face"), QT_TR_NOOP("Number of the face, in the order of the file")},
    {QT_TR_NOOP("Level"), QT_TR_NOOP("Level n: 2ⁿ texels along each edge")},
    {QT_TR_NOOP("Texels"), QT_TR_NOOP("4ⁿ texels on the face")},
    {QT_TR_NOOP("Bytes"),
     QT_TR_NOOP("Bytes that its texels take in memory; a face of one value keeps one texel")},
    {QT_TR_NOOP("Constant"), QT_TR_NOOP("All texels have one value, which is stored once")},
    {QT_TR_NOOP("Density"),
     QT_TR_NOOP(
         "Texels along an edge for each unit of length: 2ⁿ over the edges' root mean square")},
    {QT_TR_NOOP("Min"), QT_TR_NOOP("Lowest value of all texels")},
    {QT_TR_NOOP("Max"), QT_TR_NOOP("Highest value of all texels")},
    {QT_TR_NOOP("Mean"), QT_TR_NOOP("Mean of all texels")},
    {QT_TR_NOOP("Seam jump"),
     QT_TR_NOOP("How far the filter jumps at most across an edge of the face, in % of the value "
                "range; the panel Seams (F7) measures it")},
}};

QString number(float value)
{
    return QString::number(static_cast<double>(value), 'g', 4);
}

/// A share in percent as people write it: no exponents for what is next to nothing.
QString percent(double share)
{
    constexpr double kLeast = 1e-4;
    const double value = 100 * share;
    return value == 0       ? QString("0 %")
           : value < kLeast ? QString("< 0.0001 %")
                            : number(static_cast<float>(value)) + " %";
}

bool tellsValues(FaceColumn column)
{
    return column == FaceColumn::Lowest || column == FaceColumn::Highest ||
           column == FaceColumn::Mean;
}

} // namespace

FaceTableModel::FaceTableModel(FaceListing& listing,
                               const FaceSelection& selection,
                               QObject* parent)
    : QAbstractTableModel(parent)
    , m_listing(listing)
    , m_selection(selection)
{
    connect(&listing, &FaceListing::aboutToRearrange, this, [this](bool sameFaces) {
        if (sameFaces) {
            emit layoutAboutToBeChanged({}, VerticalSortHint);
            keepIndices();
        } else {
            beginResetModel();
        }
    });
    connect(&listing, &FaceListing::rearranged, this, [this](bool sameFaces) {
        if (sameFaces) {
            moveIndices();
            emit layoutChanged({}, VerticalSortHint);
        } else {
            endResetModel();
        }
    });
    connect(&listing, &FaceListing::figuresChanged, this, [this] {
        if (rowCount() > 0) {
            emit dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
        }
        emit headerDataChanged(Qt::Horizontal, 0, kColumns - 1); // of another channel
    });
}

FaceId FaceTableModel::faceAt(int row) const
{
    check(row >= 0 && row < rowCount(), "a row of the table");
    return m_listing.rows()->faces()[static_cast<std::size_t>(row)];
}

std::optional<int> FaceTableModel::rowOf(FaceId face) const
{
    const auto row = m_listing.rows()->rowOf(face);
    return row ? std::optional(static_cast<int>(*row)) : std::nullopt;
}

std::span<const FaceId> FaceTableModel::facesOf(int first, int last) const
{
    check(first >= 0 && first <= last && last < rowCount(), "rows of the table");
    return m_listing.rows()->faces().subspan(static_cast<std::size_t>(first),
                                             static_cast<std::size_t>(last - first) + 1);
}

int FaceTableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_listing.rows()->size());
}

int FaceTableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : kColumns;
}

QString FaceTableModel::text(FaceColumn column, FaceId face) const
{
    const FaceFacts facts = m_listing.facts();
    const double value = valueIn(facts, column, face);
    switch (column) {
    case FaceColumn::Face:
        return QString::number(indexOf(face)); // as it is typed
    case FaceColumn::Constant:
        return facts.figures.isConstant(face) ? tr("yes") : tr("no");
    case FaceColumn::Level:
    case FaceColumn::Texels:
    case FaceColumn::Bytes:
        return QLocale().toString(static_cast<qulonglong>(value));
    case FaceColumn::Jump:
        return std::isnan(value) ? QString("–") : percent(value);
    case FaceColumn::Density:
        return std::isnan(value) ? QString("–") : number(static_cast<float>(value));
    default:
        return number(static_cast<float>(value));
    }
}

QVariant FaceTableModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    const FaceId face = faceAt(index.row());
    const auto column = static_cast<FaceColumn>(index.column());
    switch (role) {
    case Qt::DisplayRole:
        return text(column, face);
    case Qt::TextAlignmentRole:
        return int(Qt::AlignRight | Qt::AlignVCenter);
    case Qt::ToolTipRole:
        return tellsValues(column) && m_listing.figures()->holdsNan(face)
                   ? tr("Face %1 holds NaN, which counts for nothing here").arg(indexOf(face))
                   : tr("Click selects face %1, double click goes there").arg(indexOf(face));
    case Qt::AccessibleTextRole:
        return m_selection.contains(face) ? tr("%1, selected").arg(text(column, face))
                                          : text(column, face);
    case FaceRole:
        return static_cast<uint>(face);
    case SelectedRole:
        return m_selection.contains(face);
    default:
        return {};
    }
}

QVariant FaceTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= kColumns) {
        return {};
    }
    const ColumnText& column = kTexts[static_cast<std::size_t>(section)];
    if (role == Qt::DisplayRole) {
        return tr(column.title);
    }
    if (role == Qt::ToolTipRole) {
        QString told = tr(column.explanation);
        if (tellsValues(static_cast<FaceColumn>(section)) && m_listing.figures()) {
            const ChannelChoice& channel = m_listing.figures()->channel();
            told += channel ? tr(", in channel %1 alone, as the look is").arg(*channel)
                            : tr(" and all channels but the opacity");
        }
        return told;
    }
    return role == Qt::TextAlignmentRole ? QVariant(int(Qt::AlignRight | Qt::AlignVCenter))
                                         : QVariant();
}

void FaceTableModel::sort(int column, Qt::SortOrder order)
{
    if (column >= 0 && column < kColumns) {
        m_listing.sortBy(static_cast<FaceColumn>(column), order == Qt::DescendingOrder);
    }
}

/// Persistent indices are those of the current row: few.
void FaceTableModel::keepIndices()
{
    m_kept = persistentIndexList();
    m_keptFaces.clear();
    for (const QModelIndex& index : std::as_const(m_kept)) {
        m_keptFaces.push_back(faceAt(index.row()));
    }
}

void FaceTableModel::moveIndices()
{
    QModelIndexList moved;
    for (qsizetype k = 0; k < m_kept.size(); ++k) {
        const auto row = rowOf(m_keptFaces[static_cast<std::size_t>(k)]);
        moved += row ? index(*row, m_kept[k].column()) : QModelIndex();
    }
    changePersistentIndexList(m_kept, moved);
    m_kept.clear();
}

} // namespace trixel::ui
