// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/pending_stroke.h"

#include <utility>

namespace trixel::ui {

PendingStroke::PendingStroke(Document& document, StateId state, const QString& text)
    : DocumentStep(state, text)
    , m_document(document)
{
}

void PendingStroke::undo()
{
    if (m_patch) {
        m_document.swapPatch(*m_patch);
        m_applied = false;
        return;
    }
    setObsolete(true);
    if (!m_isVoid) {
        m_document.takeBackPending();
    }
}

void PendingStroke::redo()
{
    if (!std::exchange(m_applied, true)) {
        m_document.swapPatch(*m_patch);
    }
}

} // namespace trixel::ui
