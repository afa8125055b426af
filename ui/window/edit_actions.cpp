// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/edit_actions.h"

#include <QMenu>

#include "ui/document/document.h"
#include "ui/viewport/view_settings.h"
#include "ui/window/actions.h"

namespace trixel::ui {

EditActions::EditActions(Document& document, const ViewSettings& settings, QWidget& window)
    : QObject(&window)
    , m_document(document)
    , m_settings(settings)
{
    ActionMaker make(window);
    m_undo = make(
        tr("&Undo"), tr("Take back the last step"), QKeySequence(Qt::CTRL | Qt::Key_Z), "undo");
    m_redo = make(tr("&Redo"),
                  tr("Do again what was taken back"),
                  QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z),
                  "redo");
    m_redo->setShortcuts(
        {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    m_fillAll = make(tr("&Fill All Faces"),
                     tr("Give every face the brush's colour"),
                     QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_G));

    QUndoStack& stack = document.undoStack();
    connect(m_undo, &QAction::triggered, &stack, &QUndoStack::undo);
    connect(m_redo, &QAction::triggered, &stack, &QUndoStack::redo);
    connect(m_fillAll, &QAction::triggered, this, &EditActions::fillAll);
    connect(&stack, &QUndoStack::indexChanged, this, &EditActions::enable);
    connect(&document, &Document::opened, this, &EditActions::enable);
    enable();
}

void EditActions::enable()
{
    const QUndoStack& stack = m_document.undoStack();
    m_undo->setEnabled(stack.canUndo());
    m_redo->setEnabled(stack.canRedo());
    m_undo->setText(stack.canUndo() ? tr("&Undo %1").arg(stack.undoText()) : tr("&Undo"));
    m_redo->setText(stack.canRedo() ? tr("&Redo %1").arg(stack.redoText()) : tr("&Redo"));
    m_fillAll->setEnabled(m_document.isOpen());
}

void EditActions::fillMenu(QMenu& menu)
{
    menu.addAction(m_undo);
    menu.addAction(m_redo);
    menu.addSeparator();
    menu.addAction(m_fillAll);
}

void EditActions::fillAll()
{
    std::vector<FaceId> faces(m_document.texels().faceCount());
    for (std::size_t k = 0; k < faces.size(); ++k) {
        faces[k] = faceId(k);
    }
    m_document.fillFaces(faces, m_settings.brush().color);
}

} // namespace trixel::ui
