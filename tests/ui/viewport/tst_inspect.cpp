// SPDX-License-Identifier: GPL-3.0-or-later
//
// Looking at texels in the view: pointing, holding, stepping from one to the next, going to one.
#include <QCoreApplication>
#include <QLabel>
#include <QLineEdit>
#include <QWheelEvent>

#include "core/texture/texel_address.h"
#include "tests/core/test_meshes.h"
#include "tests/ui/fixtures.h"
#include "tests/ui/viewport/view_fixture.h"
#include "ui/document/inspection.h"
#include "ui/viewport/go_to_bar.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>

namespace trixel::ui {

namespace {

/// A fan about a vertex in the middle, its faces at levels 1 to 4 by turns. The middle is the
/// first face's corner of that number; the other faces are turned by turns.
Project fanProject(std::uint32_t valence, std::uint32_t corner)
{
    TriangleMesh mesh = test::fanMesh(valence);
    FaceMap<Level> levels(mesh.faceCount());
    for (std::uint32_t k = 0; k < valence; ++k) {
        const auto turns = static_cast<std::ptrdiff_t>((3 - corner + k) % 3);
        Triangle& face = mesh.triangles[k];
        std::rotate(face.begin(), face.begin() + turns, face.end());
        levels[faceId(k)] = Level(1 + static_cast<int>((k + 1) % 4));
    }
    NoProgress progress;
    Project project;
    project.surface = Surface::build(std::move(mesh), progress).value();
    project.texels = TexelStore(TexelFormat{}, levels, kFill);
    return project;
}

QString addressOf(const std::optional<InspectedTexel>& texel)
{
    return texel ? QString::fromStdString(toText(texel->place)) : QString("none");
}

constexpr TexelCoord kLower{1, 2, TexelHalf::Lower};
constexpr TexelCoord kUpper{2, 1, TexelHalf::Upper};

} // namespace

class InspectTest : public QObject
{
    Q_OBJECT

private slots:
    void init() { open(squareProject()); }
    void cleanup()
    {
        // The inspection outlives the view, and the document both.
        if (m_fixture) {
            m_fixture->viewport.reset();
        }
        m_inspection.reset();
        m_fixture.reset();
    }

    void whatThePointerMeetsIsLookedAt()
    {
        QSignalSpy hovered(m_view, &Viewport::hovered);
        point(kFace0, kLower);
        QCOMPARE(held(), QString("pointed 0:1,2,lower"));
        const auto seen = hovered.constLast().at(0).value<std::optional<HoveredTexel>>();
        QVERIFY(seen && seen->texel == kLower && seen->hasFootprint && seen->pixelQuery);
        QVERIFY(!seen->isHeld);
        QCOMPARE(seen->report.stored, std::vector(kFill.begin(), kFill.end()));
        QVERIFY(seen->report.display.has_value());
        movePointer(*m_view, {3, 3}); // off the surface
        QCOMPARE(held(), QString("away 0:1,2,lower"));
        QVERIFY(!hovered.constLast().at(0).value<std::optional<HoveredTexel>>());
        QVERIFY(m_view->inspectedTexel()); // still to be read
    }

    void aClickHoldsATexelAndAnotherLetsItGo()
    {
        m_fixture->settings.setTool(Tool::Inspect);
        const QPoint lower = m_fixture->texelPosition(kFace0, kLower);
        const QPoint upper = m_fixture->texelPosition(kFace1, kUpper);
        QTest::mouseClick(m_view, Qt::LeftButton, {}, lower);
        QCOMPARE(held(), QString("held 0:1,2,lower"));
        QSignalSpy hovered(m_view, &Viewport::hovered);
        movePointer(*m_view, upper);
        const auto seen = hovered.constLast().at(0).value<std::optional<HoveredTexel>>();
        QVERIFY(seen && seen->isHeld && seen->texel == kLower);
        QTest::mouseClick(m_view, Qt::LeftButton, {}, upper);
        QCOMPARE(held(), QString("held 1:2,1,upper"));
        QTest::mouseClick(m_view, Qt::LeftButton, {}, {3, 3});
        QCOMPARE(held(), QString("held 1:2,1,upper"));
        QTest::mouseClick(m_view, Qt::LeftButton, {}, upper);
        QCOMPARE(held(), QString("pointed 1:2,1,upper"));
        point(kFace0, kLower);
        QCOMPARE(held(), QString("pointed 0:1,2,lower"));
        QCOMPARE(m_fixture->document.undoStack().count(), 0); // nothing was painted
    }

