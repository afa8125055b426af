// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the card needs to filter texels in other ways than one by one.
#include <QElapsedTimer>
#include <QThread>
#include <QTimer>

#include "render/filtering_study.h"
#include "ui/document/run_within_memory.h"
#include "ui/viewport/viewport_private.h"

#include <algorithm>
#include <utility>

namespace trixel::ui {

namespace {

constexpr std::size_t kSliceBytes = 512U << 10U;
constexpr int kLookAgainMs = 15; ///< for what is being made in the background

} // namespace

/// The ways of filtering of A and B.
std::vector<render::Filtering> Viewport::Private::filteringsShown() const
{
    std::vector<render::Filtering> shown{shownView.filtering};
    if (comparison.by == ComparedBy::Filtering) {
        shown.push_back(comparison.filtering);
    }
    return shown;
}

/// Levels or neighbours may be others: what was made for filtering is of no use.
void Viewport::Private::forgetFilterMesh()
{
    filterMesh.reset();
    filterMeshDirty = true;
    ++filterMeshNumber;
    redraw();
}

/// Levels are chosen by the sizes of what is seen: the cage's, or its limit surface's.
void Viewport::Private::takeFilteredLimit()
{
    const std::shared_ptr<const LimitMesh> limit = showsLimit() ? limitView.solid() : nullptr;
    if (std::exchange(filteredLimit, limit) != limit) {
        forgetFilterMesh();
    }
}

void Viewport::Private::makeFilterMesh()
{
    if (std::exchange(isMakingFilterMesh, true)) {
        return;
    }
    filterWatcher.setFuture(
        runWithinMemory([surface = shownSurface, store = texels(), limit = filteredLimit] {
            return std::shared_ptr<const render::FilterMesh>(
                std::make_shared<render::FilterMesh>(surface->mesh(),
                                                     surface->adjacency(),
                                                     store,
                                                     limit ? &limit->tessellation() : nullptr));
        }));
    filterMeshMade = filterMeshNumber;
}

/// Also where one waited for it and the watcher tells again.
void Viewport::Private::filterMeshReady()
{
    if (!std::exchange(isMakingFilterMesh, false)) {
        return;
    }
    const auto made = madeOf(filterWatcher.future());
    if (!made) {
        emit q.notice(
            tr("There is not enough memory for this way of filtering: texels are shown."));
    } else if (filterMeshMade == filterMeshNumber) {
        filterMesh = *made;
        filterMeshDirty = true;
    }
    redraw();
}

/// Which ways of filtering are shown, and what all of them need of the mesh; vertices are streamed
/// as texels are.
void Viewport::Private::prepareFilters()
{
    const std::vector<render::Filtering> shown = filteringsShown();
    const auto shows = [&](render::FilterSource source) {
        return std::ranges::find(shown, source, render::sourceOf) != shown.end();
    };
    renderer->wantFilterings(shown);
    streaming.showTexels(std::ranges::any_of(shown, render::readsTexels));
    if (!shows(render::FilterSource::Vertices) && !shows(render::FilterSource::Atlas)) {
        return;
    }
    if (!filterMesh && (isMakingFilterMesh || filterMeshMade != filterMeshNumber)) {
        makeFilterMesh(); // else there was no memory for it
    }
    if (filterMeshDirty) {
        filterMeshDirty = false;
        renderer->setFilterMesh(filterMesh);
        streaming.setFilterMesh(filterMesh);
    }
}

/// As `sendTexels`, of the atlas; the context is current.
void Viewport::Private::sendAtlas(double milliseconds)
{
    if (!shownSurface || !filterMesh) {
        return;
    }
    bool hasMore = sendAtlas(texels(), render::Side::A, milliseconds);
    if (hasOtherTexels()) {
        hasMore = sendAtlas(otherSideTexels(), render::Side::B, milliseconds) || hasMore;
    }
    if (renderer->takeAtlasFailure()) {
        emit q.notice(tr("There is not enough memory for a packed atlas: texels are shown."));
    }
    if (hasMore) {
        QTimer::singleShot(kLookAgainMs, &q, [this] { redraw(); });
    }
}

bool Viewport::Private::sendAtlas(const TexelStore& store, render::Side side, double milliseconds)
{
    QElapsedTimer clock;
    clock.start();
    while (renderer->hasAtlasWork(side) && renderer->uploadAtlas(store, kSliceBytes, side) > 0 &&
           (milliseconds <= 0 || clock.nsecsElapsed() < static_cast<qint64>(milliseconds * 1e6))) {
    }
    return renderer->hasAtlasWork(side);
}

/// Waits until ways of filtering have what they need; the context is current.
void Viewport::Private::waitForFilterMesh()
{
    if (!shownSurface) {
        return;
    }
    prepareFilters();
    while (isMakingFilterMesh) { // again where levels changed meanwhile
        filterWatcher.waitForFinished();
        filterMeshReady();
        prepareFilters();
    }
}

void Viewport::Private::finishAtlas()
{
    while (filterMesh && shownSurface &&
           (sendAtlas(texels(), render::Side::A, 0) ||
            (hasOtherTexels() && sendAtlas(otherSideTexels(), render::Side::B, 0)))) {
        QThread::msleep(1);
    }
}

} // namespace trixel::ui
