// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>

#include "tests/ui/fixtures.h"
#include "ui/document/document.h"

#include <array>
#include <numeric>

using namespace trixel;
using namespace trixel::ui;

namespace {

constexpr std::array<float, 4> kBlue{0, 0, 1, 1};

Brush wideBrush(float red = 1)
{
    Brush brush;
    brush.radius = 0.3F;
    brush.flow = 0.5F;
    brush.color = {red, 0, 0, 1};
    return brush;
}

void extendAcross(Document& document)
{
    for (const std::uint32_t face : {0U, 2U, 4U, 38U, 46U, 8U}) {
        document.extendStroke({FaceId{face}, {0.3F, 0.3F}, 1.0F, 0.1 * face});
    }
}

void paint(Document& document, const Brush& brush, StrokePace pace)
{
    document.beginStroke(brush, pace);
    extendAcross(document);
    document.endStroke();
}

} // namespace

class TestPaintingBehind : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<Document> m_document;
    std::unique_ptr<Document> m_plain; ///< the same, painted at once
    std::vector<std::byte> m_before;

    void waitUntilSettled()
    {
        QTRY_VERIFY(!m_document->isSettling());
        QVERIFY(!m_document->hasStroke());
    }
    QUndoStack& stack() { return m_document->undoStack(); }
    std::vector<std::byte> texels() const { return allTexels(m_document->texels()); }
    std::vector<std::byte> plainTexels() const { return allTexels(m_plain->texels()); }

    /// A stroke, and three edits that wait for it when it is painted behind.
    static void paintWaiting(Document& document, StrokePace pace)
    {
        paint(document, wideBrush(), pace);
        paint(document, wideBrush(0.2F), StrokePace::AtOnce);
        document.fillFaces(std::array{FaceId{4}, FaceId{5}}, kBlue);
        paint(document, wideBrush(0.7F), pace);
    }