    void draggingHoldsWhatItComesTo()
    {
        m_fixture->settings.setTool(Tool::Inspect);
        const QPoint from = m_fixture->texelPosition(kFace0, kLower);
        const QPoint to = m_fixture->texelPosition(kFace1, kUpper);
        QTest::mousePress(m_view, Qt::LeftButton, {}, from);
        movePointer(*m_view, to, Qt::LeftButton);
        QTest::mouseRelease(m_view, Qt::LeftButton, {}, to);
        QCOMPARE(held(), QString("held 1:2,1,upper"));
    }

    void escapeLetsGoAndThePointerIsFollowedAtOnce()
    {
        m_fixture->settings.setTool(Tool::Inspect);
        QTest::mouseClick(m_view, Qt::LeftButton, {}, m_fixture->texelPosition(kFace0, kLower));
        point(kFace1, kUpper);
        QTest::keyClick(m_view, Qt::Key_Escape);
        QCOMPARE(held(), QString("pointed 1:2,1,upper"));
    }

    void arrowKeysGoRoundAVertexAndComeBack_data()
    {
        QTest::addColumn<int>("valence");
        QTest::addColumn<bool>("right");
        for (const int valence : {3, 5, 6, 9}) {
            QTest::addRow("%d right", valence) << valence << true;
            QTest::addRow("%d left", valence) << valence << false;
        }
    }
    void arrowKeysGoRoundAVertexAndComeBack()
    {
        QFETCH(const int, valence);
        QFETCH(const bool, right);
        // Held by a click a texel counts as entered by its edge 0. That turns right about corner 1
        // and left about corner 0.
        const std::uint32_t corner = right ? 1 : 0;
        open(fanProject(static_cast<std::uint32_t>(valence), corner));
        m_fixture->settings.setTool(Tool::Inspect);
        const auto last = static_cast<std::uint16_t>(right ? level(kFace0).resolution() - 1 : 0);
        const TexelCoord start{last, 0, TexelHalf::Lower};
        QTest::mouseClick(m_view, Qt::LeftButton, {}, m_fixture->texelPosition(kFace0, start));
        const QString began = held();
        QCOMPARE(began, QString("held 0:%1,0,lower").arg(last));
        std::set<QString> places{began};
        std::set<int> levels;
        for (int k = 1; k <= valence; ++k) {
            QTest::keyClick(m_view, right ? Qt::Key_Right : Qt::Key_Left);
            const InspectedTexel texel = m_inspection->texel().value();
            levels.insert(texel.level.log2());
            // Every one has a corner at the vertex, which is seen in the middle of the view.
            const auto uv = corners(texel.level, texel.place.texel);
            QVERIFY(std::ranges::any_of(uv, [&](glm::dvec2 at) {
                return glm::length(m_fixture->pointOf(texel.place.face, at).position) < 1e-6F;
            }));
            QCOMPARE(held() == began, k == valence);
            places.insert(held());
        }
        QCOMPARE(int(places.size()), valence);
        QVERIFY(levels.size() > 1);
        for (int k = 0; k < valence; ++k) {
            QTest::keyClick(m_view, Qt::Key_Down); // and back on one's own steps
        }
        QCOMPARE(held(), began);
    }

    void upGoesStraightAcrossAMeshEdgeAndDownComesBack()
    {
        m_fixture->settings.setTool(Tool::Inspect);
        QTest::mouseClick(m_view, Qt::LeftButton, {}, m_fixture->texelPosition(kFace0, kLower));
        std::set<FaceId> faces;
        std::vector<QString> way;
        for (int k = 0; k < 12; ++k) {
            way.push_back(held());
            faces.insert(m_inspection->texel()->place.face);
            QTest::keyClick(m_view, Qt::Key_Up);
        }
        QCOMPARE(int(faces.size()), 2);
        while (!way.empty()) {
            if (held() != way.back()) {
                QTest::keyClick(m_view, Qt::Key_Down);
            }
            QCOMPARE(held(), way.back());
            way.pop_back();
        }
    }

    void arrowsAreNoKeysOfABrushUnlessATexelIsHeld()
    {
        point(kFace0, kLower);
        QTest::keyClick(m_view, Qt::Key_Right);
        QCOMPARE(held(), QString("pointed 0:1,2,lower"));
        m_inspection->hold();
        QTest::keyClick(m_view, Qt::Key_Right);
        QVERIFY(held().startsWith("held") && held() != "held 0:1,2,lower");
        QTest::keyClick(m_view, Qt::Key_Right, Qt::ShiftModifier);
        const QString before = held();
        QTest::keyClick(m_view, Qt::Key_Left, Qt::ControlModifier);
        QCOMPARE(held(), before);
    }

