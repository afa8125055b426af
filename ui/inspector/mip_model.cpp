// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/mip_model.h"

#include <QFont>

#include "core/texture/texel_report.h"
#include "ui/inspector/difference_colors.h"
#include "ui/inspector/mip_focus.h"
#include "ui/inspector/mip_text.h"

namespace trixel::ui {

MipModel::MipModel(const MipFocus& focus, QObject* parent)
    : QAbstractTableModel(parent)
    , m_focus(focus)
{
    connect(&focus, &MipFocus::faceChanged, this, &MipModel::takeFace);
    connect(&focus, &MipFocus::texelChanged, this, [this] { renew(Right, Parts); });
    connect(&focus, &MipFocus::measured, this, [this] { renew(File, File); });
}

Level MipModel::levelAt(int row) const
{
    return m_focus.base().coarser(row);
}

int MipModel::rowOf(Level level) const
{
    return m_focus.base().log2() - level.log2();
}

int MipModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : m_rows;
}

int MipModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

void MipModel::takeFace()
{
    const int rows = m_focus.face() ? m_focus.base().log2() + 1 : 0;
    if (rows == m_rows) {
        renew(0, ColumnCount - 1);
        return;
    }
    beginResetModel();
    m_rows = rows;
    endResetModel();
}

void MipModel::renew(int firstColumn, int lastColumn)
{
    if (m_rows > 0) {
        emit dataChanged(index(0, firstColumn), index(m_rows - 1, lastColumn));
    }
}

QVariant MipModel::data(const QModelIndex& index, int role) const
{
    // A face with other levels is told of a moment after there is one.
    if (!index.isValid() || !m_focus.face() || m_rows != m_focus.base().log2() + 1) {
        return {};
    }
    const Level level = levelAt(index.row());
    switch (role) {
    case Qt::DisplayRole:
        return text(level, index.column());
    case Qt::ToolTipRole:
        return toolTip(level, index.column());
    case Qt::TextAlignmentRole: {
        const bool isWords = index.column() == LevelNumber || index.column() == Kept;
        return QVariant::fromValue(Qt::AlignVCenter | (isWords ? Qt::AlignLeft : Qt::AlignRight));
    }
    default:
        return {};
    }
}

QString MipModel::text(Level level, int column) const
{
    return column < Right || column == Texels ? factText(level, column) : valueText(level, column);
}

QString MipModel::factText(Level level, int column) const
{
    switch (column) {
    case LevelNumber:
        return tr("%1 · %2").arg(level.log2()).arg(resolutionText(level));
    case Texels:
        return texelCountText(level);
    case Kept: {
        const PtxKeeping keeping = keepingOf(m_focus, level);
        const bool alike = m_focus.levels() != nullptr && m_focus.levels()->isConstant(level) &&
                           keeping != PtxKeeping::Constant && level.log2() > 0;
        return alike ? tr("%1, alike").arg(keepingText(keeping)) : keepingText(keeping);
    }
    case Memory:
        return bytesText(static_cast<double>(memoryBytes(m_focus, level)));
    default:
        return fileBytesText(m_focus, level);
    }
}

QString MipModel::valueText(Level level, int column) const
{
    const MipComparison* levels = m_focus.levels();
    if (levels == nullptr) {
        return QString("…");
    }
    if (column == Worst) {
        return partsText(levels->difference(level).worst).remove('+');
    }
    if (column == Rms) {
        return partsText(levels->difference(level).rms).remove('+');
    }
    const TexelCoord texel = m_focus.texel(level);
    const TexelType type = levels->format().type;
    const auto right = levels->values(m_focus.texels(), level, texel, ReductionRule::Triangles);
    if (column == Right) {
        return QString::fromStdString(storedText(type, right));
    }
    const auto box = levels->values(m_focus.texels(), level, texel, ReductionRule::Box);
    if (column == Box) {
        return QString::fromStdString(storedText(type, box));
    }
    return column == Difference ? differenceText(type, right, box)
                                : partsText(signedDifference(right, box, std::nullopt));
}

QString MipModel::toolTip(Level level, int column) const
{
    switch (column) {
    case LevelNumber:
    case Texels:
        return tr("%1: %2 texels a side, %3 in all: 4 to the power of %4")
            .arg(levelText(level))
            .arg(level.resolution())
            .arg(texelCountText(level))
            .arg(level.log2());
    case Kept:
        return m_focus.levels() != nullptr && m_focus.levels()->isConstant(level)
                   ? keepingTip(keepingOf(m_focus, level)) + "\n" +
                         tr("All texels of the level are alike.")
                   : keepingTip(keepingOf(m_focus, level));
    case Memory:
        return level == m_focus.base()
                   ? tr("The project holds the face's own level in memory.")
                   : tr("The project holds no reductions: they are made when they are needed. "
                        "This one has %1 of texels.")
                         .arg(bytesText(static_cast<double>(level.texelCount()) *
                                        static_cast<double>(m_focus.format().texelBytes())));
    case File:
        return keepingTip(keepingOf(m_focus, level)) + "\n" +
               tr("Its bytes as exported; a .trixel project stores the face's own level only.");
    case Right:
    case Box:
    case Difference:
    case Parts:
        return tr("Texel %1 of %2, which covers the texel looked at or lies in it")
            .arg(texelText(m_focus.texel(level)), levelText(level).toLower());
    default:
        return tr("Over all texels and channels of the level");
    }
}

QVariant MipModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= ColumnCount) {
        return {};
    }
    struct Head
    {
        QString title;
        QString toolTip;
    };
    const auto head = [section]() -> Head {
        switch (section) {
        case LevelNumber:
            return {tr("Level"), tr("Level and texels along an edge: each level halves them")};
        case Texels:
            return {tr("Texels"), tr("Texels of the face at the level")};
        case Kept:
            return {tr("In a .ptx"), tr("Whether a .ptx stores the level or readers compute it")};
        case Memory:
            return {tr("Memory"), tr("Bytes of the level in the open project")};
        case File:
            return {tr("File"), tr("Bytes of the level's block in a .ptx, as exported")};
        case Right:
            return {tr("Right"), tr("The texel's value: the mean of the four texels it covers")};
        case Box:
            return {tr("2×2 box"), tr("Its value if the packed square were reduced as an image")};
        case Difference:
            return {tr("Box − right"), tr("What the box gets wrong, in stored units")};
        case Parts:
            return {tr("of 255"), tr("The same in parts of 255: the channel that differs most")};
        case Worst:
            return {tr("Worst"), tr("Largest difference of the level, in parts of 255")};
        default:
            return {tr("RMS"), tr("Root of the level's mean squared difference, in parts of 255")};
        }
    };
    if (role == Qt::DisplayRole) {
        return head().title;
    }
    return role == Qt::ToolTipRole ? QVariant(head().toolTip) : QVariant();
}

} // namespace trixel::ui