private slots:
    void init()
    {
        for (std::unique_ptr<Document>* document : {&m_document, &m_plain}) {
            *document = std::make_unique<Document>();
            (*document)->open(gridProject(8, 5), {}, "grid");
        }
        m_before = texels();
    }

    void theTexelsAreThoseOfAStrokePaintedAtOnce()
    {
        QSignalSpy settled(m_document.get(), &Document::settled);
        QSignalSpy placed(m_document.get(), &Document::dabsPlaced);
        paint(*m_document, wideBrush(), StrokePace::Behind);
        QVERIFY(m_document->isSettling());
        QVERIFY(m_document->isModified());
        QVERIFY(placed.size() > 0);
        waitUntilSettled();
        QCOMPARE(settled.size(), 1);
        QCOMPARE(settled.at(0).at(0).toBool(), true);
        paint(*m_plain, wideBrush(), StrokePace::AtOnce);
        QCOMPARE(texels(), plainTexels());
        QVERIFY(texels() != m_before);
        stack().undo();
        QCOMPARE(texels(), m_before);
        QVERIFY(!m_document->isModified());
        stack().redo();
        QCOMPARE(texels(), plainTexels());
    }

    void theWindowHearsOfEveryFaceThatChanges()
    {
        std::set<FaceId> told;
        connect(m_document.get(), &Document::changed, this, [&](const Change& change) {
            for (const TouchedRect& rect : change.rects) {
                told.insert(rect.face);
            }
        });
        paint(*m_document, wideBrush(), StrokePace::Behind);
        waitUntilSettled();
        const TexelStore before = gridProject(8, 5).texels;
        for (std::uint32_t k = 0; k < before.faceCount(); ++k) {
            QVERIFY(told.contains(FaceId{k}) ||
                    before.face(FaceId{k}) == m_document->texels().face(FaceId{k}));
        }
    }

    void undoneWhileItSettlesAStrokeLeavesNothing()
    {
        paint(*m_document, wideBrush(0.5F), StrokePace::AtOnce);
        const std::vector<std::byte> first = texels();
        const StateId state = m_document->state();
        paint(*m_document, wideBrush(), StrokePace::Behind);
        QVERIFY(m_document->isSettling());
        QCOMPARE(m_document->state(), state); // nothing made from its texels counts as new
        QSignalSpy settled(m_document.get(), &Document::settled);
        stack().undo();
        QCOMPARE(settled.size(), 1);
        QCOMPARE(settled.at(0).at(0).toBool(), false);
        QVERIFY(!m_document->hasStroke());
        QCOMPARE(texels(), first); // and the one before it is still there
        QCOMPARE(stack().index(), 1);
        QTest::qWait(50);
        QCOMPARE(texels(), first);
        QCOMPARE(m_document->state(), state);
    }

    void undoneWhileItSettlesAStrokeCanBeRedone_data()
    {
        QTest::addColumn<int>("wait");
        QTest::newRow("at once") << 0;
        QTest::newRow("in the middle") << 5;
        QTest::newRow("when it would have settled") << 300;
    }
    void undoneWhileItSettlesAStrokeCanBeRedone()
    {
        QFETCH(int, wait);
        paint(*m_plain, wideBrush(), StrokePace::AtOnce);
        paint(*m_document, wideBrush(), StrokePace::Behind);
        QVERIFY(m_document->isSettling());
        const StateId before = m_document->state();
        stack().undo();
        QTest::qWait(wait);
        QCOMPARE(texels(), m_before);
        QVERIFY(stack().canRedo());
        stack().redo();
        waitUntilSettled();
        QCOMPARE(texels(), plainTexels());
        QVERIFY(m_document->state() != before);
        QCOMPARE(stack().count(), 1);
        for (int k = 0; k < 2; ++k) {
            stack().undo();
            QCOMPARE(texels(), m_before);
            QCOMPARE(m_document->state(), before);
            stack().redo();
            QCOMPARE(texels(), plainTexels());
        }
    }

    void undoneAndRedoneOverAndOverItSettlesOnce()
    {
        paint(*m_plain, wideBrush(), StrokePace::AtOnce);
        paint(*m_document, wideBrush(), StrokePace::Behind);
        for (int k = 0; k < 6; ++k) {
            stack().undo();
            QCOMPARE(texels(), m_before);
            QTest::qWait(k);
            stack().redo();
            QTest::qWait(k);
        }
        waitUntilSettled();
        QCOMPARE(texels(), plainTexels());
        QCOMPARE(stack().count(), 1);
    }

    void undoneItGoesForGoodWhenSomethingElseIsDone()
    {
        paint(*m_document, wideBrush(), StrokePace::Behind);
        stack().undo();
        paint(*m_document, wideBrush(0.4F), StrokePace::Behind);
        paint(*m_plain, wideBrush(0.4F), StrokePace::AtOnce);
        waitUntilSettled();
        QCOMPARE(texels(), plainTexels());
        QVERIFY(!stack().canRedo());
        QCOMPARE(stack().count(), 1);
        stack().undo();
        QCOMPARE(texels(), m_before);
    }

    void undoneWithOthersBelowItComesBackOnTopOfThem()
    {
        for (Document* document : {m_document.get(), m_plain.get()}) {
            paint(*document, wideBrush(0.5F), StrokePace::AtOnce);
        }
        paint(*m_document, wideBrush(), StrokePace::Behind);
        stack().undo();
        stack().undo();
        QCOMPARE(texels(), m_before);
        stack().redo();
        QCOMPARE(texels(), plainTexels());
        stack().redo();
        waitUntilSettled();
        paint(*m_plain, wideBrush(), StrokePace::AtOnce);
        QCOMPARE(texels(), plainTexels());
    }

    void aStrokeThatChangesNothingCanBeUndoneAndRedoneToo()
    {
        Brush brush = wideBrush();
        brush.blend = BlendMode::Erase; // what is there already
        paint(*m_document, brush, StrokePace::Behind);
        stack().undo();
        QTest::qWait(200);
        stack().redo();
        waitUntilSettled();
        QCOMPARE(stack().count(), 0);
        QCOMPARE(texels(), m_before);
        QVERIFY(!m_document->isModified());
    }

    void aDocumentMayCloseWithAnUndoneOneStillBeingMade()
    {
        paint(*m_document, wideBrush(), StrokePace::Behind);
        stack().undo();
        m_document->open(gridProject(3, 2), {}, "other");
        const std::vector<std::byte> other = texels();
        QTest::qWait(50);
        QCOMPARE(texels(), other);
        paint(*m_document, wideBrush(), StrokePace::Behind);
        stack().undo();
        m_document.reset();
    }

    void cancelledAStrokeLeavesNothing()
    {
        m_document->beginStroke(wideBrush(), StrokePace::Behind);
        extendAcross(*m_document);
        QTest::qWait(30); // some of it is in the texels
        m_document->cancelStroke();
        QVERIFY(!m_document->hasStroke());
        QCOMPARE(texels(), m_before);
        QTest::qWait(30);
        QCOMPARE(texels(), m_before);
        QCOMPARE(stack().count(), 0);
        QVERIFY(!m_document->isModified());
    }

    void strokesAndFillsDrawnWhileOneSettlesFollowInOrder()
    {
        const auto all = [](Document& document, StrokePace pace) {
            paint(document, wideBrush(), pace);
            paint(document, wideBrush(0.2F), StrokePace::AtOnce);
            document.fillFaces(std::array{FaceId{4}, FaceId{5}}, kBlue);
            paint(document, wideBrush(0.7F), pace);
        };
        all(*m_document, StrokePace::Behind);
        QVERIFY(m_document->isSettling());
        all(*m_plain, StrokePace::AtOnce);
        waitUntilSettled();
        QTRY_COMPARE(stack().count(), 4);
        waitUntilSettled();
        QCOMPARE(texels(), plainTexels());
        for (int k = 0; k < 4; ++k) {
            stack().undo();
            m_plain->undoStack().undo();
            QCOMPARE(texels(), plainTexels());
        }
        QCOMPARE(texels(), m_before);
    }

    void aStrokeBegunWhileAnotherSettlesGoesOnAfterwards()
    {
        paint(*m_document, wideBrush(), StrokePace::Behind);
        m_document->beginStroke(wideBrush(0.2F), StrokePace::Behind);
        QVERIFY(m_document->isTakingSamples());
        m_document->extendStroke({FaceId{0}, {0.3F, 0.3F}, 1, 0});
        QTRY_VERIFY(!m_document->isSettling());
        QVERIFY(m_document->isTakingSamples());
        m_document->extendStroke({FaceId{60}, {0.3F, 0.3F}, 1, 1});
        m_document->endStroke();
        waitUntilSettled();

        paint(*m_plain, wideBrush(), StrokePace::AtOnce);
        m_plain->beginStroke(wideBrush(0.2F));
        m_plain->extendStroke({FaceId{0}, {0.3F, 0.3F}, 1, 0});
        m_plain->extendStroke({FaceId{60}, {0.3F, 0.3F}, 1, 1});
        m_plain->endStroke();
        QCOMPARE(texels(), plainTexels());
    }

    void undoTakesBackWhatWaitsBeforeWhatSettles()
    {
        paint(*m_document, wideBrush(), StrokePace::Behind);
        paint(*m_document, wideBrush(0.2F), StrokePace::AtOnce); // waits
        stack().undo();
        QVERIFY(m_document->isSettling());
        waitUntilSettled();
        paint(*m_plain, wideBrush(), StrokePace::AtOnce);
        QCOMPARE(texels(), plainTexels());
        QTest::qWait(10);
        QCOMPARE(stack().index(), 1);
        stack().undo();
        QCOMPARE(texels(), m_before);
    }

    void whatWaitsIsAStepOfItsOwnFromTheBeginning()
    {
        paintWaiting(*m_document, StrokePace::Behind);
        QVERIFY(m_document->isSettling());
        QCOMPARE(stack().count(), 4);
        QCOMPARE(stack().undoText(), QStringLiteral("Brush stroke"));
        stack().undo();
        QCOMPARE(stack().undoText(), QStringLiteral("Fill 2 faces"));
    }

    void whatWaitsCanBeUndoneAndRedone_data()
    {
        QTest::addColumn<int>("undone");
        QTest::addColumn<int>("wait");
        for (const int undone : {1, 2, 3, 4}) {
            QTest::addRow("%d at once", undone) << undone << 0;
            QTest::addRow("%d a little later", undone) << undone << 3;
            QTest::addRow("%d once the first has settled", undone) << undone << 300;
        }
    }
    void whatWaitsCanBeUndoneAndRedone()
    {
        QFETCH(int, undone);
        QFETCH(int, wait);
        const StateId before = m_document->state();
        paintWaiting(*m_document, StrokePace::Behind);
        paintWaiting(*m_plain, StrokePace::AtOnce);
        QVERIFY(m_document->isSettling());
        for (int k = 0; k < undone; ++k) {
            stack().undo();
        }
        QTest::qWait(wait);
        QCOMPARE(stack().count(), 4);
        for (int k = 0; k < undone; ++k) {
            QVERIFY(stack().canRedo());
            stack().redo();
        }
        waitUntilSettled();
        QCOMPARE(texels(), plainTexels());
        QCOMPARE(stack().count(), 4);
        std::vector<StateId> states;
        for (int k = 0; k < 4; ++k) {
            states.push_back(m_document->state());
            QCOMPARE(texels(), plainTexels());
            stack().undo();
            m_plain->undoStack().undo();
        }
        QCOMPARE(texels(), m_before);
        QCOMPARE(m_document->state(), before);
        for (int k = 4; k > 0; --k) {
            stack().redo();
            m_plain->undoStack().redo();
            QCOMPARE(texels(), plainTexels());
            QCOMPARE(m_document->state(), states[static_cast<std::size_t>(k - 1)]);
        }
    }

    void undoneWhatWaitedGoesForGoodWhenSomethingElseIsDone()
    {
        paintWaiting(*m_document, StrokePace::Behind);
        stack().undo();
        stack().undo();
        paint(*m_document, wideBrush(0.4F), StrokePace::AtOnce);
        QVERIFY(!stack().canRedo());
        waitUntilSettled();
        paint(*m_plain, wideBrush(), StrokePace::AtOnce);
        paint(*m_plain, wideBrush(0.2F), StrokePace::AtOnce);
        paint(*m_plain, wideBrush(0.4F), StrokePace::AtOnce);
        QCOMPARE(texels(), plainTexels());
        QCOMPARE(stack().count(), 3);
    }

    void whatWaitsHasItsStateOnlyOnceItIsThere()
    {
        const StateId before = m_document->state();
        paintWaiting(*m_document, StrokePace::Behind);
        QCOMPARE(m_document->state(), before);
        stack().undo();
        QCOMPARE(m_document->state(), before);
        stack().redo();
        QCOMPARE(m_document->state(), before);
        std::vector<StateId> found;
        connect(m_document.get(), &Document::settled, this, [&] {
            found.push_back(m_document->state());
        });
        waitUntilSettled();
        QCOMPARE(found.size(), 2U); // of two strokes painted behind
        QVERIFY(found[0] != before);
        QVERIFY(found[1] != found[0]);
        QCOMPARE(found[1], m_document->state());
    }

    void whatWaitedAndComesToNothingLeavesNoStep()
    {
        Brush brush = wideBrush();
        brush.blend = BlendMode::Erase; // what is there already
        paint(*m_document, brush, StrokePace::Behind);
        paint(*m_document, brush, StrokePace::AtOnce);
        QCOMPARE(stack().count(), 2);
        waitUntilSettled();
        stack().undo(); // the first may be below the second when it turns out to be nothing
        QCOMPARE(texels(), m_before);
        QVERIFY(!stack().canUndo());
        paint(*m_document, brush, StrokePace::Behind);
        m_document->beginStroke(wideBrush(), StrokePace::Behind);
        m_document->endStroke(); // without a dab
        m_document->fillFaces(std::array{FaceId{4}}, kBlue);
        waitUntilSettled();
        m_plain->fillFaces(std::array{FaceId{4}}, kBlue);
        QCOMPARE(texels(), plainTexels());
        stack().undo();
        QCOMPARE(texels(), m_before);
    }

    void changesMadeFromTexelsThatAreStillChangingAreRefused()
    {
        paint(*m_document, wideBrush(), StrokePace::Behind);
        QSignalSpy notice(m_document.get(), &Document::notice);
        const bool applied = m_document->replaceTexels(
            m_document->texels(), m_document->state(), QStringLiteral("Fit"));
        QVERIFY(!applied);
        QCOMPARE(notice.size(), 1);
        waitUntilSettled();
        QVERIFY(texels() != m_before);
    }

    void whoWaitsForTexelsGetsAllOfThem()
    {
        bool isDone = false;
        m_document->whenSettled([&] { isDone = true; });
        QVERIFY(isDone);
        paint(*m_document, wideBrush(), StrokePace::Behind);
        std::vector<std::byte> found;
        StateId state;
        m_document->whenSettled([&] {
            found = texels();
            state = m_document->state();
        });
        QVERIFY(found.empty());
        waitUntilSettled();
        QCOMPARE(found, texels());
        QCOMPARE(state, m_document->state());
    }

    void savedWhileItSettlesAStrokeStillCountsAsUnsaved()
    {
        paint(*m_document, wideBrush(), StrokePace::Behind);
        m_document->markSaved(QStringLiteral("a.trixel"), m_document->state());
        QVERIFY(m_document->isModified());
        waitUntilSettled();
        QVERIFY(m_document->isModified());
    }

    void aStrokeThatChangesNothingLeavesNoStep()
    {
        Brush brush = wideBrush();
        brush.blend = BlendMode::Erase; // what is there already
        paint(*m_document, brush, StrokePace::Behind);
        waitUntilSettled();
        QCOMPARE(stack().count(), 0);
        QVERIFY(!m_document->isModified());
        m_document->beginStroke(wideBrush(), StrokePace::Behind);
        m_document->endStroke(); // without a dab
        QVERIFY(!m_document->hasStroke());
        QCOMPARE(stack().count(), 0);
    }

    void anotherProjectForgetsWhatWasBeingPainted()
    {
        paint(*m_document, wideBrush(), StrokePace::Behind);
        m_document->fillFaces(std::array{FaceId{4}}, kBlue);
        m_document->open(gridProject(3, 2), {}, "other");
        const std::vector<std::byte> other = texels();
        QVERIFY(!m_document->hasStroke());
        QTest::qWait(50);
        QCOMPARE(texels(), other);
        QVERIFY(!m_document->isModified());
    }

    void veryManyFacesAreFilledBehind()
    {
        m_document->open(gridProject(120, 2), {}, "many"); // 28,800 faces
        m_plain->open(gridProject(120, 2), {}, "many");
        std::vector<FaceId> faces;
        for (std::uint32_t k = 5; k < 28'000; ++k) {
            faces.push_back(FaceId{k});
        }
        QSignalSpy placed(m_document.get(), &Document::fillPlaced);
        m_document->fillFaces(faces, kBlue);
        QCOMPARE(placed.size(), 1);
        QVERIFY(m_document->isSettling());
        waitUntilSettled();
        for (const FaceId face : faces) {
            m_plain->fillFaces(std::array{face}, kBlue);
        }
        QVERIFY(texels() == plainTexels());
        QCOMPARE(stack().undoText(), QStringLiteral("Fill 27995 faces"));
        stack().undo();
        QVERIFY(texels() == allTexels(gridProject(120, 2).texels));
    }

    void aDocumentMayDieInTheMiddle()
    {
        paint(*m_document, wideBrush(), StrokePace::Behind);
        m_document.reset();
    }
};

QTEST_MAIN(TestPaintingBehind)
#include "tst_painting_behind.moc"
