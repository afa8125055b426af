// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/swap_patch.h"

#include <utility>

namespace trixel::ui {

SwapPatch::SwapPatch(Document& document, LayerPatch applied, StateId state, const QString& text)
    : DocumentStep(state, text)
    , m_document(document)
    , m_patch(std::move(applied))
{
}

void SwapPatch::undo()
{
    m_document.swapPatch(m_patch);
    m_applied = false;
}

void SwapPatch::redo()
{
    if (!std::exchange(m_applied, true)) {
        m_document.swapPatch(m_patch);
    }
}

} // namespace trixel::ui
