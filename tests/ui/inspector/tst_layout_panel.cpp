// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QLabel>
#include <QPainter>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>

#include "tests/ui/inspector/layout_fixture.h"

#include <set>

namespace trixel::ui {

namespace {

/// The pixel of a view in the middle of a texel.
QPoint spotOf(const LayoutView& view, const TexelPlace& place)
{
    return view.positionOf(place).value().toPoint();
}

/// As from a mouse that is moved there, whatever the pointer of the screen does.
void moveTo(LayoutView& view, QPoint at)
{
    QTest::mouseMove(&view, at + QPoint(1, 0));
    QTest::mouseMove(&view, at);
}

void turnWheel(LayoutView& view, QPoint at, int notches)
{
    QWheelEvent event(at,
                      view.mapToGlobal(at),
                      {},
                      QPoint(0, 120 * notches),
                      Qt::NoButton,
                      Qt::NoModifier,
                      Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(&view, &event);
}

const TexelPlace kUpper{FaceId{0}, {2, 3, TexelHalf::Upper}};

} // namespace

class LayoutPanelTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { m_settings.clear(); }
    void init() { m_settings.clear(); }

    void saysWhatToDoBeforeAnythingWasPointedAt()
    {
        LayoutFixture f;
        QVERIFY(QTest::qWaitForWindowExposed(&f.panel));
        QVERIFY(f.panel.findChild<QLabel*>()->isVisible());
        QVERIFY(f.panel.findChild<QLabel*>()->text().contains("Point at a face"));
        QVERIFY(!f.net().isVisible());
        f.inspection.pointAt(kUpper);
        QVERIFY(f.net().isVisible() && f.packed().isVisible() && f.rows().isVisible());
        QCOMPARE(f.net().scene()->faces.size(), std::size_t{3}); // one edge is a border
        QCOMPARE(f.net().scene()->main().face, FaceId{0});
    }

    void aTexelUnderThePointerIsLookedAtInAllViews()
    {
        LayoutFixture f;
        QVERIFY(QTest::qWaitForWindowExposed(&f.panel));
        f.inspection.pointAt(TexelPlace{FaceId{0}, {}});
        for (LayoutView* view : {&f.net(), &f.packed(), &f.rows()}) {
            for (std::uint32_t k = 0; k < 64; k += 5) {
                const TexelPlace place{FaceId{0}, texelAt(Level(3), static_cast<TexelIndex>(k))};
                moveTo(*view, spotOf(*view, place));
                QTRY_COMPARE(f.inspection.texel()->place, place); // events may come late
                QVERIFY(f.inspection.isPointedAt());
            }
            QEvent leave(QEvent::Leave);
            QApplication::sendEvent(view, &leave);
            QVERIFY(!f.inspection.isPointedAt());
            QVERIFY(f.inspection.texel());
        }
    }

    void theNetStaysUnderThePointerWhileTheOthersShowTheNeighbour()
    {
        LayoutFixture f;
        QVERIFY(QTest::qWaitForWindowExposed(&f.panel));
        f.inspection.pointAt(kUpper);
        const LayoutScene before = *f.net().scene();
        const PlaneSight sight = f.net().sight();
        const TexelPlace neighbour{FaceId{1}, {0, 1, TexelHalf::Lower}};
        moveTo(f.net(), spotOf(f.net(), neighbour));
        QCOMPARE(f.inspection.texel()->place, neighbour);
        QCOMPARE(*f.net().scene(), before);
        QCOMPARE(f.net().sight(), sight);
        QCOMPARE(f.packed().scene()->main().face, FaceId{1});
        QCOMPARE(f.packed().scene()->main().level, Level(2)); // its own
        QCOMPARE(f.rows().scene()->main().face, FaceId{1});
    }

    void aNeighbourThatIsClickedStaysInItsPlaceAndGetsTheNet()
    {
        LayoutFixture f;
        QVERIFY(QTest::qWaitForWindowExposed(&f.panel));
        f.inspection.pointAt(kUpper);
        const TexelPlace neighbour{FaceId{1}, {0, 1, TexelHalf::Lower}};
        const QPoint spot = spotOf(f.net(), neighbour);
        QTest::mouseClick(&f.net(), Qt::LeftButton, {}, spot);
        QVERIFY(f.inspection.isHeld());
        QCOMPARE(f.inspection.texel()->place, neighbour);
        QCOMPARE(f.net().scene()->main().face, FaceId{1});
        QVERIFY((spotOf(f.net(), neighbour) - spot).manhattanLength() <= 2);
        // A click on the held texel lets it go.
        QTest::mouseClick(&f.net(), Qt::LeftButton, {}, spotOf(f.net(), neighbour));
        QVERIFY(!f.inspection.isHeld());
    }

