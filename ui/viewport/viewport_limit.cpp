// SPDX-License-Identifier: GPL-3.0-or-later
//
// The limit surface in the cage's place: asked for, sent to the card, pointed at.
#include "ui/viewport/viewport_private.h"

#include <utility>

namespace trixel::ui {

namespace {

/// Sent with one frame: a few milliseconds' worth.
constexpr std::size_t kBytesAFrame = 8U << 20U;

} // namespace

QString Viewport::limitSurfaceRefusal() const
{
    return d->limitView.refusal();
}

std::shared_ptr<const LimitMesh> Viewport::seenLimit() const
{
    return d->showsLimit() ? d->limitView.mesh() : nullptr;
}

void Viewport::useJobs(BackgroundJobs& jobs)
{
    d->limitView.useJobs(jobs);
}

void Viewport::askForCreases()
{
    if (!d->shownSurface || !limitSurfaceRefusal().isEmpty()) {
        return;
    }
    ViewOptions view = d->settings.view();
    view.limitSurface = true;
    d->settings.setView(view);
    if (!d->creases) {
        d->creases = new CreaseBar(*this, d->document);
    }
    d->creases->ask();
}

void Viewport::Private::watchLimit()
{
    QObject::connect(&document, &Document::creasesChanged, &q, [this] {
        limitView.setCreases(document.creaseAngle());
        redraw();
    });
    QObject::connect(&limitView, &LimitView::cancelled, &q, [this] {
        ViewOptions view = settings.view();
        view.limitSurface = false;
        settings.setView(view);
    });
    QObject::connect(&limitView, &LimitView::tessellated, &q, [this] {
        limitDirty = true;
        redraw();
    });
    QObject::connect(&limitView, &LimitView::meshChanged, &q, [this] {
        if (interaction == Interaction::None) {
            refreshHover();
        }
        if (selection) {
            takeSelection();
        }
        takeFilteredLimit();
        redraw();
        emit q.seenSurfaceChanged();
    });
    QObject::connect(
        &limitView, &LimitView::refusalChanged, &q, &Viewport::limitSurfaceRefusalChanged);
}

/// Whether the limit surface is shown, and so what pointing and painting mean.
bool Viewport::Private::showsLimit() const
{
    return shownSurface && shownView.limitSurface && limitView.mesh();
}

SeenSurface Viewport::Private::seen() const
{
    return SeenSurface(*shownSurface, showsLimit() ? limitView.mesh().get() : nullptr);
}

void Viewport::Private::takeLimit()
{
    if (!shownView.limitSurface) {
        limitView.rest();
    }
}

/// What this frame's camera needs, and what came of what earlier ones needed; the context is
/// current. \param bytes  to send at most
void Viewport::Private::sendLimit(std::size_t bytes)
{
    if (shownView.limitSurface && shownSurface) {
        limitView.want(camera, shownView.limitError);
    }
    if (std::exchange(limitDirty, false)) {
        renderer->limit().set(limitView.tessellation());
    }
    if (renderer->limit().send(bytes)) {
        QMetaObject::invokeMethod(
            &q, [this] { redraw(); }, Qt::QueuedConnection);
    }
}

void Viewport::Private::sendLimit()
{
    sendLimit(kBytesAFrame);
}

void Viewport::Private::settleLimit()
{
    if (shownView.limitSurface && shownSurface) {
        limitView.want(camera, shownView.limitError);
        limitView.finish();
    }
}

} // namespace trixel::ui
