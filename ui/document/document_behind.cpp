// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a document paints on another thread. Until the last texel is there the change counts as one
// in progress: the texels' state keeps its name, so that nothing made from them in the meantime is
// taken for more than it is, and edits to come wait in line.
#include "ui/document/behind_stroke.h"
#include "ui/document/document.h"
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
    return m_behind && m_behind->hasEnded();
}

void Document::whenSettled(std::function<void()> work)
{
    if (isSettling() || !m_later.empty()) {
        m_later.push_back({false, std::move(work)});
    } else {
        work();
    }
}

void Document::startBehind(const Brush& brush)
{
    watch(std::make_unique<BehindStroke>(
        m_project.surface, m_project.texels, brush, m_fill, m_strokeThread));
}

void Document::watch(std::unique_ptr<BehindStroke> work)
{
    m_behind = std::move(work);
    connect(m_behind.get(),
            &BehindStroke::advanced,
            this,
            [this](const TexelStore& texels, const std::vector<TouchedRect>& touched) {
                m_project.texels = texels;
                if (!touched.empty()) {
                    emit changed({touched});
                }
            });
    connect(m_behind.get(), &BehindStroke::finished, this, &Document::settle);
}

void Document::endBehind()
{
    if (!m_behind || isSettling()) {
        return;
    }
    if (m_behind->isEmpty()) {
        dropBehind();
        return;
    }
    m_behind->end();
    pushPending(m_strokeErases ? tr("Erase stroke") : tr("Brush stroke"));
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
    m_project.texels = hidden->before();
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
    m_texelsBeforePending = state().texels;
    m_pending = &command;
    m_project.texels = work->told();
    const std::vector<TouchedRect> touched = work->touched();
    watch(std::move(work));
    if (!touched.empty()) {
        emit changed({touched});
    }
}

void Document::settle(TexelPatch& applied)
{
    m_behind.release()->deleteLater(); // it is telling this
    PendingStroke* command = std::exchange(m_pending, nullptr);
    if (command == nullptr) {
        push(std::move(applied), tr("Brush stroke"));
    } else if (!applied.isEmpty()) {
        command->settle(std::move(applied));
    } else {
        command->makeVoid();
        if (m_undo.command(m_undo.index() - 1) == command) {
            m_undo.undo(); // which removes it
        }
    }
    emit settled(true);
    announceModified();
    doLater();
}

void Document::doLater()
{
    while (!m_later.empty() && !isSettling()) {
        const Later next = std::move(m_later.front());
        m_later.erase(m_later.begin());
        next.work();
    }
    if (m_kept && !isSettling()) {
        play(*std::exchange(m_kept, {}));
    }
}

void Document::play(const KeptStroke& kept)
{
    start(kept.brush, kept.pace, kept.limit);
    for (const std::optional<StrokeSample>& sample : kept.samples) {
        if (sample) {
            extend(*sample);
        } else {
            liftStroke();
        }
    }
}

void Document::pushPending(const QString& text)
{
    const StateId now = state();
    m_texelsBeforePending = now.texels;
    auto command = std::make_unique<PendingStroke>(*this, StateId{++m_lastState, now.views}, text);
    m_pending = command.get();
    m_undo.push(command.release()); // the stack owns it
    announceModified();
}

/// An undo while something is settling takes back what was done last: what waits, if anything does.
/// \return  what was settling, if that was taken back
std::unique_ptr<BehindStroke> Document::takeBackPending()
{
    const auto last = std::ranges::find_if(m_later.rbegin(), m_later.rend(), &Later::isEdit);
    const bool keepsSettling = m_kept || last != m_later.rend();
    if (!keepsSettling) {
        return hideBehind();
    }
    if (m_kept) {
        m_kept.reset();
    } else {
        m_later.erase(std::next(last).base());
    }
    // The command that is being undone goes; another takes its place.
    const QString text = m_pending->text();
    m_pending = nullptr;
    QMetaObject::invokeMethod(
        this,
        [this, text] {
            if (isSettling() && m_pending == nullptr) {
                pushPending(text);
            }
        },
        Qt::QueuedConnection);
    return nullptr;
}

} // namespace trixel::ui
