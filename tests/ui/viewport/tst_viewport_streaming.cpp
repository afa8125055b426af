// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texels that come to the card while the view goes on, with the threads and the context of a
// running window.
#include <QElapsedTimer>
#include <QTest>

#include "render/residency.h"
#include "tests/render/offscreen.h"
#include "tests/ui/fixtures.h"
#include "ui/viewport/card_streaming.h"

#include <cmath>
#include <random>

using namespace trixel;
using namespace trixel::ui;

namespace {

constexpr std::uint64_t kMiB = 1U << 20U;
constexpr double kFrameMs = 4;

/// A square of 2 · cells² faces, each of one colour of its own in every texel but noise in the last
/// bits: every level of it looks the same, whatever is shown.
Project noisyProject(int cells, int level)
{
    Project project = gridProject(cells, level);
    std::mt19937 random(1);
    for (std::size_t f = 0; f < project.texels.faceCount(); ++f) {
        const auto color = static_cast<std::uint32_t>(random());
        std::size_t k = 0;
        for (std::byte& b : project.texels.writable(faceId(f))) {
            const std::uint32_t part = 64 + (color >> (8 * (k++ % 3)) & 0x7fU);
            b = static_cast<std::byte>(part ^ (random() & 1U));
        }
    }
    return project;
}

int farthest(const QImage& a, const QImage& b)
{
    int most = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y);
            const QRgb q = b.pixel(x, y);
            most = std::max({most,
                             std::abs(qRed(p) - qRed(q)),
                             std::abs(qGreen(p) - qGreen(q)),
                             std::abs(qBlue(p) - qBlue(q))});
        }
    }
    return most;
}

} // namespace

class TestViewportStreaming : public QObject
{
    Q_OBJECT

private:
    /// What a window has, without the window.
    struct View
    {
        explicit View(Project shown, std::uint64_t budget)
            : project(std::move(shown))
            , offscreen(500, 400)
        {
            offscreen.bind();
            renderer = std::move(*render::Renderer::create());
            renderer->setCardBudget(budget);
            (void)renderer->setMesh(project.surface->mesh());
            renderer->setTexels(project.texels, 0);
            streaming.setSurface(project.surface);
            scene.surface.lit = false;
            scene.camera.setViewport(500, 400);
            scene.camera.setScene(project.surface->low(), project.surface->high());
        }

        void frame()
        {
            offscreen.bind();
            (void)streaming.send(
                *renderer, scene.camera, project.texels, render::Side::A, kFrameMs);
        }

        void finish()
        {
            offscreen.bind();
            streaming.finish(*renderer, scene.camera, project.texels, render::Side::A);
        }

        Project project;
        render::Offscreen offscreen;
        std::unique_ptr<render::Renderer> renderer;
        render::Scene scene;
        CardStreaming streaming;
    };

    static render::CameraPose poseAt(double t)
    {
        render::CameraPose pose;
        pose.target = {0.5 + 0.4 * std::sin(5 * t), 0.5 + 0.4 * std::cos(3 * t), 0};
        pose.distance = 0.06 + 1.5 * std::pow(std::cos(4 * t), 2);
        pose.yaw = 0.4 * std::sin(7 * t);
        pose.pitch = 0.3;
        return pose;
    }

private slots:
    void aFlightKeepsToTheBudgetAndLeavesNoHole()
    {
        for (const std::uint64_t budget : {2 * kMiB, 64 * kMiB}) {
            View view(noisyProject(24, 6), budget);
            view.frame();
            view.finish();
            std::size_t late = 0;
            for (int k = 0; k < 60; ++k) {
                view.scene.camera.setPose(poseAt(k / 60.0));
                view.frame();
                const QImage seen = view.offscreen.draw(*view.renderer, view.scene);
                const render::FrameFigures& figures = view.renderer->figures();
                QVERIFY(figures.residentBytes > 0);
                QVERIFY(figures.residentBytes <= budget);
                QCOMPARE(figures.budgetBytes, budget);
                late += view.streaming.isBusy() ? 1 : 0;
                if (k % 12 == 11) {
                    view.finish();
                    // Every level is of nearly one colour: whatever was shown, it was no hole.
                    const QImage complete = view.offscreen.draw(*view.renderer, view.scene);
                    QVERIFY(farthest(seen, complete) <= 2);
                }
            }
            QVERIFY(late > 0);
            QVERIFY(!view.offscreen.hadErrors());
        }
    }

