// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "core/io/project.h"
#include "ui/document/background_job.h"

class QCheckBox;
class QLabel;
class QPushButton;

namespace trixel::ui {

class PathRow;
class TypeChoice;

/// Asks how a `.ptx` is to be written, and says beforehand what it will weigh.
class ExportDialog : public QDialog
{
    Q_OBJECT

public:
    /// \param project  a snapshot, for the estimate
    /// \param path     proposed destination
    ExportDialog(Project project, const QString& path, QWidget* parent = nullptr);

signals:
    void exportWanted(const QString& path, trixel::TexelType type, bool mips);

private:
    void estimate();
    void checkPath();
    void finish();

    Project m_project;
    PathRow* m_path;
    TypeChoice* m_type;
    QCheckBox* m_mips;
    QLabel* m_size;
    QLabel* m_note;
    QPushButton* m_export;
    quint64 m_generation = 0;
    BackgroundJobs m_jobs; // last: waits for work before the rest dies
};

} // namespace trixel::ui
