// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/swap_creases.h"

namespace trixel::ui {

namespace {

constexpr int kStepId = 1; // of this kind of step alone

} // namespace

SwapCreases::SwapCreases(
    Document& document, CreaseAngle next, bool goesOn, StateId state, const QString& text)
    : DocumentStep(state, text)
    , m_document(document)
    , m_angle(next)
    , m_goesOn(goesOn)
{
}

void SwapCreases::undo()
{
    m_document.swapCreases(m_angle);
}

void SwapCreases::redo()
{
    m_document.swapCreases(m_angle);
}

int SwapCreases::id() const
{
    return kStepId;
}

/// The next one has been done: what it holds is what this one left.
bool SwapCreases::mergeWith(const QUndoCommand* next)
{
    const auto* following = static_cast<const SwapCreases*>(next); // of the same id
    if (!following->m_goesOn) {
        return false;
    }
    setText(following->text());
    setState(following->state());
    return true;
}

} // namespace trixel::ui
