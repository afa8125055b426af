// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/inspect_actions.h"

#include <QApplication>
#include <QClipboard>
#include <QMenu>

#include "ui/docks/readout_panel.h"
#include "ui/document/document.h"
#include "ui/document/inspection.h"
#include "ui/viewport/viewport.h"
#include "ui/window/actions.h"

namespace trixel::ui {

InspectActions::InspectActions(const Document& document,
                               Inspection& inspection,
                               Viewport& viewport,
                               ReadoutPanel& readout,
                               QWidget& window)
    : QObject(&window)
    , m_document(document)
    , m_inspection(inspection)
    , m_readout(readout)
{
    ActionMaker make(window);
    m_goTo = make(tr("&Go to Texel…"),
                  tr("Hold and look at a face or texel by its address"),
                  QKeySequence(Qt::CTRL | Qt::Key_G));
    m_hold = make.toggle(tr("Hol&d Texel"),
                         tr("Keep looking at this texel when the pointer goes elsewhere"),
                         {Qt::Key_H});
    connect(m_goTo, &QAction::triggered, &viewport, &Viewport::askForTexel);
    connect(m_hold, &QAction::triggered, this, [this](bool wanted) {
        wanted ? m_inspection.hold() : m_inspection.letGo();
        follow();
    });
    makeCopies(window);
    connect(&inspection, &Inspection::changed, this, &InspectActions::follow);
    connect(&inspection, &Inspection::heldChanged, this, &InspectActions::follow);
    connect(&document, &Document::opened, this, &InspectActions::follow);
    follow();
}

void InspectActions::makeCopies(QWidget& window)
{
    ActionMaker make(window);
    QAction* text = make(tr("As &Text"),
                         tr("Copy the lines of the readout"),
                         QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_C));
    QAction* hex = make(tr("As &Hex"),
                        tr("Copy the texel's bytes as they are stored, in hex"),
                        QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_H));
    QAction* json = make(tr("As &JSON"),
                         tr("Copy every property of the texel as JSON"),
                         QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_J));
    m_copies = {text, hex, json};
    connect(text, &QAction::triggered, this, [this] {
        copy(m_readout.text(), tr("Copied the readout as text"));
    });
    connect(hex, &QAction::triggered, this, [this] {
        if (const auto& texel = m_readout.texel(); texel && !texel->report.stored.empty()) {
            copy(QString::fromStdString(toHex(texel->report)), tr("Copied the texel's bytes"));
        }
    });
    connect(json, &QAction::triggered, this, [this] {
        if (const auto& texel = m_readout.texel()) {
            copy(QString::fromStdString(toJson(texel->report)), tr("Copied the texel as JSON"));
        }
    });
    m_readout.setCopyActions(m_copies);
}

void InspectActions::copy(const QString& text, const QString& sentence)
{
    QApplication::clipboard()->setText(text);
    emit copied(sentence);
}

void InspectActions::follow()
{
    const bool hasTexel = m_inspection.texel().has_value();
    m_goTo->setEnabled(m_document.isOpen());
    m_hold->setEnabled(hasTexel);
    m_hold->setChecked(m_inspection.isHeld());
    for (QAction* action : m_copies) {
        action->setEnabled(hasTexel);
    }
}

void InspectActions::fillViewMenu(QMenu& menu)
{
    menu.addAction(m_goTo);
    menu.addAction(m_hold);
}

void InspectActions::fillEditMenu(QMenu& menu)
{
    menu.addMenu(tr("Cop&y Texel"))->addActions(m_copies);
}

} // namespace trixel::ui
