// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QUndoCommand>

#include "ui/document/document.h"

namespace trixel::ui {

/// Undo command of any change of the document: it knows the state that it leads to.
class DocumentStep : public QUndoCommand
{
public:
    DocumentStep(StateId state, const QString& text)
        : QUndoCommand(text)
        , m_state(state)
    {
    }

    StateId state() const { return m_state; }

protected:
    /// Another, of a step that became one with this.
    void setState(StateId state) { m_state = state; }

private:
    StateId m_state;
};

} // namespace trixel::ui
