// SPDX-License-Identifier: GPL-3.0-or-later
//
// The maps over the view, driven as a user does.
#include "core/mesh/limit_mesh.h"
#include "core/study/views/view_map.h"
#include "render/camera_view.h"
#include "tests/core/mesh/cages.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/docks/readout_panel.h"
#include "ui/viewport/map_legend.h"
#include "ui/viewport/view_map.h"

#include <algorithm>
#include <cmath>

namespace trixel::ui {

namespace {

void drag(QWidget& widget, Qt::KeyboardModifiers modifiers, QPoint from, QPoint to)
{
    QTest::mousePress(&widget, Qt::LeftButton, modifiers, from);
    QMouseEvent move(QEvent::MouseMove,
                     QPointF(to),
                     QPointF(widget.mapToGlobal(to)),
                     Qt::NoButton,
                     Qt::LeftButton,
                     modifiers);
    QCoreApplication::sendEvent(&widget, &move);
    QTest::mouseRelease(&widget, Qt::LeftButton, modifiers, to);
}

void hover(QWidget& widget, QPoint to)
{
    QMouseEvent move(QEvent::MouseMove,
                     QPointF(to),
                     QPointF(widget.mapToGlobal(to)),
                     Qt::NoButton,
                     Qt::NoButton,
                     Qt::NoModifier);
    QCoreApplication::sendEvent(&widget, &move);
}

} // namespace

class MapsTest : public WindowTest
{
    Q_OBJECT

private slots:
    void init()
    {
        openWindow();
        m_window->resize(640, 480);
        openGrid();
        fillFace(20);
        fillFace(40);
        ViewOptions options;
        options.lit = false;
        options.footprint = false;
        m_window->settings().setView(options);
        m_window->viewport().lookFrom(20, 30, 1.2);
    }
    void cleanup() { closeWindow(); }

    void aMapComesAndGoesByItsKeys()
    {
        QVERIFY(!map().legend().isVisible());
        press(Qt::Key_3, Qt::ControlModifier);
        QCOMPARE(m_window->settings().view().map, ViewMapKind::Condition);
        QVERIFY(map().legend().isVisible());
        QTRY_VERIFY(map().isComplete());
        QVERIFY(view().hasPicture());
        press(Qt::Key_1, Qt::ControlModifier);
        QVERIFY(!view().hasPicture());
        QVERIFY(!map().legend().isVisible());
    }

    void conditionIsShownAsItIs()
    {
        show(ViewMapKind::Condition);
        const QPoint middle = view().rect().center();
        const auto value = map().valueAt(middle);
        QVERIFY(value);
        const auto point = view().surfacePointAt(middle);
        const glm::dvec2 pixel = glm::floor(glm::dvec2(middle.x(), middle.y())) + 0.5;
        const Footprint footprint = screenFootprint(
            view().camera().pixelRay(pixel), document().surface()->mesh().corners(point->face));
        const FootprintEllipse ellipse =
            ellipseOf(footprint, document().surface()->mesh().corners(point->face));
        QVERIFY(std::abs(*value / ellipse.anisotropy() - 1) < 1e-3);
        QVERIFY(*value > 1.1); // seen at an angle
        const render::Rgb color = MapScale::of(ViewMapKind::Condition).color(*value);
        QCOMPARE(seen(middle), QColor(color[0], color[1], color[2]));
        QVERIFY(!map().valueAt(QPointF(2, view().height() - 2))); // beside the mesh
    }

    void conditionIsTheLimitSurfacesWhereThatIsShown()
    {
        NoProgress progress;
        Project project;
        project.surface = Surface::build(test::icosahedron(), progress).value();
        project.texels = TexelStore(20, TexelFormat{}, Level(3), std::array<std::byte, 3>{});
        document().open(std::move(project), {}, "ball");
        show(ViewMapKind::Condition);
        const QPoint at = view().rect().center() + QPoint(60, 30);
        const float onCage = *map().valueAt(at);
        ViewOptions options = m_window->settings().view();
        options.limitSurface = true;
        m_window->settings().setView(options);
        QTRY_VERIFY(view().seenLimit());
        QTRY_VERIFY(!map().isComplete());
        QTRY_VERIFY(map().isComplete());
        const glm::dvec2 pixel = glm::floor(glm::dvec2(at.x(), at.y())) + 0.5;
        const auto point = view().surfacePointAt(QPointF(pixel.x, pixel.y));
        QVERIFY(point);
        const glm::dvec2 uv(point->uv);
        const auto flat = view().seenLimit()->surface().at(point->face, uv).tangentFace(uv);
        const Footprint footprint = screenFootprint(view().camera().pixelRay(pixel), flat);
        const double condition = ellipseOf(footprint, flat).anisotropy();
        QVERIFY(std::abs(*map().valueAt(at) / condition - 1) < 1e-3);
        QVERIFY(std::abs(onCage / condition - 1) > 0.02);
    }

