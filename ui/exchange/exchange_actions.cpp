// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/exchange/exchange_actions.h"

#include <QAction>
#include <QDockWidget>
#include <QFileInfo>
#include <QMainWindow>
#include <QMenu>

#include "ui/document/document.h"
#include "ui/document/face_selection.h"
#include "ui/exchange/compare_dialog.h"
#include "ui/exchange/difference_panel.h"
#include "ui/exchange/paint_transfer.h"
#include "ui/exchange/transfer_dialog.h"
#include "ui/viewport/view_map.h"
#include "ui/viewport/view_settings.h"
#include "ui/viewport/viewport.h"
#include "ui/window/actions.h"
#include "ui/window/last_folder.h"
#include "ui/window/message_bar.h"
#include "ui/window/panel_frames.h"

namespace trixel::ui {

ExchangeActions::ExchangeActions(const Workspace& work, const PanelFrames& frames, QObject* parent)
    : QObject(parent)
    , m_work(work)
{
    ActionMaker make(m_work.window);
    m_compare = make(tr("Compare…"),
                     tr("Compare the texels with those of another file, face by face"),
                     QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_D));
    connect(m_compare, &QAction::triggered, this, &ExchangeActions::askToCompare);
    m_transferFrom = make(tr("Transfer Paint &from…"),
                          tr("Bring paint over from another mesh, whatever its faces"));
    connect(m_transferFrom, &QAction::triggered, this, &ExchangeActions::askToTransfer);
    makeDifferences(frames);
    makeTransfer();
    connect(&m_work.document, &Document::opened, this, &ExchangeActions::enable);
    enable();
}

void ExchangeActions::fillMenu(QMenu& menu)
{
    menu.addAction(m_transferFrom);
    menu.addAction(m_compare);
}

void ExchangeActions::enable()
{
    m_compare->setEnabled(m_work.document.isOpen());
    m_transferFrom->setEnabled(m_work.document.isOpen());
}

/// Out of the way until wanted.
void ExchangeActions::makeDifferences(const PanelFrames& frames)
{
    m_differences = new DifferencePanel(m_work.document, m_work.jobs);
    m_differenceDock =
        frames.beside("differencePanel", tr("Difference"), m_differences, {Qt::SHIFT | Qt::Key_F6});
    // A tab more beside the view; the first of them stays in front.
    auto* first = m_work.window.findChild<QDockWidget*>("readoutPanel");
    auto* last = m_work.window.findChild<QDockWidget*>("fitPanel");
    check(first != nullptr && last != nullptr, "the panels beside the view are there");
    m_work.window.tabifyDockWidget(last, m_differenceDock);
    m_differenceDock->hide();
    first->raise();
    connect(m_differences, &DifferencePanel::chooseWanted, this, &ExchangeActions::askToCompare);
    connect(m_differences, &DifferencePanel::failed, &m_work.messages, &MessageBar::showError);
    connect(m_differences,
            &DifferencePanel::compared,
            this,
            [this](const std::shared_ptr<const FileComparison>& comparison) {
                FaceDifferences differences;
                if (comparison) { // the map keeps the comparison alive
                    differences = {{comparison, &comparison->rms},
                                   QFileInfo(comparison->path).fileName().toStdString()};
                }
                m_work.viewMap.setFaceDifferences(std::move(differences));
            });
    connect(m_differences, &DifferencePanel::faceChosen, this, [this](FaceId face) {
        m_work.selection.set({face});
        m_work.viewport.frameFace(face);
    });
    connect(m_differences, &DifferencePanel::facesChosen, &m_work.selection, &FaceSelection::set);
}

void ExchangeActions::askToCompare()
{
    auto* dialog =
        new CompareDialog(m_work.document.snapshot(), m_differences->path(), &m_work.window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &CompareDialog::compareWanted, this, [this](const QString& path, bool matches) {
        rememberFolderOf(path);
        m_differenceDock->show();
        m_differenceDock->raise();
        ViewOptions view = m_work.settings.view();
        view.map = ViewMapKind::Difference;
        m_work.settings.setView(view);
        m_differences->compare(path, matches);
    });
    dialog->open();
}

void ExchangeActions::makeTransfer()
{
    m_transfer = new PaintTransfer(m_work.document, m_work.jobs, this);
    connect(m_transfer, &PaintTransfer::failed, &m_work.messages, &MessageBar::showError);
    connect(m_transfer, &PaintTransfer::transferred, this, [this](const QString& sentence) {
        m_work.messages.showMessage(MessageBar::Kind::Note,
                                    sentence,
                                    {tr("&Undo"), [this] { m_work.document.undoStack().undo(); }});
    });
}

void ExchangeActions::askToTransfer()
{
    const auto selected = m_work.selection.faces();
    auto* dialog = new TransferDialog({m_work.document.snapshot(),
                                       {selected.begin(), selected.end()},
                                       m_work.document.fillTexel()},
                                      m_transferPath,
                                      &m_work.window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog,
            &TransferDialog::transferWanted,
            this,
            [this](const std::shared_ptr<const Project>& from,
                   const QString& path,
                   const TransferOptions& options) {
                m_transferPath = path;
                rememberFolderOf(path);
                m_transfer->begin(from, path, options);
            });
    dialog->open();
}

} // namespace trixel::ui
