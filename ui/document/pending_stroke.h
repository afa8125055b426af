// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/texture/texel_patch.h"
#include "ui/document/document_step.h"

#include <optional>
#include <utility>

namespace trixel::ui {

/// Undo command of a change that is still being made on another thread when it is pushed. Undone
/// before it is there the change is dropped, and the command with it.
class PendingStroke : public DocumentStep
{
public:
    PendingStroke(Document& document, StateId state, const QString& text);

    /// The change is in the texels. \param applied  what it replaced
    void settle(TexelPatch applied) { m_patch = std::move(applied); }
    /// The change came to nothing: undone, the command goes without a trace.
    void makeVoid() { m_isVoid = true; }

    void undo() override;
    void redo() override;

private:
    Document& m_document;
    std::optional<TexelPatch> m_patch; ///< none while it is being made
    bool m_applied = true;
    bool m_isVoid = false;
};

} // namespace trixel::ui
