// SPDX-License-Identifier: GPL-3.0-or-later
#include <QMainWindow>

#include "tests/ui/viewport/view_fixture.h"

using namespace trixel;
using namespace trixel::ui;

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
