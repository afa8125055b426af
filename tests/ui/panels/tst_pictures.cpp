// SPDX-License-Identifier: GPL-3.0-or-later
#include <QClipboard>
#include <QContextMenuEvent>
#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <QSvgRenderer>
#include <QXmlStreamReader>

#include "core/base/read_file.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/document/inspection.h"
#include "ui/inspector/picture_file.h"
#include "ui/inspector/picture_source.h"
#include "ui/inspector/widget_picture.h"

#include <set>

namespace trixel::ui {

namespace {

/// A panel that draws itself: a red disc on blue.
class Disc : public QWidget, public PictureSource
{
public:
    QString pictureName() const override { return "disc"; }
    QSize pictureSize() const override { return m_size; }
    bool isVectorPicture() const override { return true; }
    void paintPicture(QPainter& painter, QSize size) override
    {
        painter.fillRect(QRect(QPoint(), size), Qt::blue);
        painter.setPen(Qt::NoPen);
        painter.setBrush(Qt::red);
        painter.drawEllipse(QRect(QPoint(), size).marginsRemoved({20, 20, 20, 20}));
    }

    QSize m_size{200, 100};
};

int colorsIn(const QImage& image)
{
    std::set<QRgb> colors;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            colors.insert(image.pixel(x, y));
        }
    }
    return static_cast<int>(colors.size());
}

} // namespace

class PicturesTest : public WindowTest
{
    Q_OBJECT

private slots:
    void cleanup() { closeWindow(); }

    void aPictureIsAsLargeAsAskedWithItsCaptionBelow()
    {
        Disc disc;
        const QImage bare = imageOf(disc, {}, 2).value();
        QCOMPARE(bare.size(), QSize(400, 200));
        QCOMPARE(bare.pixelColor(200, 100), QColor(Qt::red));
        QCOMPARE(bare.pixelColor(5, 5), QColor(Qt::blue));
        const QImage told = imageOf(disc, "what it is of", 1).value();
        QCOMPARE(told.width(), 200);
        QVERIFY(told.height() > 110);
        QVERIFY(colorsIn(told.copy(0, 100, 200, told.height() - 100)) > 1);
        // A long caption takes more lines rather than being cut off.
        QVERIFY(imageOf(disc, QString("word ").repeated(40), 1)->height() > told.height() + 20);
    }

    void aDrawingIsMadeOfShapes()
    {
        Disc disc;
        const QByteArray svg = svgOf(disc, "what it is of").value();
        int ellipses = 0;
        int images = 0;
        QXmlStreamReader xml(svg);
        while (!xml.atEnd()) {
            if (xml.readNext() == QXmlStreamReader::StartElement) {
                ellipses += xml.name() == u"ellipse" || xml.name() == u"circle" ? 1 : 0;
                images += xml.name() == u"image" ? 1 : 0;
            }
        }
        QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
        QCOMPARE(ellipses, 1);
        QCOMPARE(images, 0);
        QVERIFY(svg.contains("what it is of"));
        QSvgRenderer renderer(svg);
        QVERIFY(renderer.isValid());
        QCOMPARE(renderer.viewBox().width(), 200);
    }

    void whatCannotBeDrawnIsRefusedWithASentence()
    {
        Disc disc;
        disc.m_size = {};
        QVERIFY(!imageOf(disc, {}, 1));
        QVERIFY(!svgOf(disc, {}));
        disc.m_size = {9000, 10};
        const auto large = imageOf(disc, {}, 2);
        QVERIFY(!large);
        QVERIFY(large.error().message.find("18000") != std::string::npos);
    }

    void theWidgetThatDrawsItselfIsThePanelsPicture()
    {
        QWidget panel;
        panel.resize(300, 200);
        QCOMPARE(pictureOf(panel, "Panel")->pictureSize(), QSize(300, 200));
        QVERIFY(!pictureOf(panel, "Panel")->isVectorPicture());
        auto* disc = new Disc;
        disc->setParent(&panel);
        QVERIFY(pictureOf(panel, "Panel")->isVectorPicture());
        QCOMPARE(pictureOf(panel, "Panel")->pictureName(), QString("disc"));
        disc->hide();
        QVERIFY(!pictureOf(panel, "Panel")->isVectorPicture());
    }

