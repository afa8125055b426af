// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/document.h"

#include <QFileInfo>

#include "core/base/check.h"
#include "core/io/new_project.h"
#include "core/study/views/project_views.h"
#include "ui/document/behind_stroke.h"
#include "ui/document/pending_stroke.h"
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

std::vector<std::byte> encodeTexel(const TexelFormat& format, const std::array<float, 4>& color)
{
    std::vector<float> values(format.channels);
    for (std::size_t k = 0; k < values.size(); ++k) {
        values[k] = color[std::min<std::size_t>(k, color.size() - 1)];
    }
    std::vector<std::byte> texel(format.texelBytes());
    encode(format.type, values, texel);
    return texel;
}

/// Faces that take longer to fill than the window may be held up: about 4 ms.
constexpr std::size_t kFacesBehind = 20'000;

/// Whether the patch that was swapped gave a face another level.
bool changedLevels(const TexelPatch& patch, const TexelStore& texels)
{
    return std::ranges::any_of(patch.wholeFaces(), [&](const TexelPatch::Whole& whole) {
        return whole.texels.level() != texels.face(whole.face).level();
    });
}

/// Whole faces; nothing (everything may differ) when the patch covers the mesh.
Change changeOf(const TexelPatch& patch, const TexelStore& texels)
{
    Change change;
    if (patch.faces().size() == texels.faceCount()) {
        return change;
    }
    change.rects.reserve(patch.faces().size());
    for (const FaceId face : patch.faces()) {
        const auto size = static_cast<std::uint16_t>(texels.face(face).level().resolution());
        change.rects.push_back({face, 0, 0, size, size, true});
    }
    return change;
}

/// Where painting begins in a project that was opened.
LayerId topLayer(const LayerStack& layers)
{
    return layers.isPlain() ? kBaseLayer : layers.layers().back().id;
}

QString strokeText(bool erases)
{
    return erases ? Document::tr("Erase stroke") : Document::tr("Brush stroke");
}

QString fillText(std::size_t faces)
{
    return faces == 1 ? Document::tr("Fill face")
                      : Document::tr("Fill %n faces", nullptr, static_cast<int>(faces));
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
}

Document::~Document()
{
    // The stack dies after this object's signals do; nobody is to hear of it.
    m_undo.disconnect(this);
}

void Document::open(Project project, const QString& path, const QString& title)
{
    m_stroke.reset();
    m_kept.reset();
    for (const Later& later : std::exchange(m_later, {})) {
        if (later.command == nullptr) {
            later.work(); // somebody waits for its end
        }
    }
    dropBehind();
    m_pending = nullptr;
    m_project = std::move(project);
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
        m_project.texels.releaseHeld();
        emit heldTexelsReleased(); // copies keep what is held alive
    }
}

void Document::beginStroke(const Brush& brush,
                           StrokePace pace,
                           std::shared_ptr<const LimitMesh> limit)
{
    if (!isOpen()) {
        return;
    }
    endStroke();
    if (const Status valid = validate(brush); !valid) {
        emit notice(QString::fromStdString(valid.error().message));
        return;
    }
    if (isSettling()) {
        m_kept = KeptStroke{brush, pace, std::move(limit), {}};
    } else {
        start(brush, pace, std::move(limit));
    }
}

void Document::start(const Brush& brush, StrokePace pace, std::shared_ptr<const LimitMesh> limit)
{
    m_brush = brush;
    m_strokeErases = brush.blend == BlendMode::Erase;
    if (pace == StrokePace::Behind && !limit) {
        startBehind(brush);
    } else {
        m_stroke.emplace(m_project.surface, brush, m_fill, Threads::all(), std::move(limit));
    }
}

void Document::extendStroke(const StrokeSample& sample)
{
    if (m_kept) {
        m_kept->samples.emplace_back(sample);
    } else {
        extend(sample);
    }
}

void Document::extend(const StrokeSample& sample)
{
    if (m_behind && !isSettling()) {
        const std::vector<PlacedDab> dabs = m_behind->add(sample);
        if (!dabs.empty()) {
            emit dabsPlaced(m_brush, dabs);
        }
    }
    if (!m_stroke) {
        return;
    }
    Change change{m_stroke->add(sample, m_project.texels)};
    if (!change.rects.empty()) {
        emit changed(change);
    }
}

void Document::liftStroke()
{
    if (m_kept) {
        m_kept->samples.emplace_back();
    } else if (m_behind && !isSettling()) {
        m_behind->lift();
    } else if (m_stroke) {
        m_stroke->lift();
    }
}

void Document::endStroke()
{
    if (m_kept) {
        const KeptStroke kept = *std::exchange(m_kept, {});
        wait(strokeText(kept.brush.blend == BlendMode::Erase), [this, kept] {
            play(kept);
            finish();
        });
    } else {
        finish();
    }
}

void Document::finish()
{
    endBehind();
    if (!m_stroke) {
        return;
    }
    TexelPatch patch = m_stroke->finish(m_project.texels);
    m_stroke.reset();
    push(std::move(patch), strokeText(m_strokeErases));
}

void Document::cancelStroke()
{
    m_kept.reset();
    if (m_behind && !isSettling()) {
        dropBehind();
    }
    if (!m_stroke) {
        return;
    }
    TexelPatch patch = m_stroke->finish(m_project.texels);
    m_stroke.reset();
    if (!patch.isEmpty()) {
        swapPatch(patch);
    }
}

void Document::fillFaces(std::span<const FaceId> faces, const std::array<float, 4>& color)
{
    if (!isOpen() || faces.empty()) {
        return;
    }
    endStroke();
    std::vector<FaceId> chosen(faces.begin(), faces.end());
    if (isSettling()) {
        const QString text = fillText(chosen.size());
        wait(text, [this, chosen = std::move(chosen), color] { fill(chosen, color); });
    } else {
        fill(chosen, color);
    }
}

void Document::fill(const std::vector<FaceId>& faces, const std::array<float, 4>& color)
{
    const std::vector<std::byte> texel = encodeTexel(m_project.texels.format(), color);
    const QString text = fillText(faces.size());
    if (faces.size() >= kFacesBehind) {
        watch(std::make_unique<BehindStroke>(m_project.texels, faces, texel, m_strokeThread));
        beginPending(text);
        emit fillPlaced(faces, color);
        return;
    }
    TexelPatch patch = trixel::fillFaces(m_project.texels, faces, texel);
    if (patch.isEmpty()) {
        return;
    }
    emit changed(changeOf(patch, m_project.texels));
    push(std::move(patch), text);
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
    check(texels.faceCount() == m_project.texels.faceCount() &&
              texels.format() == m_project.texels.format(),
          "texels of the same faces and format");
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
    if (!patch.isEmpty()) {
        exchange(patch);
        push(std::move(patch), text);
    }
    return true;
}

void Document::push(TexelPatch applied, const QString& text)
{
    if (m_waited != nullptr) {
        complete(*std::exchange(m_waited, nullptr), std::move(applied));
    } else if (!applied.isEmpty()) {
        const StateId next{++m_lastState, state().views};
        m_undo.push(new SwapPatch(*this, std::move(applied), next, text)); // the stack owns it
    }
}

void Document::swapPatch(TexelPatch& patch)
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

void Document::exchange(TexelPatch& patch)
{
    patch.swap(m_project.texels);
    if (changedLevels(patch, m_project.texels)) {
        emit changed({}); // what derives from a face may reach into its neighbours
        emit levelsChanged();
    } else {
        emit changed(changeOf(patch, m_project.texels));
    }
}

} // namespace trixel::ui
