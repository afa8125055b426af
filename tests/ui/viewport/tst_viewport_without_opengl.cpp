// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLabel>

#include "tests/ui/viewport/view_fixture.h"

using namespace trixel;
using namespace trixel::ui;

class TestViewportWithoutOpenGl : public QObject
{
    Q_OBJECT

private slots:
    void aMessageStandsInThePlaceOfThePicture()
    {
        ViewFixture view;
        QVERIFY(!view.show());
        QTRY_VERIFY(view.viewport->findChild<QLabel*>());
        const auto* message = view.viewport->findChild<QLabel*>();
        QVERIFY(message->text().contains("OpenGL 4.1"));
        QVERIFY(message->isVisible());
        QCOMPARE(message->size(), view.viewport->size());
    }

    void pointerAndKeysDoNoHarm()
    {
        ViewFixture view;
        QVERIFY(!view.show());
        QTest::mouseClick(view.viewport.get(), Qt::LeftButton, {}, {300, 300});
        QTest::keyClick(view.viewport.get(), Qt::Key_Escape);
        view.viewport->resize(500, 400);
        view.viewport->settle();
        QVERIFY(!view.viewport->canDraw());
    }
};

QTEST_MAIN(TestViewportWithoutOpenGl)
#include "tst_viewport_without_opengl.moc"
