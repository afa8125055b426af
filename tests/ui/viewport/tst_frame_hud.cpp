// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/viewport/view_fixture.h"
#include "ui/viewport/frame_hud.h"

#include <algorithm>

using namespace trixel;
using namespace trixel::ui;

namespace {

QString figureOf(const FrameHud& hud, const QString& name)
{
    const auto line = std::ranges::find(hud.lines(), name, &FrameHud::Line::first);
    return line == hud.lines().end() ? QString() : line->second;
}

} // namespace

class TestFrameHud : public QObject
{
    Q_OBJECT

private slots:
    void figuresShowOnlyWhenAskedFor()
    {
        ViewFixture view;
        QVERIFY(view.show());
        const auto* hud = view.viewport->findChild<FrameHud*>();
        QVERIFY(hud != nullptr);
        QVERIFY(hud->isHidden());
        ViewOptions options = view.settings.view();
        options.hud = true;
        view.settings.setView(options);
        QVERIFY(hud->isVisible());
        QTRY_COMPARE(figureOf(*hud, "Faces"), QString("2"));
        QTRY_VERIFY(figureOf(*hud, "CPU").endsWith("ms"));
        QVERIFY(view.viewport->rect().contains(hud->geometry()));
        options.hud = false;
        view.settings.setView(options);
        QVERIFY(hud->isHidden());
    }

    void figuresAreThoseOfTheSlowestFrameOfATurn()
    {
        QWidget window;
        FrameHud hud(&window);
        hud.show();
        render::FrameFigures figures;
        figures.processorMs = 1;
        hud.take(figures);
        QCOMPARE(figureOf(hud, "CPU"), QString("1.00 ms"));
        figures.processorMs = 7;
        hud.take(figures);
        figures.processorMs = 2;
        hud.take(figures);
        QCOMPARE(figureOf(hud, "CPU"), QString("1.00 ms")); // can still be read
        QTRY_COMPARE(figureOf(hud, "CPU"), QString("7.00 ms"));
    }

    void whatIsNotThereIsNotWritten()
    {
        QWidget window;
        FrameHud hud(&window);
        hud.show();
        render::FrameFigures figures;
        figures.faces = figures.triangles = 1234;
        figures.residentBytes = 1U << 20U;
        hud.take(figures);
        QCOMPARE(figureOf(hud, "GPU"), QString("no clock yet"));
        QVERIFY(figureOf(hud, "Triangles").isNull());
        QVERIFY(figureOf(hud, "Off by").isNull());
        QVERIFY(!figureOf(hud, "On the card").contains("of"));
        FrameHud other(&window);
        other.show();
        figures.triangles = 5000;
        figures.surfaceError = 0.5;
        figures.budgetBytes = 512U << 20U;
        other.take(figures);
        QCOMPARE(figureOf(other, "Off by"), QString("0.50 px"));
        QVERIFY(figureOf(other, "On the card").contains("of"));
        QVERIFY(!figureOf(other, "Triangles").isNull());
    }
};

QTEST_MAIN(TestFrameHud)
#include "tst_frame_hud.moc"
