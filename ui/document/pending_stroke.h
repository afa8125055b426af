// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/document/document_step.h"
#include "ui/document/layer_paint.h"

#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace trixel::ui {

class BehindStroke;

/// Undo command of a change that is still being made on another thread when it is pushed, or waits
/// for one that is. Undone before it is there the first is made all the same, out of sight, and the
/// other is kept as it was asked for: to be redone at any time.
class PendingStroke : public DocumentStep
{
public:
    PendingStroke(Document& document, StateId state, const QString& text);

    /// The change is in the texels. \param applied  what it replaced
    void settle(LayerPatch applied) { m_patch = std::move(applied); }
    /// The change came to nothing: undone, the command goes without a trace.
    void makeVoid() { m_isVoid = true; }

    ~PendingStroke() override;

    void undo() override;
    void redo() override;

private:
    void settleUndone(LayerPatch& applied);

    Document& m_document;
    std::optional<LayerPatch> m_patch;        ///< none while it is being made
    std::unique_ptr<BehindStroke> m_unwanted; ///< what makes it while it is undone
    std::function<void()> m_waiting;          ///< what was to be done, while it is undone
    bool m_applied = true;
    bool m_isVoid = false;
};

} // namespace trixel::ui
