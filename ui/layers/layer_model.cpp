// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/layers/layer_model.h"

#include <QScopedValueRollback>

#include "core/base/check.h"
#include "ui/document/document.h"
#include "ui/layers/layer_commands.h"
#include "ui/layers/layer_words.h"

#include <algorithm>
#include <ranges>

namespace trixel::ui {

LayerModel::LayerModel(Document& document, LayerCommands& commands, QObject* parent)
    : QAbstractListModel(parent)
    , m_document(document)
    , m_commands(commands)
{
    connect(&commands, &LayerCommands::changed, this, &LayerModel::follow);
    follow();
}

std::vector<LayerModel::Row> LayerModel::rowsNow() const
{
    std::vector<Row> rows;
    if (!m_document.isOpen()) {
        return rows;
    }
    for (const Layer& layer : std::views::reverse(m_document.layers().layers())) {
        rows.push_back({layer.id, layer.settings});
    }
    LayerSettings base;
    base.name = layerName(m_document.layers(), kBaseLayer).toStdString();
    rows.push_back({kBaseLayer, base});
    return rows;
}

void LayerModel::follow()
{
    const QScopedValueRollback<bool> following(m_isFollowing, true);
    const std::vector<Row> next = rowsNow();
    removeOthers(next);
    reorder(next);
    insertNew(next);
    if (m_rows != next) {
        m_rows = next;
        emit dataChanged(index(0), index(static_cast<int>(m_rows.size()) - 1));
    }
}

void LayerModel::removeOthers(const std::vector<Row>& next)
{
    for (int row = static_cast<int>(m_rows.size()) - 1; row >= 0; --row) {
        if (std::ranges::find(next, layerAt(row), &Row::layer) == next.end()) {
            beginRemoveRows({}, row, row);
            m_rows.erase(m_rows.begin() + row);
            endRemoveRows();
        }
    }
}

/// All rows are of layers that are there still.
void LayerModel::reorder(const std::vector<Row>& next)
{
    std::vector<Row> ordered;
    for (const Row& row : next) {
        if (const int at = rowOf(row.layer); at >= 0) {
            ordered.push_back(m_rows[static_cast<std::size_t>(at)]);
        }
    }
    if (std::ranges::equal(ordered, m_rows, {}, &Row::layer, &Row::layer)) {
        return;
    }
    emit layoutAboutToBeChanged();
    const QModelIndexList before = persistentIndexList();
    std::vector<LayerId> layers;
    for (const QModelIndex& index : before) {
        layers.push_back(layerAt(index.row()));
    }
    m_rows = ordered;
    QModelIndexList after;
    for (const LayerId layer : layers) {
        after += index(rowOf(layer));
    }
    changePersistentIndexList(before, after);
    emit layoutChanged();
}

void LayerModel::insertNew(const std::vector<Row>& next)
{
    for (std::size_t k = 0; k < next.size(); ++k) {
        if (k >= m_rows.size() || m_rows[k].layer != next[k].layer) {
            const int row = static_cast<int>(k);
            beginInsertRows({}, row, row);
            m_rows.insert(m_rows.begin() + row, next[k]);
            endInsertRows();
        }
    }
}

LayerId LayerModel::layerAt(int row) const
{
    check(row >= 0 && row < static_cast<int>(m_rows.size()), "a row of the layers");
    return m_rows[static_cast<std::size_t>(row)].layer;
}

int LayerModel::rowOf(LayerId layer) const
{
    const auto found = std::ranges::find(m_rows, layer, &Row::layer);
    return found == m_rows.end() ? -1 : static_cast<int>(found - m_rows.begin());
}

int LayerModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

QVariant LayerModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    const Row& row = m_rows[static_cast<std::size_t>(index.row())];
    const LayerSettings& settings = row.settings;
    const QString name = QString::fromStdString(settings.name);
    const bool isBase = row.layer == kBaseLayer;
    switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
        return name;
    case Qt::CheckStateRole:
        return isBase               ? QVariant()
               : settings.isVisible ? QVariant(Qt::Checked)
                                    : QVariant(Qt::Unchecked);
    case Qt::AccessibleTextRole:
    case Qt::ToolTipRole: {
        if (isBase) {
            return tr("Base: what lies below all layers, always shown");
        }
        const QString hint = settingsHint(settings);
        const QString set = hint.isEmpty() ? titleOf(settings.blend) : hint;
        return settings.isVisible ? tr("%1: %2").arg(name, set)
                                  : tr("%1: %2, hidden").arg(name, set);
    }
    case Opacity:
        return isBase ? QVariant() : QVariant(settings.opacity);
    case Blend:
        return isBase ? QVariant() : QVariant(titleOf(settings.blend));
    case Hint:
        return isBase ? QString() : settingsHint(settings);
    default:
        return {};
    }
}

Qt::ItemFlags LayerModel::flags(const QModelIndex& index) const
{
    if (!index.isValid()) {
        return Qt::ItemIsDropEnabled; // between rows, not onto them
    }
    const Qt::ItemFlags common =
        Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
    return layerAt(index.row()) == kBaseLayer
               ? common
               : common | Qt::ItemIsEditable | Qt::ItemIsUserCheckable | Qt::ItemIsDragEnabled;
}

bool LayerModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid) || layerAt(index.row()) == kBaseLayer) {
        return false;
    }
    const LayerId layer = layerAt(index.row());
    if (role == Qt::EditRole) {
        m_commands.rename(layer, value.toString());
        return true;
    }
    if (role == Qt::CheckStateRole) {
        m_commands.setVisible(layer, value.toInt() == Qt::Checked);
        return true;
    }
    return false;
}

QHash<int, QByteArray> LayerModel::roleNames() const
{
    QHash<int, QByteArray> names = QAbstractListModel::roleNames();
    names.insert({{Opacity, "opacity"}, {Blend, "blend"}, {Hint, "hint"}});
    return names;
}

bool LayerModel::moveRows(
    const QModelIndex& from, int row, int count, const QModelIndex& to, int before)
{
    const int base = rowCount() - 1;
    if (from.isValid() || to.isValid() || count != 1 || row < 0 || row >= base || before < 0 ||
        before > rowCount()) {
        return false;
    }
    // Below the base is nothing: let go there, it becomes the lowest of the layers.
    const int target = std::min(before, base) - (before > row ? 1 : 0);
    m_commands.move(layerAt(row), static_cast<std::size_t>(base - 1 - target));
    return true;
}

} // namespace trixel::ui