    void aViewAtRestHasTheLevelsThatItNeeds()
    {
        View view(noisyProject(24, 6), 256 * kMiB);
        for (const double t : {0.1, 0.37, 0.8}) {
            view.scene.camera.setPose(poseAt(t));
            view.frame();
            view.finish();
            std::vector<render::Wish> wishes(view.project.texels.faceCount());
            render::wishesOf(render::FaceExtents::of(view.project.surface->mesh(), Threads{1}),
                             view.scene.camera,
                             Threads{1},
                             wishes);
            const auto records = view.renderer->texels().records();
            for (std::size_t f = 0; f < wishes.size(); ++f) {
                const int needed =
                    wishes[f] == render::kUnseen ? 0 : std::min((wishes[f] + 7) / 8, 6);
                QVERIFY(records[f].level() >= needed);
            }
        }
    }

    void whatIsPaintedMeanwhileIsShown()
    {
        View view(noisyProject(24, 6), 64 * kMiB);
        view.scene.camera.setPose(poseAt(0.1));
        std::mt19937 random(2);
        for (int k = 0; k < 30; ++k) {
            view.scene.camera.setPose(poseAt(k / 60.0));
            std::vector<TouchedRect> rects;
            for (int n = 0; n < 20; ++n) {
                const FaceId face = faceId(random() % view.project.texels.faceCount());
                std::ranges::fill(view.project.texels.writable(face), std::byte{250});
                rects.push_back({face, 0, 0, 64, 64, false});
            }
            view.streaming.texelsChanged();
            view.renderer->touchTexels(view.project.texels, rects);
            view.frame();
        }
        view.finish();
        const QImage streamed = view.offscreen.draw(*view.renderer, view.scene);
        View again(view.project, 64 * kMiB);
        again.scene = view.scene;
        again.frame();
        again.finish();
        QCOMPARE(streamed, again.offscreen.draw(*again.renderer, again.scene));
    }

    void aDropOfLevelsReplacesWhatIsShownWithoutAHole()
    {
        View view(noisyProject(8, 6), 64 * kMiB);
        view.scene.camera.setPose(poseAt(0.3));
        view.frame();
        view.finish();
        const QImage before = view.offscreen.draw(*view.renderer, view.scene);
        view.offscreen.bind();
        view.renderer->setTexels(view.project.texels, 3);
        for (int k = 0; k < 5; ++k) {
            view.frame();
            QVERIFY(farthest(before, view.offscreen.draw(*view.renderer, view.scene)) <= 2);
        }
        view.finish();
        QVERIFY(farthest(before, view.offscreen.draw(*view.renderer, view.scene)) <= 2);
        for (const render::FaceRecord& record : view.renderer->texels().records()) {
            QCOMPARE(record.ownLevel(), 3);
            QVERIFY(record.level() <= 3);
        }
    }

    void aSmallerBudgetTakesEffectAtOnce()
    {
        View view(noisyProject(24, 6), 64 * kMiB);
        view.scene.camera.setPose(poseAt(0));
        view.frame();
        view.finish();
        view.offscreen.bind();
        view.renderer->setCardBudget(kMiB);
        view.finish();
        const QImage picture = view.offscreen.draw(*view.renderer, view.scene);
        QVERIFY(view.renderer->figures().residentBytes <= kMiB);
        view.offscreen.bind();
        view.renderer->setCardBudget(64 * kMiB);
        view.finish();
        QVERIFY(farthest(picture, view.offscreen.draw(*view.renderer, view.scene)) <= 2);
    }
};

QTEST_MAIN(TestViewportStreaming)
#include "tst_viewport_streaming.moc"
