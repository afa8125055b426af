// SPDX-License-Identifier: GPL-3.0-or-later
//
// The looking tools as they are used: real mouse and key events on the window.
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMouseEvent>
#include <QSlider>
#include <QToolButton>
#include <QWheelEvent>

#include "tests/ui/look/look_fixture.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/document/inspection.h"
#include "ui/look/histogram_view.h"
#include "ui/look/look_legend.h"
#include "ui/look/look_panel.h"
#include "ui/look/mark_table.h"
#include "ui/look/value_spin.h"

namespace trixel::ui {

using render::Look;
using render::Mark;

class LookPanelTest : public WindowTest
{
    Q_OBJECT

private slots:
    void init()
    {
        openWindow();
        document().open(wildProject(), {}, "wild");
        m_window->viewport().lookFrom(0, 0);
        m_dock = m_window->findChild<QDockWidget*>("lookPanel");
        m_panel = m_window->findChild<LookPanel*>();
        QVERIFY(m_dock && m_panel);
    }
    void cleanup() { closeWindow(); }

    void shiftF2ShowsThePanelAndItCountsOnlyThen()
    {
        QTest::qWait(50);
        QVERIFY(!m_panel->survey().isCurrent());
        showPanel();
        QTRY_VERIFY(m_panel->survey().isCurrent());
    }

    void buttonsChooseWhatIsShown()
    {
        showPanel();
        click("Show Green alone");
        QCOMPARE(look().channel, std::optional<std::uint16_t>(1));
        click("Show Opacity alone");
        QCOMPARE(look().channel, std::optional<std::uint16_t>(3));
        click("Show the luminance of red, green and blue");
        QVERIFY(look().luminance && !look().channel);
        click("Show colours with their opacity");
        QCOMPARE(look(), Look());
    }

    void furtherChannelsAreInAList()
    {
        NoProgress progress;
        Project project;
        project.surface = Surface::build(gridMesh(1), progress).value();
        project.texels = TexelStore(
            2, {TexelType::UInt8, 6, {}}, Level(1), std::vector<std::byte>(6, std::byte{40}));
        document().open(std::move(project), {}, "six");
        showPanel();
        auto* list = widgetNamed<QComboBox>(*m_panel, "Further channels");
        QVERIFY(list);
        list->setFocus();
        QTest::keyClick(list, Qt::Key_Down);
        QTest::keyClick(list, Qt::Key_Down);
        QCOMPARE(look().channel, std::optional<std::uint16_t>(5));
        press(Qt::Key_C);
        QVERIFY(look().luminance);
        QCOMPARE(list->currentIndex(), 0);
        document().open(gridProject(1, 1), {}, "three");
        QVERIFY(!widgetNamed<QComboBox>(*m_panel, "Further channels"));
    }

    void keysChangeTheLookFromTheView()
    {
        m_window->viewport().setFocus();
        press(Qt::Key_Up, Qt::ControlModifier);
        press(Qt::Key_Up, Qt::ControlModifier);
        QCOMPARE(look().exposure, 1.0F);
        press(Qt::Key_Down, Qt::ControlModifier);
        QCOMPARE(look().exposure, 0.5F);
        press(Qt::Key_C);
        QCOMPARE(look().channel, std::optional<std::uint16_t>(0));
        press(Qt::Key_C, Qt::ShiftModifier);
        QVERIFY(!look().channel);
        press(Qt::Key_J);
        QVERIFY(look().falseColor);
        press(Qt::Key_N);
        QVERIFY(look().marks);
        press(Qt::Key_Home, Qt::ControlModifier);
        QCOMPARE(look(), Look());
    }

    void theRangeFitsTheValuesShown()
    {
        showPanel();
        click("Show Red alone");
        click("Fit the range");
        QTRY_COMPARE(look().high, 2 * 63.0F / 64);
        QCOMPARE(look().low, 0.0F);
        click("Range from 0 to 1");
        QCOMPARE(look().high, 1.0F);
    }

    void theRangeFitsByKeyWhileThePanelIsHidden()
    {
        document().open(wildProject(20), {}, "large"); // 0.1 % are more than the odd ones
        m_window->viewport().setFocus();
        press(Qt::Key_R);
        QTRY_COMPARE(look().low, -0.5F);
        QVERIFY(m_panel->visibleRegion().isEmpty());
        press(Qt::Key_R, Qt::ShiftModifier);
        QTRY_COMPARE(look().low, 0.0F);
    }