    void anotherFacePointedAtElsewhereIsLaidAfresh()
    {
        LayoutFixture f;
        QVERIFY(QTest::qWaitForWindowExposed(&f.panel));
        f.inspection.pointAt(kUpper);
        f.inspection.pointAt(FaceId{2}, {0.3F, 0.3F});
        QCOMPARE(f.net().scene()->main().face, FaceId{2});
        QCOMPARE(f.net().scene()->main().layout.corner(0), glm::dvec2(0));
        QVERIFY(f.net().sight().isHome());
    }

    void arrowsStepAcrossEdgesAndTheNetFollowsInPlace()
    {
        LayoutFixture f;
        QVERIFY(QTest::qWaitForWindowExposed(&f.panel));
        f.inspection.hold(TexelPlace{FaceId{0}, {0, 0, TexelHalf::Lower}});
        f.net().setFocus();
        std::set<FaceId> entered;
        for (int k = 0; k < 12; ++k) {
            QTest::keyClick(&f.net(), Qt::Key_Right);
            const TexelPlace place = f.inspection.texel()->place;
            entered.insert(place.face);
            QCOMPARE(f.net().scene()->main().face, place.face);
            QVERIFY(f.net().rect().contains(spotOf(f.net(), place)));
        }
        QVERIFY(entered.size() > 1);
        const TexelPlace here = f.inspection.texel()->place;
        QTest::keyClick(&f.packed(), Qt::Key_Up);
        QVERIFY(f.inspection.texel()->place != here);
        QTest::keyClick(&f.packed(), Qt::Key_Down);
        QCOMPARE(f.inspection.texel()->place, here);
        QTest::keyClick(&f.packed(), Qt::Key_Space);
        QVERIFY(!f.inspection.isHeld());
    }

    void theWheelZoomsToThePointerAndTheOtherViewsToTheSameTexel()
    {
        LayoutFixture f;
        QVERIFY(QTest::qWaitForWindowExposed(&f.panel));
        f.inspection.pointAt(kUpper);
        const QPoint spot = spotOf(f.packed(), kUpper);
        moveTo(f.packed(), spot);
        turnWheel(f.packed(), spot, 8);
        QVERIFY(f.packed().sight().zoom() > 3);
        QVERIFY((spotOf(f.packed(), kUpper) - spot).manhattanLength() <= 2);
        for (LayoutView* other : {&f.net(), &f.rows()}) {
            QVERIFY(std::abs(other->sight().zoom() / f.packed().sight().zoom() - 1) < 1e-6);
            QVERIFY(other->rect().contains(spotOf(*other, kUpper)));
        }
        // Each by itself when they are not linked.
        f.panel.findChild<QAction*>("layout-link")->trigger();
        const double zoom = f.net().sight().zoom();
        turnWheel(f.packed(), spot, -2);
        QCOMPARE(f.net().sight().zoom(), zoom);
        QTest::keyClick(&f.packed(), Qt::Key_F);
        QVERIFY(f.packed().sight().isHome() && f.net().sight().isHome());
    }

    void dragsMoveTheViewAndHoldNothing()
    {
        LayoutFixture f;
        QVERIFY(QTest::qWaitForWindowExposed(&f.panel));
        f.inspection.pointAt(kUpper);
        const QPoint spot = spotOf(f.rows(), kUpper);
        turnWheel(f.rows(), spot, 5);
        const QPoint from = spotOf(f.rows(), kUpper);
        for (const auto& [button, keys] : {std::pair(Qt::LeftButton, Qt::NoModifier),
                                           std::pair(Qt::MiddleButton, Qt::NoModifier),
                                           std::pair(Qt::LeftButton, Qt::AltModifier)}) {
            const QPoint at = spotOf(f.rows(), kUpper);
            QTest::mousePress(&f.rows(), button, keys, at);
            QTest::mouseMove(&f.rows(), at + QPoint(30, 10));
            QTest::mouseMove(&f.rows(), at + QPoint(40, 20));
            QTest::mouseRelease(&f.rows(), button, keys, at + QPoint(40, 20));
            QVERIFY((spotOf(f.rows(), kUpper) - at - QPoint(40, 20)).manhattanLength() <= 2);
            QVERIFY(!f.inspection.isHeld());
            f.rows().frame();
            turnWheel(f.rows(), spot, 5);
        }
        QVERIFY((spotOf(f.rows(), kUpper) - from).manhattanLength() <= 4);
    }

    void aTexelFarOutsideIsBroughtIntoSightWhereOneLooksCloser()
    {
        LayoutFixture f;
        QVERIFY(QTest::qWaitForWindowExposed(&f.panel));
        f.inspection.pointAt(FaceId{2}, {0.05F, 0.05F});
        turnWheel(f.packed(), spotOf(f.packed(), f.inspection.texel()->place), 12);
        f.inspection.pointAt(FaceId{2}, {0.05F, 0.9F});
        for (LayoutView* view : {&f.net(), &f.packed(), &f.rows()}) {
            QVERIFY(view->rect().contains(spotOf(*view, f.inspection.texel()->place)));
            QVERIFY(view->sight().zoom() > 3);
        }
    }

