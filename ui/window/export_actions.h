// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

#include "core/io/export_project.h"

#include <optional>

class QAction;
class QMenu;
class QWidget;

namespace trixel::ui {

class Document;
class FaceSelection;
class MessageBar;
class ProjectFiles;

/// Ways out of the project: asks for one, repeats the latest, tells what was written.
class ExportActions : public QObject
{
    Q_OBJECT

public:
    ExportActions(Document& document,
                  FaceSelection& selection,
                  ProjectFiles& files,
                  MessageBar& messages,
                  QWidget& window);

    void fillMenu(QMenu& menu);

private:
    void enable();
    void ask();
    void repeat();
    void tell(const ExportOutcome& outcome);
    QString proposedPath() const;

    Document& m_document;
    FaceSelection& m_selection;
    ProjectFiles& m_files;
    MessageBar& m_messages;
    QWidget& m_window;
    QAction* m_export;
    QAction* m_again;
    std::optional<ExportRequest> m_latest; ///< of this document
};

} // namespace trixel::ui