    void whatAPanelPointsAtIsShownUnderAnyTool()
    {
        QSignalSpy hovered(m_view, &Viewport::hovered);
        const QPoint edge = edgeOf(kFace1, kUpper);
        const QColor before = m_fixture->seen(edge);
        m_inspection->pointAt(TexelPlace{kFace1, kUpper});
        const auto seen = hovered.constLast().at(0).value<std::optional<HoveredTexel>>();
        QVERIFY(seen && seen->texel == kUpper && seen->pixelQuery);
        QVERIFY(isLit(edge, before));
        // A camera that moves does not make the view take the texel from the panel.
        m_view->lookFrom(3, 3);
        QCOMPARE(held(), QString("pointed 1:2,1,upper"));
        m_view->lookFrom(0, 0);
        m_inspection->pointAway();
        QVERIFY(!isLit(edge, before));
    }

    void aHeldTexelStandsOutAlsoWhileTheCameraMoves()
    {
        const QPoint edge = edgeOf(kFace0, kLower);
        const QColor before = m_fixture->seen(edge);
        m_inspection->hold(TexelPlace{kFace0, kLower});
        QVERIFY(isLit(edge, before));
        // A tick points at the corner that is the leftmost from further left.
        const QPoint corner =
            m_view->widgetPosition(m_fixture->pointOf(kFace0, corners(Level(3), kLower)[0]))
                ->toPoint();
        const QPoint middle = m_fixture->texelPosition(kFace0, kLower);
        const QPointF way = QPointF(corner - middle) / QLineF(middle, corner).length();
        QVERIFY(isLit((QPointF(corner) + 10 * way).toPoint(), before));
        QTest::mousePress(m_view, Qt::MiddleButton, {}, {100, 100});
        QVERIFY(isLit(edge, before));
        QTest::mouseRelease(m_view, Qt::MiddleButton, {}, {100, 100});
        QCOMPARE(held(), QString("held 0:1,2,lower"));
    }

    void theFootprintOfAHeldTexelIsThatOfTheCamera()
    {
        m_inspection->hold(kFace0, {0.3F, 0.4F});
        const double before = m_view->inspectedTexel()->ellipse.majorLength;
        const FaceId face = m_view->inspectedTexel()->pixelQuery->face;
        m_view->lookFrom(0, 0, 2.0); // twice as near
        const HoveredTexel seen = m_view->inspectedTexel().value();
        QVERIFY(seen.hasFootprint && seen.pixelQuery->face == face);
        QCOMPARE(seen.pixelQuery->uv, glm::vec2(0.3F, 0.4F));
        QVERIFY(std::abs(seen.ellipse.majorLength / before - 0.5) < 0.02);
        render::CameraPose away = m_view->camera().pose();
        away.yaw += 3.14159265; // about a target beside the surface: it is behind the camera then
        away.target = {0, 0, 9};
        away.distance = 1;
        m_view->setCamera(away);
        QVERIFY(!m_view->inspectedTexel()->hasFootprint || !m_view->widgetPosition(seen.point));
    }

    void levelsDroppedInTheViewAreThoseLookedAt()
    {
        m_inspection->hold(TexelPlace{kFace0, kLower});
        ViewOptions options = m_fixture->settings.view();
        options.mipDrop = 2;
        QSignalSpy hovered(m_view, &Viewport::hovered);
        m_fixture->settings.setView(options);
        QCOMPARE(m_inspection->levelsDropped(), 2);
        const auto seen = hovered.constLast().at(0).value<std::optional<HoveredTexel>>();
        QCOMPARE(seen->level.log2(), 1);
        QVERIFY(seen->texel == m_inspection->texel()->place.texel);
        QCOMPARE(seen->report.levelsDropped, 2);
    }

    void whatIsGoneToIsBroughtIntoSight()
    {
        const render::CameraPose pose = m_view->camera().pose();
        QVERIFY(m_inspection->goTo("0:1,2,lower"));
        QVERIFY(m_view->camera().pose() == pose); // seen already
        m_view->lookFrom(180, 0);                 // from behind
        QVERIFY(m_inspection->goTo("1:2,1,upper"));
        QVERIFY(m_view->camera().forward().z < -0.99);
        QVERIFY(m_view->widgetPosition(m_view->inspectedTexel()->point));
    }

    void aFaceTooSmallToBeSeenIsGoneNearTo()
    {
        open(gridProject(128, 0));
        const auto span = [this] {
            const auto from = m_view->widgetPosition(m_fixture->pointOf(kFace0, {0.01, 0.01}));
            const auto to = m_view->widgetPosition(m_fixture->pointOf(kFace0, {0.98, 0.01}));
            return from && to ? QLineF(*from, *to).length() : 0.0;
        };
        QVERIFY(span() < 6);
        QVERIFY(m_inspection->goTo("0"));
        QVERIFY(span() > 50);
    }

