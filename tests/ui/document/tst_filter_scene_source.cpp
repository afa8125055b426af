// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>

#include "tests/ui/fixtures.h"
#include "ui/document/document.h"
#include "ui/document/filter_scene_source.h"

#include <cstring>

namespace trixel::ui {

namespace {

constexpr std::array<float, 4> kRed{1, 0, 0, 1};

/// Values of all base-level texels and of all vertices at all levels.
std::vector<float> everything(const FilterScene& scene)
{
    std::vector<float> all;
    for (std::size_t f = 0; f < scene.faceCount(); ++f) {
        const Level level = scene.level(faceId(f));
        for (std::uint32_t t = 0; t < level.texelCount(); ++t) {
            const float* texel = scene.mips().texels(faceId(f), level).texel(TexelIndex{t});
            all.insert(all.end(), texel, texel + 3);
        }
        for (int n = 0; n <= level.log2(); ++n) {
            const LevelVertices vertices = scene.pyramid().vertices(faceId(f), Level(n));
            for (std::size_t k = 0; k < latticeVertexCount(Level(n)); ++k) {
                const float* vertex = vertices.values + vertices.stride * k;
                all.insert(all.end(), vertex, vertex + 3);
            }
        }
    }
    return all;
}

} // namespace

class FilterSceneSourceTest : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        m_jobs = std::make_unique<BackgroundJobs>();
        m_document = std::make_unique<Document>();
        m_source = std::make_unique<FilterSceneSource>(*m_document, *m_jobs);
        m_document->open(gridProject(4, 3), {}, "grid");
    }
    void cleanup()
    {
        m_source.reset();
        m_document.reset();
        m_jobs.reset();
    }

    void nothingIsBuiltUntilSomeoneNeedsIt()
    {
        QTest::qWait(30);
        QVERIFY(m_jobs->isIdle());
        QVERIFY(!m_source->scene());
        QCOMPARE(m_source->memoryBytes(), std::size_t{0});
        wantScene();
        QVERIFY(m_source->isCurrent());
        QVERIFY(m_source->memoryBytes() > 0);
    }

    void aBuildThatNobodyWantsAnyMoreIsCancelled()
    {
        m_source->want(m_who, true);
        BackgroundJob* building = m_jobs->latest();
        QVERIFY(building != nullptr);
        m_source->want(m_who, false);
        QVERIFY(building->isCancelled());
        wantScene(); // and another comes
        QVERIFY(m_source->isCurrent());
    }

    void whenTheLastLeavesTheSceneIsGivenUp()
    {
        QObject second;
        wantScene();
        m_source->want(second, true);
        m_source->want(m_who, false);
        QVERIFY(m_source->scene());
        m_source->want(second, false);
        QVERIFY(!m_source->scene());
        {
            QObject shortLived;
            m_source->want(shortLived, true);
            QTRY_VERIFY(m_source->scene());
        }
        QVERIFY(!m_source->scene());
    }

    void whoDiesHearsNothingMore()
    {
        int heard = 0;
        auto who = std::make_unique<QObject>();
        m_source->want(*who, true);
        QTRY_VERIFY(m_source->scene());
        connect(m_source.get(), &FilterSceneSource::changed, who.get(), [&heard] { ++heard; });
        who.reset();
        QVERIFY(!m_source->scene());
        QCOMPARE(heard, 0);
    }

    void followsPaintAndEqualsASceneBuiltAnew()
    {
        wantScene();
        const auto before = m_source->scene();
        const std::vector<float> valuesBefore = everything(*before);
        m_document->fillFaces(std::array{faceId(5), faceId(6)}, kRed);
        QVERIFY(!m_source->isCurrent());
        QTRY_VERIFY(m_source->isCurrent());
        QVERIFY(m_source->scene() != before);
        QCOMPARE(everything(*before), valuesBefore); // whoever still reads it is not disturbed
        QCOMPARE(everything(*m_source->scene()), everything(builtAnew()));
        m_document->undoStack().undo();
        QTRY_VERIFY(m_source->isCurrent());
        QCOMPARE(everything(*m_source->scene()), valuesBefore);
    }

    void changesDuringTheBuildingAreNotLost()
    {
        m_source->want(m_who, true);
        m_document->fillFaces(std::array{faceId(3)}, kRed);
        QTRY_VERIFY(m_source->isCurrent());
        QCOMPARE(everything(*m_source->scene()), everything(builtAnew()));
    }

    void aChangeOfEverythingBuildsAnew()
    {
        wantScene();
        std::vector<FaceId> all;
        for (std::uint32_t f = 0; f < m_document->texels().faceCount(); ++f) {
            all.push_back(FaceId{f});
        }
        m_document->fillFaces(all, kRed);
        m_document->fillFaces(std::array{faceId(1)}, {0, 0, 1, 1});
        m_document->undoStack().undo();
        QTRY_VERIFY(m_source->isCurrent());
        QCOMPARE(everything(*m_source->scene()), everything(builtAnew()));
    }

    void anotherDocumentTakesThePlaceOfTheFirst()
    {
        wantScene();
        m_document->open(gridProject(3, 2), {}, "other");
        QVERIFY(!m_source->scene());
        QTRY_VERIFY(m_source->scene());
        QCOMPARE(m_source->scene()->faceCount(), std::size_t{18});
    }

    void rangeFollowsThePaint()
    {
        wantScene();
        QCOMPARE(m_source->valueRange(), 0.0);
        m_document->fillFaces(std::array{faceId(3)}, {0.8F, 0, 0, 1});
        QTRY_VERIFY(m_source->isCurrent());
        QVERIFY(std::abs(m_source->valueRange() - 0.8) < 0.003);
    }

    void memoryIsNoMoreThanForetold()
    {
        Brush brush;
        brush.radius = 1.5F;
        brush.hardness = 0;
        m_document->beginStroke(brush); // most faces hold every texel
        m_document->extendStroke({faceId(9), {0.3F, 0.3F}, 1.0F, 0.0});
        m_document->endStroke();
        wantScene();
        const std::uint64_t expected = FilterSceneSource::expectedBytes(m_document->texels());
        QVERIFY2(m_source->memoryBytes() < 2 * expected,
                 qPrintable(QString("%1 of %2").arg(m_source->memoryBytes()).arg(expected)));
        QVERIFY(m_source->memoryBytes() > expected / 4);
    }

    void cancellingTheBuildingRefusesEveryone()
    {
        QSignalSpy refused(m_source.get(), &FilterSceneSource::refused);
        m_source->want(m_who, true);
        m_jobs->latest()->cancel();
        QTRY_COMPARE(refused.count(), 1);
        QVERIFY(!m_source->scene());
        QTest::qWait(60);
        QVERIFY(m_jobs->isIdle());
        wantScene(); // and may be asked again
    }

private:
    void wantScene()
    {
        m_source->want(m_who, true);
        QTRY_VERIFY(m_source->isCurrent());
    }
    FilterScene builtAnew() const
    {
        NoProgress progress;
        const Surface& surface = *m_document->surface();
        auto shape = std::make_shared<const FilterSurface>(
            FilterSurface::fromMesh(surface.mesh(), surface.adjacency()));
        return *FilterScene::build(shape, m_document->texels(), Threads{1}, progress);
    }

    QObject m_who;
    std::unique_ptr<BackgroundJobs> m_jobs;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<FilterSceneSource> m_source;
};

} // namespace trixel::ui

QTEST_MAIN(trixel::ui::FilterSceneSourceTest)
#include "tst_filter_scene_source.moc"
