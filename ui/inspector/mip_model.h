// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include "core/texture/mip_comparison.h"

namespace trixel::ui {

class MipFocus;

/// The levels of the face that is looked at as rows, the finest first: what each is, what it takes,
/// and the value of the texel looked at by both reductions.
class MipModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column {
        LevelNumber,
        Kept,
        Memory,
        File,
        Right,
        Box,
        Difference,
        Parts,
        Worst,
        Rms,
        Texels,
        ColumnCount
    };

    explicit MipModel(const MipFocus& focus, QObject* parent = nullptr);

    Level levelAt(int row) const;
    int rowOf(Level level) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    void takeFace();
    void renew(int firstColumn, int lastColumn);
    QString text(Level level, int column) const;
    QString factText(Level level, int column) const;
    QString valueText(Level level, int column) const;
    QString toolTip(Level level, int column) const;

    const MipFocus& m_focus;
    int m_rows = 0;
};

} // namespace trixel::ui
