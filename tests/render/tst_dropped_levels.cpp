// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texels that are shown coarser than they are filter as texels of that size do.
#include <QTest>

#include "core/texture/coarser_levels.h"
#include "render/filtering_study.h"
#include "tests/render/filtering_views.h"
#include "tests/render/offscreen.h"

#include <algorithm>
#include <cmath>

using namespace trixel;
using namespace trixel::render;

namespace {

/// What a store looks like that many levels coarser, by texels of that size.
TexelStore coarser(const TexelStore& store, int drop)
{
    FaceMap<Level> levels(store.faceCount());
    for (std::size_t f = 0; f < levels.size(); ++f) {
        levels[faceId(f)] = store.face(faceId(f)).level().coarser(drop);
    }
    TexelStore result(store.format(), levels, std::vector<std::byte>(3));
    for (std::size_t f = 0; f < levels.size(); ++f) {
        const FaceTexels& face = store.face(faceId(f));
        const Level level = levels[faceId(f)];
        result.exchange(faceId(f),
                        level == face.level() ? face
                                              : CoarserLevels::of(store.format(), face).at(level));
    }
    return result;
}

/// Of numbers that both pictures show, in parts of 255.
struct Difference
{
    double rms = 0;
    double worst = 0;
};

Difference differenceOf(const DrawnPicture& a, const DrawnPicture& b)
{
    Difference off;
    for (std::size_t k = 0; k < a.values.size(); ++k) {
        const double one = 255 * std::abs(double{a.values[k]} - double{b.values[k]});
        off.rms += one * one;
        off.worst = std::max(off.worst, one);
    }
    off.rms = std::sqrt(off.rms / static_cast<double>(a.values.size()));
    return off;
}

} // namespace

class TestDroppedLevels : public QObject
{
    Q_OBJECT

private slots:
    void bothSidesFilterByTheTexelsThatTheyShow_data()
    {
        QTest::addColumn<int>("drop");
        QTest::addColumn<double>("distance");
        for (const int drop : {0, 1, 2}) {
            for (const double distance : {0.2, 0.5, 1.0}) {
                QTest::addRow("%d levels, %g", drop, distance) << drop << distance;
            }
        }
    }

    void bothSidesFilterByTheTexelsThatTheyShow()
    {
        QFETCH(int, drop);
        QFETCH(double, distance);
        Offscreen offscreen(kSide, kSide);
        QVERIFY2(offscreen.isValid(), "OpenGL 4.1 core is needed");
        offscreen.bind();
        const auto gl = currentGl();
        Shown shown = torus();
        const TriangleMesh& mesh = shown.surface->mesh();
        shown.store = noiseStore(mixedLevels(mesh.faceCount(), 3, 4, 7), 5);
        shown.scene = sceneOf(*shown.surface, kSide, {{}, 1.0, 0.4, distance});
        const TexelStore small = coarser(shown.store, drop);
        const auto renderer = rendererOf(*shown.surface, shown.store);
        const auto other = rendererOf(*shown.surface, small);
        renderer->setTexels(shown.store, drop, Side::B);
        for (const Filtering filtering : {Filtering::Seamless, Filtering::Anisotropic}) {
            prepareFilterings(*renderer, shown.store, std::span(&filtering, 1));
            renderer->uploadTexels(shown.store, std::size_t{1} << 30U, Side::B);
            renderer->uploadFilters(shown.store, std::size_t{1} << 30U, Side::B);
            prepareFilterings(*other, small, std::span(&filtering, 1));
            QVERIFY(renderer->isFilterReady(filtering, Side::B));
            Scene scene = shown.scene;
            scene.surface.filtering = filtering;
            const DrawnPicture expected = drawNumbers(*gl, *other, scene);
            scene.split = Split{};
            scene.split->ownTexels = true;
            const Difference b = differenceOf(drawNumbers(*gl, *renderer, scene), expected);
            qInfo() << nameOf(filtering) << "RMS" << b.rms << "of 255, at most" << b.worst;
            // Means of means are rounded once, those of coarser texels at every level.
            QVERIFY(b.rms <= 0.25);
            QVERIFY(b.worst <= 2);
        }
    }
};

QTEST_MAIN(TestDroppedLevels)
#include "tst_dropped_levels.moc"
