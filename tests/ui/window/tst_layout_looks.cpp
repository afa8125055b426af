// SPDX-License-Identifier: GPL-3.0-or-later
//
// Looking tools in the layout's net: the maps of faces, the filtered picture, both sides of the
// split line, by the keys and the pointer that the view takes.
#include <QApplication>

#include "core/filter/filter_method.h"
#include "tests/ui/inspector/layout_fixture.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/inspector/net_filter.h"
#include "ui/viewport/split_bar.h"
#include "ui/viewport/view_map.h"

#include <set>

namespace trixel::ui {

namespace {

constexpr FaceId kFace{0};
constexpr int kPatience = 30'000;

} // namespace

class LayoutLooksTest : public WindowTest
{
    Q_OBJECT

private slots:
    void init()
    {
        openWindow();
        m_window->resize(1300, 900);
        document().open(fanProject(), {}, "fan");
        m_window->viewport().setFocus();
        press(Qt::Key_F3, Qt::ShiftModifier);
        panel().setMarks({false, false, false, false, false});
        m_window->inspection().pointAt(TexelPlace{kFace, {1, 1, TexelHalf::Lower}});
        m_window->viewport().setFocus();
        QTRY_VERIFY(net().isVisible() && net().scene());
    }
    void cleanup() { closeWindow(); }

    void facesAreShownInTheColoursOfTheMap()
    {
        const QImage texels = picture();
        press(Qt::Key_6, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->viewMap().isComplete(), kPatience);
        // Levels 1 to 4, face 0 at 3 and its neighbours across at 2.
        const MapScale scale = MapScale::ofLevels(1, 4);
        QTRY_COMPARE(colorAt({kFace, {3, 2, TexelHalf::Lower}}), toColor(scale.color(3)));
        QCOMPARE(colorAt({kFace, {0, 4, TexelHalf::Upper}}), toColor(scale.color(3)));
        QCOMPARE(colorAt({FaceId{1}, {1, 1, TexelHalf::Lower}}), toColor(scale.color(2)));
        QVERIFY(colorsIn(view(LayoutKind::Packed)).size() > 20); // texels as they are
        press(Qt::Key_7, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->viewMap().isComplete(), kPatience);
        QTRY_VERIFY(colorAt({kFace, {3, 2, TexelHalf::Lower}}) != toColor(scale.color(3)));
        press(Qt::Key_1, Qt::ControlModifier);
        QTRY_COMPARE(picture(), texels);
    }

    void everyPixelOfTheNetIsWhatTheFilterMakesOfIt()
    {
        const QImage texels = picture();
        press(Qt::Key_V);
        QTRY_VERIFY_WITH_TIMEOUT(panel().filter()->isComplete(), kPatience);
        QVERIFY(picture() != texels);
        const NetFilter::Place place = *panel().filter()->place();
        const QImage& filtered = *panel().filter()->picture(render::Side::A);
        // Ask the method itself, on a scene of its own.
        NoProgress progress;
        const Surface& surface = *document().surface();
        const auto shape = std::make_shared<const FilterSurface>(
            FilterSurface::fromMesh(surface.mesh(), surface.adjacency()));
        const FilterScene scene =
            FilterScene::build(shape, document().texels(), Threads{1}, progress).value();
        const auto method = makeMethod(m_window->settings().method());
        int asked = 0;
        for (const SceneFace& face : place.scene.faces) {
            const PlaneMap map = face.layout.moved(place.toPixels).map();
            const PlaneMap back = map.inverse();
            for (const glm::dvec2 uv : {glm::dvec2(0.3, 0.3), {0.05, 0.5}, {0.48, 0.5}}) {
                const glm::dvec2 pixel = glm::floor(map.point(uv));
                if (!place.area.contains(int(pixel.x), int(pixel.y))) {
                    continue;
                }
                const glm::vec2 at(back.point(pixel + 0.5));
                QueryArrays query;
                query.add(face.face, at, glm::vec2(back.x), glm::vec2(back.y));
                ResultArrays answer(1, 3);
                method->filter(scene, query.queries(), answer.results());
                const QColor seen = filtered.pixelColor(int(pixel.x), int(pixel.y));
                const int shown[] = {seen.red(), seen.green(), seen.blue()};
                for (std::size_t c = 0; c < 3; ++c) {
                    QVERIFY(std::abs(double{answer.values[c]} * 255 - shown[c]) <= 1);
                }
                ++asked;
            }
        }
        QVERIFY(asked >= 6);
        press(Qt::Key_V);
        QTRY_COMPARE(picture(), texels);
    }

