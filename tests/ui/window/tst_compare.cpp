// SPDX-License-Identifier: GPL-3.0-or-later
//
// A view split in two, driven as a user does.
#include <QMenu>
#include <QToolButton>

#include "tests/ui/window/window_fixture.h"
#include "ui/viewport/split_bar.h"
#include "ui/viewport/view_map.h"

namespace trixel::ui {

namespace {

constexpr FaceId kPainted{20};

void drag(QWidget& widget, QPoint from, QPoint to)
{
    QTest::mousePress(&widget, Qt::LeftButton, Qt::NoModifier, from);
    QMouseEvent move(QEvent::MouseMove,
                     QPointF(to),
                     QPointF(widget.mapToGlobal(to)),
                     Qt::NoButton,
                     Qt::LeftButton,
                     Qt::NoModifier);
    QCoreApplication::sendEvent(&widget, &move);
    QTest::mouseRelease(&widget, Qt::LeftButton, Qt::NoModifier, to);
}

} // namespace

class CompareTest : public WindowTest
{
    Q_OBJECT

private slots:
    void init()
    {
        openWindow();
        m_window->resize(640, 480);
        openGrid();
        ViewOptions options;
        options.lit = false;
        options.footprint = false;
        m_window->settings().setView(options);
        m_window->viewport().lookFrom(20, 30, 1.2);
    }
    void cleanup() { closeWindow(); }

    void theLineComesAndGoesByTheSameKey()
    {
        QVERIFY(!bar().isVisible());
        press(Qt::Key_0, Qt::ControlModifier);
        QVERIFY(bar().isVisible());
        QCOMPARE(bar().leftText(), QString("A: now"));
        QCOMPARE(bar().rightText(), QString("B: before"));
        press(Qt::Key_0, Qt::ControlModifier);
        QVERIFY(!bar().isVisible());
    }

    void beforeIsWhatWasOpenedUntilAnotherIsRemembered()
    {
        const QColor plain = seen(placeOf(kPainted));
        fillFace(20);
        press(Qt::Key_0, Qt::ControlModifier);
        moveLine(1.0);
        QCOMPARE(seen(placeOf(kPainted)), QColor(255, 0, 0));
        moveLine(0.0);
        QCOMPARE(seen(placeOf(kPainted)), plain);
        actionNamed(*m_window, "Remember Texels as Before")->trigger();
        QCOMPARE(seen(placeOf(kPainted)), QColor(255, 0, 0));
        document().undoStack().undo();
        QCOMPARE(seen(placeOf(kPainted)), QColor(255, 0, 0));
        moveLine(1.0);
        QCOMPARE(seen(placeOf(kPainted)), plain);
    }

    void theLineIsDraggedAndMovedByKeys()
    {
        fillFace(20);
        press(Qt::Key_0, Qt::ControlModifier);
        const QPoint painted = placeOf(kPainted);
        const QPoint grip = bar().rect().center();
        const auto lineAt = [&](int x) {
            drag(bar(), grip, bar().mapFrom(&view(), QPoint(x, bar().mapTo(&view(), grip).y())));
        };
        lineAt(painted.x() - 15);
        QVERIFY(seen(painted) != QColor(255, 0, 0)); // of B
        lineAt(painted.x() + 15);
        QCOMPARE(seen(painted), QColor(255, 0, 0));
        bar().setFocus();
        const double before = m_window->settings().comparison().split;
        QTest::keyClick(&bar(), Qt::Key_Left);
        QVERIFY(m_window->settings().comparison().split < before);
        QTest::keyClick(&bar(), Qt::Key_Home);
        QCOMPARE(m_window->settings().comparison().split, 0.0);
        QTest::keyClick(&bar(), Qt::Key_End);
        QCOMPARE(m_window->settings().comparison().split, 1.0);
    }

    void levelsOfTheRightAreCoarserAndFollowThePaint()
    {
        paintOneTexel();
        press(Qt::Key_9, Qt::ControlModifier);
        moveLine(1.0);
        const QPoint texel = placeOf(kPainted, {0.04F, 0.04F});
        QCOMPARE(seen(texel), QColor(255, 0, 0));
        moveLine(0.0);
        const QColor half = seen(texel);
        QVERIFY(half != QColor(255, 0, 0) && half.red() > half.green()); // the mean of four
        press(Qt::Key_PageDown, Qt::ShiftModifier);
        QCOMPARE(m_window->settings().comparison().levelsDropped, 2);
        QVERIFY(seen(texel).green() > half.green());
        QCOMPARE(bar().rightText(), QString("B: 2 levels coarser"));
        document().undoStack().undo();
        QCOMPARE(seen(texel), QColor(204, 204, 204));
    }

