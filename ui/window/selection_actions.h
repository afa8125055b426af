// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <vector>

class QAction;
class QLabel;
class QMenu;
class QWidget;

namespace trixel::ui {

class Document;
class FaceSelection;

/// Edit > Select: all faces, none, the others, their neighbours too; and how many there are.
class SelectionActions : public QObject
{
    Q_OBJECT

public:
    SelectionActions(Document& document, FaceSelection& selection, QWidget& window);

    void fillMenu(QMenu& menu);
    /// Says how many faces are selected; hidden while none is. Belongs to the caller.
    QLabel* makeLabel();

private:
    void enable();

    Document& m_document;
    FaceSelection& m_selection;
    QAction* m_all;
    QAction* m_none;
    QAction* m_invert;
    QAction* m_grow;
};

} // namespace trixel::ui
