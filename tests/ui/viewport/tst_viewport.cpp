// SPDX-License-Identifier: GPL-3.0-or-later
#include <QPointingDevice>
#include <QTabletEvent>
#include <QWheelEvent>

#include "core/texture/stored_faces.h"
#include "tests/ui/viewport/view_fixture.h"
#include "ui/viewport/footprint_legend.h"

#include <cmath>
#include <future>
#include <optional>

using namespace trixel;
using namespace trixel::ui;

namespace {

constexpr TexelCoord kLower{1, 2, TexelHalf::Lower};
constexpr TexelCoord kUpper{2, 1, TexelHalf::Upper};

const QPointingDevice& pen(QPointingDevice::PointerType type)
{
    const auto make = [](QPointingDevice::PointerType t) {
        return new QPointingDevice(QStringLiteral("pen"),
                                   7,
                                   QInputDevice::DeviceType::Stylus,
                                   t,
                                   QInputDevice::Capability::Position |
                                       QInputDevice::Capability::Pressure,
                                   1,
                                   3,
                                   {},
                                   {},
                                   qApp);
    };
    static const auto* tip = make(QPointingDevice::PointerType::Pen);
    static const auto* eraser = make(QPointingDevice::PointerType::Eraser);
    return type == QPointingDevice::PointerType::Pen ? *tip : *eraser;
}

void sendPen(QWidget& widget,
             QEvent::Type type,
             QPoint position,
             double pressure,
             QPointingDevice::PointerType pointer = QPointingDevice::PointerType::Pen)
{
    const bool down = type != QEvent::TabletRelease;
    QTabletEvent event(type,
                       &pen(pointer),
                       QPointF(position),
                       QPointF(widget.mapToGlobal(position)),
                       pressure,
                       0,
                       0,
                       0,
                       0,
                       0,
                       Qt::NoModifier,
                       type == QEvent::TabletMove ? Qt::NoButton : Qt::LeftButton,
                       down ? Qt::LeftButton : Qt::NoButton);
    QCoreApplication::sendEvent(&widget, &event);
}

void turnWheel(QWidget& widget, QPoint position, int units)
{
    QWheelEvent event(QPointF(position),
                      QPointF(widget.mapToGlobal(position)),
                      {},
                      {0, units},
                      Qt::NoButton,
                      Qt::NoModifier,
                      Qt::NoScrollPhase,
                      false);
    QCoreApplication::sendEvent(&widget, &event);
}

void drag(QWidget& widget,
          Qt::MouseButton button,
          Qt::KeyboardModifiers modifiers,
          QPoint from,
          QPoint to)
{
    QTest::mousePress(&widget, button, modifiers, from);
    movePointer(widget, to, button);
    QTest::mouseRelease(&widget, button, modifiers, to);
}

int paintedTexels(const ViewFixture& view)
{
    int count = 0;
    for (const FaceId face : {kFace0, kFace1}) {
        const FaceTexels& texels = view.document.texels().face(face);
        for (std::uint32_t t = 0; t < texels.level().texelCount(); ++t) {
            count += texels.texel(t)[1] != kFill[1] ? 1 : 0;
        }
    }
    return count;
}

/// As if a file had faces of one grey.
class GreyFaces final : public FaceReader
{
public:
    Result<bool> read(FaceId, Level, std::span<std::byte> texels) const override
    {
        std::ranges::fill(texels, std::byte{90});
        return true;
    }
    bool stores(FaceId, Level) const override { return false; }
    std::span<const std::byte> mean(FaceId) const override { return m_mean; }

private:
    std::array<std::byte, 3> m_mean{std::byte{90}, std::byte{90}, std::byte{90}};
};

/// A file that takes as long to read as the test wants.
class SlowFaces final : public FaceReader
{
public:
    explicit SlowFaces(std::shared_future<void> gate)
        : m_gate(std::move(gate))
    {
    }

    Result<bool> read(FaceId face, Level level, std::span<std::byte> texels) const override
    {
        m_gate.wait();
        return m_faces.read(face, level, texels);
    }
    bool stores(FaceId, Level) const override { return false; }
    std::span<const std::byte> mean(FaceId face) const override { return m_faces.mean(face); }

private:
    std::shared_future<void> m_gate;
    GreyFaces m_faces;
};

} // namespace

