// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>

#include "tests/ui/fixtures.h"
#include "ui/document/document.h"

#include <cmath>
#include <limits>
#include <set>

namespace trixel::ui {

namespace {

std::set<FaceId> namedFaces(const QSignalSpy& spy)
{
    std::set<FaceId> faces;
    for (const QList<QVariant>& call : spy) {
        for (const TouchedRect& rect : call.at(0).value<Change>().rects) {
            faces.insert(rect.face);
        }
    }
    return faces;
}

Brush redBrush()
{
    Brush brush;
    brush.radius = 0.1F;
    brush.color = {1, 0, 0, 1};
    return brush;
}

/// A stroke through the middle of several faces.
void extendAcross(Document& document)
{
    for (const std::uint32_t face : {0U, 2U, 4U, 6U, 8U}) {
        document.extendStroke({FaceId{face}, {0.3F, 0.3F}, 1.0F, 0.1 * face});
    }
}

void paint(Document& document, const Brush& brush = redBrush())
{
    document.beginStroke(brush);
    extendAcross(document);
    document.endStroke();
}

} // namespace

class DocumentTest : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        m_document = std::make_unique<Document>();
        m_document->open(gridProject(), {}, "grid");
        m_before = m_document->texels();
    }
    void cleanup() { m_document.reset(); }

    void strokeShowsAtOnceAndIsOneUndoStep()
    {
        m_document->beginStroke(redBrush());
        extendAcross(*m_document);
        QVERIFY(!facesThatDiffer(m_document->texels(), m_before).empty());
        QCOMPARE(m_document->undoStack().count(), 0);
        m_document->endStroke();
        QCOMPARE(m_document->undoStack().count(), 1);
    }

    void aCreaseAngleIsOneUndoStepAndPartOfTheState()
    {
        QSignalSpy changed(m_document.get(), &Document::creasesChanged);
        const StateId before = m_document->state();
        m_document->setCreaseAngle(30);
        QCOMPARE(m_document->creaseAngle(), CreaseAngle(30.0F));
        QCOMPARE(m_document->snapshot().creaseAngle, CreaseAngle(30.0F));
        QCOMPARE(m_document->state().texels, before.texels);
        QVERIFY(m_document->state() != before);
        m_document->setCreaseAngle(30); // no change
        QCOMPARE(m_document->undoStack().count(), 1);
        m_document->setCreaseAngle({});
        QCOMPARE(m_document->undoStack().count(), 2);
        QCOMPARE(changed.size(), 2);
        m_document->undoStack().undo();
        QCOMPARE(m_document->creaseAngle(), CreaseAngle(30.0F));
        m_document->undoStack().undo();
        QVERIFY(!m_document->creaseAngle());
        QCOMPARE(m_document->state(), before);
        QVERIFY(!m_document->isModified());
    }

    void changesOfTheAngleThatGoOnAreOneStepUnlessSomethingCameBetween()
    {
        m_document->setCreaseAngle(30);
        m_document->setCreaseAngle(40, true);
        m_document->setCreaseAngle(50, true);
        QCOMPARE(m_document->undoStack().count(), 1);
        m_document->markSaved("grid.trixel", m_document->state());
        QVERIFY(!m_document->isModified());
        m_document->setCreaseAngle(60, true);
        QVERIFY(m_document->isModified());
        m_document->undoStack().undo();
        QVERIFY(!m_document->creaseAngle());
        QVERIFY(m_document->isModified()); // the saved one had 50
        m_document->undoStack().redo();
        QCOMPARE(m_document->creaseAngle(), CreaseAngle(60.0F));
        paint(*m_document);
        m_document->setCreaseAngle(70, true);
        QCOMPARE(m_document->undoStack().count(), 3);
        m_document->undoStack().undo();
        m_document->undoStack().undo();
        QCOMPARE(m_document->creaseAngle(), CreaseAngle(60.0F));
        QVERIFY(facesThatDiffer(m_document->texels(), m_before).empty());
    }

    void undoAndRedoAreExactToTheBit()
    {
        const std::vector<std::byte> start = allTexels(m_document->texels());
        paint(*m_document);
        const std::vector<std::byte> first = allTexels(m_document->texels());
        Brush soft = redBrush();
        soft.color = {0, 0.5F, 1, 1};
        soft.opacity = 0.4F;
        soft.hardness = 0.0F;
        paint(*m_document, soft);
        const std::vector<std::byte> second = allTexels(m_document->texels());
        QVERIFY(first != start);
        QVERIFY(second != first);

        QUndoStack& stack = m_document->undoStack();
        for (int round = 0; round < 3; ++round) {
            stack.undo();
            QVERIFY(allTexels(m_document->texels()) == first);
            stack.undo();
            QVERIFY(allTexels(m_document->texels()) == start);
            stack.redo();
            QVERIFY(allTexels(m_document->texels()) == first);
            stack.redo();
            QVERIFY(allTexels(m_document->texels()) == second);
        }
    }

    void changedNamesTheTouchedFaces()
    {
        QSignalSpy changed(m_document.get(), &Document::changed);
        paint(*m_document);
        const std::set<FaceId> touched = facesThatDiffer(m_document->texels(), m_before);
        QVERIFY(!touched.empty() && touched.size() < m_before.faceCount());
        const std::set<FaceId> named = namedFaces(changed);
        QVERIFY(std::includes(named.begin(), named.end(), touched.begin(), touched.end()));

        changed.clear();
        m_document->undoStack().undo();
        QCOMPARE(changed.count(), 1);
        QVERIFY(namedFaces(changed) == touched);
        const Change change = changed.at(0).at(0).value<Change>();
        QVERIFY(change.rects.front().wholeFace);
        QCOMPARE(int(change.rects.front().width), 8);
    }

    void isModifiedFollowsTheUndoStack()
    {
        QSignalSpy modified(m_document.get(), &Document::modifiedChanged);
        QVERIFY(!m_document->isModified());
        paint(*m_document);
        QVERIFY(m_document->isModified());
        m_document->undoStack().undo();
        QVERIFY(!m_document->isModified());
        m_document->undoStack().redo();
        m_document->markSaved("/tmp/grid.trixel", m_document->state());
        QVERIFY(!m_document->isModified());
        m_document->undoStack().undo();
        QVERIFY(m_document->isModified());
        QCOMPARE(modified.count(), 5);
    }

    void savedStateThatWasUndoneAndReplacedStaysModified()
    {
        paint(*m_document);
        const StateId saved = m_document->state();
        m_document->undoStack().undo();
        Brush other = redBrush();
        other.color = {0, 1, 0, 1};
        paint(*m_document, other); // the same place in the stack, other texels
        m_document->markSaved("/tmp/grid.trixel", saved);
        QVERIFY(m_document->isModified());
        m_document->undoStack().undo();
        QVERIFY(m_document->isModified());
    }

    void savingWhilePaintingGoesOnLeavesLaterStrokesModified()
    {
        paint(*m_document);
        const StateId saved = m_document->state();
        const Project snapshot = m_document->snapshot();
        const std::vector<std::byte> then = allTexels(snapshot.texels);
        m_document->fillFaces(std::array{FaceId{9}}, {0, 0, 1, 1});
        m_document->markSaved("/tmp/grid.trixel", saved);
        QVERIFY(m_document->isModified());
        QVERIFY(allTexels(snapshot.texels) == then);
        m_document->undoStack().undo();
        QVERIFY(!m_document->isModified());
    }

    void cancelStrokeRestores()
    {
        m_document->beginStroke(redBrush());
        extendAcross(*m_document);
        m_document->cancelStroke();
        QVERIFY(!m_document->hasStroke());
        QVERIFY(facesThatDiffer(m_document->texels(), m_before).empty());
        QCOMPARE(m_document->undoStack().count(), 0);
    }

    void undoDuringAStrokeTakesTheStrokeBackFirst()
    {
        paint(*m_document);
        Brush other = redBrush();
        other.color = {0, 1, 0, 1};
        m_document->beginStroke(other);
        extendAcross(*m_document);
        m_document->undoStack().undo();
        QVERIFY(!m_document->hasStroke());
        QVERIFY(facesThatDiffer(m_document->texels(), m_before).empty());
    }

    void strokeThatChangesNothingIsNoStep()
    {
        m_document->beginStroke(redBrush());
        m_document->endStroke();
        QCOMPARE(m_document->undoStack().count(), 0);
        QVERIFY(!m_document->isModified());
    }

    void unusableBrushIsRefusedWithASentence_data()
    {
        QTest::addColumn<float>("radius");
        QTest::newRow("zero") << 0.0F;
        QTest::newRow("negative") << -1.0F;
        QTest::newRow("nan") << std::numeric_limits<float>::quiet_NaN();
        QTest::newRow("infinite") << std::numeric_limits<float>::infinity();
    }
    void unusableBrushIsRefusedWithASentence()
    {
        QFETCH(float, radius);
        QSignalSpy notice(m_document.get(), &Document::notice);
        Brush brush = redBrush();
        brush.radius = radius;
        paint(*m_document, brush);
        QCOMPARE(notice.count(), 1);
        QVERIFY(!notice.at(0).at(0).toString().isEmpty());
        QVERIFY(facesThatDiffer(m_document->texels(), m_before).empty());
    }

    void eraserGoesBackToTheUnpaintedColor()
    {
        m_document->fillFaces(std::array{FaceId{0}, FaceId{2}}, {0, 0, 0, 1});
        Brush eraser = redBrush();
        eraser.blend = BlendMode::Erase;
        eraser.hardness = 1;
        eraser.radius = 2;
        paint(*m_document, eraser);
        QVERIFY(facesThatDiffer(m_document->texels(), m_before).empty());
    }

    void fillIsOneUndoStep()
    {
        const std::array faces{FaceId{3}, FaceId{5}};
        QSignalSpy changed(m_document.get(), &Document::changed);
        m_document->fillFaces(faces, {1, 0.5F, 0, 1});
        const std::set<FaceId> expected(faces.begin(), faces.end());
        QVERIFY(facesThatDiffer(m_document->texels(), m_before) == expected);
        QVERIFY(namedFaces(changed) == expected);
        const FaceTexels& filled = m_document->texels().face(FaceId{3});
        QCOMPARE(int(filled.texel(0)[0]), 255);
        QCOMPARE(int(filled.texel(0)[1]), 128);
        QCOMPARE(int(filled.texel(0)[2]), 0);
        m_document->undoStack().undo();
        QVERIFY(facesThatDiffer(m_document->texels(), m_before).empty());
        m_document->undoStack().redo();
        QVERIFY(facesThatDiffer(m_document->texels(), m_before) == expected);
    }

    void allTexelsAreReplacedAsOneStepAmongOthers()
    {
        paint(*m_document);
        const std::vector<std::byte> painted = allTexels(m_document->texels());
        TexelStore coarse = m_document->texels();
        const FaceTexels& first = coarse.face(FaceId{0});
        coarse.exchange(FaceId{0}, FaceTexels::constant(Level(0), first.texel(0)));
        const std::vector<std::byte> wanted = allTexels(coarse);
        QSignalSpy levels(m_document.get(), &Document::levelsChanged);
        QVERIFY(m_document->replaceTexels(coarse, m_document->state(), "Coarse"));
        QCOMPARE(levels.count(), 1);
        QVERIFY(allTexels(m_document->texels()) == wanted);
        paint(*m_document);
        const std::vector<std::byte> paintedAgain = allTexels(m_document->texels());
        QCOMPARE(m_document->undoStack().count(), 3);
        m_document->undoStack().undo();
        QVERIFY(allTexels(m_document->texels()) == wanted);
        m_document->undoStack().undo();
        QVERIFY(allTexels(m_document->texels()) == painted);
        m_document->undoStack().undo();
        QVERIFY(facesThatDiffer(m_document->texels(), m_before).empty());
        for (int k = 0; k < 3; ++k) {
            m_document->undoStack().redo();
        }
        QVERIFY(allTexels(m_document->texels()) == paintedAgain);
    }

    void texelsMadeForAnotherStateAreRefused()
    {
        const StateId before = m_document->state();
        TexelStore late = m_document->texels();
        paint(*m_document);
        const std::vector<std::byte> painted = allTexels(m_document->texels());
        QSignalSpy notice(m_document.get(), &Document::notice);
        QVERIFY(!m_document->replaceTexels(std::move(late), before, "Late"));
        QCOMPARE(notice.count(), 1);
        QVERIFY(allTexels(m_document->texels()) == painted);
        QCOMPARE(m_document->undoStack().count(), 1);
    }

    void openingAnotherProjectForgetsHistory()
    {
        paint(*m_document);
        QSignalSpy opened(m_document.get(), &Document::opened);
        m_document->open(gridProject(), {}, "other");
        QCOMPARE(opened.count(), 1);
        QCOMPARE(m_document->undoStack().count(), 0);
        QVERIFY(!m_document->isModified());
        QCOMPARE(m_document->title(), QString("other"));
        m_document->markSaved("/tmp/named.trixel", m_document->state());
        QCOMPARE(m_document->title(), QString("named.trixel"));
    }

    void withoutAProjectNothingCanBePainted()
    {
        Document empty;
        paint(empty);
        empty.fillFaces(std::array{FaceId{0}}, {1, 1, 1, 1});
        QVERIFY(!empty.isOpen());
        QVERIFY(!empty.isModified());
        QCOMPARE(empty.undoStack().count(), 0);
    }

private:
    std::unique_ptr<Document> m_document;
    TexelStore m_before;
};

} // namespace trixel::ui

QTEST_MAIN(trixel::ui::DocumentTest)
#include "tst_document.moc"
