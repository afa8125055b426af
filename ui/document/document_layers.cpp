// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a document does with layers other than painting on them. A stack and what it looks like are
// exchanged together. Where the look takes long to work out the stack is there first: the document
// settles until it has both, and a step left before that has to work its look out again.
#include "core/base/check.h"
#include "ui/document/document.h"
#include "ui/document/layer_composer.h"
#include "ui/document/pending_stroke.h"
#include "ui/document/swap_layers.h"

#include <algorithm>
#include <utility>

namespace trixel::ui {

namespace {

/// Where an undone change is looked up face by face, so that only these are drawn anew.
constexpr std::uint32_t kFewFaces = 100'000;

/// How the settings of stacks differ of which one was made from the other.
struct SettingsEdit
{
    bool isAll = true; ///< nothing but settings differs, as far as layers tell
    std::vector<LayerId> set;
    bool isNameOnly = true;
};

SettingsEdit settingsEdit(const LayerStack& before, const LayerStack& after)
{
    SettingsEdit edit;
    edit.isAll = before.layers().size() == after.layers().size();
    for (std::size_t k = 0; k < after.layers().size() && edit.isAll; ++k) {
        const Layer& one = after.layers()[k];
        LayerSettings settings = before.layers()[k].settings;
        edit.isAll = one.id == before.layers()[k].id;
        if (!(one.settings == settings)) {
            edit.set.push_back(one.id);
            settings.name = one.settings.name;
            edit.isNameOnly = edit.isNameOnly && one.settings == settings;
        }
    }
    return edit;
}

} // namespace

void Document::setActiveLayer(LayerId layer)
{
    check(layers().has(layer), "a layer of the stack");
    if (layer == m_activeLayer) {
        return;
    }
    endStroke();
    m_activeLayer = layer;
    emit activeLayerChanged();
}

/// Ends a stroke in progress; complains where one is not yet in the layers that are to be changed.
bool Document::mayEditLayers(const QString& text)
{
    endStroke();
    const bool waits =
        std::ranges::any_of(m_later, [](const Later& one) { return one.command != nullptr; });
    if (isPaintSettling() || m_waited != nullptr || waits) {
        emit notice(tr("%1: the last stroke is still being painted, nothing was done.").arg(text));
        return false;
    }
    return isOpen();
}

bool Document::editLayers(LayerStack next, LayerId active, const QString& text, bool goesOn)
{
    check(next.base().faceCount() == texels().faceCount() && next.has(active),
          "a layer of a stack of the same faces");
    if (!mayEditLayers(text)) {
        return false;
    }
    const SettingsEdit edit = settingsEdit(layers(), next);
    if (goesOn && edit.isAll && edit.set.empty()) {
        return true; // the slider came back to where it was
    }
    const bool looksAlike = edit.isAll && !edit.set.empty() && edit.isNameOnly;
    Result<LayersState> state = stateOf(std::move(next), looksAlike);
    if (!state) {
        emit notice(tr("%1: %2").arg(text, QString::fromStdString(state.error().message)));
        return false;
    }
    state->active = active;
    SwapLayers::Kind kind{std::nullopt, goesOn, false};
    if (edit.isAll && edit.set.size() == 1) {
        kind.set = edit.set.front();
    }
    const StateId id{++m_lastState, this->state().views};
    m_undo.push(new SwapLayers(*this, std::move(*state), kind, id, text)); // the stack owns it
    return true;
}

/// With what the stack looks like, if that is known or quickly worked out.
Result<LayersState> Document::stateOf(LayerStack next, bool looksAlike) const
{
    if (next.isPlain()) {
        TexelStore base = next.base();
        return LayersState{LayerStack(), std::move(base), kBaseLayer};
    }
    LayersState state{std::move(next), std::nullopt, kBaseLayer};
    if (m_composer->isRunning()) {
        return state;
    }
    if (looksAlike) {
        state.shown = m_project.texels;
    } else if (isQuicklyComposed(state.layers)) {
        NoProgress progress;
        const Layered now{m_project.texels, layers()};
        Result<Layered> made = recomposed(state.layers, now, Threads::all(), progress);
        if (!made) {
            return tl::unexpected(made.error());
        }
        state.shown = std::move(made->shown);
    }
    return state;
}

bool Document::replaceLayers(LayersEdit edit, StateId madeFor, const QString& text)
{
    if (!mayReplace(madeFor, text)) {
        return false;
    }
    check(edit.all.shown.faceCount() == texels().faceCount() &&
              edit.all.shown.format() == texels().format() && edit.all.layers.has(edit.active),
          "layers of the same faces and format");
    LayersState state{std::move(edit.all.layers), std::move(edit.all.shown), edit.active};
    const StateId next{++m_lastState, this->state().views};
    const SwapLayers::Kind kind{std::nullopt, false, edit.changesLevels};
    m_undo.push(new SwapLayers(*this, std::move(state), kind, next, text)); // the stack owns it
    return true;
}

void Document::swapLayers(LayersState& state, bool changesLevels)
{
    cancelStroke();
    Layered now{std::move(m_project.texels), std::move(m_project.layers)};
    const bool isKnown = m_composer->isCurrent();
    m_project.layers = std::move(state.layers);
    std::swap(m_activeLayer, state.active);
    std::optional<Change> change;
    if (state.shown) {
        dropComposing();
        m_project.texels = std::move(*state.shown);
        const bool isNamed = !changesLevels && texels().faceCount() <= kFewFaces;
        change = isNamed ? changeBetween(now.shown, texels()) : Change();
    } else {
        m_project.texels = now.shown; // until they are known
        compose(isKnown ? now : Layered());
    }
    state.layers = std::move(now.layers);
    state.shown.reset();
    if (isKnown) {
        state.shown = std::move(now.shown);
    }
    if (change) {
        emit changed(*change);
    }
    if (changesLevels) {
        emit levelsChanged();
    }
    emit layersChanged();
    if (m_activeLayer != state.active) {
        emit activeLayerChanged();
    }
}

/// \param now  what is shown, and the layers it was made of; nothing where they do not agree
void Document::compose(const Layered& now)
{
    if (!hasUnsettled()) {
        m_texelsBeforePending = state().texels;
    }
    m_composer->start(layers(), now);
    announceModified();
}

/// What they look like is known otherwise.
void Document::dropComposing()
{
    if (!m_composer->isCurrent()) {
        m_composer->drop();
        QMetaObject::invokeMethod(this, &Document::layersComposed, Qt::QueuedConnection); // then
    }
}

void Document::layersComposed()
{
    if (isSettling()) {
        return; // again, since
    }
    m_texelsBeforePending = stateBelowWaiting().texels;
    announceModified();
    doLater();
}

/// Of what is there, whatever is still to be done.
StateId Document::stateBelowWaiting() const
{
    int at = m_undo.index();
    const auto waits = [&](const QUndoCommand* command) {
        return std::ranges::any_of(m_later,
                                   [=](const Later& one) { return one.command == command; });
    };
    while (at > 0 && waits(m_undo.command(at - 1))) {
        --at;
    }
    const auto* step = at > 0 ? dynamic_cast<const DocumentStep*>(m_undo.command(at - 1)) : nullptr;
    return step != nullptr ? step->state() : m_openedState;
}

/// These layers cannot be shown, or are not to be: back to the last whose look is known.
void Document::takeBackLayers(const Error& why)
{
    if (why.kind != ErrorKind::Cancelled) {
        emit notice(QString::fromStdString(why.message));
    }
    bool isBack = false;
    while (!isBack && m_undo.canUndo()) {
        const QUndoCommand* last = m_undo.command(m_undo.index() - 1);
        const bool changesLayers = dynamic_cast<const SwapLayers*>(last) != nullptr;
        m_undo.undo();
        isBack = changesLayers && m_composer->isCurrent();
    }
    layersComposed();
}

} // namespace trixel::ui
