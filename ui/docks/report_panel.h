// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/base/ids.h"

#include <vector>

class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace trixel {
class Surface;
}

namespace trixel::ui {

/// What is unusual about the mesh, finding by finding, with the faces it concerns.
class ReportPanel : public QWidget
{
    Q_OBJECT

public:
    /// Rows of faces shown under one finding; the rest are counted.
    static constexpr std::size_t kFacesShown = 500;

    explicit ReportPanel(QWidget* parent = nullptr);

    /// \param surface  null when nothing is open
    void show(const Surface* surface);

signals:
    /// The user wants to see a face.
    void faceChosen(trixel::FaceId face);
    /// All faces of a finding.
    void facesChosen(const std::vector<trixel::FaceId>& faces);

private:
    void addFinding(const QString& name, const QString& cost, const std::vector<FaceId>& faces);

    QLabel* m_summary;
    QTreeWidget* m_tree;
    std::vector<std::vector<FaceId>> m_findings; ///< in the order of the rows
};

} // namespace trixel::ui
