// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>

#include "core/texture/face_filter.h"

#include <optional>

namespace trixel::ui {

class FaceListing;
class FaceSelection;

/// The listed faces as rows. Holds nothing of its own: a million rows cost no more than those that
/// are looked at.
class FaceTableModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    static constexpr int kColumns = static_cast<int>(std::size(kFaceColumns));

    enum Role {
        FaceRole = Qt::UserRole, ///< number of the row's face
        SelectedRole             ///< whether the face is selected
    };

    FaceTableModel(FaceListing& listing, const FaceSelection& selection, QObject* parent = nullptr);

    /// The face of a row (checked).
    FaceId faceAt(int row) const;
    /// Nothing for a face that is not listed.
    std::optional<int> rowOf(FaceId face) const;
    /// The listed faces of rows [first, last] (checked).
    std::span<const FaceId> facesOf(int first, int last) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    /// The order comes a moment later.
    void sort(int column, Qt::SortOrder order) override;

private:
    QString text(FaceColumn column, FaceId face) const;
    void keepIndices();
    void moveIndices();

    FaceListing& m_listing;
    const FaceSelection& m_selection;
    QModelIndexList m_kept; ///< of views, before rows change their order
    std::vector<FaceId> m_keptFaces;
};

} // namespace trixel::ui
