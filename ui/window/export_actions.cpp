// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/export_actions.h"

#include <QAction>
#include <QFileInfo>
#include <QMenu>

#include "ui/dialogs/export_dialog.h"
#include "ui/dialogs/format_choice.h"
#include "ui/document/document.h"
#include "ui/document/face_selection.h"
#include "ui/document/project_files.h"
#include "ui/window/actions.h"
#include "ui/window/last_folder.h"
#include "ui/window/message_bar.h"

namespace trixel::ui {

namespace {

/// "Exported a.glb: 1.2 MB …"
QString sentenceOf(const ExportOutcome& outcome)
{
    QStringList names;
    for (const std::filesystem::path& file : outcome.files) {
        names.push_back(QString::fromStdString(file.filename().string()));
    }
    constexpr qsizetype kMostNames = 4;
    QString files = names.mid(0, kMostNames).join(", ");
    if (names.size() > kMostNames) {
        files = ExportActions::tr("%1 and %2 more").arg(files).arg(names.size() - kMostNames);
    }
    QString told = ExportActions::tr("Exported %1: %2, read again and found equal.")
                       .arg(files, sizeText(outcome.bytes));
    if (outcome.facesLost > 0) {
        told += ExportActions::tr(" %1 faces are too small there to hold a pixel.")
                    .arg(countText(outcome.facesLost));
    }
    return outcome.largestJump
               ? told + ExportActions::tr(" Largest jump across an edge: %1 of 255.")
                            .arg(255 * *outcome.largestJump, 0, 'f', 2)
               : told;
}

} // namespace

ExportActions::ExportActions(Document& document,
                             FaceSelection& selection,
                             ProjectFiles& files,
                             MessageBar& messages,
                             QWidget& window)
    : QObject(&window)
    , m_document(document)
    , m_selection(selection)
    , m_files(files)
    , m_messages(messages)
    , m_window(window)
{
    ActionMaker make(m_window);
    m_export = make(tr("&Export…"),
                    tr("Write a .ptx for renderers, an atlas for shaders, or a mesh with uvs"),
                    QKeySequence(Qt::CTRL | Qt::Key_E),
                    "export");
    m_again = make(tr("Export A&gain"),
                   tr("Repeat the last export as it was, to the same files"),
                   QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_E));
    connect(m_export, &QAction::triggered, this, &ExportActions::ask);
    connect(m_again, &QAction::triggered, this, &ExportActions::repeat);
    connect(&m_document, &Document::opened, this, [this] {
        m_latest.reset(); // it was of another project
        enable();
    });
    connect(&m_files,
            &ProjectFiles::exported,
            this,
            [this](const QString& /*path*/, const ExportOutcome& outcome) { tell(outcome); });
    enable();
}

void ExportActions::fillMenu(QMenu& menu)
{
    menu.addAction(m_export);
    menu.addAction(m_again);
}

void ExportActions::enable()
{
    m_export->setEnabled(m_document.isOpen());
    m_again->setEnabled(m_document.isOpen() && m_latest);
}

void ExportActions::ask()
{
    const auto faces = m_selection.faces();
    auto* dialog = new ExportDialog(
        {m_document.snapshot(), {faces.begin(), faces.end()}, m_latest}, proposedPath(), &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &ExportDialog::exportWanted, this, [this](const ExportRequest& request) {
        m_latest = request;
        enable();
        m_files.exportAs(request);
    });
    dialog->open();
}

void ExportActions::repeat()
{
    if (const auto layer = m_latest->part.layer; layer && !m_document.layers().has(*layer)) {
        m_messages.showMessage(
            MessageBar::Kind::Error,
            tr("The layer that was exported last is no longer there: choose what to export."),
            {tr("E&xport…"), [this] { ask(); }});
        return;
    }
    m_files.exportAs(*m_latest);
}

void ExportActions::tell(const ExportOutcome& outcome)
{
    m_messages.showMessage(MessageBar::Kind::Note, sentenceOf(outcome));
}

/// Where the last export of this document went, else beside its file.
QString ExportActions::proposedPath() const
{
    if (m_latest) {
        return QString::fromStdString(m_latest->path.string());
    }
    const QFileInfo file(m_document.path().isEmpty() ? folderToSaveIn() + "/" + m_document.title()
                                                     : m_document.path());
    return file.absolutePath() + "/" + file.completeBaseName() + ".ptx";
}

} // namespace trixel::ui
