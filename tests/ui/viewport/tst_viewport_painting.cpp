// SPDX-License-Identifier: GPL-3.0-or-later
//
// Strokes that the card shows before the texels have them, as their painter sees it.
#include <QOpenGLWidget>

#include "render/renderer.h"
#include "tests/ui/viewport/view_fixture.h"
#include "ui/viewport/card_painting.h"

#include <cmath>
#include <random>

using namespace trixel;
using namespace trixel::ui;

namespace {

Project noisyProject(TexelType type)
{
    Project project = squareProject();
    const TexelFormat format{type, 3, std::nullopt};
    std::mt19937 random(5);
    std::uniform_real_distribution<float> in(0, 1);
    project.texels = TexelStore(2, format, Level(6), std::vector<std::byte>(format.texelBytes()));
    std::vector<float> values(Level(6).texelCount() * 3);
    for (std::uint32_t f = 0; f < 2; ++f) {
        std::ranges::generate(values, [&] { return in(random); });
        encode(type, values, project.texels.writable(FaceId{f}));
    }
    return project;
}

Brush softBrush()
{
    Brush brush;
    brush.radius = 0.4F;
    brush.hardness = 0.2F;
    brush.flow = 0.5F;
    brush.color = {1, 0.1F, 0, 1};
    return brush;
}

int largestDifference(const QImage& a, const QImage& b)
{
    int most = a.size() == b.size() ? 0 : 255;
    for (int y = 0; y < a.height() && most < 255; ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y);
            const QRgb q = b.pixel(x, y);
            most = std::max({most,
                             std::abs(qRed(p) - qRed(q)),
                             std::abs(qGreen(p) - qGreen(q)),
                             std::abs(qBlue(p) - qBlue(q))});
        }
    }
    return most;
}

/// What a driver's reset does to the view.
void loseContext(Viewport& viewport)
{
    auto* canvas = viewport.findChild<QOpenGLWidget*>();
    for (const QEvent::Type type :
         {QEvent::WindowAboutToChangeInternal, QEvent::WindowChangeInternal}) {
        QEvent event(type);
        QCoreApplication::sendEvent(canvas, &event);
    }
}

struct PaintingFixture : ViewFixture
{
    QPoint from, to;

    bool showNoise(TexelType type = TexelType::UInt8,
                   render::PaintOnCard choice = render::PaintOnCard::Always)
    {
        const bool shown = show(noisyProject(type));
        settings.setBrush(softBrush());
        ViewOptions view = settings.view();
        view.paintOnCard = choice;
        view.lit = false;
        view.footprint = false;
        settings.setView(view);
        from = texelPosition(kFace0, {20, 20, TexelHalf::Upper});
        to = texelPosition(kFace1, {20, 20, TexelHalf::Lower});
        movePointer(*viewport, to);
        viewport->settle();
        return shown;
    }
    QImage picture()
    {
        viewport->settle();
        return viewport->grabFramebuffer();
    }
    void drag()
    {
        QTest::mousePress(viewport.get(), Qt::LeftButton, {}, from);
        movePointer(*viewport, (from + to) / 2, Qt::LeftButton);
        movePointer(*viewport, to, Qt::LeftButton);
    }
    void letGo() { QTest::mouseRelease(viewport.get(), Qt::LeftButton, {}, to); }
};

} // namespace

class TestViewportPainting : public QObject
{
    Q_OBJECT

private slots:
    void theStrokeShowsAtOnceAndLooksTheSameWhenTheTexelsHaveIt_data()
    {
        QTest::addColumn<int>("type");
        for (const TexelType type :
             {TexelType::UInt8, TexelType::UInt16, TexelType::Half, TexelType::Float}) {
            QTest::newRow(std::string(nameOf(type)).c_str()) << static_cast<int>(type);
        }
    }
    void theStrokeShowsAtOnceAndLooksTheSameWhenTheTexelsHaveIt()
    {
        QFETCH(int, type);
        PaintingFixture view;
        QVERIFY(view.showNoise(static_cast<TexelType>(type)));
        const QImage before = view.picture();
        const TexelStore texels = view.document.texels();
        view.drag();
        view.letGo();
        const QImage shown = view.picture();
        QVERIFY(view.document.isSettling()); // nothing has come back from the other thread yet
        QVERIFY(view.document.texels().face(kFace0) == texels.face(kFace0));
        QVERIFY(largestDifference(shown, before) > 60);
        QTRY_VERIFY(!view.document.isSettling());
        QVERIFY(!(view.document.texels().face(kFace0) == texels.face(kFace0)));
        // A value may round to the other side of a step of the screen.
        QVERIFY(largestDifference(view.picture(), shown) <= 1);

        PaintingFixture plain;
        QVERIFY(plain.showNoise(static_cast<TexelType>(type), render::PaintOnCard::Never));
        plain.drag();
        plain.letGo();
        for (const FaceId face : {kFace0, kFace1}) {
            QVERIFY(view.document.texels().face(face) == plain.document.texels().face(face));
        }
        QCOMPARE(view.picture(), plain.picture()); // nothing of the preview stays
    }

    void whileTexelsComeInThePictureStays()
    {
        PaintingFixture view;
        QVERIFY(view.showNoise());
        view.drag();
        const QImage shown = view.picture();
        QTRY_VERIFY(!(view.document.texels().face(kFace0) ==
                      noisyProject(TexelType::UInt8).texels.face(kFace0)));
        QVERIFY(view.document.hasStroke());
        QCOMPARE(view.picture(), shown);
        view.letGo();
        for (int k = 0; k < 20; ++k) {
            QTest::qWait(2);
            QVERIFY(largestDifference(view.viewport->grabFramebuffer(), shown) <= 1);
        }
    }

