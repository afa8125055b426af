// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inspector/footprint_model.h"

namespace trixel::ui {

namespace {

FootprintRow rowOf(std::size_t index)
{
    return static_cast<FootprintRow>(index);
}

/// Of a frozen footprint the weights are not asked for.
bool isToldOfFrozen(FootprintRow row)
{
    return row != FootprintRow::Texels && row != FootprintRow::Spread;
}

} // namespace

FootprintModel::FootprintModel(QObject* parent)
    : QAbstractTableModel(parent)
{
    m_live.fill(QStringLiteral("–"));
    arrange();
}

void FootprintModel::show(const std::optional<FootprintFacts>& facts)
{
    Texts next;
    for (std::size_t k = 0; k < kFootprintRows; ++k) {
        next[k] = facts ? footprintRowText(rowOf(k), *facts) : QStringLiteral("–");
    }
    take(m_live, next, false);
}

void FootprintModel::showFrozen(const std::optional<FootprintFacts>& facts)
{
    if (!facts && !m_hasFrozen) {
        return;
    }
    Texts next;
    for (std::size_t k = 0; facts && k < kFootprintRows; ++k) {
        if (isToldOfFrozen(rowOf(k))) {
            next[k] = footprintRowText(rowOf(k), *facts);
        }
    }
    if (m_hasFrozen == facts.has_value()) {
        take(m_frozen, next, true);
        return;
    }
    beginResetModel();
    m_hasFrozen = facts.has_value();
    m_frozen = next;
    arrange();
    endResetModel();
}

void FootprintModel::setFrozenBeside(bool beside)
{
    if (beside == m_isBeside) {
        return;
    }
    if (!m_hasFrozen) {
        m_isBeside = beside;
        return;
    }
    beginResetModel();
    m_isBeside = beside;
    arrange();
    endResetModel();
}

void FootprintModel::arrange()
{
    m_lines.clear();
    for (std::size_t k = 0; k < kFootprintRows; ++k) {
        m_lines.push_back({rowOf(k), false});
        if (m_hasFrozen && !m_isBeside && isToldOfFrozen(rowOf(k))) {
            m_lines.push_back({rowOf(k), true});
        }
    }
}

void FootprintModel::take(Texts& shown, const Texts& next, bool frozen)
{
    const Texts before = std::exchange(shown, next);
    for (int line = 0; line < rowCount(); ++line) {
        const Line& about = m_lines[static_cast<std::size_t>(line)];
        const std::size_t k = indexOfRow(about.row);
        if (before[k] == next[k]) {
            continue;
        }
        const bool isBeside = frozen && m_isBeside;
        if (isBeside || about.isFrozen == frozen) {
            // One by one: views draw what lies between two corners anew, too.
            const QModelIndex changed = index(line, isBeside ? Frozen : Value);
            emit dataChanged(changed, changed, {Qt::DisplayRole, Qt::ToolTipRole});
        }
    }
}

int FootprintModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_lines.size());
}

int FootprintModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : m_hasFrozen && m_isBeside ? 3 : 2;
}

bool FootprintModel::isFrozen(const QModelIndex& index) const
{
    return index.column() == Frozen || m_lines[static_cast<std::size_t>(index.row())].isFrozen;
}

const QString& FootprintModel::textAt(const QModelIndex& index) const
{
    const std::size_t k = indexOfRow(rowAt(index.row()));
    return isFrozen(index) ? m_frozen[k] : m_live[k];
}

QVariant FootprintModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid()) {
        return {};
    }
    const FootprintRow row = rowAt(index.row());
    const bool isName = index.column() == Name;
    switch (role) {
    case Qt::DisplayRole:
        return !isName ? textAt(index) : isFrozen(index) ? tr("  frozen") : footprintRowName(row);
    case Qt::ToolTipRole:
        // What has no room in its cell can be read whole.
        return isName ? footprintRowTip(row) : textAt(index) + "\n\n" + footprintRowTip(row);
    case Qt::TextAlignmentRole:
        return QVariant::fromValue(Qt::AlignLeft | Qt::AlignTop);
    case Qt::AccessibleTextRole: {
        const QString name = footprintRowName(row).trimmed();
        const QString whose = isFrozen(index) ? tr("%1 of the frozen footprint").arg(name) : name;
        return isName ? whose : whose + ": " + textAt(index);
    }
    case kFrozenRole:
        return isFrozen(index);
    default:
        return {};
    }
}

QVariant FootprintModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole || section < 0 ||
        section >= columnCount()) {
        return {};
    }
    return section == Name ? tr("Number") : section == Value ? tr("Footprint") : tr("Frozen");
}

QString FootprintModel::text() const
{
    QString lines;
    for (std::size_t k = 0; k < kFootprintRows; ++k) {
        QString line = footprintRowName(rowOf(k)).trimmed() + ": " + m_live[k];
        if (!m_frozen[k].isEmpty()) {
            line += " | " + m_frozen[k];
        }
        lines += line.replace('\n', ' ') + '\n';
    }
    return lines;
}

} // namespace trixel::ui
