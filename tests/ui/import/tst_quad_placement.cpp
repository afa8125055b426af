// SPDX-License-Identifier: GPL-3.0-or-later
//
// Four corners of an image, dragged in the view and moved by the keyboard.
#include "core/mapping/projection.h"
#include "core/study/views/camera_clip.h"
#include "tests/ui/import/import_fixture.h"
#include "tests/ui/viewport/view_fixture.h"
#include "ui/import/corner_handle.h"
#include "ui/import/quad_overlay.h"

namespace trixel::ui {

class QuadPlacementTest : public ImportTest
{
    Q_OBJECT

private slots:
    void init()
    {
        openWindow();
        openGrid();
    }
    void cleanup() { closeWindow(); }

    void cornersAreSeenOnlyForMappingsThatHaveThem()
    {
        openPanelWith("Plane");
        QVERIFY(!handle(0)->isVisible());
        choose(kMapping, "Quadrilateral");
        for (std::size_t k = 0; k < 4; ++k) {
            QVERIFY(handle(k)->isVisible());
        }
        QVERIFY(overlay()->isVisible());
        choose(kMapping, "Camera");
        QVERIFY(handle(0)->isVisible());
        click("Close without importing");
        QVERIFY(!handle(0)->isVisible());
        QVERIFY(!overlay()->isVisible());
    }

    void theImageLiesUprightInTheViewAtFirst()
    {
        openPanelWith("Quadrilateral");
        waitForPreview();
        const std::array<glm::dvec3, 4> quad = panel().settings().quad;
        const double width = glm::length(quad[1] - quad[0]);
        const double height = glm::length(quad[3] - quad[0]);
        QVERIFY(std::abs(width / height - 64.0 / 48) < 1e-9);
        QVERIFY(quad[1].x > quad[0].x && quad[3].y > quad[0].y);
        QVERIFY(handle(0)->place().x() < handle(1)->place().x());
        QVERIFY(handle(0)->place().y() > handle(3)->place().y());
    }

    void draggedCornersOfAQuadrilateralMakeTheTexelsThatCoreBakes()
    {
        openPanelWith("Quadrilateral");
        waitForPreview();
        const std::array<glm::dvec3, 4> before = panel().settings().quad;
        const QPointF from = handle(2)->place();
        drag(2, QPoint(-60, 45));
        QVERIFY((handle(2)->place() - from - QPointF(-60, 45)).manhattanLength() < 2);
        const std::array<glm::dvec3, 4> quad = panel().settings().quad;
        QVERIFY(glm::length(quad[2] - before[2]) > 0.01);
        QVERIFY(std::abs(quad[2].z - before[2].z) < 1e-9); // in the plane that faces the view
        QVERIFY(quad[0] == before[0] && quad[1] == before[1] && quad[3] == before[3]);

        Projection projection = quadProjection(quad).value();
        projection.frontOnly = projection.visibleOnly = true;
        const ProjectionMapping mapping(
            document().surface()->mesh(), projection, &document().surface()->bvh());
        const std::vector<std::byte> expected = baked(mapping, allFaces());
        QVERIFY(!expected.empty());
        apply();
        QVERIFY(allTexels(document().texels()) == expected);
    }

    void draggedCornersOfACameraMakeTheTexelsThatCoreBakes()
    {
        m_window->viewport().lookFrom(20, 30);
        openPanel();
        m_window->viewport().lookFrom(20, 30);
        choose(kMapping, "Camera");
        panel().begin(path("photo.png"));
        waitForPreview();
        drag(0, QPoint(30, -20));
        drag(1, QPoint(-15, -40));
        const CameraSettings camera = panel().settings().camera;
        QVERIFY(camera.camera == m_window->viewport().view());
        Projection projection = cameraQuadProjection(toClip(camera.camera), camera.corners).value();
        const ProjectionMapping mapping(
            document().surface()->mesh(), projection, &document().surface()->bvh());
        const std::vector<std::byte> expected = baked(mapping, allFaces());
        QVERIFY(!expected.empty());
        apply();
        QVERIFY(allTexels(document().texels()) == expected);
    }

    void aCornerStandsWhereItsPixelIsThrown()
    {
        openPanelWith("Camera");
        waitForPreview();
        drag(1, QPoint(-90, -60));
        // The surface seen at the handle lies at the image's corner.
        const auto point = m_window->viewport().surfacePointAt(handle(1)->place());
        QVERIFY(point);
        const CameraSettings camera = panel().settings().camera;
        const Projection projection =
            cameraQuadProjection(toClip(camera.camera), camera.corners).value();
        const glm::dvec4 at = projection.toPlane * glm::dvec4(glm::dvec3(point->position), 1);
        const auto st = inverseBilinear(projection.corners, glm::dvec2(at) / at.w);
        QVERIFY(st && std::abs(st->x - 1) < 0.02 && std::abs(st->y) < 0.02);
    }

    void aCameraStaysWhereItWasWhenTheViewMovesOn()
    {
        openPanelWith("Camera");
        waitForPreview();
        const CameraSettings before = panel().settings().camera;
        m_window->viewport().lookFrom(60, 20);
        QVERIFY(panel().settings().camera == before);
        QVERIFY(!handle(0)->isVisible());
        QVERIFY2(text("About the corners").contains("moved on"),
                 qPrintable(text("About the corners")));
        click("Look from where the image comes from");
        QVERIFY(handle(0)->isVisible());
        m_window->viewport().lookFrom(60, 20);
        click("Place the image in the view");
        QVERIFY(handle(0)->isVisible());
        QVERIFY(panel().settings().camera.camera == m_window->viewport().view());
    }

