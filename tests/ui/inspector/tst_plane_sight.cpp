// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "ui/inspector/plane_sight.h"

#include <glm/geometric.hpp>

namespace trixel::ui {

namespace {

PlaneSight sight()
{
    PlaneSight made;
    made.setView({10, 20}, {300, 200});
    made.setHome({{0, 0}, {2, 1}}, 50);
    return made;
}

bool isNear(glm::dvec2 a, glm::dvec2 b)
{
    return glm::distance(a, b) < 1e-9;
}

} // namespace

class PlaneSightTest : public QObject
{
    Q_OBJECT

private slots:
    void homeIsShownWholeAndInTheMiddleWithUpwardsUp()
    {
        const PlaneSight s = sight();
        QVERIFY(s.isHome());
        QVERIFY(isNear(s.toView({1, 0.5}), {160, 120}));
        QVERIFY(isNear(s.toView({0, 0}), {10, 195}));
        QVERIFY(isNear(s.toView({2, 1}), {310, 45}));
        QVERIFY(isNear(s.toPlane(s.toView({0.3, 0.7})), {0.3, 0.7}));
        QCOMPARE(s.zoom(), 1.0);
    }

    void homeFollowsTheSizeOfTheViewAndAnotherZoomDoesToo()
    {
        PlaneSight s = sight();
        s.setView({0, 0}, {600, 600});
        QVERIFY(s.isHome());
        QCOMPARE(s.scale(), 300.0);
        s.zoomBy(3, {100, 100});
        s.setView({0, 0}, {300, 300});
        QCOMPARE(s.zoom(), 3.0);
    }

    void zoomKeepsThePointUnderThePointer()
    {
        PlaneSight s = sight();
        const glm::dvec2 at(200, 100);
        const glm::dvec2 point = s.toPlane(at);
        for (const double factor : {1.5, 2.0, 1 / 1.3, 4.0}) {
            s.zoomBy(factor, at);
            QVERIFY(isNear(s.toPlane(at), point));
        }
        QVERIFY(!s.isHome());
    }

    void zoomEndsSomewhere()
    {
        PlaneSight s = sight();
        for (int k = 0; k < 100; ++k) {
            s.zoomBy(2, {160, 120});
        }
        QVERIFY(std::abs(s.zoom() - 50) < 1e-9);
        for (int k = 0; k < 100; ++k) {
            s.zoomBy(0.5, {160, 120});
        }
        QVERIFY(std::abs(s.zoom() - 0.5) < 1e-9);
        s.zoomBy(0, {0, 0});
        s.zoomBy(std::numeric_limits<double>::quiet_NaN(), {0, 0});
        QVERIFY(std::abs(s.zoom() - 0.5) < 1e-9);
    }

    void panMovesWithTheHandAndNeverLosesSightOfHome()
    {
        PlaneSight s = sight();
        s.zoomBy(4, {160, 120});
        const glm::dvec2 point = s.toPlane({160, 120});
        s.panBy({30, -20});
        QVERIFY(isNear(s.toPlane({190, 100}), point));
        s.panBy({1e9, 1e9});
        const glm::dvec2 middle = s.toPlane(s.middleOfView());
        QVERIFY(isNear(middle, {0, 1}));
    }

    void aPointInSightMovesNothingAndOneBesideNoMoreThanItTakes()
    {
        PlaneSight s = sight();
        s.zoomBy(4, {160, 120});
        const PlaneSight before = s;
        QVERIFY(!s.bringIntoSight({1, 0.5}, 20));
        QCOMPARE(s, before);
        const glm::dvec2 beside = s.toPlane({330, 120});
        QVERIFY(s.bringIntoSight(beside, 20));
        QVERIFY(isNear(s.toView(beside), {290, 120}));
    }

    void anotherThingIsShownAsLargeAsTheOneBefore()
    {
        PlaneSight s = sight();
        s.goHomeTo({{100, 100}, {104, 102}}, 50);
        QVERIFY(s.isHome());
        QVERIFY(isNear(s.toView({102, 101}), {160, 120}));
        s.zoomBy(5, {160, 120});
        s.goHomeTo({{0, 0}, {1, 1}}, 50);
        QVERIFY(!s.isHome());
        QVERIFY(std::abs(s.zoom() - 5) < 1e-9);
        s.goHome();
        QCOMPARE(s.zoom(), 1.0);
    }
};

} // namespace trixel::ui

QTEST_GUILESS_MAIN(trixel::ui::PlaneSightTest)
#include "tst_plane_sight.moc"
