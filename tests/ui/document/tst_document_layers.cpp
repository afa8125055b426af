// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>

#include "core/layers/layer_edits.h"
#include "tests/ui/document/layered_fixture.h"
#include "ui/document/background_job.h"
#include "ui/document/layer_paint.h"

#include <algorithm>
#include <random>
#include <set>

namespace trixel::ui {

namespace {

Brush brushOf(float red, BlendMode blend = BlendMode::Normal)
{
    Brush brush;
    brush.radius = 0.15F;
    brush.flow = 0.6F;
    brush.opacity = 0.8F;
    brush.color = {red, 0.3F, 1 - red, 1};
    brush.blend = blend;
    return brush;
}

void extendAcross(Document& document)
{
    for (const std::uint32_t face : {0U, 2U, 38U, 46U}) {
        document.extendStroke({FaceId{face}, {0.3F, 0.3F}, 1.0F, 0.1 * face});
    }
}

void paint(Document& document, const Brush& brush, StrokePace pace = StrokePace::AtOnce)
{
    document.beginStroke(brush, pace);
    extendAcross(document);
    document.endStroke();
}

std::set<FaceId> facesTold(const QSignalSpy& changed)
{
    std::set<FaceId> faces;
    for (const QList<QVariant>& call : changed) {
        for (const TouchedRect& rect : call.at(0).value<Change>().rects) {
            faces.insert(rect.face);
        }
    }
    return faces;
}

} // namespace

class DocumentLayersTest : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<Document> m_document;
    LayersPicture m_before;