    void aStepOutOfThePictureIsFollowed()
    {
        m_fixture->settings.setTool(Tool::Inspect);
        m_inspection->hold(TexelPlace{kFace0, kLower});
        render::CameraPose pose = m_view->camera().pose();
        pose.target = {50, 0, 0};
        m_view->setCamera(pose);
        QVERIFY(!m_view->widgetPosition(m_view->inspectedTexel()->point));
        QTest::keyClick(m_view, Qt::Key_Right);
        QVERIFY(m_view->widgetPosition(m_view->inspectedTexel()->point));
    }

    void anAddressIsTypedOverTheViewAndGoneTo()
    {
        m_view->askForTexel();
        auto* bar = m_view->findChild<GoToBar*>();
        auto* address = bar->findChild<QLineEdit*>();
        auto* verdict = bar->findChild<QLabel*>();
        QVERIFY(bar->isVisible());
        QVERIFY(address->placeholderText().contains("face@u,v"));
        QTest::keyClicks(address, "1:2,9,upper");
        QVERIFY2(verdict->text().contains("i + j of at most 6"), qPrintable(verdict->text()));
        QTest::keyClick(address, Qt::Key_Return);
        QVERIFY(bar->isVisible()); // what is wrong stays to be mended
        QCOMPARE(held(), QString("away none"));
        QTest::keyClicks(address, "1@0.3,0.2");
        QVERIFY2(verdict->text().contains("Face 1, level 3, texel (2, 1)"),
                 qPrintable(verdict->text()));
        QTest::keyClick(address, Qt::Key_Return);
        QVERIFY(!bar->isVisible());
        QCOMPARE(held(), QString("held 1:2,1,lower"));
        for (const char* way : {"0", "0:36", "0:1,2,upper"}) {
            m_view->askForTexel();
            QTest::keyClicks(address, way);
            QTest::keyClick(address, Qt::Key_Return);
            QVERIFY2(held().startsWith("held 0:"), qPrintable(held()));
        }
        QCOMPARE(held(), QString("held 0:1,2,upper"));
    }

    void escapeClosesTheLineAndGoesNowhere()
    {
        m_view->askForTexel();
        auto* bar = m_view->findChild<GoToBar*>();
        auto* address = bar->findChild<QLineEdit*>();
        QTest::keyClicks(address, "1");
        QTest::keyClick(address, Qt::Key_Escape);
        QVERIFY(!bar->isVisible());
        QCOMPARE(held(), QString("away none"));
        QVERIFY(m_view->hasFocus());
    }

private:
    void open(Project project)
    {
        cleanup();
        m_fixture = std::make_unique<ViewFixture>();
        QVERIFY(m_fixture->show(std::move(project)));
        m_inspection = std::make_unique<Inspection>(m_fixture->document);
        m_fixture->viewport->useInspection(*m_inspection);
        m_view = m_fixture->viewport.get();
        m_view->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_view));
        m_view->setFocus();
    }
    /// "held 0:1,2,lower", "pointed …", "away …"
    QString held() const
    {
        return (m_inspection->isHeld()        ? "held "
                : m_inspection->isPointedAt() ? "pointed "
                                              : "away ") +
               addressOf(m_inspection->texel());
    }
    void point(FaceId face, TexelCoord texel)
    {
        movePointer(*m_view, m_fixture->texelPosition(face, texel));
    }
    Level level(FaceId face) const { return m_fixture->document.texels().face(face).level(); }
    /// The middle of a texel's first edge on the screen.
    QPoint edgeOf(FaceId face, TexelCoord texel) const
    {
        const auto c = corners(level(face), texel);
        return m_view->widgetPosition(m_fixture->pointOf(face, (c[0] + c[1]) / 2.0))->toPoint();
    }
    /// Whether something lighter than that is drawn within a pixel of the place.
    bool isLit(QPoint place, const QColor& than) const
    {
        for (int x = -1; x <= 1; ++x) {
            for (int y = -1; y <= 1; ++y) {
                if (m_fixture->seen(place + QPoint(x, y)).lightness() > than.lightness() + 25) {
                    return true;
                }
            }
        }
        return false;
    }

    std::unique_ptr<ViewFixture> m_fixture;
    std::unique_ptr<Inspection> m_inspection;
    Viewport* m_view = nullptr; ///< the fixture's
};

} // namespace trixel::ui

QTEST_MAIN(trixel::ui::InspectTest)
#include "tst_inspect.moc"
