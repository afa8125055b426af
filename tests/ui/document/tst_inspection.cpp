// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <QSignalSpy>
#include <QTest>

#include "tests/ui/fixtures.h"
#include "ui/document/document.h"
#include "ui/document/inspection.h"

#include <array>
#include <memory>

namespace trixel::ui {

class InspectionTest : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        m_document = std::make_unique<Document>();
        m_inspection = std::make_unique<Inspection>(*m_document);
        m_document->open(gridProject(4, 3), {}, "grid");
    }
    void cleanup()
    {
        m_inspection.reset();
        m_document.reset();
    }

    void theTexelUnderThePointerIsLookedAtAndStaysWhenItLeaves()
    {
        QVERIFY(!m_inspection->texel());
        QSignalSpy changed(m_inspection.get(), &Inspection::changed);
        m_inspection->pointAt(faceId(5), {0.31F, 0.22F});
        QCOMPARE(changed.count(), 1);
        QVERIFY(m_inspection->isPointedAt());
        const InspectedTexel texel = m_inspection->texel().value();
        QCOMPARE(texel.level.log2(), 3);
        QVERIFY((texel.place == TexelPlace{faceId(5), texelAt(Level(3), glm::dvec2(0.31, 0.22))}));
        m_inspection->pointAt(faceId(5), {0.31F, 0.22F});
        QCOMPARE(changed.count(), 1);
        m_inspection->pointAway();
        QVERIFY(!m_inspection->isPointedAt());
        QVERIFY(m_inspection->texel() == texel);
        QCOMPARE(changed.count(), 2);
    }

    void aHeldTexelDoesNotFollowThePointer()
    {
        QSignalSpy held(m_inspection.get(), &Inspection::heldChanged);
        m_inspection->pointAt(faceId(5), {0.31F, 0.22F});
        m_inspection->hold();
        const InspectedTexel texel = m_inspection->texel().value();
        m_inspection->pointAt(faceId(6), {0.1F, 0.1F});
        m_inspection->pointAt(TexelPlace{faceId(7), {}});
        QVERIFY(m_inspection->texel() == texel);
        QCOMPARE(held.count(), 1);
        m_inspection->letGo();
        m_inspection->pointAt(faceId(6), {0.1F, 0.1F});
        QCOMPARE(m_inspection->texel()->place.face, faceId(6));
        QCOMPARE(held.count(), 2);
    }

    void rightTurnsComeRoundACornerToWhereTheyBegan()
    {
        m_inspection->pointAt(TexelPlace{faceId(5), {2, 2, TexelHalf::Lower}});
        const TexelPlace start = m_inspection->texel()->place;
        for (int k = 0; k < 6; ++k) {
            QVERIFY(m_inspection->step(Inspection::Step::Right));
            QVERIFY(m_inspection->isHeld());
            QCOMPARE(m_inspection->texel()->place == start, k == 5);
        }
    }

    void stepsStopAtTheBorder()
    {
        m_inspection->hold(TexelPlace{faceId(0), {}}); // its edges 0 and 2 are borders
        int steps = 0;
        while (m_inspection->step(Inspection::Step::Right) && steps < 100) {
            ++steps;
        }
        QVERIFY(steps < 100);
    }

    void addressesHoldTexelsAndWrongOnesSayWhy()
    {
        QSignalSpy went(m_inspection.get(), &Inspection::wentTo);
        QVERIFY(m_inspection->goTo("9:1,2,upper"));
        QVERIFY((m_inspection->texel()->place == TexelPlace{faceId(9), {1, 2, TexelHalf::Upper}}));
        QVERIFY(m_inspection->isHeld());
        QCOMPARE(went.count(), 1);
        const Status wrong = m_inspection->goTo("9999");
        QVERIFY(!wrong);
        QVERIFY(!wrong.error().message.empty());
        QCOMPARE(m_inspection->texel()->place.face, faceId(9));
        QCOMPARE(went.count(), 1);
    }

    void thePointStaysWhenLevelsChangeOrAreDropped()
    {
        m_inspection->hold(faceId(5), {0.31F, 0.22F});
        m_inspection->setLevelsDropped(2);
        QCOMPARE(m_inspection->texel()->level.log2(), 1);
        QCOMPARE(m_inspection->texel()->uv, glm::vec2(0.31F, 0.22F));
        QVERIFY(m_inspection->texel()->place.texel == texelAt(Level(1), glm::dvec2(0.31, 0.22)));
        const Project coarse = gridProject(4, 0);
        // Whoever hears of the change first must find a texel that the face has.
        connect(m_inspection.get(), &Inspection::changed, this, [this] {
            const InspectedTexel texel = m_inspection->texel().value();
            QVERIFY(texel.level == m_inspection->surface().level(texel.place.face));
            QVERIFY(isValid(texel.level, texel.place.texel));
        });
        QVERIFY(m_document->replaceTexels(coarse.texels, m_document->state(), "coarser"));
        QCOMPARE(m_inspection->texel()->level.log2(), 0);
        m_document->undoStack().undo();
        QCOMPARE(m_inspection->texel()->level.log2(), 1);
    }

    void onlyPaintOnItsFaceIsToldOf()
    {
        m_inspection->hold(faceId(5), {0.31F, 0.22F});
        QSignalSpy changed(m_inspection.get(), &Inspection::changed);
        m_document->fillFaces(std::array{faceId(6)}, {1, 0, 0, 1});
        QCOMPARE(changed.count(), 0);
        m_document->fillFaces(std::array{faceId(5)}, {1, 0, 0, 1});
        QCOMPARE(changed.count(), 1);
    }

    void itEndsWithTheProject()
    {
        m_inspection->hold(faceId(5), {0.31F, 0.22F});
        m_document->open(gridProject(1, 0), {}, "other");
        QVERIFY(!m_inspection->texel());
        QVERIFY(!m_inspection->isHeld());
        m_inspection->pointAt(faceId(5), {0.31F, 0.22F}); // there are two faces
        QVERIFY(!m_inspection->texel());
    }

private:
    std::unique_ptr<Document> m_document;
    std::unique_ptr<Inspection> m_inspection;
};

} // namespace trixel::ui

QTEST_MAIN(trixel::ui::InspectionTest)
#include "tst_inspection.moc"