    void eachSideIsDrawnInItsWay()
    {
        paintOneTexel();
        const QPoint texel = placeOf(kPainted, {0.04F, 0.04F});
        QCOMPARE(seen(texel), QColor(255, 0, 0));
        press(Qt::Key_8, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(bar().leftText(), QString("A: Texels"));
        QCOMPARE(bar().rightText(), QString("B: Seamless"));
        m_window->viewport().settle();
        moveLine(1.0);
        QCOMPARE(seen(texel), QColor(255, 0, 0));
        moveLine(0.0);
        const QColor soft = seen(texel); // at its corners are means with its neighbours
        QVERIFY(soft != QColor(255, 0, 0) && soft.red() > soft.green());
        document().undoStack().undo();
        QCOMPARE(seen(texel), QColor(204, 204, 204));
        press(Qt::Key_8, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(!bar().isVisible());
        press(Qt::Key_V, Qt::ShiftModifier);
        QCOMPARE(m_window->settings().view().filtering, render::Filtering::Seamless);
        press(Qt::Key_V, Qt::ShiftModifier);
        QCOMPARE(m_window->settings().view().filtering, render::Filtering::Texels);
    }

    void eachSideIsFilteredByItsMethod()
    {
        paintOneTexel();
        m_window->settings().setMethod({"point", std::nullopt});
        press(Qt::Key_8, Qt::ControlModifier);
        QCOMPARE(m_window->settings().view().map, ViewMapKind::Filtered);
        QVERIFY(m_window->settings().comparison().method != m_window->settings().method());
        moveLine(1.0);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->viewMap().isComplete(), 30000);
        const QPoint edge = placeOf(kPainted, {0.125F, 0.0F}); // where the painted texel ends
        const QImage left = m_window->viewport().grabFramebuffer();
        moveLine(0.0);
        QVERIFY(m_window->viewMap().isComplete()); // only the line has moved
        const QImage right = m_window->viewport().grabFramebuffer();
        int differing = 0;
        for (int x = edge.x() - 6; x < edge.x() + 6; ++x) {
            differing += left.pixelColor(x, edge.y()) != right.pixelColor(x, edge.y()) ? 1 : 0;
        }
        QVERIFY(differing > 0);
        const QString method = bar().leftText();
        actionNamed(*m_window, "Swap A and B")->trigger();
        QCOMPARE(bar().rightText().mid(3), method.mid(3));
        QTRY_VERIFY_WITH_TIMEOUT(m_window->viewMap().isComplete(), 30000);
        QCOMPARE(m_window->viewport().grabFramebuffer(), left);
        press(Qt::Key_8, Qt::ControlModifier);
        QCOMPARE(m_window->settings().view().map, ViewMapKind::None);
        QVERIFY(!view().hasPicture());
    }

    void theButtonsOfferWhatTheirSideMayShow()
    {
        const auto offers = [this] {
            return m_window->viewport().findChildren<QToolButton*>(QString(),
                                                                   Qt::FindDirectChildrenOnly);
        };
        press(Qt::Key_8, Qt::ControlModifier);
        for (const QToolButton* button : offers()) {
            if (button->text().startsWith("A: ") || button->text().startsWith("B: ")) {
                QVERIFY(button->menu() != nullptr);
                QVERIFY(button->menu()->actions().size() >=
                        static_cast<qsizetype>(filterMethods().size()));
            }
        }
        actionNamed(*m_window, "B: Trilinear")->trigger();
        QCOMPARE(bar().rightText(), QString("B: Trilinear"));
    }

    void nearestAndFilteredTakeTurns()
    {
        press(Qt::Key_V);
        QCOMPARE(m_window->settings().view().map, ViewMapKind::Filtered);
        press(Qt::Key_V);
        QCOMPARE(m_window->settings().view().map, ViewMapKind::None);
    }

private:
    Viewport& view() { return m_window->viewport(); }
    SplitBar& bar() { return view().splitBar(); }
    void moveLine(double split)
    {
        Comparison comparison = m_window->settings().comparison();
        comparison.split = split;
        m_window->settings().setComparison(comparison);
    }
    /// The first texel of the painted face, red.
    void paintOneTexel()
    {
        TexelStore texels = document().texels();
        const std::span<std::byte> bytes = texels.writable(kPainted);
        bytes[0] = std::byte{255};
        bytes[1] = bytes[2] = std::byte{0};
        QVERIFY(document().replaceTexels(texels, document().state(), "one texel"));
    }
    QPoint placeOf(FaceId face, glm::vec2 uv = glm::vec2(1.0F / 3.0F))
    {
        const auto corners = document().surface()->mesh().corners(face);
        const auto place = view().widgetPosition({face, uv, pointAt(corners, uv.x, uv.y)});
        return place ? place->toPoint() : QPoint();
    }
    QColor seen(QPoint position)
    {
        return m_window->viewport().grabFramebuffer().pixelColor(position);
    }
};

} // namespace trixel::ui

TRIXEL_WINDOW_TEST_MAIN(trixel::ui::CompareTest)
#include "tst_compare.moc"
