// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/file_actions.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>

#include "ui/dialogs/format_choice.h"
#include "ui/dialogs/new_dialog.h"
#include "ui/document/document.h"
#include "ui/document/project_files.h"
#include "ui/window/actions.h"
#include "ui/window/export_actions.h"
#include "ui/window/last_folder.h"
#include "ui/window/message_bar.h"
#include "ui/window/recent_files.h"

#include <utility>

namespace trixel::ui {

namespace {

QString meshFilter()
{
    return FileActions::tr("Meshes (*.obj *.ply *.stl *.off)");
}

/// A file dialog that dies when it closes.
QFileDialog* makeFileDialog(QWidget& window, const QString& title, const QString& start)
{
    auto* dialog = new QFileDialog(&window, title, start);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    return dialog;
}

QString withEnding(const QString& path, const QString& ending)
{
    return path.endsWith(ending, Qt::CaseInsensitive) ? path : path + ending;
}

} // namespace

FileActions::FileActions(Document& document,
                         FaceSelection& selection,
                         ProjectFiles& files,
                         MessageBar& messages,
                         QWidget& window)
    : QObject(&window)
    , m_document(document)
    , m_files(files)
    , m_messages(messages)
    , m_window(window)
    , m_recent(new RecentFiles(this))
    , m_exports(new ExportActions(document, selection, files, messages, window))
{
    makeActions();
    listen();
    enable();
}

void FileActions::makeActions()
{
    ActionMaker make(m_window);
    m_new = make(tr("&New from Mesh…"),
                 tr("Start a project on a mesh: choose levels, type and fill"),
                 QKeySequence::New,
                 "new");
    m_open = make(
        tr("&Open…"), tr("Open a project, a .ptx texture or a mesh"), QKeySequence::Open, "open");
    m_sample = make(tr("Open Sa&mple Scene"), tr("Open the scene that comes with the program"));
    m_save = make(tr("&Save"), tr("Save the project"), QKeySequence::Save, "save");
    m_saveAs = make(tr("Save &As…"),
                    tr("Save the project under another name"),
                    QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S));
    m_quit = make(tr("&Quit"), tr("Close the window"), QKeySequence(Qt::CTRL | Qt::Key_Q));

    connect(m_new, &QAction::triggered, this, [this] { askForNew({}); });
    connect(m_open, &QAction::triggered, this, &FileActions::askForOpen);
    connect(m_sample, &QAction::triggered, this, [this] {
        withoutLoss([this] { m_files.openSample(); });
    });
    connect(m_save, &QAction::triggered, this, [this] { save({}); });
    connect(m_saveAs, &QAction::triggered, this, [this] { saveAs({}); });
    connect(m_quit, &QAction::triggered, &m_window, &QWidget::close);
}

void FileActions::listen()
{
    connect(m_recent, &RecentFiles::chosen, this, &FileActions::open);
    connect(&m_document, &Document::opened, this, [this] {
        enable();
        m_messages.dismiss(); // of what was open before; notices of the new document follow
    });
    connect(&m_document, &Document::notice, this, [this](const QString& sentence) {
        m_messages.showMessage(MessageBar::Kind::Error, sentence);
    });
    connect(&m_files, &ProjectFiles::failed, this, [this](const QString& sentence) {
        m_messages.showMessage(MessageBar::Kind::Error, sentence);
    });
    connect(&m_files, &ProjectFiles::opened, this, [this](const QString& path) {
        m_recent->add(path);
        rememberFolderOf(path);
    });
    connect(&m_files, &ProjectFiles::saved, this, [this](const QString& path) {
        m_recent->add(path);
        rememberFolderOf(path);
    });
    connect(&m_files, &ProjectFiles::savingChanged, this, &FileActions::enable);
    connect(&m_files, &ProjectFiles::meshOpened, this, &FileActions::tellOfMesh);
    connect(&m_files,
            &ProjectFiles::matchWanted,
            this,
            [this](const QString& ptx, const QString& mesh, const QString& sentence) {
                m_messages.showMessage(
                    MessageBar::Kind::Note, sentence, {tr("&Match Faces"), [this, ptx, mesh] {
                                                           withoutLoss([this, ptx, mesh] {
                                                               m_files.openPtxMatchedOn(ptx, mesh);
                                                           });
                                                       }});
            });
    connect(&m_files,
            &ProjectFiles::meshWanted,
            this,
            [this](const QString& ptxPath, const QString& sentence) {
                m_messages.showMessage(
                    MessageBar::Kind::Note, sentence, {tr("Choose &Mesh…"), [this, ptxPath] {
                                                           askForMesh(ptxPath);
                                                       }});
            });
}

void FileActions::enable()
{
    const bool isOpen = m_document.isOpen();
    m_save->setEnabled(isOpen && !m_files.isSaving());
    m_saveAs->setEnabled(isOpen && !m_files.isSaving());
}

void FileActions::fillMenu(QMenu& menu)
{
    menu.addAction(m_new);
    menu.addAction(m_open);
    m_recent->attachTo(*menu.addMenu(tr("Open &Recent")));
    menu.addAction(m_sample);
    menu.addSeparator();
    menu.addAction(m_save);
    menu.addAction(m_saveAs);
    menu.addSeparator();
    m_exports->fillMenu(menu);
}

