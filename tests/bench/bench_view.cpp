// SPDX-License-Identifier: GPL-3.0-or-later
//
// Frames and uploads of the view. Needs a display with OpenGL; see README.md for how to run it.
#include <QGuiApplication>
#include <QOpenGLBuffer>
#include <QOpenGLVertexArrayObject>

#include "core/mesh/triangle_mesh.h"
#include "render/corner_normals.h"
#include "render/matrices.h"
#include "tests/bench/sheet_mesh.h"
#include "tests/render/offscreen.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <random>

using namespace trixel;
using namespace trixel::render;

namespace {

constexpr std::size_t kAll = ~std::size_t{0};
constexpr int kWidth = 1280;
constexpr int kHeight = 800;

/// A wavy sheet of 2 n² faces.
const TriangleMesh& sheet(int n)
{
    static std::map<int, TriangleMesh> sheets;
    TriangleMesh& mesh = sheets[n];
    if (!mesh.triangles.empty()) {
        return mesh;
    }
    mesh = sheetMesh(n);
    return mesh;
}

TexelStore noise(std::size_t faces, int level)
{
    std::mt19937 random(1);
    const TexelFormat format;
    TexelStore store(
        static_cast<std::uint32_t>(faces), format, Level(level), std::vector<std::byte>(3));
    for (std::size_t f = 0; f < faces; ++f) {
        for (std::byte& b : store.writable(faceId(f))) {
            b = static_cast<std::byte>(random());
        }
    }
    return store;
}

Scene scene()
{
    Scene result;
    result.camera.setViewport(kWidth, kHeight);
    result.camera.setScene({-1, -1, -0.2F}, {1, 1, 0.2F});
    result.camera.frame({-1, -1, -0.2F}, {1, 1, 0.2F});
    return result;
}

/// Sides of the sheet for 10 thousand, 100 thousand and a million faces.
void sizes(benchmark::internal::Benchmark* bench)
{
    bench->Arg(71)->Arg(224)->Arg(707)->Unit(benchmark::kMillisecond);
    bench->MeasureProcessCPUTime()->UseRealTime();
}

/// The view's own picture: texels, light, overlays.
void drawSurface(benchmark::State& state, const SurfaceStyle& style, bool stored)
{
    Offscreen offscreen(kWidth, kHeight);
    const auto renderer = std::move(*Renderer::create());
    const TriangleMesh& mesh = sheet(static_cast<int>(state.range(0)));
    const TexelStore store = stored ? noise(mesh.faceCount(), 1)
                                    : TexelStore(static_cast<std::uint32_t>(mesh.faceCount()),
                                                 TexelFormat{},
                                                 Level(3),
                                                 std::vector<std::byte>(3, std::byte{200}));
    (void)renderer->setMesh(mesh);
    renderer->setCorners(SharedCorners::of(mesh, cornerNormals(mesh)));
    renderer->setTexels(store, 0);
    renderer->uploadTexels(store, kAll);
    Scene shown = scene();
    shown.surface = style;
    for (auto _ : state) {
        offscreen.drawOnly(*renderer, shown);
    }
    state.counters["faces"] = static_cast<double>(mesh.faceCount());
}

void unpaintedLit(benchmark::State& state)
{
    drawSurface(state, {}, false);
}
void paintedLit(benchmark::State& state)
{
    drawSurface(state, {}, true);
}
void paintedUnlit(benchmark::State& state)
{
    drawSurface(state, {.lit = false}, true);
}
void paintedWithLines(benchmark::State& state)
{
    drawSurface(state, {.wireframe = true, .texelGrid = true}, true);
}

/// What any program could not do without: the same mesh, indexed, in one colour.
void indexedOneColour(benchmark::State& state)
{
    Offscreen offscreen(kWidth, kHeight);
    const auto gl = currentGl();
    const TriangleMesh& mesh = sheet(static_cast<int>(state.range(0)));
    QOpenGLShaderProgram program;
    program.addShaderFromSourceCode(QOpenGLShader::Vertex,
                                    "#version 410 core\nuniform mat4 toClip; in vec3 p;\n"
                                    "void main() { gl_Position = toClip * vec4(p, 1.0); }");
    program.addShaderFromSourceCode(QOpenGLShader::Fragment,
                                    "#version 410 core\nout vec4 c;\n"
                                    "void main() { c = vec4(0.7, 0.7, 0.7, 1.0); }");
    program.link();
    QOpenGLVertexArrayObject array;
    array.create();
    array.bind();
    QOpenGLBuffer positions(QOpenGLBuffer::VertexBuffer);
    QOpenGLBuffer triangles(QOpenGLBuffer::IndexBuffer);
    positions.create();
    positions.bind();
    positions.allocate(mesh.positions.data(),
                       static_cast<int>(mesh.positions.size() * sizeof(glm::vec3)));
    triangles.create();
    triangles.bind();
    triangles.allocate(mesh.triangles.data(),
                       static_cast<int>(mesh.triangles.size() * sizeof(Triangle)));
    program.bind();
    program.enableAttributeArray("p");
    program.setAttributeBuffer("p", GL_FLOAT, 0, 3);
    const Scene shown = scene();
    program.setUniformValue("toClip", toQt(shown.camera.projection() * shown.camera.view()));
    offscreen.bind();
    gl->glEnable(GL_DEPTH_TEST);
    gl->glViewport(0, 0, kWidth, kHeight);
    for (auto _ : state) {
        gl->glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        gl->glDrawElements(
            GL_TRIANGLES, static_cast<GLsizei>(3 * mesh.faceCount()), GL_UNSIGNED_INT, nullptr);
        gl->glFinish();
    }
    state.counters["faces"] = static_cast<double>(mesh.faceCount());
}

BENCHMARK(indexedOneColour)->Apply(sizes);
BENCHMARK(unpaintedLit)->Apply(sizes);
BENCHMARK(paintedLit)->Apply(sizes);
BENCHMARK(paintedUnlit)->Apply(sizes);
BENCHMARK(paintedWithLines)->Apply(sizes);

/// A dab's texels: rectangles of so many texels in all, over faces of level 5.
void sendTouched(benchmark::State& state)
{
    const Offscreen offscreen(64, 64);
    const auto renderer = std::move(*Renderer::create());
    const TriangleMesh& mesh = sheet(71);
    const TexelStore store = noise(mesh.faceCount(), 5);
    (void)renderer->setMesh(mesh);
    renderer->setTexels(store, 0);
    renderer->uploadTexels(store, kAll);
    std::vector<TouchedRect> rects;
    for (std::size_t f = 0; f < static_cast<std::size_t>(state.range(0)) / 512; ++f) {
        rects.push_back({faceId(1000 + f), 8, 0, 16, 32, false});
    }
    for (auto _ : state) {
        renderer->touchTexels(store, rects);
        benchmark::DoNotOptimize(renderer->uploadTexels(store, 0));
        currentGl()->glFinish();
    }
}
BENCHMARK(sendTouched)
    ->Arg(1'024)
    ->Arg(10'240)
    ->Arg(102'400)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

/// One slice of a store that is being opened: 512 KB of texels on the card.
void sendSlice(benchmark::State& state)
{
    const Offscreen offscreen(64, 64);
    const auto renderer = std::move(*Renderer::create());
    const TriangleMesh& mesh = sheet(224);
    const TexelStore store = noise(mesh.faceCount(), static_cast<int>(state.range(0)));
    (void)renderer->setMesh(mesh);
    renderer->setTexels(store, 0);
    for (auto _ : state) {
        if (!renderer->texels().hasWork()) {
            renderer->touchAllTexels();
        }
        renderer->uploadTexels(store, 512U << 10U);
    }
}
BENCHMARK(sendSlice)
    ->Arg(1)
    ->Arg(3)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

/// Normals of a million faces, on all cores, away from the window's thread.
void makeNormals(benchmark::State& state)
{
    for (auto _ : state) {
        benchmark::DoNotOptimize(cornerNormals(sheet(707)));
    }
}
BENCHMARK(makeNormals)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

} // namespace

int main(int argc, char** argv)
{
    const QGuiApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
