// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a document paints on another thread. Until the last texel is there the change counts as one
// in progress: the texels' state keeps its name, so that nothing made from them in the meantime is
// taken for more than it is, and edits to come wait in line.
#include "ui/document/behind_stroke.h"
#include "ui/document/document.h"
#include "ui/document/layer_composer.h"
#include "ui/document/pending_stroke.h"

#include <algorithm>
#include <utility>

namespace trixel::ui {

bool Document::isTakingSamples() const
{
    return m_stroke.has_value() || m_kept.has_value() || (m_behind && !m_behind->hasEnded());
}

bool Document::isSettling() const
{
    return isPaintSettling() || m_composer->isRunning();
}

bool Document::isPaintSettling() const
{
    return m_behind && m_behind->hasEnded();
}

void Document::whenSettled(std::function<void()> work)
{
    if (isSettling() || !m_later.empty()) {
        m_later.push_back({nullptr, std::move(work)});
    } else {
        work();
    }
}

void Document::whenPainted(std::function<void()> work)
{
    if (isPaintSettling() || !m_later.empty()) {
        m_later.push_back({nullptr, std::move(work)});
    } else {
        work();
    }
}

void Document::watch(std::unique_ptr<BehindStroke> work)
{
    m_behind = std::move(work);
    connect(m_behind.get(),
            &BehindStroke::advanced,
            this,
            [this](const Layered& all, const std::vector<TouchedRect>& touched) {
                m_project.texels = all.shown;
                m_project.layers = all.layers;
                if (!touched.empty()) {
                    emit changed({touched});
                }
            });
    connect(m_behind.get(), &BehindStroke::finished, this, &Document::settle);
}

void Document::endBehind()
{
    if (!m_behind || m_behind->hasEnded()) {
        return;
    }
    if (m_behind->isEmpty()) {
        dropBehind();
        return;
    }
    m_behind->end();
    beginPending(strokeText(m_brush));
    tellColor(m_brush);
}

/// Nothing of it stays; what waited for it goes on.
void Document::dropBehind()
{
    if (m_behind) {
        hideBehind().release()->deleteLater(); // it may be telling something
    }
}

/// The same, but what it was painted by may go on out of sight.
std::unique_ptr<BehindStroke> Document::hideBehind()
{
    const std::vector<TouchedRect> touched = m_behind->touched();
    std::unique_ptr<BehindStroke> hidden = std::move(m_behind);
    hidden->disconnect(this);
    m_project.texels = hidden->before().shown;
    m_project.layers = hidden->before().layers;
    m_pending = nullptr;
    emit settled(false);
    if (!touched.empty()) {
        emit changed({touched});
    }
    doLater();
    return hidden;
}

/// What was undone while it settled is wanted again before it is done.
void Document::resumePending(std::unique_ptr<BehindStroke> work, PendingStroke& command)
{
    cancelStroke();
    if (!hasUnsettled()) {
        m_texelsBeforePending = state().texels;
    }
    m_composer->drop(); // it has all of it
    m_pending = &command;
    m_project.texels = work->told().shown;
    m_project.layers = work->told().layers;
    const std::vector<TouchedRect> touched = work->touched();
    watch(std::move(work));
    if (!touched.empty()) {
        emit changed({touched});
    }
}

void Document::settle(LayerPatch& applied)
{
    m_behind.release()->deleteLater(); // it is telling this
    PendingStroke* command = std::exchange(m_pending, nullptr);
    if (command == nullptr) {
        push(std::move(applied), strokeText(m_brush));
    } else {
        complete(*command, std::move(applied));
    }
    emit settled(true);
    announceModified();
    doLater();
}

/// A command of what was painted later than asked for has what it was to have.
void Document::complete(PendingStroke& command, LayerPatch applied)
{
    if (!applied.texels.isEmpty()) {
        command.settle(std::move(applied));
        m_texelsBeforePending = command.state().texels;
        return;
    }
    command.makeVoid();
    if (m_undo.command(m_undo.index() - 1) == &command) {
        m_undo.undo(); // which removes it
    }
}

void Document::doLater()
{
    if (m_waited != nullptr) {
        return; // one after the other
    }
    while (!m_later.empty() && !isSettling()) {
        const Later next = std::move(m_later.front());
        m_later.erase(m_later.begin());
        if (next.command != nullptr) {
            doWaiting(*next.command, next.work);
            announceModified();
        } else {
            next.work();
        }
    }
    if (m_kept && !isSettling()) {
        play(*std::exchange(m_kept, {}));
    }
}

void Document::play(const KeptStroke& kept)
{
    start(kept);
    for (const std::optional<StrokeSample>& sample : kept.samples) {
        if (sample) {
            extend(*sample);
        } else {
            liftStroke();
        }
    }
}

// What is done later than asked for has its command on the stack all the time: undone and redone in
// its place, whether it waits, is being painted or is there.

bool Document::hasUnsettled() const
{
    return m_pending != nullptr || m_waited != nullptr || m_composer->isRunning() ||
           std::ranges::any_of(m_later, [](const Later& one) { return one.command != nullptr; });
}

PendingStroke* Document::pushPending(const QString& text)
{
    const StateId now = state();
    if (!hasUnsettled()) {
        m_texelsBeforePending = now.texels;
    }
    auto* command = new PendingStroke(*this, StateId{++m_lastState, now.views}, text);
    m_undo.push(command); // the stack owns it
    return command;
}

/// For what has begun to settle.
void Document::beginPending(const QString& text)
{
    m_pending = m_waited != nullptr ? std::exchange(m_waited, nullptr) : pushPending(text);
    announceModified();
}

void Document::wait(const QString& text, std::function<void()> work)
{
    m_later.push_back({pushPending(text), std::move(work)});
    announceModified();
}

/// Redone: behind what waits by now, or at once.
void Document::waitAgain(PendingStroke& command, std::function<void()> work)
{
    cancelStroke();
    if (isSettling() || !m_later.empty()) {
        m_later.push_back({&command, std::move(work)});
        return;
    }
    m_texelsBeforePending = state().texels;
    doWaiting(command, work);
}

void Document::doWaiting(PendingStroke& command, const std::function<void()>& work)
{
    m_waited = &command;
    work();
    if (std::exchange(m_waited, nullptr) != nullptr) {
        complete(command, {}); // it came to nothing
    }
}

/// \return  what it would have done, if it waits
std::function<void()> Document::takeBackWaiting(PendingStroke& command)
{
    const auto at = std::ranges::find(m_later, &command, &Later::command);
    if (at == m_later.end()) {
        return {};
    }
    std::function<void()> work = std::move(at->work);
    m_later.erase(at);
    return work;
}

} // namespace trixel::ui
