// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include "ui/docks/brush_colors.h"
#include "ui/docks/brush_panel.h"
#include "ui/docks/swatches.h"
#include "ui/docks/value_row.h"
#include "ui/viewport/view_settings.h"

namespace trixel::ui {

class BrushPanelTest : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        m_settings = std::make_unique<ViewSettings>();
        m_colors = std::make_unique<BrushColors>(*m_settings);
        m_panel = std::make_unique<BrushPanel>(*m_settings, *m_colors);
        m_panel->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_panel.get()));
    }
    void cleanup()
    {
        m_panel.reset();
        m_colors.reset();
    }

    void typedValuesReachTheBrush_data()
    {
        QTest::addColumn<QString>("field");
        QTest::addColumn<QString>("typed");
        QTest::addColumn<float>("expected");
        QTest::newRow("radius") << "Radius"
                                << "0.125" << 0.125F;
        QTest::newRow("hardness") << "Hardness"
                                  << "25" << 0.25F;
        QTest::newRow("opacity") << "Opacity"
                                 << "40" << 0.4F;
        QTest::newRow("flow") << "Flow"
                              << "12.5" << 0.125F;
        QTest::newRow("spacing") << "Spacing"
                                 << "150" << 1.5F;
    }
    void typedValuesReachTheBrush()
    {
        QFETCH(QString, field);
        QFETCH(QString, typed);
        QFETCH(float, expected);
        auto* spin = named<QDoubleSpinBox>(field);
        QVERIFY(spin);
        spin->setFocus();
        spin->selectAll();
        QTest::keyClicks(spin, typed);
        QTest::keyClick(spin, Qt::Key_Return);
        const Brush& b = m_settings->brush();
        const float found = field == "Radius"     ? b.radius
                            : field == "Hardness" ? b.hardness
                            : field == "Opacity"  ? b.opacity
                            : field == "Flow"     ? b.flow
                                                  : b.spacing;
        QVERIFY2(std::abs(found - expected) < 1e-6F, qPrintable(QString::number(found)));
        QVERIFY(validate(b).has_value());
    }

    void radiusSliderIsLogarithmicAndFitsTheSurface()
    {
        m_panel->setSurfaceSize(1000.0F);
        auto* slider = named<QSlider>("Radius slider");
        slider->setValue(slider->maximum());
        slider->setValue(0);
        QVERIFY(qFuzzyCompare(m_settings->brush().radius, 1000 * BrushPanel::kLeastRadius));
        slider->setValue(slider->maximum());
        const float most = m_settings->brush().radius;
        QVERIFY(qFuzzyCompare(most, 1000 * BrushPanel::kMostRadius));
        slider->setValue(slider->maximum() / 2);
        const float middle = m_settings->brush().radius;
        const float mean = 1000 * std::sqrt(BrushPanel::kLeastRadius * BrushPanel::kMostRadius);
        QVERIFY(std::abs(middle / mean - 1) < 1e-3F);
    }

    void everyPositionOfEverySliderGivesAUsableBrush()
    {
        for (QSlider* slider : m_panel->findChildren<QSlider*>()) {
            for (int position = slider->minimum(); position <= slider->maximum(); position += 50) {
                slider->setValue(position);
                const Status valid = validate(m_settings->brush());
                QVERIFY2(valid.has_value(), valid ? "" : valid.error().message.c_str());
            }
        }
    }

    void numbersAreShownToThreeDigitsAndReadBack_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("text");
        QTest::newRow("micro") << 0.0000123456 << "1.23e-05";
        QTest::newRow("small") << 0.00123456 << "0.00123";
        QTest::newRow("one") << 1.23456 << "1.23";
        QTest::newRow("hundred") << 123.456 << "123";
        QTest::newRow("thousands") << 12345.6 << "12346";
        QTest::newRow("million") << 1234567.0 << "1.23e+06";
    }
    void numbersAreShownToThreeDigitsAndReadBack()
    {
        QFETCH(double, value);
        QFETCH(QString, text);
        ScaledSpinBox spin(Scale::Logarithmic);
        spin.setLocale(QLocale::c());
        spin.setRange(1e-9, 1e9);
        spin.setValue(value);
        QCOMPARE(spin.text(), text);
        QCOMPARE(spin.value(), value); // showing it rounded does not round it
        QVERIFY(std::abs(spin.valueFromText(text) / value - 1) < 0.005);
    }

    void panelFollowsTheBrushWithoutChangingIt()
    {
        Brush brush;
        brush.radius = 0.0123F;
        brush.hardness = 0.333F;
        brush.paintThrough = true;
        m_settings->setBrush(brush);
        QVERIFY(named<QCheckBox>("Paint through")->isChecked());
        QCOMPARE(m_settings->brush().hardness, 0.333F);
        QCOMPARE(m_settings->brush().radius, 0.0123F);
    }

    void switchesReachTheBrush()
    {
        tick("Pressure to size");
        QVERIFY(m_settings->brush().pressureToSize);
        tick("Pressure to opacity");
        QVERIFY(m_settings->brush().pressureToOpacity);
        tick("Paint through");
        QVERIFY(m_settings->brush().paintThrough);
    }

    void erasingIsAToolAndNoSwitchAsWell()
    {
        for (const QCheckBox* box : m_panel->findChildren<QCheckBox*>()) {
            QVERIFY2(!box->text().contains("rase"), qPrintable(box->text()));
        }
    }

    void clickedSwatchIsPaintedWith()
    {
        SwatchButton* red = nullptr;
        for (SwatchButton* swatch : m_panel->findChildren<SwatchButton*>()) {
            if (swatch->accessibleName().startsWith("Palette") && swatch->color() == 0xd8342b) {
                red = swatch;
            }
        }
        QVERIFY(red);
        QTest::mouseClick(red, Qt::LeftButton);
        QCOMPARE(m_colors->color(), QColor(0xd8342b));
        QVERIFY(m_colors->recent().empty()); // not before something was painted with it
        m_colors->remember(m_settings->brush().color);
        QCOMPARE(m_colors->recent().front(), QColor(0xd8342b));
        QVERIFY(named<SwatchButton>("Recent colour #d8342b"));
    }

    void thePaletteIsOneStopOfTabAndArrowsGoWithinIt()
    {
        m_panel->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_panel.get()));
        const std::vector<QColor>& colors = paletteColors();
        const auto focused = [] {
            auto* swatch = qobject_cast<SwatchButton*>(QApplication::focusWidget());
            return swatch != nullptr ? swatch->color() : QColor();
        };
        named<QToolButton>("Default colours")->setFocus();
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QCOMPARE(focused(), colors[0]);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Left); // nothing is there
        QCOMPARE(focused(), colors[0]);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Right);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Down);
        QCOMPARE(focused(), colors[colors.size() / 2 + 1]);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
        QCOMPARE(m_colors->color(), colors[colors.size() / 2 + 1]);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QVERIFY(!focused().isValid());
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Backtab);
        QCOMPARE(focused(), colors[colors.size() / 2 + 1]);
    }

    void swapAndResetColors()
    {
        m_colors->choose(QColor(10, 20, 30));
        m_colors->swap();
        QCOMPARE(m_colors->color(), QColor(Qt::white));
        QCOMPARE(m_colors->other(), QColor(10, 20, 30));
        m_colors->swap();
        QCOMPARE(m_colors->color(), QColor(10, 20, 30));
        m_colors->reset();
        QCOMPARE(m_colors->color(), QColor(Qt::black));
        QCOMPARE(m_colors->other(), QColor(Qt::white));
    }

    void recentColorsAreFewAndEachOnce()
    {
        for (int k = 0; k < 30; ++k) {
            m_colors->choose(QColor(k, 0, 0));
            m_colors->remember(m_settings->brush().color);
        }
        QCOMPARE(m_colors->recent().size(), BrushColors::kRecentMax);
        m_colors->choose(QColor(25, 0, 0));
        m_colors->remember(m_settings->brush().color);
        QCOMPARE(m_colors->recent().size(), BrushColors::kRecentMax);
        QCOMPARE(m_colors->recent().front(), QColor(25, 0, 0));
    }

    void pickedValuesBeyondAColorAreKept()
    {
        m_colors->choose(std::array{2.5F, 0.123456F, -1.0F, 1.0F});
        QCOMPARE(m_settings->brush().color[0], 2.5F);
        QCOMPARE(m_settings->brush().color[1], 0.123456F);
        QCOMPARE(m_colors->color().red(), 255);
    }

    void oneChannelMeansGreys()
    {
        m_colors->setGreyOnly(true);
        m_colors->choose(QColor(0, 0, 255));
        const auto& color = m_settings->brush().color;
        QVERIFY(color[0] > 0.0F); // blue is not nothing
        QCOMPARE(color[0], color[1]);
        QCOMPARE(color[1], color[2]);
    }

private:
    /// On the box, left of its text.
    void tick(const QString& name) const
    {
        auto* box = named<QCheckBox>(name);
        QTest::mouseClick(box, Qt::LeftButton, {}, {8, box->height() / 2});
    }

    template <class T>
    T* named(const QString& name) const
    {
        for (T* widget : m_panel->findChildren<T*>()) {
            if (widget->accessibleName() == name) {
                return widget;
            }
        }
        return nullptr;
    }

    std::unique_ptr<ViewSettings> m_settings;
    std::unique_ptr<BrushColors> m_colors;
    std::unique_ptr<BrushPanel> m_panel;
};

} // namespace trixel::ui

QTEST_MAIN(trixel::ui::BrushPanelTest)
#include "tst_brush_panel.moc"
