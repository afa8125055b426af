// SPDX-License-Identifier: GPL-3.0-or-later
//
// The chosen faces: their outline, and choosing them with the pointer.

#include "ui/document/run_within_memory.h"
#include "ui/viewport/viewport_private.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <memory>
#include <utility>

namespace trixel::ui {

namespace {

/// An outline of no more faces is made at once.
constexpr std::size_t kFacesAtOnce = 8192;
constexpr double kStep = 2.0; // device pixels between the places that a drag looks at
constexpr int kMostSteps = 500;

} // namespace

void Viewport::useSelection(FaceSelection& selection)
{
    d->selection = &selection;
    connect(&selection, &FaceSelection::changed, this, [this] { d->takeSelection(); });
    connect(&d->outlineWatcher, &QFutureWatcherBase::finished, this, [this] { d->outlineReady(); });
    d->takeSelection();
}

void Viewport::Private::takeSelection()
{
    const std::shared_ptr<const Surface>& surface = document.surface();
    const std::span<const FaceId> faces = selection->faces();
    const std::shared_ptr<const LimitMesh> limit = showsLimit() ? limitView.mesh() : nullptr;
    const bool isBusy = outlineWatcher.isRunning();
    outlineIsStale = isBusy;
    if (!surface || faces.size() <= kFacesAtOnce) {
        selectionLines = surface ? selectionOutline(*surface, faces, limit.get())
                                 : std::vector<render::Polyline>();
        redraw();
    } else if (!isBusy) {
        outlineWatcher.setFuture(runWithinMemory([surface, limit, chosen = selection->snapshot()] {
            return selectionOutline(*surface, *chosen, limit.get());
        }));
    }
}

void Viewport::Private::outlineReady()
{
    if (std::exchange(outlineIsStale, false)) {
        takeSelection();
        return;
    }
    selectionLines = madeOf(outlineWatcher.future()).value_or(std::vector<render::Polyline>());
    redraw();
}

/// Without a modifier the face under the pointer takes the selection's place.
void Viewport::Private::beginSelecting(const PointerEvent& event)
{
    if (selection == nullptr) {
        return;
    }
    interaction = Interaction::Select;
    selectionBefore = selection->snapshot();
    selectRemoves = event.modifiers.testFlag(Qt::ControlModifier);
    selectedTo = event.sample.position;
    if (!selectRemoves && !event.modifiers.testFlag(Qt::ShiftModifier)) {
        const auto point = hit(event.sample.position);
        selection->set(point ? std::vector{point->face} : std::vector<FaceId>());
        return;
    }
    selectTo(event.sample.position);
}

/// Everything on the way: a quick drag leaves no gaps.
void Viewport::Private::selectTo(glm::dvec2 position)
{
    const glm::dvec2 from = std::exchange(selectedTo, position);
    const double length = glm::length(position - from);
    const int steps = static_cast<int>(std::clamp(length / kStep, 1.0, double{kMostSteps}));
    std::vector<FaceId> met;
    for (int k = 1; k <= steps; ++k) {
        const auto point = hit(from + (position - from) * (double(k) / steps));
        if (point && (met.empty() || met.back() != point->face)) {
            met.push_back(point->face);
        }
    }
    if (selectRemoves) {
        selection->remove(std::move(met));
    } else {
        selection->add(std::move(met));
    }
}

} // namespace trixel::ui
