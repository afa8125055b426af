// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

#include <functional>

class QAction;
class QMenu;
class QWidget;

namespace trixel::ui {

class Document;
class ExportActions;
class FaceSelection;
class MessageBar;
class ProjectFiles;
class RecentFiles;

/// The File menu: asks what must be asked, then has `ProjectFiles` do it, and shows what came of
/// it. Questions never block the event loop.
class FileActions : public QObject
{
    Q_OBJECT

public:
    FileActions(Document& document,
                FaceSelection& selection,
                ProjectFiles& files,
                MessageBar& messages,
                QWidget& window);

    void fillMenu(QMenu& menu);
    QAction* newAction() const { return m_new; }
    QAction* openAction() const { return m_open; }
    QAction* saveAction() const { return m_save; }
    QAction* quitAction() const { return m_quit; }

    /// Opens a file, after the question about unsaved changes.
    void open(const QString& path);
    /// Opens what was dropped on the window: a `.ptx` together with its mesh, or the first file.
    void openDropped(const QStringList& paths);
    /// Goes on with `then` once nothing would be lost: at once, or when the user has saved the
    /// changes or given them up. Not at all when the user cancels.
    void withoutLoss(std::function<void()> then);

private:
    void makeActions();
    void listen();
    void enable();
    void askForNew(const QString& meshPath);
    void askForOpen();
    void askForMesh(const QString& ptxPath);
    void save(std::function<void()> then);
    void saveAs(std::function<void()> then);
    void saveTo(const QString& path, std::function<void()> then);
    void tellOfMesh(const QString& path);

    Document& m_document;
    ProjectFiles& m_files;
    MessageBar& m_messages;
    QWidget& m_window;
    RecentFiles* m_recent;
    ExportActions* m_exports;
    QAction* m_new = nullptr;
    QAction* m_open = nullptr;
    QAction* m_sample = nullptr;
    QAction* m_save = nullptr;
    QAction* m_saveAs = nullptr;
    QAction* m_quit = nullptr;
};

} // namespace trixel::ui
