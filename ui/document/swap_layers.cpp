// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/swap_layers.h"

#include "ui/document/layer_paint.h"
#include "ui/document/released_elsewhere.h"

#include <utility>

namespace trixel::ui {

namespace {

constexpr int kStepId = 2; // of this kind of step alone

} // namespace

SwapLayers::SwapLayers(
    Document& document, LayersState next, Kind kind, StateId state, const QString& text)
    : DocumentStep(state, text)
    , m_document(document)
    , m_other(releasedElsewhere(std::make_unique<LayersState>(std::move(next))))
    , m_kind(kind)
{
    QObject::connect(&document, &Document::heldTexelsReleased, &m_watch, [this] {
        if (m_other->shown) {
            releaseHeld(m_other->layers, *m_other->shown);
        } else {
            m_other->layers.texels(kBaseLayer).releaseHeld();
        }
    });
}

void SwapLayers::undo()
{
    m_document.swapLayers(*m_other, m_kind.changesLevels);
}

void SwapLayers::redo()
{
    m_document.swapLayers(*m_other, m_kind.changesLevels);
}

int SwapLayers::id() const
{
    return kStepId;
}

/// The next one has been done: what it holds is what this one left.
bool SwapLayers::mergeWith(const QUndoCommand* next)
{
    const auto* following = static_cast<const SwapLayers*>(next); // of the same id
    if (!following->m_kind.goesOn || !m_kind.set || m_kind.set != following->m_kind.set) {
        return false;
    }
    setText(following->text());
    setState(following->state());
    return true;
}

} // namespace trixel::ui
