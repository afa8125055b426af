// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QDockWidget>
#include <QImage>
#include <QMainWindow>
#include <QPainter>
#include <QTabBar>
#include <QTest>

#include "tests/ui/fixtures.h"
#include "ui/window/icons.h"
#include "ui/window/theme.h"

#include <cmath>

namespace trixel::ui {

namespace {

/// Relative luminance of an sRGB colour (WCAG 2.1).
double luminance(const QColor& color)
{
    const auto linear = [](double c) {
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) +
           0.0722 * linear(color.blueF());
}

double contrast(const QColor& a, const QColor& b)
{
    const double la = luminance(a) + 0.05;
    const double lb = luminance(b) + 0.05;
    return std::max(la, lb) / std::min(la, lb);
}

} // namespace

class ThemeTest : public QObject
{
    Q_OBJECT

private slots:
    void textReadsWellInBothThemes()
    {
        for (const QPalette& palette : {darkPalette(), lightPalette()}) {
            const auto ratio = [&palette](QPalette::ColorRole text, QPalette::ColorRole ground) {
                return contrast(palette.color(text), palette.color(ground));
            };
            QVERIFY(ratio(QPalette::WindowText, QPalette::Window) >= 7);
            QVERIFY(ratio(QPalette::Text, QPalette::Base) >= 7);
            QVERIFY(ratio(QPalette::ButtonText, QPalette::Button) >= 7);
            QVERIFY(ratio(QPalette::HighlightedText, QPalette::Highlight) >= 4.5);
            QVERIFY(ratio(QPalette::ToolTipText, QPalette::ToolTipBase) >= 7);
            QVERIFY(contrast(palette.color(QPalette::Disabled, QPalette::WindowText),
                             palette.color(QPalette::Window)) >= 3);
        }
    }

    void greysAreNeutral()
    {
        for (const QPalette& palette : {darkPalette(), lightPalette()}) {
            for (const QPalette::ColorRole role :
                 {QPalette::Window, QPalette::Base, QPalette::Button}) {
                const QColor color = palette.color(role);
                QCOMPARE(color.red(), color.green());
                QCOMPARE(color.green(), color.blue());
            }
        }
    }

    void namesRoundTrip()
    {
        for (const Theme theme : {Theme::System, Theme::Dark, Theme::Light}) {
            QVERIFY(themeFromName(nameOf(theme)) == theme);
        }
        QVERIFY(!themeFromName("neon").has_value());
    }

    void everyIconIsDrawnInTheThemesColorAtEveryScale()
    {
        const QStringList names = QDir(":/icons").entryList({"*.svg"});
        QVERIFY(names.size() >= 20);
        for (const Theme theme : {Theme::Dark, Theme::Light}) {
            applyTheme(theme);
            const QColor text = qApp->palette().color(QPalette::ButtonText);
            for (const QString& file : names) {
                if (file == "trixel.svg") {
                    continue; // in its own colours
                }
                for (const int size : {16, 20, 40, 64}) {
                    const QImage image = icon(file.chopped(4)).pixmap(size, size).toImage();
                    QCOMPARE(image.width(), size);
                    QCOMPARE(strongest(image).rgb(), text.rgb());
                }
            }
        }
    }

    void panelsThatShareAPlaceKeepTheirWholeNames()
    {
        applyTheme(Theme::Dark);
        QMainWindow window;
        QDockWidget* first = nullptr;
        for (const char* name :
             {"Texel", "Layers", "History", "Seams", "Difference", "Footprint"}) {
            auto* dock = new QDockWidget(name);
            window.addDockWidget(Qt::RightDockWidgetArea, dock);
            if (first != nullptr) {
                window.tabifyDockWidget(first, dock);
            }
            first = dock;
        }
        window.resize(200, 200);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        const auto* tabs = window.findChild<QTabBar*>();
        QVERIFY(tabs != nullptr && tabs->count() == 6);
        for (int k = 0; k < tabs->count(); ++k) {
            QVERIFY(tabs->tabRect(k).width() >
                    tabs->fontMetrics().horizontalAdvance(tabs->tabText(k)));
        }
    }

private:
    /// Colour of the most opaque pixel.
    static QColor strongest(const QImage& image)
    {
        QColor best(0, 0, 0, 0);
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const QColor color = image.pixelColor(x, y);
                best = color.alpha() > best.alpha() ? color : best;
            }
        }
        return best;
    }
};

} // namespace trixel::ui

QTEST_MAIN(trixel::ui::ThemeTest)
#include "tst_theme.moc"
