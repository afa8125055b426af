// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "ui/document/face_selection.h"
#include "ui/import/import_settings.h"

#include <vector>

class QCheckBox;
class QComboBox;
class QFormLayout;

namespace trixel::ui {

class ValueRow;

/// What does not depend on the way an image is laid onto the surface: how it is looked up, how
/// strongly it is laid on, and onto which faces.
class ImportOptions : public QObject
{
    Q_OBJECT

public:
    /// Adds its rows to a form. \param selection  outlives this
    ImportOptions(const FaceSelection& selection, QFormLayout& form, QObject* parent);

    /// Puts what is chosen into the settings.
    void fill(ImportSettings& settings) const;
    /// Shows the rows that mean something for a mapping.
    void showFor(MapKind kind);
    bool isSelectionOnly() const;
    /// Nothing where all faces are meant.
    std::vector<FaceId> chosenFaces() const;

signals:
    void changed();

private:
    void makeReach(QFormLayout& form);
    void makeLookup(QFormLayout& form);
    void takeSelection();

    const FaceSelection& m_selection;
    QComboBox* m_faces;
    QCheckBox* m_frontOnly;
    QCheckBox* m_visibleOnly;
    QCheckBox* m_repeats;
    QComboBox* m_lookup;
    QComboBox* m_index;
    ValueRow* m_opacity;
};

} // namespace trixel::ui