class TestViewport : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        m_view = std::make_unique<ViewFixture>();
        QVERIFY2(m_view->show(), "a shown view with OpenGL is needed");
    }
    void cleanup() { m_view.reset(); }

    void theViewShowsTheTexels()
    {
        ViewOptions options;
        options.lit = false;
        options.footprint = false;
        m_view->settings.setView(options);
        QCOMPARE(m_view->seen(m_view->texelPosition(kFace0, kLower)), QColor(200, 150, 100));
        QCOMPARE(m_view->seen(m_view->texelPosition(kFace1, kUpper)), QColor(200, 150, 100));
    }

    /// Its texels are as fine, and a split stands at the same place, as in a view so large.
    void aPictureOfTwiceTheDensityIsThatOfAViewTwiceAsLarge()
    {
        Project project = squareProject(10);
        for (const FaceId face : {kFace0, kFace1}) {
            auto state = static_cast<std::uint32_t>(1 + indexOf(face));
            for (std::byte& value : project.texels.writable(face)) {
                state = state * 1664525U + 1013904223U;
                value = static_cast<std::byte>(state >> 24U);
            }
        }
        m_view->document.open(std::move(project), {}, "noise");
        ViewOptions options;
        options.lit = false;
        options.footprint = false;
        m_view->settings.setView(options);
        m_view->settings.setComparison({ComparedBy::Level, {}, {}, 6, 0.3});
        Viewport& viewport = *m_view->viewport;
        const double density = viewport.devicePixelRatioF();
        viewport.lookFrom(0, 0);
        const QImage dense = viewport.picture(2 * density);
        QCOMPARE(viewport.picture(density).size() * 2, dense.size());
        viewport.resize(viewport.size() * 2);
        const QImage large = viewport.picture(density);
        QCOMPARE(dense.size(), large.size());
        int differing = 0;
        for (int y = 0; y < large.height(); ++y) {
            for (int x = 0; x < large.width(); ++x) {
                differing +=
                    std::abs(qGreen(dense.pixel(x, y)) - qGreen(large.pixel(x, y))) > 3 ? 1 : 0;
            }
        }
        QVERIFY2(differing < large.width() * large.height() / 200,
                 std::to_string(differing).c_str());
    }

    /// The view keeps texels as they were before; that must not keep a file's faces in memory.
    void whatIsHeldOfAFileIsGivenBackByTheViewToo()
    {
        Project project = squareProject(4);
        const auto faces =
            StoredFaces::make(project.texels.format(), std::make_unique<GreyFaces>(), 0);
        for (const FaceId face : {kFace0, kFace1}) {
            project.texels.exchange(face, faces->face(face, Level(4)));
        }
        project.storedFaces = faces;
        m_view->document.open(std::move(project), {}, "stored");
        m_view->viewport->settle();
        QVERIFY(!m_view->document.texels().face(kFace0).bytes().empty());
        QVERIFY(faces->heldBytes() > 0);
        m_view->document.releaseHeldTexels();
        QTRY_COMPARE(faces->heldBytes(), std::uint64_t{0});
    }

    void theFootprintIsExplainedWhileItIsDrawn()
    {
        const auto* legend = m_view->viewport->findChild<FootprintLegend*>();
        QVERIFY(legend);
        QVERIFY(legend->isVisible());
        QVERIFY(legend->text().contains("40× larger"));
        QVERIFY(m_view->viewport->rect().contains(legend->geometry()));
        m_view->viewport->resize(500, 300);
        QVERIFY(m_view->viewport->rect().contains(legend->geometry()));
        ViewOptions options = m_view->settings.view();
        options.footprint = false;
        m_view->settings.setView(options);
        QVERIFY(!legend->isVisible());
    }

    void aClickPaintsTheTexelUnderItAndUndoRestoresIt_data()
    {
        QTest::addColumn<int>("face");
        QTest::addColumn<bool>("upper");
        QTest::newRow("face 0, lower") << 0 << false;
        QTest::newRow("face 0, upper") << 0 << true;
        QTest::newRow("face 1, lower") << 1 << false;
        QTest::newRow("face 1, upper") << 1 << true;
    }

    void aClickPaintsTheTexelUnderItAndUndoRestoresIt()
    {
        QFETCH(int, face);
        QFETCH(bool, upper);
        const FaceId id = face == 0 ? kFace0 : kFace1;
        const TexelCoord at = upper ? kUpper : kLower;
        ViewOptions options;
        options.lit = false;
        options.footprint = false;
        m_view->settings.setView(options);
        const QPoint position = m_view->texelPosition(id, at);
        QTest::mouseClick(m_view->viewport.get(), Qt::LeftButton, {}, position);
        QCOMPARE(m_view->texel(id, at), kRed);
        QCOMPARE(paintedTexels(*m_view), 1);
        QCOMPARE(m_view->document.undoStack().count(), 1);
        QCOMPARE(m_view->seen(position), QColor(255, 0, 0));
        m_view->document.undoStack().undo();
        QCOMPARE(m_view->texel(id, at), kFillColor);
        QCOMPARE(m_view->seen(position), QColor(200, 150, 100));
    }

    void aDragPaintsAcrossTheEdgeInOneStep()
    {
        const TexelCoord corner{0, 0, TexelHalf::Lower}; // at the right angle of each face
        const QPoint from = m_view->texelPosition(kFace0, corner);
        const QPoint to = m_view->texelPosition(kFace1, corner);
        drag(*m_view->viewport, Qt::LeftButton, {}, from, to);
        QCOMPARE(m_view->texel(kFace0, corner), kRed);
        QCOMPARE(m_view->texel(kFace1, corner), kRed);
        QCOMPARE(m_view->document.undoStack().count(), 1);
    }

    void shiftClickDrawsAStraightLineFromTheLastStroke()
    {
        const TexelCoord corner{0, 0, TexelHalf::Lower};
        QTest::mouseClick(
            m_view->viewport.get(), Qt::LeftButton, {}, m_view->texelPosition(kFace0, corner));
        const int before = paintedTexels(*m_view);
        QTest::mouseClick(m_view->viewport.get(),
                          Qt::LeftButton,
                          Qt::ShiftModifier,
                          m_view->texelPosition(kFace1, corner));
        QVERIFY(paintedTexels(*m_view) > before + 8);
        QCOMPARE(m_view->texel(kFace1, corner), kRed);
        QCOMPARE(m_view->document.undoStack().count(), 2);
    }

    void escapeTakesTheStrokeBack()
    {
        const QPoint position = m_view->texelPosition(kFace0, kLower);
        QTest::mousePress(m_view->viewport.get(), Qt::LeftButton, {}, position);
        QCOMPARE(m_view->texel(kFace0, kLower), kRed);
        QTest::keyClick(m_view->viewport.get(), Qt::Key_Escape);
        QCOMPARE(m_view->texel(kFace0, kLower), kFillColor);
        QTest::mouseRelease(m_view->viewport.get(), Qt::LeftButton, {}, position);
        QCOMPARE(m_view->document.undoStack().count(), 0);
    }

    void theEraserGoesBackToTheFill()
    {
        const QPoint position = m_view->texelPosition(kFace0, kLower);
        QTest::mouseClick(m_view->viewport.get(), Qt::LeftButton, {}, position);
        m_view->settings.setTool(Tool::Eraser);
        QTest::mouseClick(m_view->viewport.get(), Qt::LeftButton, {}, position);
        QCOMPARE(m_view->texel(kFace0, kLower), kFillColor);
    }

    void theFillToolFillsTheFaceUnderThePointer()
    {
        m_view->settings.setTool(Tool::Fill);
        QTest::mouseClick(
            m_view->viewport.get(), Qt::LeftButton, {}, m_view->texelPosition(kFace1, kUpper));
        QVERIFY(m_view->document.texels().face(kFace1).isConstant());
        QCOMPARE(m_view->texel(kFace1, kLower), kRed);
        QCOMPARE(m_view->texel(kFace0, kLower), kFillColor);
    }

    void pressesBesideTheSurfacePaintNothing()
    {
        QTest::mouseClick(m_view->viewport.get(), Qt::LeftButton, {}, {2, 2});
        QCOMPARE(paintedTexels(*m_view), 0);
        QCOMPARE(m_view->document.undoStack().count(), 0);
    }

    void penPressureSetsTheSize()
    {
        Brush brush = m_view->settings.brush();
        brush.radius = 0.5F;
        brush.pressureToSize = true;
        m_view->settings.setBrush(brush);
        const QPoint position = m_view->texelPosition(kFace0, kUpper);
        const auto dabOf = [&](double pressure) {
            sendPen(*m_view->viewport, QEvent::TabletPress, position, pressure);
            sendPen(*m_view->viewport, QEvent::TabletRelease, position, 0);
            const int painted = paintedTexels(*m_view);
            m_view->document.undoStack().undo();
            return painted;
        };
        const int light = dabOf(0.3);
        const int full = dabOf(1.0);
        QVERIFY2(light >= 1 && full > 4 * light, qPrintable(QString("%1 %2").arg(light).arg(full)));
    }

    void thePensEraserEndErases()
    {
        const QPoint position = m_view->texelPosition(kFace0, kLower);
        QTest::mouseClick(m_view->viewport.get(), Qt::LeftButton, {}, position);
        const auto eraser = QPointingDevice::PointerType::Eraser;
        sendPen(*m_view->viewport, QEvent::TabletPress, position, 1, eraser);
        sendPen(*m_view->viewport, QEvent::TabletRelease, position, 0, eraser);
        QCOMPARE(m_view->texel(kFace0, kLower), kFillColor);
    }

    void mouseEventsDuringAPenStrokeAreIgnored()
    {
        const QPoint position = m_view->texelPosition(kFace0, kLower);
        sendPen(*m_view->viewport, QEvent::TabletPress, position, 1);
        QTest::mouseClick(
            m_view->viewport.get(), Qt::LeftButton, {}, m_view->texelPosition(kFace1, kUpper));
        QCOMPARE(paintedTexels(*m_view), 1);
        // The pen goes on as if nothing had happened.
        const TexelCoord next{kLower.i, static_cast<std::uint16_t>(kLower.j + 1), kLower.half};
        sendPen(*m_view->viewport, QEvent::TabletMove, m_view->texelPosition(kFace0, next), 1);
        sendPen(*m_view->viewport, QEvent::TabletRelease, position, 0);
        QCOMPARE(m_view->texel(kFace0, next), kRed);
        QCOMPARE(m_view->document.undoStack().count(), 1);
        const int painted = paintedTexels(*m_view);
        // And afterwards the mouse works again.
        QTest::mouseClick(
            m_view->viewport.get(), Qt::LeftButton, {}, m_view->texelPosition(kFace1, kUpper));
        QCOMPARE(paintedTexels(*m_view), painted + 1);
    }

    void hoverTellsTheTexelOfBothHalves()
    {
        std::optional<HoveredTexel> last;
        connect(m_view->viewport.get(), &Viewport::hovered, this, [&](const auto& t) { last = t; });
        const Level level(3);
        for (const FaceId face : {kFace0, kFace1}) {
            for (std::uint32_t t = 0; t < level.texelCount(); ++t) {
                const TexelCoord expected = texelAt(level, static_cast<TexelIndex>(t));
                movePointer(*m_view->viewport, m_view->texelPosition(face, expected));
                QVERIFY(last);
                QCOMPARE(last->point.face, face);
                QCOMPARE(last->texel, expected);
                QCOMPARE(last->index, static_cast<TexelIndex>(t));
                QCOMPARE(last->pixel, packedPixel(level, expected));
                QCOMPARE(last->level, level);
                QCOMPARE(last->values.size(), std::size_t{3});
                QVERIFY(std::abs(last->values[0] - 200.0F / 255.0F) < 1e-6F);
            }
        }
        movePointer(*m_view->viewport, QPoint(3, 3));
        QVERIFY(!last);
    }

    void hoverDoesNotWaitForAFaceThatIsBeingRead()
    {
        std::promise<void> gate;
        Project project = squareProject();
        const auto faces = StoredFaces::make(
            project.texels.format(), std::make_unique<SlowFaces>(gate.get_future().share()));
        for (const FaceId face : {kFace0, kFace1}) {
            project.texels.exchange(face, faces->face(face, Level(3)));
        }
        project.storedFaces = faces;
        m_view->document.open(std::move(project), {}, "stored");
        std::optional<HoveredTexel> last;
        connect(m_view->viewport.get(), &Viewport::hovered, this, [&](const auto& t) { last = t; });
        QSignalSpy read(m_view->viewport.get(), &Viewport::inspectedRead);
        movePointer(*m_view->viewport, m_view->texelPosition(kFace0, kLower));
        movePointer(*m_view->viewport, m_view->texelPosition(kFace1, kUpper));
        const bool isAnswered = last.has_value(); // with the file still closed
        const auto told = last.value_or(HoveredTexel());
        const std::uint64_t bytesRead = faces->readBytes();
        gate.set_value();
        QVERIFY(isAnswered);
        QCOMPARE(bytesRead, std::uint64_t{0});
        QCOMPARE(told.point.face, kFace1);
        QCOMPARE(told.texel, kUpper);
        QVERIFY(told.values.empty());
        QVERIFY(!told.report.display);
        QTRY_VERIFY(last && !last->values.empty());
        QCOMPARE(last->point.face, kFace1);
        QVERIFY(std::abs(last->values[1] - 90.0F / 255.0F) < 1e-6F);
        QVERIFY(read.count() > 0);
    }

    void hoverTellsTheFootprintOfThePixel()
    {
        std::optional<HoveredTexel> last;
        connect(m_view->viewport.get(), &Viewport::hovered, this, [&](const auto& t) { last = t; });
        movePointer(*m_view->viewport, m_view->texelPosition(kFace0, kUpper));
        QVERIFY(last);
        // The square is 2 wide, so is (u,v) 1: a device pixel is half its world length in uv.
        const double pixel = m_view->viewport->camera().worldPerPixel({0, 0, 0});
        const double length = std::hypot(last->footprint.w1.x, last->footprint.w1.y);
        QVERIFY(std::abs(length - pixel / 2) < 1e-6);
        QVERIFY(std::abs(last->ellipse.majorLength - pixel / 2) < 1e-6);
        QVERIFY(std::abs(last->ellipse.anisotropy() - 1) < 1e-3);
    }

    void hoverFollowsTheMipDrop()
    {
        std::optional<HoveredTexel> last;
        connect(m_view->viewport.get(), &Viewport::hovered, this, [&](const auto& t) { last = t; });
        movePointer(*m_view->viewport, m_view->texelPosition(kFace0, kUpper));
        ViewOptions options = m_view->settings.view();
        options.mipDrop = 2;
        m_view->settings.setView(options);
        QVERIFY(last);
        QCOMPARE(last->level, Level(1));
        options.mipDrop = 5;
        m_view->settings.setView(options);
        QCOMPARE(last->level, Level(0));
        QCOMPARE(last->index, TexelIndex{});
    }

    void hoverShowsTheNewValueAfterUndo()
    {
        const QPoint position = m_view->texelPosition(kFace0, kLower);
        QTest::mouseClick(m_view->viewport.get(), Qt::LeftButton, {}, position);
        std::optional<HoveredTexel> last;
        connect(m_view->viewport.get(), &Viewport::hovered, this, [&](const auto& t) { last = t; });
        m_view->document.undoStack().undo();
        QVERIFY(last);
        QVERIFY(std::abs(last->values[1] - 150.0F / 255.0F) < 1e-6F);
    }

    void pickingGivesTheColourOfTheTexel()
    {
        QSignalSpy picked(m_view->viewport.get(), &Viewport::colorPicked);
        const QPoint position = m_view->texelPosition(kFace0, kUpper);
        m_view->settings.setTool(Tool::Pick);
        QTest::mouseClick(m_view->viewport.get(), Qt::LeftButton, {}, position);
        m_view->settings.setTool(Tool::Brush);
        QTest::mouseClick(m_view->viewport.get(), Qt::LeftButton, Qt::ControlModifier, position);
        QCOMPARE(picked.count(), 2);
        for (const auto& arguments : picked) {
            const auto color = arguments[0].value<std::array<float, 4>>();
            QVERIFY(std::abs(color[0] - 200.0F / 255.0F) < 1e-6F);
            QVERIFY(std::abs(color[2] - 100.0F / 255.0F) < 1e-6F);
            QCOMPARE(color[3], 1.0F);
        }
        QCOMPARE(paintedTexels(*m_view), 0);
    }

    void draggingNavigates_data()
    {
        QTest::addColumn<int>("button");
        QTest::addColumn<int>("modifiers");
        QTest::addColumn<QString>("changes");
        const auto row = [](const char* name, Qt::MouseButton b, Qt::KeyboardModifier m, auto c) {
            QTest::newRow(name) << int(b) << int(m) << QString(c);
        };
        row("Alt left", Qt::LeftButton, Qt::AltModifier, "angle");
        row("middle", Qt::MiddleButton, Qt::NoModifier, "angle");
        row("Alt middle", Qt::MiddleButton, Qt::AltModifier, "target");
        row("Shift middle", Qt::MiddleButton, Qt::ShiftModifier, "target");
        row("Alt right", Qt::RightButton, Qt::AltModifier, "distance");
    }

    void draggingNavigates()
    {
        QFETCH(int, button);
        QFETCH(int, modifiers);
        QFETCH(QString, changes);
        const render::CameraPose before = m_view->viewport->camera().pose();
        drag(*m_view->viewport,
             static_cast<Qt::MouseButton>(button),
             static_cast<Qt::KeyboardModifier>(modifiers),
             {240, 240},
             {300, 260});
        const render::CameraPose after = m_view->viewport->camera().pose();
        QCOMPARE(after.yaw != before.yaw, changes == "angle");
        QCOMPARE(after.target != before.target, changes == "target");
        QCOMPARE(after.distance != before.distance, changes == "distance");
        QCOMPARE(paintedTexels(*m_view), 0);
    }

    void theWheelZoomsTowardsThePointer()
    {
        const QPoint position = m_view->texelPosition(kFace0, kUpper);
        const auto under = m_view->viewport->surfacePointAt(position);
        const double before = m_view->viewport->camera().pose().distance;
        turnWheel(*m_view->viewport, position, 240);
        QVERIFY(m_view->viewport->camera().pose().distance < before);
        const auto now = m_view->viewport->surfacePointAt(position);
        QVERIFY(now && glm::length(now->position - under->position) < 1e-4F);
        turnWheel(*m_view->viewport, position, -240);
        QVERIFY(std::abs(m_view->viewport->camera().pose().distance - before) < 1e-9);
    }

    void framingTheHoveredFaceComesNearerAndFramingAllGoesBack()
    {
        const render::CameraPose all = m_view->viewport->camera().pose();
        m_view->viewport->setCamera({{0.5, 0, 0}, 9, 0, 0});
        m_view->viewport->frameHovered(); // nothing is hovered
        QCOMPARE(m_view->viewport->camera().pose(), all);
        m_view->viewport->setCamera({{0.5, 0, 0}, 9, 0, 0});
        movePointer(*m_view->viewport, m_view->texelPosition(kFace0, kUpper));
        m_view->viewport->frameHovered();
        QVERIFY(m_view->viewport->camera().pose().distance < 9);
        m_view->viewport->frameAll();
        QCOMPARE(m_view->viewport->camera().pose(), all);
    }

    void draggingWithControlAndTheRightButtonSetsTheBrush()
    {
        const Brush before = m_view->settings.brush();
        const QPoint position = m_view->texelPosition(kFace0, kUpper);
        drag(*m_view->viewport,
             Qt::RightButton,
             Qt::ControlModifier,
             position,
             position + QPoint(40, 0));
        QVERIFY(m_view->settings.brush().radius > 1.2F * before.radius);
        QCOMPARE(m_view->settings.brush().hardness, before.hardness);
        const float radius = m_view->settings.brush().radius;
        drag(*m_view->viewport,
             Qt::RightButton,
             Qt::ControlModifier,
             position,
             position + QPoint(0, 50));
        QVERIFY(m_view->settings.brush().hardness < before.hardness - 0.1F);
        QCOMPARE(m_view->settings.brush().radius, radius);
        QCOMPARE(paintedTexels(*m_view), 0);
    }

    void theBrushRingIsDrawnWhereThePointerIs()
    {
        ViewOptions options;
        options.lit = false;
        options.footprint = false;
        m_view->settings.setView(options);
        Brush brush = m_view->settings.brush();
        brush.radius = 0.4F;
        m_view->settings.setBrush(brush);
        const QPoint centre = m_view->texelPosition(kFace0, kUpper);
        const double pixel = m_view->viewport->camera().worldPerPixel({0, 0, 0});
        const double ratio = m_view->viewport->devicePixelRatioF();
        const QPoint onRing = centre - QPoint(int(std::lround(0.4 / pixel / ratio)), 0);
        QCOMPARE(m_view->seen(onRing), QColor(200, 150, 100));
        movePointer(*m_view->viewport, centre);
        QVERIFY(m_view->seen(onRing) != QColor(200, 150, 100));
        QCOMPARE(m_view->seen(centre), QColor(200, 150, 100));
        m_view->settings.setTool(Tool::Fill);
        QCOMPARE(m_view->seen(onRing), QColor(200, 150, 100));
    }

    void manyMovesBeforeAFrameAllCount()
    {
        Viewport& viewport = *m_view->viewport;
        const QPoint from = m_view->texelPosition(kFace0, {0, 0, TexelHalf::Lower});
        QTest::mousePress(&viewport, Qt::LeftButton, {}, from);
        const QPoint corner(from.x(), m_view->texelPosition(kFace0, {6, 0, TexelHalf::Lower}).y());
        const QPoint left = m_view->texelPosition(kFace0, {0, 6, TexelHalf::Lower});
        for (const QPoint& to : {corner, from, left}) {
            movePointer(viewport, to, Qt::LeftButton);
        }
        QTest::mouseRelease(&viewport, Qt::LeftButton, {}, left);
        QCOMPARE(m_view->texel(kFace0, {4, 0, TexelHalf::Lower}), kRed);
        QCOMPARE(m_view->texel(kFace0, {0, 4, TexelHalf::Lower}), kRed);
    }

    void aStrokeThatLeavesTheSurfaceDoesNotBridgeTheGap()
    {
        Viewport& viewport = *m_view->viewport;
        const Level level(3);
        const TexelCoord low = texelAt(level, glm::dvec2(0.01, 0.97)); // lower left, in face 0
        const QPoint from = m_view->texelPosition(kFace0, low);
        const TexelCoord high{0, 0, TexelHalf::Lower}; // upper left, in face 1
        const QPoint to = m_view->texelPosition(kFace1, high);
        QTest::mousePress(&viewport, Qt::LeftButton, {}, from);
        movePointer(viewport, {2, from.y()}, Qt::LeftButton);
        movePointer(viewport, {2, to.y()}, Qt::LeftButton);
        movePointer(viewport, to, Qt::LeftButton);
        QTest::mouseRelease(&viewport, Qt::LeftButton, {}, to);
        QCOMPARE(m_view->texel(kFace1, high), kRed);
        QVERIFY2(paintedTexels(*m_view) <= 4, qPrintable(QString::number(paintedTexels(*m_view))));
        QCOMPARE(m_view->document.undoStack().count(), 1); // one stroke, one step
    }

    void anUndoDuringAStrokeEndsItWithoutHarm()
    {
        const QPoint position = m_view->texelPosition(kFace0, kLower);
        QTest::mouseClick(
            m_view->viewport.get(), Qt::LeftButton, {}, m_view->texelPosition(kFace1, kUpper));
        QTest::mousePress(m_view->viewport.get(), Qt::LeftButton, {}, position);
        m_view->document.undoStack().undo();
        movePointer(*m_view->viewport, position + QPoint(3, 0), Qt::LeftButton);
        QTest::mouseRelease(m_view->viewport.get(), Qt::LeftButton, {}, position);
        QCOMPARE(paintedTexels(*m_view), 0);
    }

    void theViewHasANameAndTakesTheKeyboard()
    {
        QVERIFY(!m_view->viewport->accessibleName().isEmpty());
        QCOMPARE(m_view->viewport->focusPolicy(), Qt::StrongFocus);
        QVERIFY(m_view->viewport->toolTip().isEmpty());
    }

    void openingAnotherProjectShowsItAtOnce()
    {
        ViewOptions options;
        options.lit = false;
        m_view->settings.setView(options);
        Project other = squareProject(5);
        const std::array<std::byte, 3> blue{std::byte{10}, std::byte{20}, std::byte{250}};
        other.texels = TexelStore(2, TexelFormat{}, Level(5), blue);
        m_view->document.open(std::move(other), {}, "blue");
        QCOMPARE(m_view->seen(m_view->texelPosition(kFace1, kLower)), QColor(10, 20, 250));
    }

    void aClosedProjectLeavesAHint()
    {
        m_view->document.open({}, {}, {});
        const QImage image = m_view->viewport->grabFramebuffer();
        QTest::mouseClick(m_view->viewport.get(), Qt::LeftButton, {}, {240, 240});
        QVERIFY(!m_view->viewport->surfacePointAt({240, 240}));
        int bright = 0; // letters
        for (int x = 0; x < image.width(); ++x) {
            for (int y = image.height() / 2 - 20; y < image.height() / 2 + 20; ++y) {
                bright += image.pixelColor(x, y).lightness() > 120 ? 1 : 0;
            }
        }
        QVERIFY(bright > 50);
    }

private:
    std::unique_ptr<ViewFixture> m_view;
};

QTEST_MAIN(TestViewport)
#include "tst_viewport.moc"
