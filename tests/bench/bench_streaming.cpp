// SPDX-License-Identifier: GPL-3.0-or-later
//
// The window's thread while texels stream: its part of a frame while the camera orbits, from a
// stroke's sample to the card, and the plan that other threads make. Needs a display with OpenGL;
// see README.md for how to run it.
#include <QApplication>
#include <QMouseEvent>
#include <QThread>

#include "tests/bench/sheet_project.h"
#include "tests/render/offscreen.h"
#include "ui/document/document.h"
#include "ui/viewport/card_streaming.h"
#include "ui/viewport/limit_view.h"
#include "ui/viewport/seen_surface.h"
#include "ui/viewport/view_settings.h"
#include "ui/viewport/viewport.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <limits>
#include <map>
#include <random>

using namespace trixel;
using namespace trixel::ui;

namespace {

constexpr int kWidth = 1280;
constexpr int kHeight = 800;
constexpr double kUploadMs = 4.0; // as the view has it

/// Made once.
const Project& sheet(int n)
{
    static std::map<int, Project> sheets;
    Project& project = sheets[n];
    if (!project.surface) {
        project = sheetProject(n, Level(3));
    }
    return project;
}

double threadMs()
{
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

/// Milliseconds of the thread, told as mean, 99th percentile and most.
class Times
{
public:
    template <class Work>
    void take(benchmark::State& state, Work work)
    {
        const double before = threadMs();
        work();
        m_ms.push_back(threadMs() - before);
        state.SetIterationTime(m_ms.back() / 1e3);
    }

    void tell(benchmark::State& state)
    {
        std::ranges::sort(m_ms);
        const std::size_t place = (m_ms.size() * 99 + 99) / 100 - 1;
        state.counters["p99_ms"] = m_ms[place];
        state.counters["most_ms"] = m_ms.back();
    }

private:
    std::vector<double> m_ms;
};

/// A renderer that shows a project, and the streaming that feeds it.
struct View
{
    View(const Project& project, int width, int height)
        : offscreen(width, height)
        , renderer(std::move(*render::Renderer::create()))
    {
        scene.camera.setViewport(width, height);
        scene.camera.setScene(project.surface->low(), project.surface->high());
        scene.camera.frame(project.surface->low(), project.surface->high());
        offscreen.bind();
        (void)renderer->setMesh(project.surface->mesh());
        renderer->setTexels(project.texels, 0);
        streaming.setSurface(project.surface);
    }

    /// Shows vertices from now on. \return  milliseconds until the mesh is ready for that
    double filter(const Project& project, const LimitTessellation* limit = nullptr)
    {
        const auto before = std::chrono::steady_clock::now();
        scene.surface.filtering = render::Filtering::Seamless;
        auto mesh = std::make_shared<const render::FilterMesh>(
            project.surface->mesh(), project.surface->adjacency(), project.texels, limit);
        const std::chrono::duration<double, std::milli> taken =
            std::chrono::steady_clock::now() - before;
        renderer->wantFilterings(std::array{render::Filtering::Seamless});
        renderer->setFilterMesh(mesh);
        streaming.setFilterMesh(mesh);
        streaming.showTexels(false);
        return taken.count();
    }

    bool send(const TexelStore& texels, double ms = kUploadMs)
    {
        return streaming.send(*renderer, scene.camera, texels, render::Side::A, ms);
    }

    render::Offscreen offscreen;
    std::unique_ptr<render::Renderer> renderer;
    render::Scene scene;
    CardStreaming streaming;
};

/// Close over a million faces of 64 texels: faces come into view and go with every frame.
void orbit(benchmark::State& state)
{
    const Project& project = sheet(static_cast<int>(state.range(0)));
    View view(project, kWidth, kHeight);
    view.renderer->setCardBudget(static_cast<std::uint64_t>(state.range(1)) << 20U);
    if (state.range(2) != 0) {
        view.filter(project);
    }
    view.streaming.finish(*view.renderer, view.scene.camera, project.texels, render::Side::A);
    view.scene.camera.zoom(0.15);
    Times times;
    std::uint64_t most = 0;
    std::size_t changes = 0;
    int frame = 0;
    for (auto _ : state) {
        view.scene.camera.orbit({6, frame % 40 < 20 ? 2.0 : -2.0});
        view.scene.camera.pan({8, 3});
        ++frame;
        times.take(state, [&] { view.send(project.texels); });
        view.offscreen.drawOnly(*view.renderer, view.scene);
        most = std::max(most, view.renderer->figures().residentBytes);
        changes += view.streaming.isBusy() ? 1 : 0;
    }
    times.tell(state);
    state.counters["most_MiB"] = static_cast<double>(most) / (1U << 20U);
    state.counters["busy"] = static_cast<double>(changes) / frame;
}
BENCHMARK(orbit)
    ->ArgNames({"side", "MiB", "vertices"})
    ->Args({71, 512, 0})
    ->Args({707, 512, 0})
    ->Args({707, 24, 0})
    ->Args({707, 512, 1})
    ->Args({707, 64, 1})
    ->Iterations(100)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

/// From the choice of a way of filtering over vertices to the first frame of them, however coarse,
/// and to all that the view needs; and the window's thread meanwhile.
void switching(benchmark::State& state)
{
    using Clock = std::chrono::steady_clock;
    const Project& project = sheet(707);
    for (auto _ : state) {
        View view(project, kWidth, kHeight);
        if (state.range(0) != 0) {
            view.scene.camera.zoom(0.15);
        }
        view.streaming.finish(*view.renderer, view.scene.camera, project.texels, render::Side::A);
        const auto begin = Clock::now();
        const auto since = [&] {
            return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
        };
        state.counters["mesh_ms"] = view.filter(project);
        double first = 0;
        double most = 0;
        const auto* vertices = view.renderer->vertices(project.texels, render::Side::A);
        do {
            const double before = threadMs();
            view.send(project.texels);
            most = std::max(most, threadMs() - before);
            if (first == 0 && view.renderer->isFilterReady(render::Filtering::Seamless)) {
                first = since();
            }
            QThread::msleep(2);
        } while (first == 0 || view.streaming.isBusy() || vertices->hasJobs());
        state.SetIterationTime(since() / 1e3);
        state.counters["first_ms"] = first;
        state.counters["most_ms"] = most;
    }
}
BENCHMARK(switching)->ArgName("close")->Arg(0)->Arg(1)->Iterations(2)->UseManualTime()->Unit(
    benchmark::kMillisecond);

/// The limit surface as a view shows it to its camera.
void showLimit(LimitView& limit, View& view, const Document& document)
{
    limit.setSurface(document.surface(), document.creaseAngle());
    limit.want(view.scene.camera, 0.5);
    limit.finish();
    view.renderer->limit().set(limit.tessellation());
    view.renderer->limit().send(std::numeric_limits<std::size_t>::max());
    view.scene.surface.limit = true;
}

/// From a sample of the pointer to its texels on the card: ray, dabs, document, what is sent.
/// Drawing the frame is left out: here it is the processor's work too.
/// \param state  cells along the sheet, whether frames are drawn, whether the limit surface is
///               shown and painted on, whether vertices are shown
void stroke(benchmark::State& state)
{
    const int side = static_cast<int>(state.range(0));
    Document document;
    document.open(sheet(side), {}, {});
    View view({document.surface(), document.texels(), {}}, 640, 400);
    QObject::connect(&document, &Document::changed, [&](const Change& change) {
        view.streaming.texelsChanged();
        view.renderer->touchTexels(document.texels(), change.rects);
    });
    // As many faces on the screen whatever the mesh: about thirty across.
    view.scene.camera.zoom(30.0 / side);
    LimitView limit;
    if (state.range(2) != 0) {
        showLimit(limit, view, document);
    }
    if (state.range(3) != 0) {
        view.filter(sheet(side), limit.solid() ? &limit.solid()->tessellation() : nullptr);
    }
    view.streaming.finish(*view.renderer, view.scene.camera, document.texels(), render::Side::A);
    Brush brush;
    brush.radius = 3.0F / static_cast<float>(side);
    brush.color = {0.9F, 0.3F, 0.2F, 1};
    document.beginStroke(brush, StrokePace::AtOnce, limit.solid());
    const SeenSurface seen(*document.surface(), limit.mesh().get());
    Times times;
    double angle = 0;
    for (auto _ : state) {
        angle += 0.05;
        const glm::dvec2 at(320 + 150 * std::cos(angle), 200 + 120 * std::sin(1.3 * angle));
        times.take(state, [&] {
            const PixelRay ray = view.scene.camera.pixelRay(at);
            const auto hit = seen.raycast({glm::vec3(ray.origin), glm::vec3(ray.direction)});
            if (hit) {
                document.extendStroke({hit->face, hit->uv, 1, angle});
            }
            view.send(document.texels());
        });
        if (state.range(1) != 0) {
            view.offscreen.drawOnly(*view.renderer, view.scene);
        }
        QCoreApplication::processEvents();
    }
    document.endStroke();
    times.tell(state);
}
BENCHMARK(stroke)
    ->ArgNames({"side", "draws", "limit", "vertices"})
    ->ArgsProduct({{71, 707}, {0, 1}, {0, 1}, {0, 1}})
    ->Iterations(300)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

/// What a move of the pointer asks of the view while it paints, all but the frame.
/// \param state  cells along the sheet, whether the limit surface is shown
void strokeEvents(benchmark::State& state)
{
    const int side = static_cast<int>(state.range(0));
    Document document;
    ViewSettings settings;
    Brush brush;
    brush.radius = 3.0F / static_cast<float>(side);
    settings.setBrush(brush);
    ViewOptions options;
    options.limitSurface = state.range(1) != 0;
    settings.setView(options);
    Viewport view(document, settings);
    view.resize(640, 400);
    view.show();
    document.open(sheet(side), {}, {});
    view.lookFrom(0, 0, side / 30.0);
    view.settle();
    const auto send = [&view](QEvent::Type type, QPointF at) {
        const auto button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
        QMouseEvent event(type, at, view.mapToGlobal(at), button, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&view, &event);
    };
    send(QEvent::MouseButtonPress, {320, 200});
    Times times;
    double angle = 0;
    for (auto _ : state) {
        angle += 0.05;
        const QPointF at(320 + 150 * std::cos(angle), 200 + 120 * std::sin(1.3 * angle));
        times.take(state, [&] { send(QEvent::MouseMove, at); });
    }
    send(QEvent::MouseButtonRelease, {320, 200});
    times.tell(state);
    if (!document.undoStack().canUndo()) {
        state.SkipWithError("nothing was painted");
    }
}
BENCHMARK(strokeEvents)
    ->ArgNames({"side", "limit"})
    ->ArgsProduct({{71, 707}, {0, 1}})
    ->Iterations(300)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

/// What other threads do for each view, on one core.
void plan(benchmark::State& state)
{
    const Project& project = sheet(707);
    const auto extents = render::FaceExtents::of(project.surface->mesh(), Threads{1});
    std::vector<render::Wish> wishes(extents.size());
    const std::vector<render::FaceOnCard> faces(extents.size(), render::FaceOnCard{3, 1});
    const auto room = render::CardRoom::of(
        render::CardBlocks(render::BlockKind::Texels, extents.size(), 1U << 27U), 1U << 26U);
    render::Camera camera;
    camera.setViewport(kWidth, kHeight);
    camera.setScene(project.surface->low(), project.surface->high());
    camera.frame(project.surface->low(), project.surface->high());
    for (auto _ : state) {
        render::wishesOf(extents, camera, Threads{1}, wishes);
        if (state.range(0) != 0) {
            benchmark::DoNotOptimize(render::planResidency(wishes, faces, room));
        }
    }
}
BENCHMARK(plan)->ArgName("whole")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

} // namespace

int main(int argc, char** argv)
{
    const QApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
