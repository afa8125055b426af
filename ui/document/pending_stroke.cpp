// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/pending_stroke.h"

#include "ui/document/behind_stroke.h"

#include <utility>

namespace trixel::ui {

PendingStroke::PendingStroke(Document& document, StateId state, const QString& text)
    : DocumentStep(state, text)
    , m_document(document)
{
}

PendingStroke::~PendingStroke() = default;

void PendingStroke::undo()
{
    if (m_patch) {
        m_document.swapPatch(*m_patch);
        m_applied = false;
        return;
    }
    if (m_isVoid) {
        setObsolete(true);
        return;
    }
    m_applied = false;
    m_document.cancelStroke(); // as with any other step
    m_waiting = m_document.takeBackWaiting(*this);
    if (m_waiting) {
        return;
    }
    m_unwanted = m_document.hideBehind();
    QObject::connect(m_unwanted.get(),
                     &BehindStroke::finished,
                     m_unwanted.get(),
                     [this](LayerPatch& applied) { settleUndone(applied); });
}

/// Keeps what it comes to, in the place of what it replaced.
void PendingStroke::settleUndone(LayerPatch& applied)
{
    Layered after = m_unwanted->told();
    m_unwanted.release()->deleteLater(); // it is telling this
    if (applied.texels.isEmpty()) {
        makeVoid();
        return;
    }
    applied.texels.swap(paintedTexels(after.layers, applied.layer, after.shown));
    settle(std::move(applied));
}

void PendingStroke::redo()
{
    if (std::exchange(m_applied, true)) {
        return; // pushed
    }
    if (m_patch) {
        m_document.swapPatch(*m_patch);
    } else if (m_unwanted) {
        m_unwanted->disconnect();
        m_document.resumePending(std::move(m_unwanted), *this);
    } else if (m_waiting) {
        m_document.waitAgain(*this, std::exchange(m_waiting, {}));
    }
    setObsolete(m_isVoid); // it came to nothing
}

} // namespace trixel::ui
