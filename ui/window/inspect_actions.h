// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

class QAction;
class QMenu;
class QWidget;

namespace trixel::ui {

class Document;
class Inspection;
class ReadoutPanel;
class Viewport;

/// Commands about the texel looked at: go to one, hold it, copy what the readout says of it.
class InspectActions : public QObject
{
    Q_OBJECT

public:
    InspectActions(const Document& document,
                   Inspection& inspection,
                   Viewport& viewport,
                   ReadoutPanel& readout,
                   QWidget& window);

    /// Go to and hold.
    void fillViewMenu(QMenu& menu);
    /// Copy, as text, hex bytes or JSON.
    void fillEditMenu(QMenu& menu);

signals:
    /// One sentence for the status bar.
    void copied(const QString& sentence);

private:
    void makeCopies(QWidget& window);
    void copy(const QString& text, const QString& sentence);
    void follow();

    const Document& m_document;
    Inspection& m_inspection;
    ReadoutPanel& m_readout;
    QAction* m_goTo;
    QAction* m_hold;
    QList<QAction*> m_copies;
};

} // namespace trixel::ui
