// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/report_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "core/mesh/surface.h"

#include <algorithm>

namespace trixel::ui {

namespace {

constexpr int kFaceRole = Qt::UserRole;
constexpr int kFindingRole = Qt::UserRole + 1;

std::vector<FaceId> facesOf(const std::vector<MeshReport::Edge>& edges)
{
    std::vector<FaceId> faces;
    faces.reserve(edges.size());
    for (const MeshReport::Edge& edge : edges) {
        faces.push_back(edge.face);
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
}

} // namespace

ReportPanel::ReportPanel(QWidget* parent)
    : QWidget(parent)
    , m_summary(new QLabel)
    , m_tree(new QTreeWidget)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    layout->addWidget(m_summary);
    layout->addWidget(m_tree, 1);
    layout->addStretch(0);

    m_summary->setWordWrap(true);
    // The keyboard comes here where there are no findings.
    m_summary->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_summary->setToolTip(tr("What the mesh is made of"));
    m_tree->setHeaderHidden(true);
    m_tree->setUniformRowHeights(true);
    m_tree->setAccessibleName(tr("Findings about the mesh"));
    m_tree->setToolTip(
        tr("Choose a face to select it and go there, a finding to select all its faces"));
    const auto choose = [this](const QTreeWidgetItem* item) {
        const QVariant face = item->data(0, kFaceRole);
        if (face.isValid()) {
            emit faceChosen(FaceId{face.toUInt()});
        }
        const QVariant finding = item->data(0, kFindingRole);
        if (finding.isValid()) {
            emit facesChosen(m_findings[finding.toUInt()]);
        }
    };
    connect(m_tree, &QTreeWidget::itemClicked, this, choose);
    connect(m_tree, &QTreeWidget::itemActivated, this, choose);
    show(nullptr);
}

void ReportPanel::show(const Surface* surface)
{
    m_tree->clear();
    m_findings.clear();
    m_tree->setVisible(surface != nullptr && !surface->report().isClean());
    if (surface == nullptr) {
        m_summary->setText(tr("No mesh is open."));
        return;
    }
    const MeshReport& report = surface->report();
    const QLocale locale;
    m_summary->setText(
        tr("%1 faces, %2 vertices, %3 border edges. %4")
            .arg(locale.toString(static_cast<qulonglong>(surface->mesh().faceCount())),
                 locale.toString(static_cast<qulonglong>(surface->mesh().positions.size())),
                 locale.toString(static_cast<qulonglong>(report.borderEdges)),
                 report.isClean() ? tr("Nothing unusual.")
                                  : tr("All faces can be painted; what is unusual:")));
    addFinding(tr("Edges of three or more faces"),
               tr("such an edge counts as a border: paint and filters do not cross it"),
               facesOf(report.nonManifoldEdges));
    addFinding(tr("Faces without area"), tr("a brush cannot reach them"), report.degenerateFaces);
    addFinding(tr("Faces on top of another"),
               tr("the same three corners: only one of them is seen"),
               report.duplicateFaces);
    addFinding(tr("Faces turned over"),
               tr("wound against their neighbours: their shared edges are borders"),
               report.flippedFaces);
    addFinding(tr("Faces on their own"), tr("all three edges are borders"), report.isolatedFaces);
    addFinding(tr("Faces outside the half-edges"),
               tr("their surroundings cannot be walked around"),
               report.halfEdgeRefusedFaces);
}

void ReportPanel::addFinding(const QString& name,
                             const QString& cost,
                             const std::vector<FaceId>& faces)
{
    if (faces.empty()) {
        return;
    }
    auto* finding = new QTreeWidgetItem(m_tree);
    finding->setText(0, tr("%1: %2").arg(name).arg(faces.size()));
    finding->setToolTip(0, tr("%1: %2. Click to select them all.").arg(name, cost));
    finding->setFirstColumnSpanned(true);
    finding->setData(0, kFindingRole, static_cast<uint>(m_findings.size()));
    m_findings.push_back(faces);
    const std::size_t shown = std::min(faces.size(), kFacesShown);
    for (std::size_t k = 0; k < shown; ++k) {
        const auto face = static_cast<quint32>(faces[k]);
        auto* row = new QTreeWidgetItem(finding);
        row->setText(0, tr("Face %1").arg(face));
        row->setToolTip(0, tr("Look at face %1").arg(face));
        row->setData(0, kFaceRole, face);
    }
    if (shown < faces.size()) {
        auto* rest = new QTreeWidgetItem(finding);
        rest->setText(0, tr("and %1 more").arg(faces.size() - shown));
        rest->setToolTip(0, tr("Only the first %1 are listed").arg(shown));
    }
}

} // namespace trixel::ui
