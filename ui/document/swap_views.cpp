// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/swap_views.h"

#include <utility>

namespace trixel::ui {

SwapViews::SwapViews(Document& document, SceneViews next, StateId state, const QString& text)
    : DocumentStep(state, text)
    , m_document(document)
    , m_views(std::move(next))
{
}

void SwapViews::undo()
{
    m_document.swapViews(m_views);
}

void SwapViews::redo()
{
    m_document.swapViews(m_views);
}

} // namespace trixel::ui
