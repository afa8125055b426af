// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/paint_speed.h"

#include "core/paint/dab_painter.h"

#include <algorithm>
#include <chrono>
#include <vector>

namespace trixel::render {

namespace {

constexpr int kLevel = 8;
/// Threads help from dabs of so many texels on, twice the sample: assumed to share its cost evenly.
constexpr double kMostThreads = 8;

template <class Work>
double nanosecondsATexel(Work&& work)
{
    double best = 0;
    for (int k = 0; k < 2; ++k) { // the first time things are made and come into caches
        const auto begin = std::chrono::steady_clock::now();
        work();
        const std::chrono::duration<double, std::nano> took =
            std::chrono::steady_clock::now() - begin;
        best = took.count() / Level(kLevel).texelCount();
    }
    return best;
}

} // namespace

PaintSpeed measurePaintSpeed(Gl& gl, PaintSheet& sheet, const TexelFormat& format, Threads threads)
{
    const Level level(kLevel);
    const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}};
    const std::array dabs{Dab{{0.3F, 0.3F, 0}, {}, 2, 1}};
    const PaintSheet::Strength strength{0.2F, 0.5F};
    PaintSpeed speed;

    PaintBatch batch(dabs);
    batch.add(mesh.corners(FaceId{0}), {0, 0, level}, 1, true);
    gl.glFinish();
    speed.card = nanosecondsATexel([&] {
        sheet.draw(batch, strength);
        gl.glFinish();
    });

    const std::vector<std::byte> black(format.texelBytes());
    TexelStore store(1, format, level, black);
    (void)store.writable(FaceId{0});
    const std::vector<float> white(format.channels, 1.0F);
    speed.processor = nanosecondsATexel([&] {
        DabPainter painter(format, white, strength.hardness, strength.flow, Threads{1});
        painter.paint(dabs[0], mesh, std::array{FaceId{0}}, store);
    });
    speed.processor /= std::clamp(static_cast<double>(threads.count), 1.0, kMostThreads);
    return speed;
}

} // namespace trixel::render
