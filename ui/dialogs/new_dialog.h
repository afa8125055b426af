// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QTimer>

#include "core/mesh/triangle_mesh.h"
#include "ui/document/background_job.h"
#include "ui/document/project_options.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QSpinBox;
class QStackedWidget;

namespace trixel::ui {

class ChannelChoice;
class PathRow;
class SwatchButton;
class TypeChoice;

/// A new project from a mesh: which file, how many texels of which type, which fill; says what it
/// will take before it is made.
class NewDialog : public QDialog
{
    Q_OBJECT

public:
    /// \param meshPath  read at once unless empty
    explicit NewDialog(const QString& meshPath, QWidget* parent = nullptr);

signals:
    void createWanted(const std::shared_ptr<const trixel::TriangleMesh>& mesh,
                      const trixel::ui::ProjectOptions& options,
                      const QString& name);

private:
    QFormLayout* makeForm();
    QWidget* makeSize();
    void connectAll();
    void readMesh();
    void takeMesh(Result<TriangleMesh> mesh);
    void plan();
    void showPlan(const Result<LevelPlan>& plan);
    ProjectOptions options() const;
    void chooseFill();
    void finish();

    PathRow* m_path;
    QLabel* m_mesh;
    QComboBox* m_by;
    QStackedWidget* m_sizes;
    QDoubleSpinBox* m_total;   ///< million texels
    QDoubleSpinBox* m_density; ///< texels per world unit
    QSpinBox* m_level;
    TypeChoice* m_type;
    ChannelChoice* m_channels;
    SwatchButton* m_fill;
    QLabel* m_summary;
    QPushButton* m_create;
    QTimer m_typing;
    std::shared_ptr<const TriangleMesh> m_triangles;
    quint64 m_meshGeneration = 0;
    quint64 m_planGeneration = 0;
    BackgroundJobs m_jobs; // last: waits for work before the rest dies
};

} // namespace trixel::ui