    void theKeyboardReachesAndMovesEveryCorner()
    {
        openPanelWith("Quadrilateral");
        waitForPreview();
        click("Move the corners by keyboard");
        QCOMPARE(QApplication::focusWidget(), handle(0));
        const QPointF first = handle(0)->place();
        press(Qt::Key_Left);
        press(Qt::Key_Up, Qt::ShiftModifier);
        QVERIFY((handle(0)->place() - first - QPointF(-1, -10)).manhattanLength() < 0.01);
        for (std::size_t k = 1; k < 4; ++k) {
            press(Qt::Key_Tab);
            QCOMPARE(QApplication::focusWidget(), handle(k));
            const QPointF before = handle(k)->place();
            press(Qt::Key_Right, Qt::ShiftModifier);
            QVERIFY((handle(k)->place() - before - QPointF(10, 0)).manhattanLength() < 0.01);
        }
        press(Qt::Key_Backtab, Qt::ShiftModifier);
        QCOMPARE(QApplication::focusWidget(), handle(2));
        press(Qt::Key_Escape);
        QCOMPARE(QApplication::focusWidget(), &m_window->viewport());
    }

    void cornersAreNamedAndExplained()
    {
        openPanelWith("Camera");
        QSet<QString> names;
        for (std::size_t k = 0; k < 4; ++k) {
            names += handle(k)->accessibleName();
            QVERIFY(handle(k)->toolTip().contains("arrow keys"));
            QVERIFY(handle(k)->accessibleDescription().contains("pixels of the view"));
        }
        QCOMPARE(names.size(), 4);
    }

    void aBowTieIsSaidBesideTheFieldAndCannotBeApplied()
    {
        for (const QString mapping : {"Quadrilateral", "Camera"}) {
            openPanelWith(mapping);
            waitForPreview();
            const QPointF from = handle(2)->place();
            const QPointF over = handle(3)->place() - QPointF(40, 0) - from;
            drag(2, over.toPoint()); // the upper edge is the wrong way round now
            QVERIFY2(problem().contains("crosses itself"), qPrintable(problem()));
            QVERIFY(!button("Apply the import")->isEnabled());
            QVERIFY(!m_window->viewport().showsOtherTexels());
            QCOMPARE(document().undoStack().count(), 0);
            drag(2, -over.toPoint());
            QVERIFY2(problem().isEmpty(), qPrintable(problem()));
            waitForPreview();
            QVERIFY(button("Apply the import")->isEnabled());
        }
    }

    void aLineIsSaidBesideTheFieldAndCannotBeApplied()
    {
        openPanelWith("Camera");
        waitForPreview();
        for (const std::size_t corner : {2U, 3U}) { // onto the lower edge, to a pixel
            const double down = handle(0)->place().y() - handle(corner)->place().y();
            drag(corner, QPoint(corner == 2 ? -100 : 100, qRound(down)));
        }
        QTRY_VERIFY(!problem().isEmpty());
        QVERIFY(!button("Apply the import")->isEnabled());
        // To the bit.
        ImportSettings settings = panel().settings();
        settings.kind = MapKind::Quad;
        settings.quad = {glm::dvec3(0, 0, 0), {1, 1, 0}, {2, 2, 0}, {3, 3, 0}};
        const auto mapping = makeImportMapping(settings, document().surface());
        QVERIFY(!mapping);
        QVERIFY(QString::fromStdString(mapping.error().message).contains("on a line"));
    }

    void paintingBesideTheCornersGoesOn()
    {
        openPanelWith("Quadrilateral");
        waitForPreview();
        const QPoint middle = m_window->viewport().rect().center();
        QTest::mouseClick(&m_window->viewport(), Qt::LeftButton, {}, middle);
        QTRY_COMPARE(document().undoStack().count(), 1); // the brush, through the outline
        waitForPreview();
    }

private:
    inline static const QString kMapping = "How the image lies on the surface";

    CornerHandle* handle(std::size_t corner)
    {
        const char* const names[] = {"Lower left corner of the image",
                                     "Lower right corner of the image",
                                     "Upper right corner of the image",
                                     "Upper left corner of the image"};
        for (auto* one : m_window->viewport().findChildren<CornerHandle*>()) {
            if (one->accessibleName() == names[corner]) {
                return one;
            }
        }
        return nullptr;
    }
    QuadOverlay* overlay() { return m_window->viewport().findChild<QuadOverlay*>(); }

    /// In ten moves, as a hand does; the handle moves along below the pointer.
    void drag(std::size_t corner, QPoint by)
    {
        CornerHandle& dragged = *handle(corner);
        QWidget& view = m_window->viewport();
        const QPoint from = dragged.mapTo(&view, dragged.rect().center());
        QTest::mousePress(&dragged, Qt::LeftButton, {}, dragged.rect().center());
        for (int k = 1; k <= 10; ++k) {
            movePointer(dragged, dragged.mapFrom(&view, from + by * k / 10), Qt::LeftButton);
        }
        QTest::mouseRelease(&dragged, Qt::LeftButton, {}, dragged.rect().center());
    }
};

} // namespace trixel::ui

TRIXEL_WINDOW_TEST_MAIN(trixel::ui::QuadPlacementTest)
#include "tst_quad_placement.moc"
