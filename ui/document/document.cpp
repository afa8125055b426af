// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/document.h"

#include <QFileInfo>

#include "core/base/check.h"
#include "core/io/new_project.h"
#include "core/study/views/project_views.h"
#include "ui/document/behind_stroke.h"
#include "ui/document/layer_composer.h"
#include "ui/document/layer_paint.h"
#include "ui/document/pending_stroke.h"
#include "ui/document/released_elsewhere.h"
#include "ui/document/stored_faces_watch.h"
#include "ui/document/swap_creases.h"
#include "ui/document/swap_patch.h"
#include "ui/document/swap_store.h"
#include "ui/document/swap_views.h"
#include "ui/document/view_bookmarks.h"

#include <algorithm>
#include <utility>

namespace trixel::ui {

namespace {

/// Whether the patch that was swapped gave a face another level.
bool changedLevels(const TexelPatch& patch, const TexelStore& texels)
{
    return std::ranges::any_of(patch.wholeFaces(), [&](const TexelPatch::Whole& whole) {
        return whole.texels.level() != texels.face(whole.face).level();
    });
}

/// Where painting begins in a project that was opened.
LayerId topLayer(const LayerStack& layers)
{
    return layers.isPlain() ? kBaseLayer : layers.layers().back().id;
}

} // namespace

Document::Document(QObject* parent)
    : QObject(parent)
    , m_bookmarks(new ViewBookmarks(*this))
    , m_storedFaces(new StoredFacesWatch(*this))
{
    connect(m_storedFaces, &StoredFacesWatch::damaged, this, &Document::notice);
    connect(&m_undo, &QUndoStack::indexChanged, this, &Document::announceModified);
    m_strokeThread.setMaxThreadCount(1);
    m_composer = std::make_unique<LayerComposer>();
    connect(m_composer.get(),
            &LayerComposer::composed,
            this,
            [this](const TexelStore& shown, const std::optional<Change>& change) {
                m_project.texels = shown;
                if (change) {
                    emit changed(*change);
                }
            });
    connect(m_composer.get(), &LayerComposer::finished, this, &Document::layersComposed);
    connect(m_composer.get(), &LayerComposer::failed, this, &Document::takeBackLayers);
}

Document::~Document()
{
    // The stack dies after this object's signals do; nobody is to hear of it.
    m_undo.disconnect(this);
}

void Document::useJobs(BackgroundJobs& jobs)
{
    m_composer->useJobs(jobs);
}

void Document::open(Project project, const QString& path, const QString& title)
{
    m_stroke.reset();
    m_kept.reset();
    m_composer->drop();
    for (const Later& later : std::exchange(m_later, {})) {
        if (later.command == nullptr) {
            later.work(); // somebody waits for its end
        }
    }
    dropBehind();
    m_pending = nullptr;
    // Until nobody who is told below shares its texels any more.
    const auto before =
        releasedElsewhere(std::make_unique<Project>(std::exchange(m_project, std::move(project))));
    m_fill = fillOf(m_project);
    m_activeLayer = topLayer(m_project.layers);
    m_path = path;
    m_title = title;
    ++m_lastState;
    m_openedState = {m_lastState, m_lastState};
    m_savedState = m_openedState;
    m_undo.clear();
    m_storedFaces->begin();
    const Result<SceneViews> views = viewsOf(m_project);
    m_bookmarks->take(views.value_or(SceneViews()));
    emit opened();
    emit layersChanged();
    emit activeLayerChanged();
    emit titleChanged();
    announceModified();
    if (!views) {
        emit notice(tr("The bookmarked views of %1 cannot be read and are left out: %2.")
                        .arg(this->title(), QString::fromStdString(views.error().message)));
    }
}

QString Document::title() const
{
    return m_path.isEmpty() ? m_title : QFileInfo(m_path).fileName();
}

StateId Document::state() const
{
    const QUndoCommand* last = m_undo.command(m_undo.index() - 1);
    const auto* step = dynamic_cast<const DocumentStep*>(last);
    StateId state = step != nullptr ? step->state() : m_openedState;
    if (hasUnsettled()) {
        state.texels = m_texelsBeforePending; // until the next one's last texel is there
    }
    return state;
}

void Document::markSaved(const QString& path, StateId saved)
{
    m_savedState = saved;
    if (std::exchange(m_path, path) != path) {
        emit titleChanged();
    }
    announceModified();
}

void Document::announceModified()
{
    const bool modified = isModified();
    if (std::exchange(m_announcedModified, modified) != modified) {
        emit modifiedChanged(modified);
    }
}

void Document::releaseHeldTexels()
{
    if (!hasStroke()) {
        releaseHeld(m_project.layers, m_project.texels);
        emit heldTexelsReleased(); // copies keep what is held alive
    }
}

/// Ends a stroke in progress; complains where the texels are others than those the change is for.
bool Document::mayReplace(StateId madeFor, const QString& text)
{
    endStroke();
    if (!isOpen() || isSettling() || state().texels != madeFor.texels) {
        emit notice(tr("%1: the texture has changed meanwhile, nothing was done.").arg(text));
        return false;
    }
    return true;
}

bool Document::replaceTexels(TexelStore texels, StateId madeFor, const QString& text)
{
    if (!mayReplace(madeFor, text)) {
        return false;
    }
    check(layers().isPlain() && texels.faceCount() == m_project.texels.faceCount() &&
              texels.format() == m_project.texels.format(),
          "texels of the same faces and format, without layers");
    exchange(texels);
    const StateId next{++m_lastState, state().views};
    m_undo.push(new SwapStore(*this, std::move(texels), next, text)); // the stack owns it
    return true;
}

bool Document::applyPatch(TexelPatch patch, StateId madeFor, const QString& text)
{
    if (!mayReplace(madeFor, text)) {
        return false;
    }
    check(layers().isPlain(), "texels without layers");
    if (!patch.isEmpty()) {
        LayerPatch applied{kBaseLayer, std::move(patch)};
        exchange(applied);
        push(std::move(applied), text);
    }
    return true;
}

void Document::push(LayerPatch applied, const QString& text)
{
    if (m_waited != nullptr) {
        complete(*std::exchange(m_waited, nullptr), std::move(applied));
    } else if (!applied.texels.isEmpty()) {
        const StateId next{++m_lastState, state().views};
        m_undo.push(new SwapPatch(*this, std::move(applied), next, text)); // the stack owns it
    }
}

void Document::swapPatch(LayerPatch& patch)
{
    // A patch fits the state it was made on, which a stroke in progress has left.
    cancelStroke();
    exchange(patch);
}

void Document::swapStore(TexelStore& texels)
{
    cancelStroke();
    exchange(texels);
}

void Document::exchange(TexelStore& texels)
{
    std::swap(m_project.texels, texels);
    emit changed({});
    emit levelsChanged(); // which of them have is not asked
}

void Document::swapViews(SceneViews& views)
{
    cancelStroke();
    SceneViews before = m_bookmarks->views();
    keepViews(m_project, views);
    m_bookmarks->take(std::exchange(views, std::move(before)));
}

void Document::pushViews(SceneViews next, const QString& text)
{
    endStroke();
    m_undo.push(new SwapViews(*this, std::move(next), withOtherViews(), text)); // the stack owns it
}

/// The next state, of the same texels.
StateId Document::withOtherViews()
{
    // Those of the step below, even if its last texel is not there yet.
    const auto* last = dynamic_cast<const DocumentStep*>(m_undo.command(m_undo.index() - 1));
    return {last != nullptr ? last->state().texels : state().texels, ++m_lastState};
}

void Document::setCreaseAngle(CreaseAngle angle, bool goesOn)
{
    check(!angle || (*angle >= 0 && *angle <= 180), "an angle between two directions");
    if (!isOpen() || angle == creaseAngle()) {
        return;
    }
    endStroke();
    const QString text =
        angle ? tr("Creases from %1°").arg(double{*angle}) : tr("No creases by angle");
    m_undo.push(new SwapCreases(*this, angle, goesOn, withOtherViews(), text)); // the stack owns it
}

void Document::swapCreases(CreaseAngle& angle)
{
    cancelStroke();
    std::swap(m_project.creaseAngle, angle);
    emit creasesChanged();
}

void Document::exchange(LayerPatch& patch)
{
    TexelStore& texels = painted(patch.layer);
    patch.texels.swap(texels);
    if (changedLevels(patch.texels, texels)) {
        emit changed({}); // what derives from a face may reach into its neighbours
        emit levelsChanged();
    } else if (m_composer->isRunning()) {
        compose({}); // again, of other paint
    } else {
        std::vector<TouchedRect> rects = rectsOf(patch.texels, texels);
        rects = showPaint(layers(), std::move(rects), m_project.texels);
        emit changed(changeOf(std::move(rects), m_project.texels));
    }
}

} // namespace trixel::ui
