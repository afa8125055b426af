// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/swap_layers.h"

#include <utility>

namespace trixel::ui {

namespace {

constexpr int kStepId = 2; // of this kind of step alone

} // namespace

SwapLayers::SwapLayers(
    Document& document, LayersState next, Merging merging, StateId state, const QString& text)
    : DocumentStep(state, text)
    , m_document(document)
    , m_other(std::move(next))
    , m_merging(merging)
{
}

void SwapLayers::undo()
{
    m_document.swapLayers(m_other);
}

void SwapLayers::redo()
{
    m_document.swapLayers(m_other);
}

int SwapLayers::id() const
{
    return kStepId;
}

/// The next one has been done: what it holds is what this one left.
bool SwapLayers::mergeWith(const QUndoCommand* next)
{
    const auto* following = static_cast<const SwapLayers*>(next); // of the same id
    if (!following->m_merging.goesOn || !m_merging.set ||
        m_merging.set != following->m_merging.set) {
        return false;
    }
    setText(following->text());
    setState(following->state());
    return true;
}

} // namespace trixel::ui
