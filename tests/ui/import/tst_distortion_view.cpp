// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a mapping distorts an image, over the surface and in words.
#include <QCheckBox>

#include "tests/ui/import/import_fixture.h"
#include "tests/ui/viewport/view_fixture.h"
#include "ui/import/distortion_scale.h"
#include "ui/import/distortion_view.h"
#include "ui/import/import_look.h"
#include "ui/viewport/map_legend.h"

#include <bit>

namespace trixel::ui {

class DistortionViewTest : public ImportTest
{
    Q_OBJECT

private slots:
    void init()
    {
        openWindow();
        openGrid();
    }
    void cleanup() { closeWindow(); }

    void itIsShownInTheColoursOfItsLegend()
    {
        openPanelWith("Plane");
        waitForPreview();
        // 8 cells of level 3 are 64 texels along the square, under 48 of the image's 64 x 48
        // pixels: the picture is 4/3 units wide and 1 high.
        show();
        const auto shown = distortion().shown();
        QCOMPARE(shown->colors.size(), std::size_t{3 * 128});
        const double number = distortionAt(*shown, faceId(40), {0.3, 0.3});
        // 64 texels a unit along each side of a right triangle's packed square hold two a cell.
        QVERIFY2(std::abs(number - std::sqrt(2.0) * 64 / 48) < 1e-3,
                 qPrintable(QString::number(number)));
        const render::Rgb color = distortionScale(shown->measure).color(number);
        const auto made = std::bit_cast<std::array<std::uint8_t, 4>>(shown->colors[3 * 40 + 1]);
        QVERIFY(made[0] == color[0] && made[1] == color[1] && made[2] == color[2]);
        const QColor seen = seenInTheMiddle();
        QVERIFY2(std::abs(seen.red() - color[0]) <= 2 && std::abs(seen.green() - color[1]) <= 2 &&
                     std::abs(seen.blue() - color[2]) <= 2,
                 qPrintable(seen.name()));
        QVERIFY(distortion().legend().isVisible());
        QVERIFY2(distortion().legend().title().contains("Texels a pixel"),
                 qPrintable(distortion().legend().title()));
    }

    void coloursOfCornersBlendOverAFace()
    {
        m_window->viewport().lookFrom(0, 0);
        std::vector<std::uint32_t> colors(3 * document().texels().faceCount(), 0xff000000U);
        const std::uint32_t face = 72; // near the middle
        colors[3 * face] = 0xff0000c8U;
        colors[3 * face + 1] = 0xff00c800U;
        colors[3 * face + 2] = 0xffc80000U;
        m_window->viewport().setFaceColors(colors);
        m_window->viewport().settle();
        const QImage image = m_window->viewport().grabFramebuffer();
        const auto triangle = document().surface()->mesh().corners(faceId(face));
        for (const glm::vec2 uv : {glm::vec2(0.2F, 0.2F), {0.6F, 0.2F}, {0.2F, 0.6F}}) {
            const auto at = m_window->viewport().widgetPosition(
                {faceId(face), uv, pointAt(triangle, uv.x, uv.y)});
            QVERIFY(at);
            const QColor seen = image.pixelColor(at->toPoint());
            const QColor blend(
                int(200 * (1 - uv.x - uv.y)), int(200 * uv.x), int(200 * uv.y)); // red at V0
            QVERIFY2(std::abs(seen.red() - blend.red()) < 8 &&
                         std::abs(seen.green() - blend.green()) < 8 &&
                         std::abs(seen.blue() - blend.blue()) < 8,
                     qPrintable(seen.name() + " " + blend.name()));
        }
    }

    void theNumberUnderThePointerIsSaid()
    {
        openPanelWith("Plane");
        waitForPreview();
        show();
        QWidget& view = m_window->viewport();
        movePointer(view, view.rect().center());
        QTRY_VERIFY2(distortion().legend().state().contains("1.89 texels a pixel"),
                     qPrintable(distortion().legend().state()));
    }

