// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include "ui/inspector/footprint_rows.h"

#include <array>
#include <optional>
#include <vector>

namespace trixel::ui {

/// The numbers of a footprint as rows of name and value. Those of a frozen one stand in a third
/// column or, where that has no room, in rows of their own below each.
class FootprintModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Name, Value, Frozen };
    /// Whether a cell belongs to the frozen footprint.
    static constexpr int kFrozenRole = Qt::UserRole;

    explicit FootprintModel(QObject* parent = nullptr);

    /// Only cells whose text differs are told of.
    void show(const std::optional<FootprintFacts>& facts);
    void showFrozen(const std::optional<FootprintFacts>& facts);
    bool hasFrozen() const { return m_hasFrozen; }
    void setFrozenBeside(bool beside);

    /// What a line of the model is about.
    FootprintRow rowAt(int line) const { return m_lines[static_cast<std::size_t>(line)].row; }
    const QString& text(FootprintRow row) const { return m_live[indexOfRow(row)]; }
    /// Empty where there is none.
    const QString& frozenText(FootprintRow row) const { return m_frozen[indexOfRow(row)]; }
    /// All rows as lines, for the clipboard.
    QString text() const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    struct Line
    {
        FootprintRow row{};
        bool isFrozen = false;
    };
    using Texts = std::array<QString, kFootprintRows>;

    static std::size_t indexOfRow(FootprintRow row) { return static_cast<std::size_t>(row); }
    void arrange();
    bool isFrozen(const QModelIndex& index) const;
    const QString& textAt(const QModelIndex& index) const;
    void take(Texts& shown, const Texts& next, bool frozen);

    Texts m_live;
    Texts m_frozen;
    std::vector<Line> m_lines;
    bool m_hasFrozen = false;
    bool m_isBeside = false;
};

} // namespace trixel::ui
