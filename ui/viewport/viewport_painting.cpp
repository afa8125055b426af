// SPDX-License-Identifier: GPL-3.0-or-later
//
// Strokes that the card shows before the texels have them.
#include "ui/viewport/viewport_private.h"

namespace trixel::ui {

void Viewport::Private::watchPainting()
{
    QObject::connect(&document,
                     &Document::dabsPlaced,
                     &q,
                     [this](const Brush& brush, const std::vector<PlacedDab>& dabs) {
                         setOtherTexels(std::nullopt);
                         painting.place(document, brush, dabs);
                         redraw();
                     });
    QObject::connect(&document,
                     &Document::fillPlaced,
                     &q,
                     [this](const std::vector<FaceId>& faces, const std::array<float, 4>& color) {
                         placeFill(faces, color);
                     });
    QObject::connect(&document, &Document::settled, &q, [this](bool isInTexels) {
        painting.settle(document, isInTexels);
        redraw();
    });
}

/// Whether a stroke is shown by the card first; see `CardPainting`.
StrokePace Viewport::Private::paceAt(const Brush& brush, glm::dvec2 position)
{
    const auto point = hit(position);
    // What is drawn on the limit surface lies elsewhere than the texels of the cage.
    if (!point || !canvas || shownView.limitSurface) {
        return StrokePace::AtOnce;
    }
    canvas->makeCurrent();
    const StrokePace pace =
        painting.paceFor(shownView.paintOnCard, brush, point->face, document, renderer.get());
    canvas->doneCurrent();
    if (const QString sentence = painting.takeNotice(); !sentence.isEmpty()) {
        emit q.notice(sentence);
    }
    return pace;
}

void Viewport::Private::placeFill(const std::vector<FaceId>& faces,
                                  const std::array<float, 4>& color)
{
    if (!renderer || shownView.paintOnCard == render::PaintOnCard::Never) {
        return; // it shows when the texels have it
    }
    canvas->makeCurrent();
    const bool isAble = renderer->preview().has_value();
    canvas->doneCurrent();
    if (isAble) {
        setOtherTexels(std::nullopt);
        painting.placeFill(document, faces, color);
        redraw();
    }
}

/// Before texels are sent; the context is current.
void Viewport::Private::drawPreview()
{
    if (!shownSurface) {
        return;
    }
    const std::vector<TouchedRect> rects = painting.draw(*renderer, shownSurface->mesh());
    if (rects.empty()) {
        return;
    }
    streaming.texelsChanged(); // a block made of what they were before would come too late
    if (!texelsDirty) {
        touchTexels({rects}, render::Side::A);
    }
}

/// After they have been sent.
void Viewport::Private::previewDrawn()
{
    painting.drawn(*renderer);
    if (painting.isGivingBack()) {
        QMetaObject::invokeMethod(
            &q, [this] { redraw(); }, Qt::QueuedConnection);
    }
}

} // namespace trixel::ui