    void thePointerReadsItsNumber()
    {
        show(ViewMapKind::Condition);
        QVERIFY(map().legend().valueText().isEmpty());
        hover(view(), view().rect().center());
        QCOMPARE(map().legend().valueText(),
                 MapScale::text(ViewMapKind::Condition, *map().valueAt(view().rect().center())));
        hover(view(), QPoint(2, view().height() - 2));
        QVERIFY(map().legend().valueText().isEmpty());
    }

    void orbitingThrowsTheMapAwayAndAnotherFollows()
    {
        show(ViewMapKind::Condition);
        const float before = *map().valueAt(view().rect().center());
        const QPoint middle = view().rect().center();
        drag(view(), Qt::AltModifier, middle, middle + QPoint(0, 60));
        QVERIFY(!view().hasPicture());
        QCOMPARE(map().completeStep(), 0);
        QTRY_VERIFY(map().isComplete());
        QVERIFY(std::abs(*map().valueAt(middle) - before) > 0.01F);
    }

    void theSizeOfTheViewIsTheSizeOfTheMap()
    {
        show(ViewMapKind::Condition);
        m_window->resize(700, 520);
        QTRY_VERIFY(!view().hasPicture() || map().isComplete());
        QTRY_VERIFY(map().isComplete());
        QVERIFY(map().valueAt(view().rect().center()));
    }

    void coarsePassesComeFirst()
    {
        std::vector<int> steps;
        connect(&map(), &ViewMap::progressed, this, [&] {
            if (steps.empty() || steps.back() != map().completeStep()) {
                steps.push_back(map().completeStep());
            }
        });
        show(ViewMapKind::Filtered);
        steps.erase(std::remove(steps.begin(), steps.end(), 0), steps.end());
        QCOMPARE(steps, (std::vector<int>{8, 4, 2, 1}));
    }

    void theFilteredPictureShowsThePaint()
    {
        choose("point");
        show(ViewMapKind::Filtered);
        const QPoint painted = placeOf(20);
        const QPoint plain = placeOf(60);
        QCOMPARE(seen(painted), QColor(255, 0, 0));
        QCOMPARE(seen(plain), QColor(204, 204, 204));
        document().undoStack().undo();
        document().undoStack().undo();
        QVERIFY(!view().hasPicture());
        QTRY_VERIFY(map().isComplete());
        QCOMPARE(seen(painted), QColor(204, 204, 204));
    }

    void exactHasNoErrorAndOthersHave()
    {
        choose("exact");
        show(ViewMapKind::Error);
        QCOMPARE(worst(), 0.0F);
        choose("point");
        QVERIFY(!view().hasPicture());
        QTRY_VERIFY_WITH_TIMEOUT(map().isComplete(), 30000);
        QVERIFY2(worst() > 0.1F, qPrintable(QString::number(worst())));
        QVERIFY(worst() <= 1.0F);
    }

    void theLegendNamesTheMethod()
    {
        show(ViewMapKind::Error);
        for (const char* name : {"point", "exact"}) {
            choose(name);
            const std::string_view title = findMethod(name)->title;
            QVERIFY(map().legend().title().contains(
                QString::fromUtf8(title.data(), static_cast<qsizetype>(title.size()))));
        }
    }

    void levelsColourTheFacesAndStayWhileTheCameraMoves()
    {
        TexelStore texels = document().texels();
        const Level own = texels.face(FaceId{20}).level();
        texels.exchange(FaceId{20}, texels.face(FaceId{20}).atLevel(own.coarser()));
        QVERIFY(document().replaceTexels(texels, document().state(), "coarser"));
        show(ViewMapKind::Level);
        const int coarse = own.log2() - 1;
        const MapScale scale = MapScale::ofLevels(coarse, coarse + 1);
        const auto colorOf = [&](int level) {
            const render::Rgb color = scale.color(level);
            return QColor(color[0], color[1], color[2]);
        };
        QCOMPARE(seen(placeOf(20)), colorOf(coarse));
        QCOMPARE(seen(placeOf(60)), colorOf(coarse + 1));
        QCOMPARE(*map().valueAt(placeOf(20)), float(coarse));
        hover(view(), placeOf(60));
        QCOMPARE(map().legend().valueText(), QString("level %1").arg(coarse + 1));
        const QPoint middle = view().rect().center();
        drag(view(), Qt::AltModifier, middle, middle + QPoint(20, 30));
        QVERIFY(map().isComplete());
        QCOMPARE(seen(placeOf(20)), colorOf(coarse));
        document().undoStack().undo();
        QTRY_VERIFY(map().isComplete());
        QCOMPARE(*map().valueAt(placeOf(20)), float(coarse + 1));
        press(Qt::Key_1, Qt::ControlModifier);
        QVERIFY(!view().hasFaceColors());
        QCOMPARE(seen(placeOf(20)), QColor(255, 0, 0));
    }

    void densityIsTexelsAlongAUnit()
    {
        press(Qt::Key_7, Qt::ControlModifier);
        QTRY_VERIFY(map().isComplete());
        const TriangleMesh& mesh = document().surface()->mesh();
        const Level level = document().texels().face(FaceId{20}).level();
        const auto corners = mesh.corners(FaceId{20});
        double squares = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const float length = glm::length(corners[k] - corners[(k + 1) % 3]);
            squares += double{length} * double{length};
        }
        const double wanted = level.resolution() / std::sqrt(squares / 3);
        QVERIFY(std::abs(double{*map().valueAt(placeOf(20))} / wanted - 1) < 1e-5);
        QVERIFY(map().legend().isVisible());
    }

