// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/selection_actions.h"

#include <QLabel>
#include <QMenu>

#include "ui/dialogs/format_choice.h"
#include "ui/document/document.h"
#include "ui/document/face_selection.h"
#include "ui/window/actions.h"

namespace trixel::ui {

SelectionActions::SelectionActions(Document& document, FaceSelection& selection, QWidget& window)
    : QObject(&window)
    , m_document(document)
    , m_selection(selection)
{
    ActionMaker make(window);
    m_all = make(tr("Select &All"), tr("Select every face"), QKeySequence(Qt::CTRL | Qt::Key_A));
    m_none = make(
        tr("Select &None"), tr("Select no face"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_A));
    m_invert = make(tr("&Invert Selection"),
                    tr("Select the faces that are not selected, and no others"),
                    QKeySequence(Qt::CTRL | Qt::Key_I));
    m_grow = make(tr("&Grow Selection"),
                  tr("Select the faces next to those selected, too"),
                  QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_I));
    connect(m_all, &QAction::triggered, &selection, &FaceSelection::selectAll);
    connect(m_none, &QAction::triggered, &selection, &FaceSelection::clear);
    connect(m_invert, &QAction::triggered, &selection, &FaceSelection::invert);
    connect(m_grow, &QAction::triggered, &selection, &FaceSelection::grow);
    connect(&selection, &FaceSelection::changed, this, &SelectionActions::enable);
    connect(&document, &Document::opened, this, &SelectionActions::enable);
    enable();
}

void SelectionActions::enable()
{
    m_all->setEnabled(m_document.isOpen());
    m_invert->setEnabled(m_document.isOpen());
    m_none->setEnabled(!m_selection.isEmpty());
    m_grow->setEnabled(!m_selection.isEmpty());
}

void SelectionActions::fillMenu(QMenu& menu)
{
    menu.addAction(m_all);
    menu.addAction(m_none);
    menu.addAction(m_invert);
    menu.addAction(m_grow);
}

QLabel* SelectionActions::makeLabel()
{
    auto* label = new QLabel;
    label->setAccessibleName(tr("Selected faces"));
    label->setToolTip(tr("How many faces are selected"));
    const auto show = [this, label] {
        label->setText(tr("%1 selected").arg(countText(m_selection.faces().size())));
        label->setVisible(!m_selection.isEmpty());
    };
    connect(&m_selection, &FaceSelection::changed, label, show);
    show();
    return label;
}

} // namespace trixel::ui
