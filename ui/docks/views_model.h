// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include "core/study/views/view_camera.h"

#include <variant>
#include <vector>

namespace trixel::ui {

class Document;

/// The bookmarked views of a document as rows in their order; names can be edited.
class ViewsModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column { Name, Picture, ColumnCount };

    explicit ViewsModel(Document& document, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

private:
    using View = std::variant<ViewCamera, DistantViews>;
    /// Rows that are the same before and after stay as they are, selection and all.
    void follow();

    Document& m_document;
    std::vector<View> m_views;
};

} // namespace trixel::ui
