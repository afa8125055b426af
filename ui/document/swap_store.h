// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texture/texel_store.h"
#include "ui/document/document_step.h"

namespace trixel::ui {

/// Undo command of a change of so many faces that naming them would take long: undo and redo are
/// the same exchange of the store, which costs the same for any number of faces. The stores share
/// what is alike in them.
class SwapStore : public DocumentStep
{
public:
    /// \param before  the store whose place another has taken; the redo of the push does nothing
    /// \param state   the name of the document's state after the change
    SwapStore(Document& document, TexelStore before, StateId state, const QString& text);

    void undo() override;
    void redo() override;

private:
    Document& m_document;
    TexelStore m_store;
    bool m_applied = true;
};

} // namespace trixel::ui
