// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "ui/document/background_job.h"
#include "ui/exchange/other_file.h"

class QCheckBox;
class QPushButton;

namespace trixel::ui {

class FileField;

/// Asks which file the open project is to be compared with, and looks whether it can be.
class CompareDialog : public QDialog
{
    Q_OBJECT

public:
    /// \param project  a snapshot
    /// \param path     proposed file; may be empty
    CompareDialog(Project project, const QString& path, QWidget* parent = nullptr);

signals:
    /// \param matches  whether the file's faces are to be matched to the mesh's
    void compareWanted(const QString& path, bool matches);

private:
    void look(const QString& path);
    void take(const Result<OtherFile>& other, const QString& path);
    void forget();
    void finish();

    Project m_project;
    FileField* m_file;
    QCheckBox* m_matches;
    QPushButton* m_compare;
    quint64 m_generation = 0;
    BackgroundJobs m_jobs; // last: waits for work before the rest dies
};

} // namespace trixel::ui