    void everyMethodCanBeChosenFromTheMenu()
    {
        for (const MethodEntry& entry : filterMethods()) {
            QAction* action = actionNamed(
                *m_window,
                QString::fromUtf8(entry.title.data(), static_cast<qsizetype>(entry.title.size())));
            QVERIFY(action);
            action->trigger();
            QCOMPARE(m_window->settings().method().name, std::string(entry.name));
            QVERIFY(action->isChecked());
        }
    }

    void cancellingThePreparationTurnsTheMapOff()
    {
        press(Qt::Key_2, Qt::ControlModifier);
        QVERIFY(m_window->jobs().latest());
        m_window->jobs().latest()->cancel();
        QTRY_COMPARE(m_window->settings().view().map, ViewMapKind::None);
        QVERIFY(!map().legend().isVisible());
    }

    void closingWhileItIsComputedIsSafe()
    {
        choose("exact");
        press(Qt::Key_4, Qt::ControlModifier);
        QTRY_VERIFY(view().hasPicture());
        closeWindow();
    }

    void theReadoutTellsTheErrorThatTheMapShows()
    {
        choose("nearest-level");
        show(ViewMapKind::Error);
        // A pixel that sees both the painted face and what is beside it.
        const auto corners = document().surface()->mesh().corners(FaceId{20});
        const auto place =
            view().widgetPosition({FaceId{20}, {0.5F, 0}, pointAt(corners, 0.5F, 0)});
        const QPoint at = place->toPoint();
        hover(view(), at);
        const auto* readout = m_window->findChild<ReadoutPanel*>();
        const float shown = map().valueAt(at).value_or(-1);
        QVERIFY(shown > 0.001F);
        const QString wanted = QString("Error: %1 %").arg(100 * double{shown}, 0, 'g', 3);
        QTRY_VERIFY2(readout->text().contains(wanted),
                     qPrintable(wanted + " in\n" + readout->text()));
        // Another method answers for the same pixel, without another move.
        choose("exact");
        QTRY_VERIFY(readout->text().contains("Error: 0 %"));
    }

    void paintUnderTheRestingPointerIsFilteredAnew()
    {
        choose("point");
        hover(view(), placeOf(60));
        const auto* readout = m_window->findChild<ReadoutPanel*>();
        QTRY_VERIFY(readout->text().contains("Filtered: 204.00  204.00  204.00"));
        fillFace(60);
        QTRY_VERIFY(readout->text().contains("Filtered: 255.00  0.00  0.00"));
    }

    void coreSeesTheSameRaysAsTheView()
    {
        for (const QSize size : {QSize(640, 480), QSize(400, 700)}) {
            render::Camera camera = view().camera();
            camera.setViewport(size.width(), size.height());
            const ViewCamera same = render::viewOf(camera);
            QVERIFY(validate(same));
            for (const glm::dvec2 at :
                 {glm::dvec2(0.5), glm::dvec2(100.5, 37.5), glm::dvec2(399.5, 479.5)}) {
                const PixelRay a = camera.pixelRay(at);
                const PixelRay b = same.pixelRay(at.x, at.y);
                QVERIFY(glm::length(a.origin - b.origin) < 1e-12);
                QVERIFY(glm::length(a.direction - b.direction) < 1e-9);
                QVERIFY(glm::length(a.perX - b.perX) < 1e-9);
                QVERIFY(glm::length(a.perY - b.perY) < 1e-9);
            }
        }
    }

private:
    ViewMap& map() { return m_window->viewMap(); }
    Viewport& view() { return m_window->viewport(); }
    void choose(const std::string& method)
    {
        m_window->settings().setMethod({method, std::nullopt});
    }
    void show(ViewMapKind kind)
    {
        ViewOptions options = m_window->settings().view();
        options.map = kind;
        m_window->settings().setView(options);
        QTRY_VERIFY_WITH_TIMEOUT(map().isComplete(), 30000);
    }
    QPoint placeOf(std::uint32_t face)
    {
        const auto corners = document().surface()->mesh().corners(FaceId{face});
        const glm::vec2 uv(1.0F / 3.0F);
        const auto place = view().widgetPosition({FaceId{face}, uv, pointAt(corners, uv.x, uv.y)});
        return place ? place->toPoint() : QPoint();
    }
    QColor seen(QPoint position)
    {
        return m_window->viewport().grabFramebuffer().pixelColor(position);
    }
    /// Largest value of the map over the view.
    float worst()
    {
        float largest = 0;
        for (int y = 0; y < view().height(); y += 3) {
            for (int x = 0; x < view().width(); ++x) {
                largest = std::max(largest, map().valueAt(QPointF(x, y)).value_or(0.0F));
            }
        }
        return largest;
    }
};

} // namespace trixel::ui

TRIXEL_WINDOW_TEST_MAIN(trixel::ui::MapsTest)
#include "tst_maps.moc"