    void hiddenPanelsDoNothingAndCatchUp()
    {
        LayoutFixture f;
        f.panel.hide();
        f.inspection.pointAt(kUpper);
        QVERIFY(!f.net().scene());
        f.panel.show();
        QVERIFY(f.net().scene());
        QCOMPARE(f.net().scene()->main().face, FaceId{0});
    }

    void levelsThatAreDroppedAndFacesThatChangeAreFollowed()
    {
        LayoutFixture f;
        QVERIFY(QTest::qWaitForWindowExposed(&f.panel));
        f.inspection.pointAt(kUpper);
        f.inspection.setLevelsDropped(2);
        QCOMPARE(f.net().scene()->main().level, Level(1));
        QCOMPARE(f.packed().scene()->main().level, Level(1));
        f.inspection.setLevelsDropped(0);
        const QImage before = f.packed().grab().toImage();
        const FaceId faces[] = {FaceId{0}};
        f.document.fillFaces(faces, {1, 0, 0, 1});
        QVERIFY(f.packed().grab().toImage() != before);
        f.document.undoStack().undo();
        QCOMPARE(f.packed().grab().toImage(), before);
        f.document.open(fanProject(), {}, "another");
        QVERIFY(!f.inspection.texel());
        QVERIFY(!f.net().isVisible());
    }

    void aPainterOfTheLookShowsInEveryView()
    {
        LayoutFixture f;
        QVERIFY(QTest::qWaitForWindowExposed(&f.panel));
        f.inspection.pointAt(kUpper);
        f.inspection.pointAway();
        const QImage before = f.rows().grab().toImage();
        render::Look look;
        look.channel = 1;
        f.settings.setLook(look);
        QVERIFY(f.rows().grab().toImage() != before);
        f.settings.setLook({});
        QCOMPARE(f.rows().grab().toImage(), before);
    }

    void selectedFacesAreOutlined()
    {
        LayoutFixture f;
        QVERIFY(QTest::qWaitForWindowExposed(&f.panel));
        f.inspection.pointAt(kUpper);
        const QImage before = f.net().grab().toImage();
        f.selection.set({FaceId{1}});
        QVERIFY(f.net().grab().toImage() != before);
        f.selection.clear();
        QCOMPARE(f.net().grab().toImage(), before);
    }

    void switchesAreNamedAndRemembered()
    {
        {
            LayoutFixture f;
            QVERIFY(QTest::qWaitForWindowExposed(&f.panel));
            f.inspection.pointAt(kUpper);
            for (const QAction* action : f.panel.switches()) {
                QVERIFY(!action->text().isEmpty() && !action->toolTip().isEmpty());
            }
            for (const QToolButton* button : f.panel.findChildren<QToolButton*>()) {
                if (button->defaultAction() != nullptr) {
                    QVERIFY(!button->accessibleName().isEmpty());
                }
            }
            for (LayoutView* view : {&f.net(), &f.packed(), &f.rows()}) {
                QVERIFY(!view->accessibleName().isEmpty() && !view->toolTip().isEmpty());
            }
            const QImage before = f.rows().grab().toImage();
            for (const char* name :
                 {"texel-grid", "mark-tint", "mark-centres", "mark-values", "mark-indices"}) {
                f.rows().zoomBy(6);
                const QImage off = f.rows().grab().toImage();
                f.panel.findChild<QAction*>(name)->trigger();
                QVERIFY2(f.rows().grab().toImage() != off, name);
                f.panel.findChild<QAction*>(name)->trigger();
                f.rows().frame();
            }
            QCOMPARE(f.rows().grab().toImage(), before);
            f.panel.findChild<QAction*>("mark-tint")->trigger();
            f.panel.findChild<QAction*>("layout-packed")->trigger();
            QVERIFY(!f.packed().isVisible());
        }
        LayoutFixture again;
        QVERIFY(QTest::qWaitForWindowExposed(&again.panel));
        again.inspection.pointAt(kUpper);
        QVERIFY(again.panel.marks().tint);
        QVERIFY(!again.packed().isVisible() && again.net().isVisible());
    }

    void narrowPanelsHaveTheirViewsBelowEachOther()
    {
        LayoutFixture f(fanProject(), {310, 700});
        QVERIFY(QTest::qWaitForWindowExposed(&f.panel));
        f.inspection.pointAt(kUpper);
        QCoreApplication::processEvents();
        QVERIFY(f.packed().y() > f.net().y());
        QVERIFY(f.net().width() > 250);
        f.panel.resize(900, 300);
        QCoreApplication::processEvents();
        QCOMPARE(f.packed().y(), f.net().y());
    }

private:
    TemporarySettings m_settings;
};

} // namespace trixel::ui

QTEST_MAIN(trixel::ui::LayoutPanelTest)
#include "tst_layout_panel.moc"