    void twoFiltersAreComparedOnBothSidesOfTheLine()
    {
        press(Qt::Key_8, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(panel().filter()->isComplete(), kPatience);
        QVERIFY(bar().isVisible());
        const QImage* a = panel().filter()->picture(render::Side::A);
        const QImage* b = panel().filter()->picture(render::Side::B);
        QVERIFY(a != nullptr && b != nullptr && *a != *b);
        m_window->settings().setMethod(m_window->settings().comparison().method);
        QTRY_VERIFY_WITH_TIMEOUT(panel().filter()->isComplete(), kPatience);
        QCOMPARE(*panel().filter()->picture(render::Side::A),
                 *panel().filter()->picture(render::Side::B));
    }

    void rightOfTheLineLevelsAreCoarser()
    {
        const QImage texels = picture();
        press(Qt::Key_9, Qt::ControlModifier);
        press(Qt::Key_PageDown, Qt::ShiftModifier);
        press(Qt::Key_PageDown, Qt::ShiftModifier);
        QCOMPARE(m_window->settings().comparison().levelsDropped, 3);
        QVERIFY(bar().isVisible());
        QCOMPARE(bar().rightText(), QString("B: 3 levels coarser"));
        bar().setFocus();
        QTest::keyClick(&bar(), Qt::Key_Home); // all is B: level 0
        QCOMPARE(colorAt({kFace, {1, 1, TexelHalf::Lower}}),
                 colorAt({kFace, {5, 0, TexelHalf::Upper}}));
        QTest::keyClick(&bar(), Qt::Key_End); // all is A
        QVERIFY(colorAt({kFace, {1, 1, TexelHalf::Lower}}) !=
                colorAt({kFace, {5, 0, TexelHalf::Upper}}));
        press(Qt::Key_9, Qt::ControlModifier);
        QVERIFY(!bar().isVisible());
        QTRY_COMPARE(picture(), texels);
    }

    void rightOfTheLineTexelsAreThoseBefore()
    {
        const TexelPlace place{kFace, {1, 1, TexelHalf::Lower}};
        const QColor before = colorAt(place);
        fillFace(indexOf(kFace));
        QTRY_COMPARE(colorAt(place), QColor(255, 0, 0));
        press(Qt::Key_0, Qt::ControlModifier);
        bar().setFocus();
        QTest::keyClick(&bar(), Qt::Key_Home);
        QCOMPARE(colorAt(place), before);
        actionNamed(*m_window, "Remember Texels as Before")->trigger();
        QCOMPARE(colorAt(place), QColor(255, 0, 0));
        document().undoStack().undo();
        QTRY_COMPARE(colorAt(place), QColor(255, 0, 0)); // B stays
        QTest::keyClick(&bar(), Qt::Key_End);
        QCOMPARE(colorAt(place), before);
    }

    void twoWaysOfDrawingAreSaidToBeSeenInTheViewAlone()
    {
        const QString plain = net().caption();
        const QImage before = picture();
        press(Qt::Key_8, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(m_window->settings().comparison().by == ComparedBy::Filtering);
        QVERIFY(m_window->viewport().splitBar().isVisible());
        QVERIFY(!bar().isVisible());
        QVERIFY(net().caption() != plain && net().caption().contains("view alone"));
        QVERIFY(picture() != before); // it is written there
        QCOMPARE(view(LayoutKind::Packed).caption(), captionOf(LayoutKind::Packed));
        press(Qt::Key_8, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(net().caption(), plain);
        QTRY_COMPARE(picture(), before);
    }

    void oneLineSplitsViewAndNet()
    {
        press(Qt::Key_0, Qt::ControlModifier);
        SplitBar& viewBar = m_window->viewport().splitBar();
        const int before = viewBar.x();
        const QPoint grip(bar().width() / 2, bar().height() / 3);
        QTest::mousePress(&bar(), Qt::LeftButton, {}, grip);
        const QPoint to = grip + QPoint(-net().width() / 4, 0);
        QMouseEvent move(QEvent::MouseMove,
                         QPointF(to),
                         QPointF(bar().mapToGlobal(to)),
                         Qt::NoButton,
                         Qt::LeftButton,
                         Qt::NoModifier);
        QCoreApplication::sendEvent(&bar(), &move);
        QTest::mouseRelease(&bar(), Qt::LeftButton);
        QVERIFY(std::abs(m_window->settings().comparison().split - 0.25) < 0.02);
        QVERIFY(viewBar.x() < before);
        QVERIFY(std::abs(bar().geometry().center().x() - net().width() / 4) <= 2);
    }

    void hiddenDockAsksNoFilter()
    {
        press(Qt::Key_V);
        QTRY_VERIFY(panel().filter()->place());
        press(Qt::Key_F3, Qt::ShiftModifier);
        QVERIFY(!panel().isVisible());
        QVERIFY(!panel().filter()->place());
    }

private:
    LayoutPanel& panel() { return *m_window->findChild<LayoutPanel*>(); }
    LayoutView& view(LayoutKind kind) { return panel().view(kind); }
    LayoutView& net() { return view(LayoutKind::Net); }
    SplitBar& bar() { return *net().findChild<SplitBar*>(); }
    QImage picture() { return net().grab().toImage(); }
    QColor colorAt(const TexelPlace& place)
    {
        bar().hide(); // its line lies over texels
        const QColor color = picture().pixelColor(net().positionOf(place).value().toPoint());
        bar().setVisible(splitsNet(m_window->settings()));
        return QColor(color.red(), color.green(), color.blue());
    }
    static std::set<QRgb> colorsIn(LayoutView& view)
    {
        const QImage image = view.grab().toImage();
        std::set<QRgb> colors;
        for (int x = 0; x < image.width(); ++x) {
            colors.insert(image.pixel(x, image.height() / 2));
        }
        return colors;
    }
    static QColor toColor(render::Rgb color) { return {color[0], color[1], color[2]}; }
};

} // namespace trixel::ui

TRIXEL_WINDOW_TEST_MAIN(trixel::ui::LayoutLooksTest)
#include "tst_layout_looks.moc"
