// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the pointer on a texel to the panel of mips drawn, as the window's thread does it; and what
// a face of level 12 takes in the background. Needs no display.
#include <QApplication>
#include <QElapsedTimer>

#include "core/lattice/texel.h"
#include "tests/ui/fixtures.h"
#include "ui/document/document.h"
#include "ui/document/inspection.h"
#include "ui/inspector/mip_panel.h"
#include "ui/viewport/view_settings.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <random>

using namespace trixel;
using namespace trixel::ui;

namespace {

constexpr std::size_t kPainted = 64;

/// Of this thread, in ms: what the window's thread is held up by on a machine of its own.
double threadMs()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

FaceTexels noise(Level level)
{
    std::mt19937 random(static_cast<unsigned>(level.log2()));
    std::vector<std::byte> texels(3 * std::size_t{level.texelCount()});
    for (std::byte& texel : texels) {
        texel = static_cast<std::byte>(random());
    }
    return FaceTexels::full(level, 3, texels);
}

/// A square of a million faces of which some are painted.
class Scene
{
public:
    Scene(Level level, QSize size)
        : m_inspection(m_document)
        , m_panel(m_document, m_inspection, m_settings)
    {
        Project project = gridProject(707, 0);
        for (std::size_t k = 0; k < kPainted; ++k) {
            project.texels.exchange(faceId(k), noise(level));
        }
        m_document.open(std::move(project), {}, "bench");
        m_panel.resize(size);
        m_panel.show();
        QApplication::processEvents();
    }

    /// \return  longest time that the window did not answer, in ms
    double pointAt(FaceId face, TexelCoord texel)
    {
        double longest = 0;
        const auto step = [&](const auto& work) {
            const double begin = threadMs();
            work();
            longest = std::max(longest, threadMs() - begin);
        };
        step([&] { m_inspection.pointAt(TexelPlace{face, texel}); });
        do {
            step([] { QApplication::processEvents(); });
        } while (!m_panel.view().isComplete());
        step([] { QApplication::processEvents(); });
        return longest;
    }

private:
    Document m_document;
    Inspection m_inspection;
    ViewSettings m_settings;
    MipPanel m_panel;
};

QSize sizeOf(const benchmark::State& state)
{
    return state.range(1) == 0 ? QSize(310, 600) : QSize(900, 420);
}

void anotherFace(benchmark::State& state)
{
    Scene scene(Level(static_cast<int>(state.range(0))), sizeOf(state));
    std::size_t face = 0;
    double longest = 0;
    for (auto _ : state) {
        face = (face + 1) % kPainted;
        longest = std::max(longest, scene.pointAt(faceId(face), {}));
    }
    state.counters["longest_ms"] = longest;
}

void anotherTexel(benchmark::State& state)
{
    const Level level(static_cast<int>(state.range(0)));
    Scene scene(level, sizeOf(state));
    std::uint32_t texel = 0;
    double longest = 0;
    for (auto _ : state) {
        texel = (texel + 7) % level.texelCount();
        longest = std::max(longest, scene.pointAt(faceId(3), texelAt(level, TexelIndex{texel})));
    }
    state.counters["longest_ms"] = longest;
}

/// Until everything is drawn and measured.
void largeFace(benchmark::State& state)
{
    const Level level(static_cast<int>(state.range(0)));
    Document document;
    Inspection inspection(document);
    ViewSettings settings;
    MipPanel panel(document, inspection, settings);
    Project project = gridProject(2, 0);
    project.texels.exchange(faceId(0), noise(level));
    document.open(std::move(project), {}, "bench");
    panel.resize(900, 420);
    panel.show();
    double longest = 0;
    double drawn = 0;
    QElapsedTimer whole;
    for (auto _ : state) {
        inspection.pointAt(TexelPlace{faceId(1), {}});
        while (!panel.focus().isMeasured()) { // its first showing is not this face's
            QApplication::processEvents();
        }
        whole.start();
        inspection.pointAt(TexelPlace{faceId(0), {}});
        while (!panel.focus().isMeasured()) {
            const double begin = threadMs();
            QApplication::processEvents();
            longest = std::max(longest, threadMs() - begin);
            if (panel.view().isComplete() && drawn == 0) {
                drawn = static_cast<double>(whole.elapsed());
            }
        }
    }
    state.counters["longest_ms"] = longest;
    state.counters["drawn_ms"] = drawn;
}

BENCHMARK(anotherFace)->ArgsProduct({{3, 5, 6, 7}, {0, 1}})->Unit(benchmark::kMillisecond);
BENCHMARK(anotherTexel)->ArgsProduct({{3, 5, 7}, {0, 1}})->Unit(benchmark::kMillisecond);
BENCHMARK(largeFace)->Arg(9)->Arg(12)->Iterations(1)->Unit(benchmark::kMillisecond);

} // namespace

int main(int argc, char** argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
