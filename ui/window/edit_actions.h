// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QAction;
class QMenu;
class QWidget;

namespace trixel::ui {

class Document;
class ViewSettings;

/// The Edit menu: undo, redo, fill everything.
class EditActions : public QObject
{
    Q_OBJECT

public:
    EditActions(Document& document, const ViewSettings& settings, QWidget& window);

    void fillMenu(QMenu& menu);
    QAction* undoAction() const { return m_undo; }
    QAction* redoAction() const { return m_redo; }

private:
    void enable();
    void fillAll();

    Document& m_document;
    const ViewSettings& m_settings;
    QAction* m_undo;
    QAction* m_redo;
    QAction* m_fillAll;
};

} // namespace trixel::ui
