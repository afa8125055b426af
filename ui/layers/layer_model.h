// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractListModel>

#include "core/layers/layer_stack.h"

#include <vector>

namespace trixel::ui {

class Document;
class LayerCommands;

/// The layers of a document as rows, the topmost first, the base last; no rows while none is open.
/// Names are edited, check boxes show and hide, rows are moved: one undo step each.
class LayerModel : public QAbstractListModel
{
    Q_OBJECT

public:
    enum Role {
        Opacity = Qt::UserRole, ///< [0,1]; none for the base
        Blend,                  ///< its title; none for the base
        Hint                    ///< how it is set where that is not as layers begin
    };

    LayerModel(Document& document, LayerCommands& commands, QObject* parent = nullptr);

    /// \param row  of the model (checked)
    LayerId layerAt(int row) const;
    /// -1 for one that is not there.
    int rowOf(LayerId layer) const;
    /// Whether rows come and go right now because the layers did, by no choice of a view's user.
    bool isFollowing() const { return m_isFollowing; }

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    QHash<int, QByteArray> roleNames() const override;

    Qt::DropActions supportedDropActions() const override { return Qt::MoveAction; }
    /// Within the list, one row at a time, never the base.
    bool moveRows(
        const QModelIndex& from, int row, int count, const QModelIndex& to, int before) override;

private:
    struct Row
    {
        LayerId layer = kBaseLayer;
        LayerSettings settings; ///< of the base: its name alone

        bool operator==(const Row&) const = default;
    };
    std::vector<Row> rowsNow() const;
    /// Rows whose layer stays keep what points at them, selection and all.
    void follow();
    void removeOthers(const std::vector<Row>& next);
    void reorder(const std::vector<Row>& next);
    void insertNew(const std::vector<Row>& next);

    Document& m_document;
    LayerCommands& m_commands;
    std::vector<Row> m_rows;
    bool m_isFollowing = false;
};

} // namespace trixel::ui
