// SPDX-License-Identifier: GPL-3.0-or-later
//
// The view's ways of filtering on the chart: the card's time for a frame against the error of its
// pixels.
#include <QCoreApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>

#include "core/study/small_studies.h"
#include "core/study/solid_texture.h"
#include "core/study/speed/speed_accuracy.h"
#include "render/filtering_study.h"
#include "ui/docks/chart_study.h"
#include "ui/viewport/filtering_words.h"

#include <memory>
#include <utility>

namespace trixel::ui {

namespace {

constexpr int kSide = 512;     ///< of the picture, pixels
constexpr int kStep = 4;       ///< every fourth pixel either way is judged
constexpr int kFrames = 7;     ///< of which the median counts
constexpr double kExact = 0.8; ///< share of the time that the exact answers take

/// Where no window's view is touched. Made on the window's thread, used on another.
QSurfaceFormat contextFormat()
{
    QSurfaceFormat format;
    format.setVersion(4, 1);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    return format;
}

struct Measured
{
    std::shared_ptr<const Surface> surface;
    TexelStore texels;
};

Result<Measured> measuredOn(const StudyInput& input, Progress& progress)
{
    if (input.project) {
        return Measured{input.project->surface, input.project->texels};
    }
    auto cage = storedCage();
    if (!cage) {
        return tl::unexpected(cage.error());
    }
    auto data = parseTestData(storedTestFiles());
    if (!data) {
        return tl::unexpected(data.error());
    }
    auto surface = Surface::build(std::move(*cage), progress);
    if (!surface) {
        return tl::unexpected(surface.error());
    }
    const TriangleMesh& mesh = (*surface)->mesh();
    auto texels = solidTexture(
        mesh, planUniform(mesh.faceCount(), Level(4)), *data, Threads::all(), progress);
    if (!texels) {
        return tl::unexpected(texels.error());
    }
    return Measured{*surface, std::move(*texels)};
}

render::Scene sceneOf(const Surface& surface)
{
    render::Scene scene;
    scene.camera.setViewport(kSide, kSide);
    scene.camera.setScene(surface.low(), surface.high());
    scene.camera.frame(surface.low(), surface.high());
    scene.surface.lit = false;
    return scene;
}

/// A context is current.
Result<Study>
measure(const Measured& on, const render::ExactPicture& exact, Study study, StudyWatcher& watcher)
{
    const auto gl = render::currentGl();
    auto made = render::Renderer::create();
    if (!gl || !made) {
        return contentsError("OpenGL 4.1 is not available.");
    }
    render::Renderer& renderer = **made;
    if (const Status sent = renderer.setMesh(on.surface->mesh()); !sent) {
        return tl::unexpected(sent.error());
    }
    renderer.setTexels(on.texels, 0);
    renderer.setFilterMesh(std::make_shared<const render::FilterMesh>(
        on.surface->mesh(), on.surface->adjacency(), on.texels));
    bool hasClock = true;
    double done = 0;
    for (const render::Filtering filtering : render::kFilterings) {
        if (!watcher.report(kExact + (1 - kExact) * done++ / render::kFilterings.size())) {
            return cancelled();
        }
        render::prepareFilterings(renderer, on.texels, std::span(&filtering, 1));
        render::Scene scene = sceneOf(*on.surface);
        scene.surface.filtering = filtering;
        const auto off = differenceOf(render::drawNumbers(*gl, renderer, scene), exact);
        const auto time = render::cardTime(*gl, renderer, scene, kFrames);
        StudyPoint point;
        point.series = filteringTitle(filtering).toStdString();
        point.rms = off.rms;
        point.p99 = off.p99;
        point.worst = off.worst;
        point.samples = off.pixels;
        hasClock = hasClock && time;
        if (time) {
            point.cost = *time;
            study.points.push_back(point);
            watcher.measured(point);
        } else {
            study.notes.push_back(point.series + ": RMS " + std::to_string(100 * off.rms) +
                                  " % of the value range.");
        }
    }
    if (!hasClock) {
        study.notes.insert(study.notes.begin(),
                           "This graphics card has no clock (timer queries): no times, and so no "
                           "points; errors alone are told here.");
    }
    markFront(study.points);
    return study;
}

Result<Study>
run(QOffscreenSurface& place, const Study& header, const StudyInput& input, StudyWatcher& watcher)
{
    auto on = measuredOn(input, watcher);
    if (!on) {
        return tl::unexpected(on.error());
    }
    StageProgress building(watcher, 0, 0.1);
    const auto surface = std::make_shared<const FilterSurface>(
        FilterSurface::fromMesh(on->surface->mesh(), on->surface->adjacency()));
    const auto scene = FilterScene::build(surface, on->texels, Threads::all(), building);
    if (!scene) {
        return tl::unexpected(scene.error());
    }
    StageProgress answering(watcher, 0.1, kExact);
    const auto exact = exactPicture(*on->surface,
                                    *scene,
                                    on->texels.format(),
                                    sceneOf(*on->surface).camera,
                                    {kStep, 0},
                                    Threads::all(),
                                    answering);
    if (!exact) {
        return tl::unexpected(exact.error());
    }
    QOpenGLContext context;
    context.setFormat(contextFormat());
    if (!context.create() || !context.makeCurrent(&place)) {
        return contentsError("OpenGL 4.1 is not available here.");
    }
    Study study = header;
    study.subject = input.project ? input.name.toStdString() : "Cage of the sample, solid texture";
    study.conditions = machineText() + "; " + std::to_string(kSide) + "×" + std::to_string(kSide) +
                       " pixels; times by the graphics card's clock";
    auto measured = measure(*on, *exact, std::move(study), watcher);
    context.doneCurrent();
    return measured;
}

} // namespace

StudyOffer filteringOffer()
{
    StudyOffer offer;
    offer.title = QCoreApplication::translate("Studies", "View");
    offer.about = QCoreApplication::translate(
        "Studies", "Every way the view draws texels, judged by the exact integral for each pixel");
    offer.stored = QCoreApplication::translate("Studies", "Cage of the sample");
    offer.header.name = "view-filtering";
    offer.header.title = "Ways of drawing: time a frame against error";
    offer.header.costTitle = "Time per frame";
    offer.header.costUnit = "ms";
    auto place = std::make_shared<QOffscreenSurface>();
    place->setFormat(contextFormat());
    place->create();
    offer.run = [place, header = offer.header](const StudyInput& input, StudyWatcher& watcher) {
        return run(*place, header, input, watcher);
    };
    return offer;
}

} // namespace trixel::ui
