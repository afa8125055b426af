// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/swap_store.h"

#include <utility>

namespace trixel::ui {

SwapStore::SwapStore(Document& document, TexelStore before, StateId state, const QString& text)
    : DocumentStep(state, text)
    , m_document(document)
    , m_store(std::move(before))
{
}

void SwapStore::undo()
{
    m_document.swapStore(m_store);
    m_applied = false;
}

void SwapStore::redo()
{
    if (!std::exchange(m_applied, true)) {
        m_document.swapStore(m_store);
    }
}

} // namespace trixel::ui