    void aPlaneThatIsWiderThanItsImageStretchesIt()
    {
        openPanelWith("Plane");
        waitForPreview();
        auto* keeps = widgetNamed<QCheckBox>(panel(), "Keep the image’s proportions");
        QTest::mouseClick(keeps, Qt::LeftButton, {}, QPoint(8, keeps->height() / 2));
        type("Width of the plane", "4"); // 64 pixels over 4 units, 48 over 1
        choose("Measure of the distortion", "Stretch", true);
        QTRY_VERIFY(distortion().isShown() &&
                    distortion().shown()->measure == DistortionMeasure::Stretch);
        QTRY_VERIFY(std::abs(distortionAt(*distortion().shown(), faceId(40), {0.3, 0.3}) - 3) <
                    1e-3);
    }

    void whatTheImageDoesNotReachIsGrey()
    {
        openPanelWith("Plane");
        waitForPreview();
        type("Centre of the plane, X", "1.2");
        show();
        QTRY_VERIFY(std::isnan(distortionAt(*distortion().shown(), faceId(0), {0.3, 0.3})));
        const auto grey =
            std::bit_cast<std::array<std::uint8_t, 4>>(distortion().shown()->colors[0]);
        QVERIFY(std::abs(grey[0] - grey[2]) < 6);
        QCOMPARE(distortionText(DistortionMeasure::Stretch, NAN), QString("not reached"));
    }

    void everyMappingHasOne()
    {
        openPanelWith("Sphere");
        type("Centre of the sphere, Z", "-1");
        waitForPreview();
        show();
        for (const QString mapping : {"Plane", "Quadrilateral", "Camera", "Sphere"}) {
            choose("How the image lies on the surface", mapping);
            waitForPreview();
            QTRY_VERIFY(
                distortion().isShown() &&
                (distortion().shown()->mapping.projection.has_value() != (mapping == "Sphere")));
            const double number = distortionAt(*distortion().shown(), faceId(70), {0.3, 0.3});
            QVERIFY2(number > 0.1 && number < 10, qPrintable(mapping));
        }
    }

    void theTexelsAreSeenAgainAfterwards()
    {
        openPanelWith("Plane");
        waitForPreview();
        const std::vector<std::byte> before = allTexels(document().texels());
        show();
        QVERIFY(m_window->viewport().hasFaceColors());
        QVERIFY(!m_window->viewport().showsOtherTexels());
        chooseLook("Show the texels with the image");
        QVERIFY(!m_window->viewport().hasFaceColors());
        QVERIFY(m_window->viewport().showsOtherTexels());
        show();
        click("Close without importing");
        QTRY_VERIFY(!m_window->viewport().hasFaceColors());
        QVERIFY(!distortion().legend().isVisible());
        QVERIFY(allTexels(document().texels()) == before);
    }

    void anotherMapTakesItsPlace()
    {
        openPanelWith("Plane");
        waitForPreview();
        show();
        ViewOptions view = m_window->settings().view();
        view.map = ViewMapKind::Level;
        m_window->settings().setView(view);
        QVERIFY(!distortion().isShown());
        QTRY_VERIFY(m_window->viewport().hasFaceColors()); // of the levels
        show();
        QVERIFY(m_window->settings().view().map == ViewMapKind::None);
    }

    void anotherProjectTakesItAlong()
    {
        openPanelWith("Plane");
        waitForPreview();
        show();
        document().open(gridProject(2, 2), {}, "other");
        QTRY_VERIFY(distortion().isShown() &&
                    distortion().shown()->colors.size() == std::size_t{3 * 8});
    }

private:
    const DistortionView& distortion() { return panel().look().distortion(); }
    void chooseLook(const QString& name)
    {
        auto* choice = widgetNamed<QRadioButton>(panel(), name);
        QTest::mouseClick(choice, Qt::LeftButton, {}, QPoint(8, choice->height() / 2));
    }
    void show()
    {
        chooseLook("Show the distortion of the image");
        QTRY_VERIFY(distortion().isShown());
    }
    void choose(const QString& box, const QString& entry, bool showsFirst = false)
    {
        if (showsFirst) {
            show();
        }
        ImportTest::choose(box, entry);
    }
    QColor seenInTheMiddle()
    {
        Viewport& view = m_window->viewport();
        view.settle();
        const QImage image = view.grabFramebuffer();
        return image.pixelColor(image.width() / 2 + 7, image.height() / 2 + 3);
    }
};

} // namespace trixel::ui

TRIXEL_WINDOW_TEST_MAIN(trixel::ui::DistortionViewTest)
#include "tst_distortion_view.moc"
