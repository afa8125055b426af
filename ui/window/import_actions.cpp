// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/import_actions.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QUndoStack>

#include "ui/document/document.h"
#include "ui/import/import_panel.h"
#include "ui/import/import_words.h"
#include "ui/viewport/viewport.h"
#include "ui/window/actions.h"
#include "ui/window/message_bar.h"

namespace trixel::ui {

namespace {

constexpr int kHeight = 620;

} // namespace

ImportActions::ImportActions(const Workspace& work, const PanelFrames& frames, QObject* parent)
    : QObject(parent)
    , m_work(work)
    , m_panel(
          new ImportPanel(work.document, work.selection, work.jobs, work.viewport, work.settings))
{
    m_dock = frames.beside("importPanel", tr("Import"), m_panel, {Qt::SHIFT | Qt::Key_F9});
    // One place for all panels but the brush, a tab each.
    if (auto* shared = work.window.findChild<QDockWidget*>("readoutPanel")) {
        work.window.tabifyDockWidget(shared, m_dock);
        shared->raise();
    }
    m_dock->hide();
    m_import = ActionMaker(work.window)(tr("Impor&t Image…"),
                                        tr("Lay a picture onto the faces, by uvs, round a sphere, "
                                           "from a plane or from the view"),
                                        QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O));
    connect(m_import, &QAction::triggered, this, [this] { begin({}); });
    connect(m_panel, &ImportPanel::finished, m_dock, [this] {
        m_dock->hide();
        m_work.viewport.setFocus();
    });
    connect(m_panel, &ImportPanel::failed, &work.messages, &MessageBar::showError);
    connect(m_panel, &ImportPanel::applied, this, [this](const QString& sentence) {
        m_work.messages.showMessage(MessageBar::Kind::Note,
                                    sentence,
                                    {tr("&Undo"), [this] { m_work.document.undoStack().undo(); }});
    });
    connect(&work.document, &Document::opened, this, &ImportActions::enable);
    enable();
}

void ImportActions::fillMenu(QMenu& menu)
{
    menu.addAction(m_import);
}

void ImportActions::enable()
{
    m_import->setEnabled(m_work.document.isOpen());
}

bool ImportActions::takeDropped(const QStringList& paths)
{
    if (paths.isEmpty() || !isImageName(paths.constFirst())) {
        return false;
    }
    if (m_work.document.isOpen()) {
        begin(paths.constFirst());
    } else {
        m_work.messages.showError(tr("Open a mesh before an image is laid onto it."));
    }
    return true;
}

void ImportActions::begin(const QString& path)
{
    if (m_dock->isHidden()) {
        m_dock->show();
        // There is more to choose than in the other panels beside it.
        m_work.window.resizeDocks({m_dock}, {kHeight}, Qt::Vertical);
    }
    m_dock->raise();
    m_panel->begin(path);
}

} // namespace trixel::ui
