// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vertices that come to the card while the view goes on, for ways of filtering over them.
#include <QTest>

#include "render/filtering_study.h"
#include "tests/ui/viewport/streaming_view.h"

using namespace trixel;
using namespace trixel::ui;
using render::Filtering;

namespace {

/// Levels 2 to 6, and each texel of a colour of its own: what shows every level that is missing.
Project wildProject(int cells)
{
    Project project = gridProject(cells, 2);
    std::mt19937 random(4);
    const std::vector<std::byte> grey(3, std::byte{90});
    for (std::size_t f = 0; f < project.texels.faceCount(); ++f) {
        const Level level(2 + static_cast<int>(random() % 5));
        project.texels.exchange(faceId(f), FaceTexels::constant(level, grey));
        if (random() % 9 != 0) {
            for (std::byte& b : project.texels.writable(faceId(f))) {
                b = static_cast<std::byte>(random());
            }
        }
    }
    return project;
}

/// With all of them on the card, whatever the view.
QImage allVertices(StreamingView& view)
{
    StreamingView whole(view.project, 1024 * kMiB);
    whole.filter(view.scene.surface.filtering);
    whole.scene = view.scene;
    const Filtering filtering = view.scene.surface.filtering;
    whole.frame();
    whole.finish();
    render::prepareFilterings(*whole.renderer, whole.project.texels, std::span(&filtering, 1));
    return whole.offscreen.draw(*whole.renderer, whole.scene);
}

} // namespace

class TestVertexStreaming : public QObject
{
    Q_OBJECT

private slots:
    void aViewAtRestLooksAsIfAllWereThere_data()
    {
        QTest::addColumn<int>("filtering");
        QTest::addRow("seamless") << static_cast<int>(Filtering::Seamless);
        QTest::addRow("anisotropic") << static_cast<int>(Filtering::Anisotropic);
    }

    void aViewAtRestLooksAsIfAllWereThere()
    {
        QFETCH(int, filtering);
        StreamingView view(wildProject(16), 512 * kMiB);
        view.filter(static_cast<Filtering>(filtering));
        for (const double t : {0.1, 0.3, 0.37, 0.8}) {
            render::CameraPose pose = poseAt(t);
            pose.pitch = 0.2 + t;
            view.scene.camera.setPose(pose);
            view.frame();
            view.finish();
            QVERIFY(view.renderer->isFilterReady(view.scene.surface.filtering));
            const QImage seen = view.offscreen.draw(*view.renderer, view.scene);
            const auto* vertices = view.renderer->vertices(view.project.texels, render::Side::A);
            std::uint64_t all = 0;
            for (const render::FaceRecord& record : vertices->records()) {
                all += elementsOf(render::BlockKind::Vertices, Level(record.ownLevel()));
            }
            QVERIFY(!vertices->isReduced());
            QVERIFY(t > 0.1 || vertices->verticesUsed() < all); // later ones keep what is there
            const int off = farthest(seen, allVertices(view));
            QVERIFY2(off <= 1, qPrintable(QString::number(off)));
        }
    }

    void aFlightKeepsToTheBudgetAndLeavesNoHole()
    {
        for (const std::uint64_t budget : {2 * kMiB, 64 * kMiB}) {
            StreamingView view(noisyProject(24, 6), budget);
            view.filter(Filtering::Seamless);
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
                late += view.streaming.isBusy() ? 1 : 0;
                if (k % 12 == 11) {
                    // Texels of a face are of one colour: only where faces meet may what is coarser
                    // differ, and there it lies between theirs.
                    for (int y = 0; y < seen.height(); y += 7) {
                        for (int x = 0; x < seen.width(); x += 7) {
                            QVERIFY(seen.pixel(x, y) != qRgb(115, 115, 115)); // pending
                        }
                    }
                    view.finish();
                    const QImage complete = view.offscreen.draw(*view.renderer, view.scene);
                    QVERIFY(budget < 64 * kMiB || farthest(complete, allVertices(view)) <= 1);
                }
            }
            QVERIFY(late > 0);
            QVERIFY(!view.offscreen.hadErrors());
        }
    }

    /// From the first frame on something is shown: texels, then means, then what is wanted.
    void switchingShowsSomethingAtOnce()
    {
        StreamingView view(noisyProject(24, 6), 64 * kMiB);
        view.frame();
        view.finish();
        const QImage texels = view.offscreen.draw(*view.renderer, view.scene);
        view.filter(Filtering::Seamless);
        QVERIFY(farthest(texels, view.offscreen.draw(*view.renderer, view.scene)) == 0);
        for (int k = 0; k < 100 && !view.renderer->isFilterReady(Filtering::Seamless); ++k) {
            view.frame();
            QTest::qWait(5);
        }
        QVERIFY(view.renderer->isFilterReady(Filtering::Seamless));
        view.finish();
        QVERIFY(farthest(view.offscreen.draw(*view.renderer, view.scene), allVertices(view)) <= 1);
        // And back.
        view.filter(Filtering::Texels);
        view.frame();
        view.finish();
        QCOMPARE(view.offscreen.draw(*view.renderer, view.scene), texels);
    }

    void whatIsPaintedMeanwhileIsShown()
    {
        StreamingView view(wildProject(24), 256 * kMiB);
        view.filter(Filtering::Seamless);
        std::mt19937 random(2);
        for (int k = 0; k < 30; ++k) {
            view.scene.camera.setPose(poseAt(k / 60.0));
            std::vector<TouchedRect> rects;
            for (int n = 0; n < 20; ++n) {
                const FaceId face = faceId(random() % view.project.texels.faceCount());
                const bool wasConstant = view.project.texels.face(face).isConstant();
                const auto r =
                    static_cast<std::uint16_t>(view.project.texels.face(face).level().resolution());
                std::ranges::fill(view.project.texels.writable(face),
                                  static_cast<std::byte>(random()));
                rects.push_back({face, 0, 0, r, r, wasConstant});
            }
            view.streaming.texelsChanged();
            view.renderer->touchTexels(view.project.texels, rects);
            view.frame();
        }
        view.finish();
        QVERIFY(farthest(view.offscreen.draw(*view.renderer, view.scene), allVertices(view)) <= 1);
    }

    /// Where not all fits everything is coarser by as much: no edge opens.
    void whatDoesNotFitIsCoarserAlike()
    {
        StreamingView view(wildProject(16), 2 * kMiB);
        view.filter(Filtering::Seamless);
        view.scene.camera.setPose(poseAt(0));
        view.frame();
        view.finish();
        const auto* vertices = view.renderer->vertices(view.project.texels, render::Side::A);
        QVERIFY(vertices->isReduced());
        std::vector<render::Wish> wishes(view.project.texels.faceCount());
        render::wishesOf(
            render::vertexExtents(view.project.surface->mesh(), *view.filterMesh, Threads{1}),
            view.scene.camera,
            Threads{1},
            wishes);
        for (std::size_t f = 0; f < wishes.size(); ++f) {
            const render::FaceRecord& record = vertices->records()[f];
            const double finest = wishes[f] / 8.0 - vertices->viewCut(); // that is looked at
            QVERIFY(wishes[f] == render::kUnseen || record.isConstant() ||
                    record.level() >= std::min<double>(finest, record.ownLevel()));
        }
    }
};

QTEST_MAIN(TestVertexStreaming)
#include "tst_vertex_streaming.moc"
