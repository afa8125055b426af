// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texels that come to the card while the view goes on, with the threads and the context of a
// running window.
#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>

#include "core/texture/stored_faces.h"
#include "tests/ui/viewport/streaming_view.h"

#include <new>

using namespace trixel;
using namespace trixel::ui;

namespace {

/// As if each face of a file was too large to be read.
class FacesWithoutMemory final : public FaceReader
{
public:
    Result<bool> read(FaceId, Level, std::span<std::byte>) const override
    {
        throw std::bad_alloc();
    }
    bool stores(FaceId, Level) const override { return false; }
    std::span<const std::byte> mean(FaceId) const override { return m_mean; }

private:
    std::array<std::byte, 3> m_mean{};
};

} // namespace

class TestViewportStreaming : public QObject
{
    Q_OBJECT

private slots:
    void aFlightKeepsToTheBudgetAndLeavesNoHole()
    {
        for (const std::uint64_t budget : {2 * kMiB, 64 * kMiB}) {
            StreamingView view(noisyProject(24, 6), budget);
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
        StreamingView view(noisyProject(24, 6), 256 * kMiB);
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
        StreamingView view(noisyProject(24, 6), 64 * kMiB);
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
        StreamingView again(view.project, 64 * kMiB);
        again.scene = view.scene;
        again.frame();
        again.finish();
        QCOMPARE(streamed, again.offscreen.draw(*again.renderer, again.scene));
    }

    void whatChangesAltogetherWhileFirstTexelsAreMadeIsShown()
    {
        StreamingView view(gridProject(8, 3), 64 * kMiB); // faces of one value: bases say all
        view.frame();                                     // begins with the texels there are
        const std::array<std::byte, 3> red{std::byte{255}, std::byte{0}, std::byte{0}};
        view.project.texels = TexelStore(
            view.project.texels.faceCount(), view.project.texels.format(), Level(3), red);
        view.streaming.texelsChanged();
        view.renderer->touchAllTexels();
        view.finish();
        const QImage seen = view.offscreen.draw(*view.renderer, view.scene);
        StreamingView again(view.project, 64 * kMiB);
        again.finish();
        QCOMPARE(seen, again.offscreen.draw(*again.renderer, again.scene));
    }

    void wantOfMemoryIsToldOnceAndEndsNothing()
    {
        Project project = gridProject(8, 6);
        const auto faces =
            StoredFaces::make(project.texels.format(), std::make_unique<FacesWithoutMemory>());
        for (std::size_t f = 0; f < project.texels.faceCount(); ++f) {
            project.texels.exchange(faceId(f), faces->face(faceId(f), Level(6)));
        }
        project.storedFaces = faces;
        StreamingView view(std::move(project), 64 * kMiB);
        QSignalSpy told(&view.streaming, &CardStreaming::outOfMemory);
        view.scene.camera.setPose(poseAt(0));
        view.frame();
        view.finish();
        QVERIFY(!view.streaming.isBusy());
        QCOMPARE(told.count(), 1);
        for (const render::FaceRecord& record : view.renderer->texels().records()) {
            QVERIFY(!record.isPending()); // the means that the file keeps are there
        }
    }

    void aDropOfLevelsReplacesWhatIsShownWithoutAHole()
    {
        StreamingView view(noisyProject(8, 6), 64 * kMiB);
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
        StreamingView view(noisyProject(24, 6), 64 * kMiB);
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

    /// Their bases take several frames.
    void thePackedAtlasFollowsTheBudget()
    {
        StreamingView view(noisyProject(24, 6), 128 * kMiB);
        view.scene.camera.setPose(poseAt(0));
        view.filter(render::Filtering::PackedAtlas);
        const auto bytesOfAtlas = [&](std::uint64_t budget) {
            view.offscreen.bind();
            view.renderer->setCardBudget(budget);
            view.finish();
            while (view.renderer->hasAtlasWork()) {
                (void)view.renderer->uploadAtlas(view.project.texels, kMiB);
                QTest::qWait(1);
            }
            (void)view.offscreen.draw(*view.renderer, view.scene);
            const render::FrameFigures& figures = view.renderer->figures();
            view.offscreen.bind();
            return figures.residentBytes - view.renderer->texels().cardBytes();
        };
        const std::uint64_t most = bytesOfAtlas(128 * kMiB);
        const std::uint64_t least = bytesOfAtlas(48 * kMiB);
        QVERIFY(least < most);
        QVERIFY(view.renderer->figures().residentBytes <= 48 * kMiB);
        QCOMPARE(bytesOfAtlas(128 * kMiB), most);
    }

    void veryManyFacesStayShownWhileTheBudgetShrinks()
    {
        StreamingView view(noisyProject(220, 2), 64 * kMiB);
        view.scene.camera.setPose(poseAt(0));
        view.frame();
        view.finish();
        const QImage before = view.offscreen.draw(*view.renderer, view.scene);
        view.offscreen.bind();
        view.renderer->setCardBudget(2 * kMiB);
        bool wasOpening = false;
        for (int k = 0; k < 200; ++k) {
            view.frame(0); // one part each
            wasOpening = wasOpening || view.renderer->texels().isOpening();
            const QImage seen = view.offscreen.draw(*view.renderer, view.scene);
            QVERIFY(farthest(before, seen) <= 2);
            if (!view.renderer->texels().needsOpening() && !view.streaming.isBusy()) {
                break;
            }
            QTest::qWait(1);
        }
        QVERIFY(wasOpening);
        view.finish();
        QVERIFY(farthest(before, view.offscreen.draw(*view.renderer, view.scene)) <= 2);
        QVERIFY(view.renderer->figures().residentBytes <= 2 * kMiB);
    }
};

QTEST_MAIN(TestViewportStreaming)
#include "tst_viewport_streaming.moc"
