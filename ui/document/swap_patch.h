// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/document/document_step.h"
#include "ui/document/layer_paint.h"

namespace trixel::ui {

/// Undo command of any change of texels of a layer: undo and redo are the same exchange of a patch.
class SwapPatch : public DocumentStep
{
public:
    /// \param applied  what a change already made replaced; the redo of the push does nothing
    /// \param state    the name of the document's state after the change
    SwapPatch(Document& document, LayerPatch applied, StateId state, const QString& text);

    void undo() override;
    void redo() override;

private:
    Document& m_document;
    LayerPatch m_patch;
    bool m_applied = true;
};

} // namespace trixel::ui
