// SPDX-License-Identifier: GPL-3.0-or-later
//
// Frames of every way of filtering beside a plain draw of the same mesh, and what a dab costs the
// vertices on the card. Needs a display with OpenGL; see README.md for how to run it.
#include <QGuiApplication>
#include <QOpenGLBuffer>
#include <QOpenGLVertexArrayObject>

#include "render/corner_normals.h"
#include "render/filtering_study.h"
#include "render/matrices.h"
#include "render/residency.h"
#include "tests/bench/sheet_mesh.h"
#include "tests/render/offscreen.h"

#include <benchmark/benchmark.h>

#include <array>
#include <map>
#include <random>

using namespace trixel;
using namespace trixel::render;

namespace {

constexpr int kWidth = 1280;
constexpr int kHeight = 800;
constexpr int kLevel = 3; // 64 texels a face

Scene scene()
{
    Scene result;
    result.camera.setViewport(kWidth, kHeight);
    result.camera.setScene({-1, -1, -0.2F}, {1, 1, 0.2F});
    result.camera.frame({-1, -1, -0.2F}, {1, 1, 0.2F});
    result.surface.lit = false;
    return result;
}

/// A sheet of 2 n² painted faces.
struct Painted
{
    TriangleMesh mesh;
    TexelStore store;
    std::shared_ptr<const FilterMesh> filterMesh;
    SharedCorners corners;
};

const Painted& painted(int n)
{
    static std::map<int, Painted> all;
    Painted& sheet = all[n];
    if (!sheet.filterMesh) {
        sheet.mesh = sheetMesh(n);
        const std::size_t faces = sheet.mesh.faceCount();
        sheet.store = TexelStore(static_cast<std::uint32_t>(faces),
                                 TexelFormat{},
                                 Level(kLevel),
                                 std::vector<std::byte>(3));
        std::mt19937 random(1);
        for (std::size_t f = 0; f < faces; ++f) {
            for (std::byte& byte : sheet.store.writable(faceId(f))) {
                byte = static_cast<std::byte>(random());
            }
        }
        sheet.corners = SharedCorners::of(sheet.mesh, cornerNormals(sheet.mesh));
        sheet.filterMesh = std::make_shared<const FilterMesh>(
            sheet.mesh, buildAdjacency(sheet.mesh.triangles), sheet.store);
    }
    return sheet;
}

/// Three positions and colours a face, from one buffer.
void plainVertexColours(benchmark::State& state)
{
    Offscreen offscreen(kWidth, kHeight);
    const auto gl = currentGl();
    const Painted& sheet = painted(static_cast<int>(state.range(0)));
    struct Vertex
    {
        glm::vec3 position;
        std::array<std::uint8_t, 4> color;
    };
    std::vector<Vertex> vertices;
    vertices.reserve(3 * sheet.mesh.faceCount());
    std::mt19937 random(1);
    for (const Triangle& triangle : sheet.mesh.triangles) {
        for (const std::uint32_t v : triangle) {
            const auto byte = [&] { return static_cast<std::uint8_t>(random()); };
            vertices.push_back({sheet.mesh.positions[v], {byte(), byte(), byte(), 255}});
        }
    }
    QOpenGLShaderProgram program;
    program.addShaderFromSourceCode(
        QOpenGLShader::Vertex,
        "#version 410 core\nuniform mat4 toClip; in vec3 p; in vec4 c; out vec4 color;\n"
        "void main() { color = c; gl_Position = toClip * vec4(p, 1.0); }");
    program.addShaderFromSourceCode(QOpenGLShader::Fragment,
                                    "#version 410 core\nin vec4 color; out vec4 o;\n"
                                    "void main() { o = color; }");
    program.link();
    QOpenGLVertexArrayObject array;
    array.create();
    array.bind();
    QOpenGLBuffer buffer(QOpenGLBuffer::VertexBuffer);
    buffer.create();
    buffer.bind();
    buffer.allocate(vertices.data(), static_cast<int>(vertices.size() * sizeof(Vertex)));
    program.bind();
    program.enableAttributeArray("p");
    program.setAttributeBuffer("p", GL_FLOAT, 0, 3, sizeof(Vertex));
    program.enableAttributeArray("c");
    program.setAttributeBuffer("c", GL_UNSIGNED_BYTE, sizeof(glm::vec3), 4, sizeof(Vertex));
    const Scene shown = scene();
    program.setUniformValue("toClip", toQt(shown.camera.projection() * shown.camera.view()));
    offscreen.bind();
    gl->glEnable(GL_DEPTH_TEST);
    gl->glViewport(0, 0, kWidth, kHeight);
    for (auto _ : state) {
        gl->glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        gl->glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
        gl->glFinish();
    }
}

void drawFiltered(benchmark::State& state, Filtering filtering, bool lit)
{
    Offscreen offscreen(kWidth, kHeight);
    const auto renderer = std::move(*Renderer::create());
    const Painted& sheet = painted(static_cast<int>(state.range(0)));
    (void)renderer->setMesh(sheet.mesh);
    renderer->setCorners(sheet.corners);
    renderer->setTexels(sheet.store, 0);
    renderer->setFilterMesh(sheet.filterMesh);
    prepareFilterings(*renderer, sheet.store, std::span(&filtering, 1));
    Scene shown = scene();
    shown.surface.filtering = filtering;
    shown.surface.lit = lit;
    for (auto _ : state) {
        offscreen.drawOnly(*renderer, shown);
    }
}

/// Has on the card what a view needs, as the window does.
template <class Send>
void stream(DisplayBlocks& blocks, const Painted& sheet, const Camera& camera, Send send)
{
    const auto sendAll = [&] {
        while (blocks.hasReady() || blocks.isOpening()) {
            send();
        }
    };
    blocks.open(blocks.opener()(sheet.store));
    sendAll();
    const FaceExtents extents = FaceExtents::of(sheet.mesh, Threads::all());
    std::vector<Wish> wishes(extents.size());
    wishesOf(extents, camera, Threads::all(), wishes);
    blocks.follow(planResidency(wishes, blocks.facesOnCard(), blocks.mostRoom()));
    while (blocks.hasJobs(false)) {
        const JobBatch batch = blocks.nextJobs(std::size_t{1} << 20U, false);
        blocks.accept(blocks.maker()(sheet.store, batch.jobs), batch, sheet.store);
        sendAll();
    }
}

/// What the window shows: levels by the view.
void drawStreamed(benchmark::State& state, Filtering filtering)
{
    Offscreen offscreen(kWidth, kHeight);
    const auto renderer = std::move(*Renderer::create());
    const Painted& sheet = painted(static_cast<int>(state.range(0)));
    (void)renderer->setMesh(sheet.mesh);
    renderer->setCorners(sheet.corners);
    renderer->setTexels(sheet.store, 0);
    renderer->setFilterMesh(sheet.filterMesh);
    renderer->wantFilterings(std::span(&filtering, 1));
    Scene shown = scene();
    shown.surface.filtering = filtering;
    constexpr std::size_t kMost = std::size_t{1} << 24U;
    stream(renderer->display(Side::A), sheet, shown.camera, [&] {
        renderer->sendReady(sheet.store, kMost, Side::A);
    });
    if (sourceOf(filtering) == FilterSource::Vertices) {
        stream(*renderer->vertices(sheet.store, Side::A), sheet, shown.camera, [&] {
            renderer->sendReadyVertices(sheet.store, kMost, Side::A);
        });
    }
    check(renderer->isFilterReady(filtering), "something of every face");
    for (auto _ : state) {
        offscreen.drawOnly(*renderer, shown);
    }
    state.counters["MiB"] = static_cast<double>(renderer->figures().residentBytes) / (1U << 20U);
}

void texels(benchmark::State& state)
{
    drawFiltered(state, Filtering::Texels, false);
}
void lowerHalf(benchmark::State& state)
{
    drawFiltered(state, Filtering::LowerHalf, false);
}
void packedAtlas(benchmark::State& state)
{
    drawFiltered(state, Filtering::PackedAtlas, false);
}
void seamless(benchmark::State& state)
{
    drawFiltered(state, Filtering::Seamless, false);
}
void anisotropic(benchmark::State& state)
{
    drawFiltered(state, Filtering::Anisotropic, false);
}
void seamlessInView(benchmark::State& state)
{
    drawStreamed(state, Filtering::Seamless);
}
void texelsInView(benchmark::State& state)
{
    drawStreamed(state, Filtering::Texels);
}
void seamlessLit(benchmark::State& state)
{
    drawFiltered(state, Filtering::Seamless, true);
}

/// Sides of the sheet for 10 thousand faces and a million.
void sizes(benchmark::internal::Benchmark* bench)
{
    bench->Arg(71)->Arg(707)->Unit(benchmark::kMillisecond);
    bench->MeasureProcessCPUTime()->UseRealTime();
}

BENCHMARK(plainVertexColours)->Apply(sizes);
BENCHMARK(seamless)->Apply(sizes);
BENCHMARK(seamlessInView)->Apply(sizes);
BENCHMARK(texelsInView)->Apply(sizes);
BENCHMARK(seamlessLit)->Apply(sizes);
BENCHMARK(texels)->Apply(sizes);
BENCHMARK(lowerHalf)->Apply(sizes);
BENCHMARK(packedAtlas)->Apply(sizes);
// Of half a million faces each footprint reaches as many as are summed at most.
BENCHMARK(anisotropic)->Apply(sizes)->Arg(500);

/// A dab of 3,000 texels over 200 faces: mips, vertices, and what is sent.
void dab(benchmark::State& state)
{
    const Painted& sheet = painted(static_cast<int>(state.range(0)));
    TexelStore store = sheet.store;
    DisplayVertices vertices;
    vertices.reset(sheet.filterMesh, store, 0, 1U << 27U);
    while (vertices.hasWork()) {
        vertices.take(store, 4U << 20U);
    }
    const std::size_t middle = store.faceCount() / 2;
    std::vector<TouchedRect> rects;
    for (std::size_t f = 0; f < 200; ++f) {
        rects.push_back({faceId(middle + f), 1, 2, 5, 3, false});
    }
    std::size_t sent = 0;
    std::size_t bytes = 0;
    for (auto _ : state) {
        vertices.touch(store, rects);
        const DisplayUpdate update = vertices.take(store, 0);
        bytes = update.bytes.size();
        sent = bytes / texelBytes(vertices.format());
        benchmark::DoNotOptimize(update);
    }
    state.counters["vertices"] = static_cast<double>(sent);
    state.counters["bytes"] = static_cast<double>(bytes);
}
BENCHMARK(dab)->Arg(71)->Arg(707)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

/// All vertices of a mesh, as they are made in the background.
void makeVertices(benchmark::State& state)
{
    const Painted& sheet = painted(static_cast<int>(state.range(0)));
    for (auto _ : state) {
        DisplayVertices vertices;
        vertices.reset(sheet.filterMesh, sheet.store, 0, 1U << 27U);
        while (vertices.hasWork()) {
            benchmark::DoNotOptimize(vertices.take(sheet.store, 512U << 10U));
        }
        state.counters["per texel"] = static_cast<double>(vertices.verticesUsed()) /
                                      static_cast<double>(sheet.store.texelCount());
    }
}
BENCHMARK(makeVertices)
    ->Arg(71)
    ->Arg(707)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

} // namespace

int main(int argc, char** argv)
{
    const QGuiApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