    void handlesAreDragged()
    {
        showPanel();
        QTRY_VERIFY(m_panel->survey().isCurrent());
        HistogramView& view = m_panel->histogram();
        const int y = view.height() / 2;
        const double before = view.placeOf(1);
        drag(view, QPoint(int(before), y), QPoint(int(before) - 40, y));
        const double moved = view.placeOf(double(look().whiteValue())) - view.placeOf(1);
        QVERIFY2(std::abs(moved + 40) < 3, qPrintable(QString::number(moved)));
        QCOMPARE(look().low, 0.0F);
        const QPoint black(int(view.placeOf(0)), y);
        drag(view, black, black + QPoint(20, 0));
        QVERIFY(look().low > 0 && look().low < look().high);
        view.setFocus();
        const float white = look().high;
        QTest::keyClick(&view, Qt::Key_Right);
        QVERIFY(look().high > white);
        const float low = look().low;
        QTest::keyClick(&view, Qt::Key_Left, Qt::ShiftModifier);
        QVERIFY(look().low < low);
    }

    void theWheelLooksCloserAndADoubleClickSeesAll()
    {
        showPanel();
        QTRY_VERIFY(m_panel->survey().isCurrent());
        HistogramView& view = m_panel->histogram();
        const double width = view.axisHigh() - view.axisLow();
        const QPointF at(view.width() / 2.0, view.height() / 2.0);
        const double about = view.valueAt(at.x());
        QWheelEvent wheel(at,
                          view.mapToGlobal(at),
                          {},
                          {0, 240},
                          Qt::NoButton,
                          Qt::NoModifier,
                          Qt::NoScrollPhase,
                          false);
        QCoreApplication::sendEvent(&view, &wheel);
        QVERIFY(view.axisHigh() - view.axisLow() < 0.7 * width);
        QVERIFY(std::abs(view.valueAt(at.x()) - about) < 1e-6 * width);
        QTest::mouseDClick(&view, Qt::LeftButton, {}, at.toPoint());
        QCOMPARE(view.axisHigh() - view.axisLow(), width);
    }

    void fieldsAndSliderSetTheLook()
    {
        showPanel();
        type("Value shown white", "4e3");
        QCOMPARE(look().high, 4000.0F);
        type("Value shown black", "4000"); // equal: refused
        QCOMPARE(look().low, 0.0F);
        QCOMPARE(widgetNamed<ValueSpin>(*m_panel, "Value shown black")->value(), 0.0);
        type("Value shown black", "-2.5");
        QCOMPARE(look().low, -2.5F);
        auto* slider = widgetNamed<QSlider>(*m_panel, "Exposure slider");
        slider->setValue(slider->maximum());
        QCOMPARE(look().exposure, 16.0F);
        click("No exposure");
        QCOMPARE(look().exposure, 0.0F);
        click("Reset the look");
        QCOMPARE(look(), Look());
    }

    void countsAreSaidAndFollowTheLook()
    {
        showPanel();
        QTRY_VERIFY(m_panel->survey().isCurrent());
        QCOMPARE(counts("NaN"), QString("1 R · 1 B"));
        QCOMPARE(counts("Infinite"), QString("1 G"));
        QCOMPARE(counts("Negative"), QString("1 G"));
        QVERIFY(counts("Clipped").contains("R"));
        click("Show Green alone");
        QCOMPARE(counts("NaN"), QString("none"));
        QCOMPARE(counts("Clipped"), QString("none"));
        QVERIFY(!widgetNamed<QToolButton>(*m_panel, "Next texel: NaN")->isEnabled());
    }

    void nextGoesFromOneSuchTexelToTheNext()
    {
        showPanel();
        QTRY_VERIFY(m_panel->survey().isCurrent());
        const std::pair<std::uint32_t, std::uint32_t> wanted[] = {{1, 10}, {5, 3}, {1, 10}};
        for (const auto& [face, texel] : wanted) {
            click("Next texel: NaN");
            QTRY_VERIFY(!m_panel->marks().isSearching());
            QVERIFY(inspection().isHeld());
            const TexelPlace place = inspection().texel()->place;
            QCOMPARE(indexOf(place.face), std::size_t{face});
            QCOMPARE(indexOf(texelIndex(Level(kWildLevel), place.texel)), std::size_t{texel});
        }
        QCOMPARE(m_panel->marks().message(), QString());
    }

