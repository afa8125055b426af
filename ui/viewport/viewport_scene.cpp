// SPDX-License-Identifier: GPL-3.0-or-later
#include <QElapsedTimer>
#include <QLoggingCategory>
#include <QPainter>
#include <QScopedValueRollback>

#include "render/corner_normals.h"
#include "ui/document/run_within_memory.h"
#include "ui/viewport/graphics_probe.h"
#include "ui/viewport/viewport_private.h"

#include <utility>

namespace trixel::ui {

namespace {

/// Ways of filtering go by the levels that faces have.
bool sameLevels(const TexelStore& a, const TexelStore& b)
{
    if (a.faceCount() != b.faceCount()) {
        return false;
    }
    for (std::uint32_t f = 0; f < a.faceCount(); ++f) {
        if (a.face(faceId(f)).level() != b.face(faceId(f)).level()) {
            return false;
        }
    }
    return true;
}

} // namespace

namespace {

Q_LOGGING_CATEGORY(lcViewport, "ui.viewport", QtInfoMsg)

/// Part of a frame that may go into sending texels.
constexpr double kUploadMs = 4.0;

} // namespace

void Viewport::Private::takeSurface()
{
    stroke.cancel();
    stroke.forgetLastPoint();
    interaction = Interaction::None;
    reading.forget();
    painting.forget();
    meshDirty = true;
    texelsDirty = true;
    sharedCorners.reset();
    forgetFilterMesh();
    shownSurface = document.surface();
    streaming.setSurface(shownSurface);
    setOtherTexels(std::nullopt);
    faceColors.clear();
    texelsBefore = document.texels();
    markedEdge.reset();
    pointed.reset(); // of another surface
    if (givenFootprints) {
        givenFootprints->clear(); // of another surface
    }
    hoveredTexel.reset();
    emit q.hovered(std::nullopt);
    if (shownSurface) {
        camera.setScene(shownSurface->low(), shownSurface->high());
        cornersWatcher.setFuture(runWithinMemory([surface = shownSurface]() -> Corners {
            const TriangleMesh& mesh = surface->mesh();
            return std::make_shared<const render::SharedCorners>(
                render::SharedCorners::of(mesh, render::cornerNormals(mesh)));
        }));
    }
    limitView.setSurface(shownSurface, document.creaseAngle());
    showOverlays();
    q.frameAll();
}

/// Of copies that are only shown: what was read for them can be read again.
void Viewport::Private::releaseHeldTexels()
{
    reading.forget();
    texelsBefore.releaseHeld();
    if (otherTexels) {
        otherTexels->releaseHeld();
    }
}

void Viewport::Private::takeChange(const Change& change)
{
    reading.forget();
    streaming.texelsChanged();
    const bool isHeld = painting.hold(change, document.texels());
    if (otherTexels) {
        setOtherTexels(std::nullopt);
    } else if (renderer && !texelsDirty) {
        if (!isHeld) {
            touchTexels(change, render::Side::A);
        }
        if (comparison.by == ComparedBy::Level && !otherSideDirty) {
            touchTexels(change, render::Side::B);
        }
    }
    if (interaction == Interaction::None) {
        refreshHover(); // under a pointer that moves it follows by itself
    }
    redraw();
}

void Viewport::Private::touchTexels(const Change& change, render::Side side)
{
    if (change.rects.empty()) {
        renderer->touchAllTexels(side);
    } else {
        const bool isA = side == render::Side::A;
        renderer->touchTexels(isA ? sentTexels() : document.texels(), change.rects, side);
    }
}

void Viewport::Private::setOtherTexels(std::optional<TexelStore> others)
{
    if (!others && !otherTexels) {
        return;
    }
    const bool hasOtherLevels = !sameLevels(others ? *others : document.texels(), texels());
    otherTexels = std::move(others);
    reading.forget();
    streaming.texelsChanged();
    if (hasOtherLevels) {
        forgetFilterMesh();
    }
    otherSideDirty = true;
    if (renderer && !texelsDirty) {
        renderer->touchAllTexels();
    }
    emit q.otherTexelsShown(otherTexels.has_value());
    redraw();
}

void Viewport::Private::takeView()
{
    if (settings.view().mipDrop != shownView.mipDrop) {
        texelsDirty = true;
        otherSideDirty = true;
        reading.forget();
    }
    shownView = settings.view();
    {
        const QScopedValueRollback itself(pointsItself, true);
        inspection->setLevelsDropped(shownView.mipDrop);
    }
    takeLimit();
    showOverlays();
    refreshHover();
    redraw();
}

void Viewport::Private::takeLook()
{
    if (renderer) {
        renderer->setLook(settings.look());
    }
    redraw();
}

void Viewport::Private::makeCanvas()
{
    const auto format = usableFormat();
    if (!format) {
        explainNoOpenGl({});
        return;
    }
    canvas =
        new Canvas(*format,
                   {[this] { makeRenderer(); }, [this] { renderer.reset(); }, [this] { draw(); }},
                   &q);
    legend = new FootprintLegend(&q);
    hud = new FrameHud(&q);
}

void Viewport::Private::makeRenderer()
{
    auto made = render::Renderer::create();
    if (!made) {
        explainNoOpenGl(QString::fromStdString(made.error().message));
        return;
    }
    renderer = std::move(*made);
    delete std::exchange(message, nullptr); // of an attempt before
    painting.forgetCard();
    renderer->setLook(settings.look());
    meshDirty = true; // and with it all that is shown on it
}

/// One frame; the context is current.
void Viewport::Private::draw()
{
    if (!renderer) {
        return;
    }
    QElapsedTimer clock;
    clock.start();
    fitCamera(); // the window may have come to a screen of another density
    sendMesh();
    sendLimit();
    drawPreview();
    sendTexels(kUploadMs);
    previewDrawn();
    sendAtlas(kUploadMs);
    sendPicture(render::Side::A);
    sendPicture(render::Side::B);
    sendFaceColors();
    renderer->draw(scene());
    render::FrameFigures figures = renderer->figures();
    figures.processorMs = 1e-6 * static_cast<double>(clock.nsecsElapsed());
    hud->take(figures);
    if (!shownSurface) {
        paintHint();
    }
}

void Viewport::Private::redraw()
{
    if (canvas) {
        canvas->update(); // several of these make one frame
    }
}

void Viewport::Private::fitCamera()
{
    const double ratio = q.devicePixelRatioF();
    const glm::ivec2 before = camera.viewport();
    camera.setViewport(qRound(q.width() * ratio), qRound(q.height() * ratio));
    if (camera.viewport() != before) {
        emit q.cameraChanged();
    }
}

void Viewport::Private::sendMesh()
{
    if (!std::exchange(meshDirty, false)) {
        return;
    }
    texelsDirty = true;
    otherSideDirty = true;
    streaming.forget();
    filterMeshDirty = true;
    faceColorsDirty = !faceColors.empty();
    limitDirty = true;
    if (!shownSurface) {
        renderer->clear();
        return;
    }
    if (const Status sent = renderer->setMesh(shownSurface->mesh()); !sent) {
        emit q.notice(QString::fromStdString(sent.error().message));
        shownSurface.reset();
        return;
    }
    if (sharedCorners) {
        renderer->setCorners(*sharedCorners);
    }
}

/// Which texels are shown at all.
void Viewport::Private::prepareTexels()
{
    renderer->setCardBudget(static_cast<std::uint64_t>(shownView.cardBudget) << 20U);
    if (std::exchange(texelsDirty, false)) {
        renderer->setTexels(sentTexels(), shownView.mipDrop);
    }
    prepareOtherSide();
    prepareFilters();
}

/// Texels that are ready, for so long; the frames to come send the rest.
void Viewport::Private::sendTexels(double milliseconds)
{
    if (!shownSurface) {
        return;
    }
    prepareTexels();
    bool hasMore = streaming.send(*renderer, camera, sentTexels(), render::Side::A, milliseconds);
    if (hasOtherTexels()) {
        const bool hasOthers =
            streaming.send(*renderer, camera, otherSideTexels(), render::Side::B, milliseconds);
        hasMore = hasMore || hasOthers;
    }
    if (hasMore) {
        QMetaObject::invokeMethod(
            &q, [this] { redraw(); }, Qt::QueuedConnection);
    }
}

/// All that the view needs, however long it takes.
void Viewport::Private::finishTexels()
{
    if (!shownSurface) {
        return;
    }
    prepareTexels();
    streaming.finish(*renderer, camera, sentTexels(), render::Side::A);
    if (hasOtherTexels()) {
        streaming.finish(*renderer, camera, otherSideTexels(), render::Side::B);
    }
}

void Viewport::Private::cornersReady()
{
    const auto made = madeOf(cornersWatcher.future());
    if (!made) {
        emit q.notice(tr("There is not enough memory to shade the surface smoothly."));
        return;
    }
    const bool isOfAnother =
        !shownSurface || (*made)->faces.size() != shownSurface->mesh().faceCount();
    if (isOfAnother || *made == sharedCorners) {
        return; // of a surface shown before, or taken already by who waited
    }
    sharedCorners = *made;
    if (renderer && !meshDirty) {
        canvas->makeCurrent();
        renderer->setCorners(*sharedCorners);
        canvas->doneCurrent();
    }
    redraw();
}

void Viewport::Private::waitForCorners()
{
    if (shownSurface && !sharedCorners) {
        cornersWatcher.waitForFinished();
        cornersReady();
    }
}

render::Scene Viewport::Private::scene() const
{
    render::Scene result;
    result.camera = camera;
    result.surface.lit = shownView.lit;
    result.surface.limit = showsLimit();
    result.surface.wireframe = shownView.wireframe;
    result.surface.texelGrid = shownView.texelGrid;
    result.surface.filtering = shownView.filtering;
    if (!faceColors.empty()) { // colours that mean numbers must be seen as they are
        result.surface.faceColors = true;
        result.surface.lit = false;
        result.surface.texelGrid = false;
    }
    result.surface.hasAlpha = !result.surface.faceColors && texels().format().alpha.has_value();
    result.surface.pixelRatio = static_cast<float>(q.devicePixelRatioF());
    result.overlays = overlays();
    result.split = split();
    return result;
}

void Viewport::Private::paintHint()
{
    QPainter painter(canvas);
    painter.setRenderHint(QPainter::Antialiasing);
    QFont font = q.font();
    font.setPointSizeF(font.pointSizeF() * 1.4);
    painter.setFont(font);
    painter.setPen(QColor(255, 255, 255, 150));
    painter.drawText(q.rect(), Qt::AlignCenter, tr("Open or drop a mesh"));
}

void Viewport::Private::showOverlays()
{
    if (legend) {
        legend->setVisible(shownSurface && shownView.footprint && !message);
        hud->setVisible(shownSurface && shownView.hud && !message);
    }
}

void Viewport::Private::explainNoOpenGl(const QString& reason)
{
    qCWarning(lcViewport).noquote() << "OpenGL 4.1 is not available." << reason;
    const QString sentence =
        tr("The 3D view needs OpenGL 4.1, which this display does not offer. %1").arg(reason);
    delete std::exchange(message, nullptr);
    message = new QLabel(sentence, &q);
    message->setAlignment(Qt::AlignCenter);
    message->setWordWrap(true);
    message->setMargin(24);
    message->setAutoFillBackground(true);
    message->setGeometry(q.rect());
    message->show();
    showOverlays();
    // Nobody listens yet while the view is being made.
    QMetaObject::invokeMethod(
        &q, [this, sentence] { emit q.notice(sentence); }, Qt::QueuedConnection);
}

} // namespace trixel::ui