    QUndoStack& stack() { return m_document->undoStack(); }
    LayersPicture picture() const { return pictureOf(*m_document); }
    void waitUntilSettled() { QTRY_VERIFY_WITH_TIMEOUT(!m_document->isSettling(), 20'000); }
    /// So many faces that layers are put together on another thread.
    void openMany() { m_document->open(gridProject(120, 2), {}, "many"); }

    void undoAllAndRedoAll(const std::vector<LayersPicture>& steps,
                           const std::vector<StateId>& states)
    {
        for (std::size_t k = steps.size() - 1; k > 0; --k) {
            stack().undo();
            waitUntilSettled();
            QVERIFY(picture() == steps[k - 1]);
            QCOMPARE(m_document->state(), states[k - 1]);
            QVERIFY(isShown(*m_document));
        }
        for (std::size_t k = 1; k < steps.size(); ++k) {
            stack().redo();
            waitUntilSettled();
            QVERIFY(picture() == steps[k]);
            QCOMPARE(m_document->state(), states[k]);
        }
    }

    /// One edit of the stack; what makes no sense for it does nothing.
    void editAtRandom(std::mt19937& random)
    {
        const std::span<const Layer> layers = m_document->layers().layers();
        const std::size_t at = layers.empty() ? 0 : random() % layers.size();
        switch (layers.empty() ? 0 : random() % 7) {
        case 0:
            addLayer(*m_document, "L" + std::to_string(random() % 100));
            break;
        case 1:
            setOpacity(*m_document, layers[at].id, static_cast<float>(random() % 5) / 4);
            break;
        case 2:
            setVisible(*m_document, layers[at].id, !layers[at].settings.isVisible);
            break;
        case 3: {
            LayerSettings settings = layers[at].settings;
            settings.blend = kLayerBlends[random() % kLayerBlends.size()];
            setLayer(*m_document, layers[at].id, settings);
            break;
        }
        case 4: {
            LayerStack next = m_document->layers();
            next.move(layers[at].id, random() % layers.size());
            m_document->editLayers(std::move(next), m_document->activeLayer(), "Move layer");
            break;
        }
        case 5:
            removeLayer(*m_document, layers[at].id);
            break;
        default:
            if (layers[at].settings.isVisible) {
                NoProgress progress;
                LayerStack next =
                    mergedDown(m_document->layers(), layers[at].id, Threads::all(), progress)
                        .value();
                const LayerId active =
                    next.isPlain() ? kBaseLayer : next.layers()[random() % next.layers().size()].id;
                m_document->editLayers(std::move(next), active, "Merge down");
            }
        }
    }

    void paintAtRandom(std::mt19937& random)
    {
        const auto layers = m_document->layers().layers();
        const std::size_t at = random() % (layers.size() + 1);
        m_document->setActiveLayer(at == layers.size() ? kBaseLayer : layers[at].id);
        const float red = static_cast<float>(random() % 100) / 100;
        switch (random() % 4) {
        case 0:
            paint(*m_document, brushOf(red, BlendMode::Erase));
            break;
        case 1:
            m_document->fillFaces(
                std::array{FaceId{static_cast<std::uint32_t>(random() % 60)}, FaceId{61}},
                {red, red, 0, 1});
            break;
        case 2:
            paint(*m_document, brushOf(red), StrokePace::Behind);
            waitUntilSettled();
            break;
        default:
            paint(*m_document, brushOf(red));
        }
    }

private slots:
    void init()
    {
        m_document = std::make_unique<Document>();
        m_document->open(gridProject(8, 4), {}, "grid");
        m_before = picture();
    }
    void cleanup() { m_document.reset(); }

    void aProjectHasNoLayersUntilOneIsAddedWhichIsThenPainted()
    {
        QVERIFY(m_document->layers().isPlain());
        QCOMPARE(m_document->activeLayer(), kBaseLayer);
        QSignalSpy changed(m_document.get(), &Document::layersChanged);
        QSignalSpy active(m_document.get(), &Document::activeLayerChanged);
        const StateId before = m_document->state();
        const LayerId layer = addLayer(*m_document, "Layer 1");
        QCOMPARE(m_document->activeLayer(), layer);
        QCOMPARE(m_document->layers().layers().size(), std::size_t{1});
        QVERIFY(m_document->state().texels != before.texels);
        QVERIFY(m_document->isModified());
        QCOMPARE(changed.size(), 1);
        QCOMPARE(active.size(), 1);
        QVERIFY(m_document->snapshot().layers.has(layer));
        QCOMPARE(picture().shown, m_before.shown);
        stack().undo();
        QVERIFY(picture() == m_before);
        QCOMPARE(m_document->activeLayer(), kBaseLayer);
        QCOMPARE(m_document->state(), before);
        QVERIFY(!m_document->isModified());
        stack().redo();
        QCOMPARE(m_document->activeLayer(), layer);
    }

    void aStrokePaintsTheActiveLayerAndNothingElse()
    {
        const LayerId lower = addLayer(*m_document, "Layer 1");
        const LayerId upper = addLayer(*m_document, "Layer 2");
        m_document->setActiveLayer(lower);
        paint(*m_document, brushOf(1));
        const LayersPicture painted = picture();
        QVERIFY(painted.shown != m_before.shown);
        QCOMPARE(painted.texels[0], m_before.shown); // the base
        QVERIFY(painted.texels[1] != painted.texels[2]);
        QVERIFY(isShown(*m_document));
        m_document->setActiveLayer(upper);
        stack().undo(); // of the layer that was painted, whichever is active now
        QCOMPARE(picture().shown, m_before.shown);
        QVERIFY(isShown(*m_document));
        stack().redo();
        QVERIFY(picture() == painted);
    }

    void whatAStrokeChangesIsToldFaceByFace()
    {
        const LayerId layer = addLayer(*m_document, "Layer 1");
        setOpacity(*m_document, layer, 0.5F);
        const TexelStore before = m_document->texels();
        QSignalSpy changed(m_document.get(), &Document::changed);
        paint(*m_document, brushOf(1));
        QCOMPARE(facesTold(changed), facesThatDiffer(before, m_document->texels()));
        const TexelStore painted = m_document->texels();
        changed.clear();
        stack().undo();
        QCOMPARE(facesTold(changed), facesThatDiffer(before, painted));
    }

    void firstPaintOnAFineFaceIsPutTogetherOnlyWhereItLies()
    {
        const Project project = gridProject(1, 6);
        TexelStore shown = project.texels;
        (void)shown.writable(FaceId{0});
        LayerStack layers(shown);
        const LayerId layer = layers.insert(0, {});
        const std::size_t far = shown.face(FaceId{0}).level().texelCount() - 1;
        const std::vector<std::byte> mark(shown.format().texelBytes(), std::byte{77});
        std::ranges::copy(mark, shown.writable(FaceId{0}).last(mark.size()).begin());
        Stroke stroke(project.surface, brushOf(1), Ground::layer());
        auto rects = stroke.add({FaceId{0}, {0.3F, 0.3F}, 1, 0}, layers.texels(layer));
        QVERIFY(rects.front().face == FaceId{0} && rects.front().wholeFace);
        rects = showPaint(layers, {rects.front()}, shown);
        QVERIFY(!rects.front().wholeFace && rects.front().width < 64);
        QVERIFY(std::ranges::equal(shown.face(FaceId{0}).texel(far), mark)); // left alone
        QVERIFY(shown.face(FaceId{0}) != layers.base().face(FaceId{0}));
        std::ranges::copy(layers.base().face(FaceId{0}).texel(far),
                          shown.writable(FaceId{0}).last(mark.size()).begin());
        NoProgress progress;
        QVERIFY(shown.face(FaceId{0}) ==
                composed(layers, Threads::all(), progress)->shown.face(FaceId{0}));
    }

    void erasingALayerShowsWhatLiesBelowToTheBit()
    {
        addLayer(*m_document, "Layer 1");
        m_document->fillFaces(std::array{FaceId{3}, FaceId{4}}, kLayerBlue);
        QVERIFY(picture().shown != m_before.shown);
        Brush eraser = brushOf(0, BlendMode::Erase);
        eraser.radius = 10;
        eraser.hardness = 1;
        eraser.opacity = eraser.flow = 1;
        paint(*m_document, eraser);
        QCOMPARE(picture().shown, m_before.shown);
        QVERIFY(isShown(*m_document));
    }

    void aHiddenLayerIsNotPainted()
    {
        const LayerId layer = addLayer(*m_document, "Layer 1");
        setVisible(*m_document, layer, false);
        const LayersPicture hidden = picture();
        QSignalSpy notice(m_document.get(), &Document::notice);
        paint(*m_document, brushOf(1));
        m_document->fillFaces(std::array{FaceId{3}}, kLayerBlue);
        QCOMPARE(notice.size(), 2);
        QCOMPARE(notice[0][0].toString(),
                 QStringLiteral("Layer 1 is hidden: show it to paint on it."));
        QVERIFY(picture() == hidden);
        QVERIFY(!m_document->hasStroke());
    }

    void allLayersRemovedTheBaseIsWhatIsShown()
    {
        const LayerId layer = addLayer(*m_document, "Layer 1");
        paint(*m_document, brushOf(1));
        const LayersPicture painted = picture();
        removeLayer(*m_document, layer);
        QVERIFY(m_document->layers().isPlain());
        QVERIFY(picture() == m_before);
        paint(*m_document, brushOf(0.5F)); // the texels themselves
        QVERIFY(picture().shown != m_before.shown);
        stack().undo();
        stack().undo();
        QVERIFY(picture() == painted);
    }

    void aRandomProgramIsUndoneAndRedoneToTheBit_data()
    {
        QTest::addColumn<unsigned>("seed");
        for (const unsigned seed : {1U, 2U, 3U, 4U}) {
            QTest::addRow("%u", seed) << seed;
        }
    }
    void aRandomProgramIsUndoneAndRedoneToTheBit()
    {
        QFETCH(unsigned, seed);
        std::mt19937 random(seed);
        std::vector<LayersPicture> steps{picture()};
        std::vector<StateId> states{m_document->state()};
        while (steps.size() < 40) {
            const int count = stack().count();
            if (random() % 3 == 0) {
                editAtRandom(random);
            } else {
                paintAtRandom(random);
            }
            waitUntilSettled();
            QVERIFY(isShown(*m_document));
            if (stack().count() > count) { // it came to something
                steps.push_back(picture());
                states.push_back(m_document->state());
            }
        }
        undoAllAndRedoAll(steps, states);
        undoAllAndRedoAll(steps, states);
    }

    void aDragOfTheOpacityIsOneStep()
    {
        const LayerId layer = addLayer(*m_document, "Layer 1");
        paint(*m_document, brushOf(1));
        const LayersPicture painted = picture();
        const int count = stack().count();
        setOpacity(*m_document, layer, 0.9F);
        for (const float opacity : {0.8F, 0.8F, 0.5F, 0.3F}) {
            setOpacity(*m_document, layer, opacity, true);
            QVERIFY(isShown(*m_document));
        }
        QCOMPARE(stack().count(), count + 1);
        const LayersPicture dragged = picture();
        QCOMPARE(dragged.settings[0].opacity, 0.3F);
        stack().undo();
        QVERIFY(picture() == painted);
        stack().redo();
        QVERIFY(picture() == dragged);
        const LayerId other = addLayer(*m_document, "Layer 2");
        setOpacity(*m_document, other, 0.4F, true); // not a drag of that
        QCOMPARE(stack().count(), count + 3);
    }

    void anotherNameChangesNothingThatIsShown()
    {
        const LayerId layer = addLayer(*m_document, "Layer 1");
        m_document->markSaved("grid.trixel", m_document->state());
        QSignalSpy changed(m_document.get(), &Document::changed);
        LayerSettings settings = m_document->layers().settings(layer);
        settings.name = "Rust";
        setLayer(*m_document, layer, settings);
        QCOMPARE(changed.size(), 0);
        QVERIFY(m_document->isModified());
        stack().undo();
        QCOMPARE(m_document->layers().settings(layer).name, std::string("Layer 1"));
        QVERIFY(!m_document->isModified());
    }

    void paintedBehindALayerIsThatOfAStrokePaintedAtOnce()
    {
        const LayerId layer = addLayer(*m_document, "Layer 1");
        setOpacity(*m_document, layer, 0.6F);
        const LayersPicture before = picture();
        QSignalSpy placed(m_document.get(), &Document::dabsPlaced);
        paint(*m_document, brushOf(1), StrokePace::Behind);
        QVERIFY(m_document->isSettling());
        QCOMPARE(placed.size(), 0); // half of it would be seen
        waitUntilSettled();
        QVERIFY(isShown(*m_document));
        const LayersPicture behind = picture();
        stack().undo();
        QVERIFY(picture() == before);
        stack().redo();
        QVERIFY(picture() == behind);
        stack().undo();
        paint(*m_document, brushOf(1));
        QVERIFY(picture() == behind);
    }

    void dabsAreShownBeforeTheyAreThereOnlyWhereTheyLookAlike()
    {
        QSignalSpy placed(m_document.get(), &Document::dabsPlaced);
        const auto isPreviewed = [&](const Brush& brush) {
            placed.clear();
            paint(*m_document, brush, StrokePace::Behind);
            waitUntilSettled();
            return !placed.empty();
        };
        QVERIFY(isPreviewed(brushOf(1)));
        const LayerId lower = addLayer(*m_document, "Layer 1");
        QVERIFY(isPreviewed(brushOf(1)));
        QVERIFY(!isPreviewed(brushOf(1, BlendMode::Erase)));
        const LayerId upper = addLayer(*m_document, "Layer 2");
        QVERIFY(isPreviewed(brushOf(0.5F)));
        m_document->setActiveLayer(lower);
        QVERIFY(!isPreviewed(brushOf(0.2F)));
        m_document->setActiveLayer(kBaseLayer);
        QVERIFY(!isPreviewed(brushOf(0.3F)));
        setVisible(*m_document, upper, false);
        m_document->setActiveLayer(lower);
        QVERIFY(isPreviewed(brushOf(0.4F)));
        LayerSettings settings = m_document->layers().settings(lower);
        settings.blend = LayerBlend::Multiply;
        setLayer(*m_document, lower, settings);
        QVERIFY(!isPreviewed(brushOf(0.6F)));
    }

    void undoneWhileItSettlesAStrokeOnALayerCanBeRedone()
    {
        addLayer(*m_document, "Layer 1");
        const LayersPicture before = picture();
        paint(*m_document, brushOf(1));
        const LayersPicture painted = picture();
        stack().undo();
        paint(*m_document, brushOf(1), StrokePace::Behind);
        stack().undo();
        QVERIFY(picture() == before);
        QTest::qWait(100); // it is made all the same
        QVERIFY(picture() == before);
        stack().redo();
        waitUntilSettled();
        QVERIFY(picture() == painted);
        paint(*m_document, brushOf(0.4F), StrokePace::Behind);
        stack().undo();
        stack().redo(); // before it is there
        waitUntilSettled();
        QVERIFY(isShown(*m_document));
        stack().undo();
        QVERIFY(picture() == painted);
    }

    void layersAreNotEditedWhileAStrokeSettles()
    {
        const LayerId layer = addLayer(*m_document, "Layer 1");
        paint(*m_document, brushOf(1), StrokePace::Behind);
        QSignalSpy notice(m_document.get(), &Document::notice);
        QVERIFY(!setOpacity(*m_document, layer, 0.5F));
        QCOMPARE(notice.size(), 1);
        bool isDone = false;
        m_document->whenPainted([&] { isDone = setOpacity(*m_document, layer, 0.5F); });
        QVERIFY(!isDone);
        waitUntilSettled();
        QVERIFY(isDone);
        QVERIFY(isShown(*m_document));
    }

    void onAGreatMeshLayersAreThereAtOnceAndTheirLookFollows()
    {
        openMany();
        const std::vector<std::byte> plain = picture().shown;
        const LayerId layer = addLayer(*m_document, "Layer 1");
        QVERIFY(m_document->isSettling());
        waitUntilSettled();
        paint(*m_document, brushOf(1));
        const LayersPicture painted = picture();
        const StateId before = m_document->state();
        QSignalSpy changed(m_document.get(), &Document::changed);
        setVisible(*m_document, layer, false);
        QVERIFY(!m_document->layers().settings(layer).isVisible);
        QVERIFY(m_document->isSettling());
        QVERIFY(m_document->isModified());
        QCOMPARE(m_document->state(), before); // until it is what it will be
        QVERIFY(picture().shown == painted.shown);
        waitUntilSettled();
        QVERIFY(picture().shown == plain);
        QVERIFY(m_document->state() != before);
        QCOMPARE(changed.size(), 1);
        const Change told = changed[0][0].value<Change>();
        QVERIFY(!told.rects.empty() && told.rects.size() < 10'000); // those that were painted
        stack().undo();
        QVERIFY(!m_document->isSettling()); // it is known
        QVERIFY(picture() == painted);
        stack().redo();
        QVERIFY(!m_document->isSettling());
        QVERIFY(picture().shown == plain);
    }

    /// The layer itself holds one value a face; what lies below is what takes time.
    void aFillOverFinePaintIsWorkedOutElsewhere()
    {
        Project project = gridProject(1, 10);
        for (const FaceId face : {FaceId{0}, FaceId{1}}) {
            (void)project.texels.writable(face);
        }
        m_document->open(std::move(project), {}, "fine");
        const LayerId layer = addLayer(*m_document, "Layer 1");
        QVERIFY(!m_document->isSettling()); // it covers nothing
        m_document->fillFaces(std::array{FaceId{0}, FaceId{1}}, kLayerBlue);
        const LayersPicture filled = picture();
        setOpacity(*m_document, layer, 0.5F);
        QVERIFY(m_document->isSettling());
        waitUntilSettled();
        QVERIFY(isShown(*m_document));
        stack().undo();
        QVERIFY(picture() == filled);
        setVisible(*m_document, layer, false);
        QVERIFY(!m_document->isSettling()); // it is not looked at
        QVERIFY(isShown(*m_document));
    }

    void aDragOnAGreatMeshEndsWithTheLastAndIsOneStep()
    {
        openMany();
        const LayerId layer = addLayer(*m_document, "Layer 1");
        waitUntilSettled();
        paint(*m_document, brushOf(1));
        const LayersPicture painted = picture();
        const int count = stack().count();
        for (int k = 99; k > 30; --k) {
            setOpacity(*m_document, layer, static_cast<float>(k) / 100, k < 99);
            QTest::qWait(k % 3);
        }
        QCOMPARE(m_document->layers().settings(layer).opacity, 0.31F);
        waitUntilSettled();
        QCOMPARE(stack().count(), count + 1);
        QVERIFY(isShown(*m_document));
        stack().undo();
        QVERIFY(picture() == painted);
    }

    void whatIsWorkedOutIsAJobAndCancellingItLeavesWhatWasThere()
    {
        BackgroundJobs jobs;
        m_document->useJobs(jobs);
        openMany();
        const LayerId layer = addLayer(*m_document, "Layer 1");
        QVERIFY(jobs.latest() && !jobs.latest()->title().isEmpty());
        waitUntilSettled();
        QVERIFY(jobs.isIdle());
        paint(*m_document, brushOf(1));
        const LayersPicture painted = picture();
        const StateId before = m_document->state();
        QSignalSpy notice(m_document.get(), &Document::notice);
        setOpacity(*m_document, layer, 0.5F);
        setVisible(*m_document, layer, false);
        jobs.latest()->cancel();
        bool isDone = false;
        m_document->whenSettled([&] { isDone = true; });
        waitUntilSettled();
        QVERIFY(picture() == painted);
        QCOMPARE(m_document->state(), before);
        QVERIFY(isDone);
        QCOMPARE(notice.size(), 0); // nobody is told what they chose
        stack().redo();
        stack().redo();
        waitUntilSettled();
        QVERIFY(!m_document->layers().settings(layer).isVisible);
        QVERIFY(isShown(*m_document));
        m_document.reset(); // before the jobs
    }

    void editsUndoneBeforeTheirLookIsThereLeaveWhatWasThere()
    {
        openMany();
        const LayerId layer = addLayer(*m_document, "Layer 1");
        waitUntilSettled();
        paint(*m_document, brushOf(1));
        const LayersPicture painted = picture();
        const StateId before = m_document->state();
        for (int round = 0; round < 4; ++round) {
            const auto wait = [=] {
                if (round > 0) {
                    QTest::qWait(round); // looks may come to be known
                }
            };
            setOpacity(*m_document, layer, 0.5F);
            setVisible(*m_document, layer, false); // its step knows no look of the one before
            wait();
            stack().undo();
            QCOMPARE(m_document->layers().settings(layer).opacity, 0.5F);
            QVERIFY(m_document->layers().settings(layer).isVisible);
            wait();
            stack().undo();
            QVERIFY(picture() == painted);
            QCOMPARE(m_document->state(), before);
            QVERIFY(!m_document->isSettling());
            stack().redo();
            stack().redo();
            QVERIFY(round > 0 || m_document->isSettling());
            waitUntilSettled();
            QVERIFY(isShown(*m_document));
            stack().undo();
            waitUntilSettled();
            QVERIFY(isShown(*m_document));
            stack().undo();
            waitUntilSettled();
            QVERIFY(picture() == painted);
        }
    }

    void aStrokeBelowAnEditIsUndoneWhileTheLookOfThatIsWorkedOut()
    {
        openMany();
        const LayerId layer = addLayer(*m_document, "Layer 1");
        waitUntilSettled();
        const LayersPicture empty = picture();
        paint(*m_document, brushOf(1));
        setOpacity(*m_document, layer, 0.5F);
        setOpacity(*m_document, layer, 0.4F);
        stack().undo(); // no look of it is known
        stack().undo();
        stack().undo(); // the stroke
        waitUntilSettled();
        QVERIFY(picture() == empty);
        stack().redo();
        stack().redo();
        stack().redo();
        waitUntilSettled();
        QCOMPARE(m_document->layers().settings(layer).opacity, 0.4F);
        QVERIFY(isShown(*m_document));
    }

    void strokesBegunWhileLayersAreWorkedOutFollowInOrder()
    {
        openMany();
        const LayerId layer = addLayer(*m_document, "Layer 1");
        waitUntilSettled();
        std::vector<LayersPicture> steps{picture()};
        std::vector<StateId> states{m_document->state()};
        setOpacity(*m_document, layer, 0.5F);
        QVERIFY(m_document->isSettling());
        paint(*m_document, brushOf(1));
        m_document->fillFaces(std::array{FaceId{7}}, kLayerBlue);
        QSignalSpy notice(m_document.get(), &Document::notice);
        QVERIFY(!setOpacity(*m_document, layer, 0.2F, true)); // they are not in there yet
        QCOMPARE(notice.size(), 1);
        waitUntilSettled();
        QVERIFY(isShown(*m_document));
        QCOMPARE(stack().count(), 4);
        for (int k = 0; k < 3; ++k) {
            steps.insert(steps.begin() + 1, picture());
            states.insert(states.begin() + 1, m_document->state());
            stack().undo();
            waitUntilSettled();
        }
        QVERIFY(picture() == steps[0]);
        QCOMPARE(m_document->state(), states[0]);
        for (int k = 0; k < 3; ++k) {
            stack().redo();
            waitUntilSettled();
        }
        undoAllAndRedoAll(steps, states);
    }

    void veryManyFacesOfALayerAreFilledBehind()
    {
        openMany();
        const LayerId layer = addLayer(*m_document, "Layer 1");
        waitUntilSettled();
        const LayersPicture before = picture();
        std::vector<FaceId> faces;
        for (std::uint32_t k = 5; k < 28'000; ++k) {
            faces.push_back(FaceId{k});
        }
        m_document->fillFaces(faces, kLayerBlue);
        QVERIFY(m_document->isSettling());
        waitUntilSettled();
        QVERIFY(isShown(*m_document));
        QVERIFY(m_document->layers().texels(layer).face(FaceId{9}).isConstant());
        QVERIFY(m_document->texels().face(FaceId{9}).isConstant());
        stack().undo();
        QVERIFY(picture() == before);
    }

    void whoWaitsForLayersGetsWhatTheyLookLike()
    {
        openMany();
        addLayer(*m_document, "Layer 1");
        bool isDone = false;
        m_document->whenSettled([&] {
            isDone = true;
            QVERIFY(isShown(*m_document));
        });
        QVERIFY(!isDone);
        QTRY_VERIFY(isDone);
        addLayer(*m_document, "Layer 2");
        isDone = false;
        m_document->whenSettled([&] { isDone = true; });
        stack().undo(); // nothing is worked out any more
        QTRY_VERIFY(isDone);
    }

    void changesMadeForOtherLayersAreRefused()
    {
        const LayerId layer = addLayer(*m_document, "Layer 1");
        const StateId state = m_document->state();
        LayersEdit edit{{m_document->texels(), m_document->layers()}, layer, false};
        setOpacity(*m_document, layer, 0.5F);
        QSignalSpy notice(m_document.get(), &Document::notice);
        QVERIFY(!m_document->replaceLayers(std::move(edit), state, "Late"));
        QCOMPARE(notice.size(), 1);
    }

    void levelsOfAllLayersChangeInOneStep()
    {
        const LayerId layer = addLayer(*m_document, "Layer 1");
        paint(*m_document, brushOf(1));
        const LayersPicture painted = picture();
        NoProgress progress;
        const auto& adjacency = m_document->surface()->adjacency();
        const FaceMap<Level> levels(m_document->texels().faceCount(), Level(2));
        auto next =
            withLevels(m_document->layers(), adjacency, levels, Threads::all(), progress).value();
        Layered all = composed(std::move(next), Threads::all(), progress).value();
        QSignalSpy levelsChanged(m_document.get(), &Document::levelsChanged);
        QVERIFY(m_document->replaceLayers(
            {std::move(all), layer, true}, m_document->state(), "Coarser"));
        QCOMPARE(levelsChanged.size(), 1);
        QVERIFY(isShown(*m_document));
        paint(*m_document, brushOf(0.5F));
        QVERIFY(isShown(*m_document));
        stack().undo();
        stack().undo();
        QCOMPARE(levelsChanged.size(), 2);
        QVERIFY(picture() == painted);
    }

    void anotherProjectForgetsLayersThatWereWorkedOut()
    {
        openMany();
        addLayer(*m_document, "Layer 1");
        QVERIFY(m_document->isSettling());
        m_document->open(gridProject(3, 2), {}, "other");
        QVERIFY(!m_document->isSettling());
        QVERIFY(m_document->layers().isPlain());
        QCOMPARE(m_document->activeLayer(), kBaseLayer);
        const LayersPicture other = picture();
        QTest::qWait(100);
        QVERIFY(picture() == other);
        QVERIFY(!m_document->isModified());
        addLayer(*m_document, "Layer 1");
        paint(*m_document, brushOf(1));
        const Project layered = m_document->snapshot();
        const LayersPicture saved = picture();
        m_document->open(gridProject(3, 2), {}, "other");
        m_document->open(layered, {}, "layered");
        QCOMPARE(m_document->activeLayer(), layered.layers.layers().back().id);
        QVERIFY(picture() == saved);
    }

    void aDocumentMayDieWhileLayersAreWorkedOut()
    {
        openMany();
        addLayer(*m_document, "Layer 1");
        m_document.reset();
    }
};

} // namespace trixel::ui

QTEST_MAIN(trixel::ui::DocumentLayersTest)
#include "tst_document_layers.moc"