    void theViewSaysThatTheLookIsNotNeutral()
    {
        auto* chip = m_window->viewport().findChild<QToolButton*>("lookChip");
        QVERIFY(chip && chip->isHidden());
        Look other;
        other.channel = 0;
        other.exposure = 2;
        m_window->settings().setLook(other);
        QVERIFY(chip->isVisible());
        QCOMPARE(chip->text(), QString("Red only · Exposure +2 — reset"));
        QTest::mouseClick(chip, Qt::LeftButton);
        QCOMPARE(look(), Look());
        QVERIFY(chip->isHidden());
    }

    void falseColourHasALegendWithTheNumberUnderThePointer()
    {
        auto* legend = m_window->viewport().findChild<LookLegend*>();
        QVERIFY(legend->isHidden());
        m_window->viewport().setFocus();
        press(Qt::Key_C);
        press(Qt::Key_J);
        QVERIFY(legend->isVisible());
        QCOMPARE(legend->title(), QString("Red in false colour"));
        const QPoint middle = m_window->viewport().rect().center();
        QMouseEvent move(QEvent::MouseMove,
                         QPointF(middle),
                         QPointF(m_window->viewport().mapToGlobal(middle)),
                         Qt::NoButton,
                         Qt::NoButton,
                         Qt::NoModifier);
        QCoreApplication::sendEvent(&m_window->viewport(), &move);
        QVERIFY(!legend->valueText().isEmpty());
        press(Qt::Key_J);
        QVERIFY(legend->isHidden());
    }

    void theViewShowsWhatTheLookSays()
    {
        const QPoint middle = m_window->viewport().rect().center() + QPoint(20, -60);
        const auto seen = [&] {
            m_window->viewport().settle();
            const QImage image = m_window->viewport().grabFramebuffer();
            const double ratio = m_window->viewport().devicePixelRatioF();
            return image.pixelColor(int(middle.x() * ratio), int(middle.y() * ratio));
        };
        ViewOptions options = m_window->settings().view();
        options.lit = false;
        options.footprint = false;
        m_window->settings().setView(options);
        Look blue;
        blue.channel = 2;
        m_window->settings().setLook(blue);
        QCOMPARE(seen(), QColor(64, 64, 64));
        blue.exposure = 1;
        m_window->settings().setLook(blue);
        QCOMPARE(seen(), QColor(128, 128, 128));
    }

private:
    const Look& look() { return m_window->settings().look(); }
    Inspection& inspection() { return m_window->inspection(); }

    void showPanel()
    {
        m_dock->show();
        m_dock->raise();
        QTRY_VERIFY(!m_panel->visibleRegion().isEmpty());
    }

    /// The button that a screen reader calls so, clicked with the mouse.
    void click(const QString& name)
    {
        auto* button = widgetNamed<QAbstractButton>(*m_panel, name);
        QVERIFY2(button && button->isEnabled(), qPrintable(name));
        QTest::mouseClick(button, Qt::LeftButton);
    }

    void type(const QString& name, const QString& text)
    {
        auto* field = widgetNamed<ValueSpin>(*m_panel, name);
        QVERIFY2(field, qPrintable(name));
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    }

    QString counts(const QString& mark)
    {
        const auto labels = m_panel->marks().findChildren<QLabel*>();
        for (qsizetype k = 0; k + 1 < labels.size(); ++k) {
            if (labels[k]->text() == mark) {
                return labels[k + 1]->text();
            }
        }
        return {};
    }

    static void drag(QWidget& widget, QPoint from, QPoint to)
    {
        QTest::mousePress(&widget, Qt::LeftButton, {}, from);
        QMouseEvent move(QEvent::MouseMove,
                         QPointF(to),
                         QPointF(widget.mapToGlobal(to)),
                         Qt::NoButton,
                         Qt::LeftButton,
                         Qt::NoModifier);
        QCoreApplication::sendEvent(&widget, &move);
        QTest::mouseRelease(&widget, Qt::LeftButton, {}, to);
    }

    QDockWidget* m_dock = nullptr;
    LookPanel* m_panel = nullptr;
};

} // namespace trixel::ui

TRIXEL_WINDOW_TEST_MAIN(trixel::ui::LookPanelTest)
#include "tst_look_panel.moc"