    void anotherMipLevelInTheMiddleOfAStrokeLosesNothing()
    {
        PaintingFixture view;
        QVERIFY(view.showNoise());
        PaintingFixture plain;
        QVERIFY(plain.showNoise(TexelType::UInt8, render::PaintOnCard::Never));
        for (PaintingFixture* one : {&view, &plain}) {
            one->drag();
            for (const int drop : {2, 0}) {
                ViewOptions options = one->settings.view();
                options.mipDrop = drop;
                one->settings.setView(options);
                QTest::qWait(15); // texels come in before the next frame, or after it
            }
            one->letGo();
        }
        QTRY_VERIFY(!view.document.hasStroke());
        QCOMPARE(view.picture(), plain.picture());
    }

    void aCancelledStrokeLeavesNothing()
    {
        PaintingFixture view;
        QVERIFY(view.showNoise());
        const QImage before = view.picture();
        view.drag();
        QTest::qWait(20); // with some of it in the texels
        QVERIFY(largestDifference(view.picture(), before) > 60);
        QTest::keyClick(view.viewport.get(), Qt::Key_Escape);
        QCOMPARE(view.picture(), before);
        QTest::qWait(20);
        QCOMPARE(view.picture(), before);
    }

    void aStrokeUndoneWhileItSettlesLeavesNothing()
    {
        PaintingFixture view;
        QVERIFY(view.showNoise());
        const QImage before = view.picture();
        view.drag();
        view.letGo();
        QVERIFY(view.document.isSettling());
        view.document.undoStack().undo();
        QCOMPARE(view.picture(), before);
        QTest::qWait(20);
        QCOMPARE(view.picture(), before);
    }

    void strokesInQuickSuccessionEndAsThosePaintedAtOnce()
    {
        PaintingFixture view;
        QVERIFY(view.showNoise());
        PaintingFixture plain;
        QVERIFY(plain.showNoise(TexelType::UInt8, render::PaintOnCard::Never));
        for (PaintingFixture* one : {&view, &plain}) {
            for (int k = 0; k < 4; ++k) {
                Brush brush = softBrush();
                brush.color[2] = 0.3F * static_cast<float>(k);
                one->settings.setBrush(brush);
                one->drag();
                one->letGo();
                std::swap(one->from, one->to);
                (void)one->viewport->grabFramebuffer();
            }
        }
        QTRY_COMPARE(view.document.undoStack().count(), 4);
        QTRY_VERIFY(!view.document.hasStroke());
        QVERIFY(view.document.texels().face(kFace0) == plain.document.texels().face(kFace0));
        QCOMPARE(view.picture(), plain.picture());
        view.document.undoStack().undo();
        plain.document.undoStack().undo();
        QCOMPARE(view.picture(), plain.picture());
    }

    void aContextLostInTheMiddleOfAStrokeLosesNothing()
    {
        PaintingFixture view;
        QVERIFY(view.showNoise());
        PaintingFixture plain;
        QVERIFY(plain.showNoise(TexelType::UInt8, render::PaintOnCard::Never));
        for (PaintingFixture* one : {&view, &plain}) {
            QTest::mousePress(one->viewport.get(), Qt::LeftButton, {}, one->from);
            (void)one->viewport->grabFramebuffer();
            if (one == &view) {
                loseContext(*view.viewport);
            }
            (void)one->viewport->grabFramebuffer();
            movePointer(*one->viewport, one->to, Qt::LeftButton);
            (void)one->viewport->grabFramebuffer();
            one->letGo();
        }
        QTRY_VERIFY(!view.document.hasStroke());
        QVERIFY(view.document.texels().face(kFace0) == plain.document.texels().face(kFace0));
        QVERIFY(view.document.texels().face(kFace1) == plain.document.texels().face(kFace1));
        QCOMPARE(view.picture(), plain.picture());
        // And the next stroke shows at once again.
        view.drag();
        view.letGo();
        plain.drag();
        plain.letGo();
        QVERIFY(view.document.isSettling());
        QVERIFY(largestDifference(view.picture(), plain.picture()) <= 1);
    }

    void aCardThatIsNotAbleToIsLeftOutWithOneNotice()
    {
        PaintingFixture view;
        QVERIFY(view.showNoise());
        auto* canvas = view.viewport->findChild<QOpenGLWidget*>();
        canvas->makeCurrent();
        auto renderer = render::Renderer::create();
        QVERIFY(renderer.has_value());
        (*renderer)->setCoverageFormat(GL_RGB9_E5); // can be read, not drawn into
        CardPainting painting;
        const auto pace = [&] {
            return painting.paceFor(
                render::PaintOnCard::Always, softBrush(), kFace0, view.document, renderer->get());
        };
        QCOMPARE(pace(), StrokePace::AtOnce);
        QVERIFY(painting.takeNotice().contains("cannot draw"));
        QCOMPARE(pace(), StrokePace::AtOnce);
        QVERIFY(painting.takeNotice().isEmpty());
        (*renderer)->setCoverageFormat(GL_R32F);
        QCOMPARE(pace(), StrokePace::Behind);
        renderer->reset();
        canvas->doneCurrent();
    }

    void smallDabsArePaintedAtOnceAndLargeOnesWhereTheCardIsFaster()
    {
        PaintingFixture view;
        QVERIFY(view.showNoise(TexelType::UInt8, render::PaintOnCard::WhereFaster));
        view.drag();
        QVERIFY(!view.document.isSettling());
        view.letGo();
        QVERIFY(!view.document.isSettling());
        QCOMPARE(view.document.undoStack().count(), 1);
    }
};

QTEST_MAIN(TestViewportPainting)
#include "tst_viewport_painting.moc"
