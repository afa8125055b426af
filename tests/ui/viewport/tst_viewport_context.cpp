// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDockWidget>
#include <QMainWindow>
#include <QOpenGLWidget>

#include "tests/ui/viewport/view_fixture.h"
#include "ui/viewport/canvas.h"

using namespace trixel;
using namespace trixel::ui;

namespace {

constexpr int kLosses = 20;

/// What Qt does with a view when it finds that the graphics card was reset: everything that was in
/// the context is gone, and a new one is made.
void loseContext(Viewport& viewport)
{
    auto* canvas = viewport.findChild<QOpenGLWidget*>();
    const QPointer<QOpenGLContext> before = canvas->context();
    for (const QEvent::Type type :
         {QEvent::WindowAboutToChangeInternal, QEvent::WindowChangeInternal}) {
        QEvent event(type);
        QCoreApplication::sendEvent(canvas, &event);
    }
    QVERIFY(before.isNull());
}

/// A picture of stripes, half covering.
std::vector<std::uint32_t> stripes(QSize size)
{
    std::vector<std::uint32_t> pixels(static_cast<std::size_t>(size.width() * size.height()));
    for (std::size_t k = 0; k < pixels.size(); ++k) {
        pixels[k] = (k / 7) % 2 == 0 ? 0x80ff0000U : 0U;
    }
    return pixels;
}

} // namespace

class TestViewportContext : public QObject
{
    Q_OBJECT

private slots:
    void aViewMovedToAnotherWindowShowsTheSame()
    {
        ViewFixture view;
        QVERIFY(view.show());
        const QPoint position = view.texelPosition(kFace0, {1, 1, TexelHalf::Upper});
        QTest::mouseClick(view.viewport.get(), Qt::LeftButton, {}, position);
        view.viewport->settle();
        movePointer(*view.viewport, QPoint(2, 2));
        const QImage before = view.viewport->grabFramebuffer();

        // Another top-level window means another context.
        QWidget window;
        window.resize(480, 480);
        view.viewport->setParent(&window);
        view.viewport->setGeometry(0, 0, 480, 480);
        view.viewport->show();
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QVERIFY(view.viewport->canDraw());
        view.viewport->settle();
        const QImage after = view.viewport->grabFramebuffer();
        view.viewport->setParent(nullptr);
        QCOMPARE(after, before);
    }

    void aViewMovedToAnotherDockShowsTheSame()
    {
        ViewFixture view;
        QVERIFY(view.show());
        QMainWindow window;
        auto* first = new QDockWidget(&window);
        auto* second = new QDockWidget(&window);
        window.addDockWidget(Qt::LeftDockWidgetArea, first);
        window.addDockWidget(Qt::RightDockWidgetArea, second);
        first->setWidget(view.viewport.get());
        second->setFloating(true);
        view.viewport->setFixedSize(480, 480);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        view.viewport->settle();
        const QImage before = view.viewport->grabFramebuffer();
        second->setWidget(view.viewport.get());
        second->show();
        QVERIFY(QTest::qWaitForWindowExposed(second));
        view.viewport->settle();
        const QImage after = view.viewport->grabFramebuffer();
        view.viewport->setParent(nullptr);
        QVERIFY(!before.isNull());
        QCOMPARE(after, before);
    }

    void aLostContextLosesNothing()
    {
        ViewFixture view;
        QVERIFY(view.show());
        const QPoint position = view.texelPosition(kFace0, {1, 1, TexelHalf::Upper});
        QTest::mouseClick(view.viewport.get(), Qt::LeftButton, {}, position);
        movePointer(*view.viewport, QPoint(2, 2));
        // All that can lie on the card: texels, a look, a second side, colours, a picture over it.
        render::Look look;
        look.exposure = 0.5F;
        view.settings.setLook(look);
        view.viewport->rememberBefore();
        Comparison comparison;
        comparison.by = ComparedBy::Level;
        view.settings.setComparison(comparison);
        view.viewport->setPictureRows(stripes({480, 200}), {480, 200}, 0);
        view.viewport->settle();
        const QImage before = view.viewport->grabFramebuffer();
        for (int k = 0; k < kLosses; ++k) {
            loseContext(*view.viewport);
            view.viewport->settle();
            QCOMPARE(view.viewport->grabFramebuffer(), before);
        }
        view.viewport->setFaceColors({0xff2040c0U, 0xffc04020U});
        const QImage colored = view.viewport->grabFramebuffer();
        QVERIFY(colored != before);
        for (int k = 0; k < kLosses; ++k) {
            loseContext(*view.viewport);
            view.viewport->settle();
            QCOMPARE(view.viewport->grabFramebuffer(), colored);
        }
    }

    void aContextLostInTheMiddleOfAStrokeLosesNothing()
    {
        ViewFixture view;
        QVERIFY(view.show());
        ViewFixture other;
        QVERIFY(other.show());
        const QPoint first = view.texelPosition(kFace0, {1, 1, TexelHalf::Upper});
        const QPoint second = view.texelPosition(kFace1, {1, 1, TexelHalf::Upper});
        for (ViewFixture* one : {&view, &other}) {
            QTest::mousePress(one->viewport.get(), Qt::LeftButton, {}, first);
            movePointer(*one->viewport, (first + second) / 2, Qt::LeftButton);
            if (one == &view) {
                loseContext(*view.viewport);
            }
            movePointer(*one->viewport, second, Qt::LeftButton);
            QTest::mouseRelease(one->viewport.get(), Qt::LeftButton, {}, second);
            movePointer(*one->viewport, QPoint(2, 2));
            one->viewport->settle();
        }
        QCOMPARE(view.document.undoStack().count(), 1);
        for (const FaceId face : {kFace0, kFace1}) {
            QVERIFY(view.document.texels().face(face) == other.document.texels().face(face));
        }
        QCOMPARE(view.viewport->grabFramebuffer(), other.viewport->grabFramebuffer());
    }

    void layingOutDrawsNothingUntilItIsDone()
    {
        QWidget window;
        window.resize(300, 300);
        int frames = 0;
        auto* canvas = new Canvas({}, {[] {}, [] {}, [&frames] { ++frames; }}, &window);
        canvas->setGeometry(0, 0, 100, 100);
        window.show();
        QTRY_VERIFY(frames > 0);
        QCoreApplication::processEvents();

        frames = 0;
        canvas->resize(200, 100);
        canvas->resize(200, 200);
        QCOMPARE(frames, 0);
        QTRY_VERIFY(frames > 0);
    }

    void aViewDestroyedBeforeItIsShownLeavesNothing()
    {
        ViewFixture view;
        view.viewport = std::make_unique<Viewport>(view.document, view.settings);
        view.document.open(squareProject(), {}, "square");
        view.viewport->settle();
        QVERIFY(!view.viewport->canDraw());
        view.viewport.reset();
    }
};

QTEST_MAIN(TestViewportContext)
#include "tst_viewport_context.moc"