    void theViewIsSavedWithItsLegendsAndACaption()
    {
        open();
        m_window->inspection().hold(FaceId{60}, {0.3F, 0.3F});
        // As it is before a message takes its room.
        const QSize view = m_window->viewport().size();
        const QImage shown = m_window->viewport().grabFramebuffer();
        QRect legend;
        for (const QLabel* label : m_window->viewport().findChildren<QLabel*>()) {
            legend = label->isVisible() ? label->geometry() : legend;
        }
        QVERIFY(legend.isValid());
        press(Qt::Key_S, Qt::ControlModifier | Qt::AltModifier);
        QVERIFY(save(path("view.png")));
        QTRY_VERIFY(m_window->messages().sentence().contains("view.png"));
        const QImage saved(path("view.png"));
        QCOMPARE(saved.width(), view.width());
        QVERIFY(saved.height() > view.height() + 10);
        QVERIFY(saved.text("Description").contains("grid"));
        QVERIFY(saved.text("Description").contains("face 60"));
        QVERIFY(saved.text("Description").contains("filter "));
        const QPoint middle(view.width() / 2, view.height() / 2);
        QCOMPARE(saved.pixelColor(middle), shown.pixelColor(middle));
        QVERIFY(colorsIn(saved.copy(legend)) > colorsIn(shown.copy(legend)) + 10);
    }