void FileActions::open(const QString& path)
{
    withoutLoss([this, path] { m_files.open(path); });
}

void FileActions::openDropped(const QStringList& paths)
{
    QString ptx;
    QString mesh;
    for (const QString& path : paths) {
        if (fileKindOf(path) == FileKind::Ptx) {
            ptx = path;
        } else if (fileKindOf(path) == FileKind::Mesh) {
            mesh = path;
        }
    }
    if (paths.size() == 2 && !ptx.isEmpty() && !mesh.isEmpty()) {
        withoutLoss([this, ptx, mesh] { m_files.openPtxOn(ptx, mesh); });
    } else if (!paths.isEmpty()) {
        open(paths.constFirst());
    }
}

void FileActions::askForNew(const QString& meshPath)
{
    auto* dialog = new NewDialog(meshPath, &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog,
            &NewDialog::createWanted,
            this,
            [this](const std::shared_ptr<const TriangleMesh>& mesh,
                   const ProjectOptions& options,
                   const QString& name) {
                m_messages.dismiss();
                withoutLoss(
                    [this, mesh, options, name] { m_files.createNew(mesh, options, name); });
            });
    dialog->open();
}

void FileActions::askForOpen()
{
    QFileDialog* dialog = makeFileDialog(m_window, tr("Open"), lastFolder());
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters({tr("All that can be opened (*.trixel *.ptx *.obj *.ply *.stl *.off)"),
                            tr("Projects (*.trixel)"),
                            tr("Ptex textures (*.ptx)"),
                            meshFilter(),
                            tr("All files (*)")});
    connect(dialog, &QFileDialog::fileSelected, this, &FileActions::open);
    dialog->open();
}

void FileActions::askForMesh(const QString& ptxPath)
{
    QFileDialog* dialog = makeFileDialog(m_window,
                                         tr("Mesh of %1").arg(QFileInfo(ptxPath).fileName()),
                                         QFileInfo(ptxPath).absolutePath());
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters({meshFilter(), tr("All files (*)")});
    connect(dialog, &QFileDialog::fileSelected, this, [this, ptxPath](const QString& mesh) {
        withoutLoss([this, ptxPath, mesh] { m_files.openPtxOn(ptxPath, mesh); });
    });
    dialog->open();
}

void FileActions::save(std::function<void()> then)
{
    if (m_document.path().isEmpty()) {
        saveAs(std::move(then));
    } else {
        saveTo(m_document.path(), std::move(then));
    }
}

void FileActions::saveAs(std::function<void()> then)
{
    const QString start =
        m_document.path().isEmpty()
            ? folderToSaveIn() + "/" + QFileInfo(m_document.title()).completeBaseName()
            : m_document.path();
    QFileDialog* dialog = makeFileDialog(m_window, tr("Save As"), QFileInfo(start).absolutePath());
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilter(tr("Projects (*.trixel)"));
    dialog->setDefaultSuffix("trixel");
    dialog->selectFile(QFileInfo(withEnding(start, ".trixel")).fileName());
    connect(dialog,
            &QFileDialog::fileSelected,
            this,
            [this, then = std::move(then)](const QString& path) { saveTo(path, then); });
    dialog->open();
}

void FileActions::saveTo(const QString& path, std::function<void()> then)
{
    if (then) {
        connect(
            &m_files,
            &ProjectFiles::saveEnded,
            this,
            [then = std::move(then)](bool done) {
                if (done) {
                    then();
                }
            },
            Qt::SingleShotConnection);
    }
    m_files.save(withEnding(path, ".trixel"));
}

void FileActions::withoutLoss(std::function<void()> then)
{
    m_document.endStroke();
    if (m_files.isSaving()) {
        // What is being written may turn out to be all there is to save.
        connect(
            &m_files,
            &ProjectFiles::saveEnded,
            this,
            [this, then = std::move(then)] { withoutLoss(then); },
            Qt::SingleShotConnection);
        return;
    }
    if (!m_document.isModified()) {
        then();
        return;
    }
    auto* box = new QMessageBox(QMessageBox::Warning,
                                tr("Unsaved Changes"),
                                tr("Save the changes to %1?").arg(m_document.title()),
                                QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel,
                                &m_window);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setInformativeText(tr("They are lost otherwise."));
    box->setDefaultButton(QMessageBox::Save);
    box->button(QMessageBox::Discard)->setText(tr("&Don’t Save"));
    connect(box, &QMessageBox::buttonClicked, this, [this, box, then](QAbstractButton* button) {
        switch (box->standardButton(button)) {
        case QMessageBox::Save:
            save(then);
            break;
        case QMessageBox::Discard:
            then();
            break;
        default:
            break;
        }
    });
    box->open();
}

void FileActions::tellOfMesh(const QString& path)
{
    m_messages.showMessage(MessageBar::Kind::Note,
                           tr("%1: %2 faces, %3 texels, uint8 RGB.")
                               .arg(QFileInfo(path).fileName(),
                                    countText(m_document.texels().faceCount()),
                                    countText(m_document.texels().texelCount())),
                           {tr("&Change…"), [this, path] { askForNew(path); }});
}

} // namespace trixel::ui
