// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/document/document_step.h"

namespace trixel::ui {

/// Undo command of another crease angle: undo and redo are the same exchange.
class SwapCreases : public DocumentStep
{
public:
    /// \param next    to come; the redo of the push puts it in place
    /// \param goesOn  whether it becomes one step with the one before, if that is of this kind
    SwapCreases(
        Document& document, CreaseAngle next, bool goesOn, StateId state, const QString& text);

    void undo() override;
    void redo() override;
    int id() const override;
    bool mergeWith(const QUndoCommand* next) override;

private:
    Document& m_document;
    CreaseAngle m_angle; ///< that the document does not have
    bool m_goesOn;
};

} // namespace trixel::ui