    void theViewIsDrawnAnewForSharperPictures()
    {
        open();
        actionNamed(*m_window, "Captions")->setChecked(false);
        ViewOptions options = m_window->settings().view();
        options.wireframe = true;
        m_window->settings().setView(options);
        press(Qt::Key_S, Qt::ControlModifier | Qt::AltModifier);
        const QSize view = m_window->viewport().size(); // before a message takes its room
        const QImage shown = m_window->viewport().grabFramebuffer();
        QVERIFY(save(path("sharp.png"), "twice"));
        QTRY_VERIFY(QFile::exists(path("sharp.png")));
        const QImage saved(path("sharp.png"));
        QCOMPARE(saved.size(), view * 2);
        // Not the same pixels made larger.
        const QImage larger =
            shown.scaled(saved.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        int sharper = 0;
        for (int x = 0; x < saved.width(); ++x) {
            for (int y = 0; y < saved.height() - 100; y += 3) {
                sharper += std::abs(qGray(saved.pixel(x, y)) - qGray(larger.pixel(x, y))) > 25;
            }
        }
        QVERIFY2(sharper > 1000, qPrintable(QString::number(sharper)));
    }

    void aPanelIsSavedByARightClickOnItsTitle()
    {
        open();
        auto* dock = m_window->findChild<QDockWidget*>("reportPanel");
        dock->raise();
        QCoreApplication::processEvents();
        QVERIFY(QMetaObject::invokeMethod(
            this, [this] { chooseInMenu("Save Picture…"); }, Qt::QueuedConnection));
        const QPoint title(60, 10);
        QContextMenuEvent click(QContextMenuEvent::Mouse, title, dock->mapToGlobal(title));
        QApplication::sendEvent(dock, &click);
        QTRY_VERIFY(openDialog<QFileDialog>());
        QVERIFY(save(path("mesh.png")));
        QTRY_VERIFY(QFile::exists(path("mesh.png")));
        const QImage saved(path("mesh.png"));
        QCOMPARE(saved.width(), dock->widget()->width());
        QVERIFY(saved.height() > dock->widget()->height());
        QVERIFY(colorsIn(saved) > 10);
    }

    void everyPanelIsOfferedWhileItIsShown()
    {
        open();
        for (QDockWidget* dock : m_window->findChildren<QDockWidget*>()) {
            QAction* action =
                actionNamed(*m_window, QString("Save Picture of %1…").arg(dock->windowTitle()));
            QVERIFY2(action, qPrintable(dock->windowTitle()));
            QCOMPARE(action->isEnabled(), dock->isVisible() && !dock->visibleRegion().isEmpty());
        }
    }

    void aChartIsSavedAsADrawing()
    {
        open();
        Disc* disc = new Disc;
        auto* dock = m_window->findChild<QDockWidget*>("reportPanel");
        dock->raise();
        disc->setParent(dock->widget());
        disc->show();
        QCoreApplication::processEvents();
        actionNamed(*m_window, "Save Picture of Mesh…")->trigger();
        QVERIFY(save(path("disc.svg"), "Drawing"));
        QTRY_VERIFY(QFile::exists(path("disc.svg")));
        const std::string svg = readFile(path("disc.svg").toStdString()).value();
        QVERIFY(svg.find("<ellipse") != std::string::npos ||
                svg.find("<circle") != std::string::npos);
    }

    void theEndingTypedDecides()
    {
        open();
        Disc* disc = new Disc;
        auto* dock = m_window->findChild<QDockWidget*>("reportPanel");
        dock->raise();
        disc->setParent(dock->widget());
        disc->show();
        QCoreApplication::processEvents();
        actionNamed(*m_window, "Save Picture of Mesh…")->trigger();
        QVERIFY(save(path("typed.svg"))); // with a filter of PNG chosen
        QTRY_VERIFY(QFile::exists(path("typed.svg")));
        const std::string svg = readFile(path("typed.svg").toStdString()).value();
        QVERIFY(svg.starts_with("<?xml"));
    }

    void whatCannotBeWrittenIsToldInASentenceAndLeavesNothing()
    {
        open();
        const QString closed = path("closed");
        QVERIFY(QDir().mkdir(closed));
        press(Qt::Key_S, Qt::ControlModifier | Qt::AltModifier);
        auto* dialog = openDialog<QFileDialog>();
        QVERIFY(dialog);
        // Between being chosen and being written to the folder goes away.
        QVERIFY(QDir(closed).removeRecursively());
        emit dialog->fileSelected(closed + "/view.png");
        dialog->reject();
        QTRY_VERIFY(!m_window->messages().sentence().isEmpty());
        QCOMPARE(m_window->messages().kind(), MessageBar::Kind::Error);
        QVERIFY(m_window->messages().sentence().contains("view.png"));
        QVERIFY(!QFile::exists(closed));
    }

    void aCopiedPictureIsOnTheClipboard()
    {
        open();
        QGuiApplication::clipboard()->clear();
        press(Qt::Key_C, Qt::ControlModifier | Qt::AltModifier);
        QTRY_VERIFY(!QGuiApplication::clipboard()->image().isNull());
        QCOMPARE(QGuiApplication::clipboard()->image().width(), m_window->viewport().width());
    }

private:
    void open()
    {
        openWindow();
        openGrid();
        m_window->viewport().settle();
        QCoreApplication::processEvents();
    }
    /// Ends the dialog as Enter would.
    static bool save(const QString& file, const QString& filter = {})
    {
        auto* dialog = openDialog<QFileDialog>();
        if (dialog == nullptr) {
            return false;
        }
        for (const QString& offered : dialog->nameFilters()) {
            if (!filter.isEmpty() && offered.contains(filter)) {
                dialog->selectNameFilter(offered);
                emit dialog->filterSelected(offered);
            }
        }
        dialog->findChild<QLineEdit*>("fileNameEdit")->setText(file);
        QMetaObject::invokeMethod(dialog, "accept");
        return true;
    }
    static void chooseInMenu(const QString& name)
    {
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        QVERIFY(menu);
        for (QAction* action : menu->actions()) {
            if (QString(action->text()).remove('&') == name) {
                QTest::mouseClick(
                    menu, Qt::LeftButton, Qt::NoModifier, menu->actionGeometry(action).center());
                return;
            }
        }
        menu->close();
        QFAIL("no such command");
    }
};

} // namespace trixel::ui

TRIXEL_WINDOW_TEST_MAIN(trixel::ui::PicturesTest)
#include "tst_pictures.moc"
