// SPDX-License-Identifier: GPL-3.0-or-later
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QProgressBar>
#include <QScrollArea>
#include <QSignalSpy>
#include <QStatusBar>
#include <QThread>
#include <QToolButton>
#include <QUndoView>

#include "tests/ui/window/window_fixture.h"

namespace trixel::ui {

class MainWindowTest : public WindowTest
{
    Q_OBJECT

private slots:
    void init()
    {
        openWindow();
        openGrid();
    }
    void cleanup() { closeWindow(); }

    void theTexelUnderThePointerIsReadWithoutTurningToItsPanel()
    {
        auto* texel = m_window->findChild<QDockWidget*>("readoutPanel");
        QTRY_VERIFY(!texel->visibleRegion().isEmpty());
    }

    void aPanelThatAKeyShowsIsInFront()
    {
        for (const auto& [key, name] : {std::pair{Qt::Key_F5, "footprintPanel"},
                                        std::pair{Qt::Key_F3, "layoutPanel"},
                                        std::pair{Qt::Key_F4, "mipPanel"},
                                        std::pair{Qt::Key_F8, "facesPanel"}}) {
            auto* panel = m_window->findChild<QDockWidget*>(name);
            QVERIFY(panel->visibleRegion().isEmpty());
            press(key, Qt::ShiftModifier);
            QTRY_VERIFY2(!panel->visibleRegion().isEmpty(), name);
        }
    }

    void panelsBehindTabsRest()
    {
        auto* mesh = m_window->findChild<QDockWidget*>("reportPanel");
        auto* texel = m_window->findChild<QDockWidget*>("readoutPanel");
        QTRY_VERIFY(texel->widget()->isVisible() && !mesh->widget()->isVisible());
        mesh->raise();
        QTRY_VERIFY(!texel->widget()->isVisible() && mesh->widget()->isVisible());
    }

    void undoAndRedoKeys()
    {
        const std::vector<std::byte> before = allTexels(document().texels());
        fillFace(5);
        const std::vector<std::byte> after = allTexels(document().texels());
        press(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(allTexels(document().texels()) == before);
        press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(allTexels(document().texels()) == after);
        press(Qt::Key_Z, Qt::ControlModifier);
        press(Qt::Key_Y, Qt::ControlModifier);
        QVERIFY(allTexels(document().texels()) == after);
        QVERIFY(m_window->isWindowModified());
    }

    void toolKeys()
    {
        press(Qt::Key_E);
        QCOMPARE(m_window->settings().tool(), Tool::Eraser);
        QCOMPARE(m_window->settings().brush().blend, BlendMode::Erase);
        press(Qt::Key_G);
        QCOMPARE(m_window->settings().tool(), Tool::Fill);
        press(Qt::Key_B);
        QCOMPARE(m_window->settings().tool(), Tool::Brush);
        QCOMPARE(m_window->settings().brush().blend, BlendMode::Normal);
        QVERIFY(actionNamed(*m_window, "Brush")->isChecked());
    }

    void pickLastsWhileSIsHeld()
    {
        press(Qt::Key_G);
        QWidget* focus = QApplication::focusWidget();
        QTest::keyPress(focus, Qt::Key_S);
        QCOMPARE(m_window->settings().tool(), Tool::Pick);
        QTest::keyRelease(focus, Qt::Key_S);
        QCOMPARE(m_window->settings().tool(), Tool::Fill);
    }

    void lettersHeldInAFieldPickNothing()
    {
        auto* radius = widgetNamed<QDoubleSpinBox>(*m_window, "Radius");
        radius->setFocus();
        QTest::keyPress(radius, Qt::Key_S);
        QCOMPARE(m_window->settings().tool(), Tool::Brush);
        QTest::keyRelease(radius, Qt::Key_S);
        QCOMPARE(m_window->settings().tool(), Tool::Brush);
    }

    void longWorkShowsProgressAndCanBeCancelled()
    {
        QVERIFY(!widgetNamed<QToolButton>(*m_window, "Cancel the work under way"));
        std::optional<ErrorKind> outcome;
        m_window->jobs().run(
            "Counting…",
            [](Progress& progress) -> Result<int> {
                while (progress.report(0.5)) {
                    QThread::msleep(1);
                }
                return cancelled();
            },
            [&outcome](const Result<int>& result) { outcome = result.error().kind; });
        QTRY_VERIFY(widgetNamed<QToolButton>(*m_window, "Cancel the work under way"));
        auto* progress = widgetNamed<QProgressBar>(*m_window, "Progress");
        QTRY_COMPARE(progress->value(), progress->maximum() / 2);
        fillFace(4); // the window stays usable
        QVERIFY(document().isModified());
        QTest::mouseClick(widgetNamed<QToolButton>(*m_window, "Cancel the work under way"),
                          Qt::LeftButton);
        QTRY_COMPARE(outcome, ErrorKind::Cancelled);
        QVERIFY(!widgetNamed<QToolButton>(*m_window, "Cancel the work under way"));
    }

    void sizeKeysScaleTheBrushWithinBounds()
    {
        const float before = m_window->settings().brush().radius;
        press(Qt::Key_BracketRight);
        QVERIFY(m_window->settings().brush().radius > before);
        press(Qt::Key_BracketLeft);
        QVERIFY(qFuzzyCompare(m_window->settings().brush().radius, before));
        for (int k = 0; k < 200; ++k) {
            press(Qt::Key_BracketLeft);
        }
        QVERIFY(validate(m_window->settings().brush()).has_value());
        QVERIFY(m_window->settings().brush().radius > 0);
    }

    void hardnessKeysStayWithinBounds()
    {
        for (int k = 0; k < 20; ++k) {
            press(Qt::Key_BraceRight, Qt::ShiftModifier);
        }
        QCOMPARE(m_window->settings().brush().hardness, 1.0F);
        for (int k = 0; k < 20; ++k) {
            press(Qt::Key_BraceLeft, Qt::ShiftModifier);
        }
        QCOMPARE(m_window->settings().brush().hardness, 0.0F);
    }

    void digitsSetTheOpacity()
    {
        press(Qt::Key_3);
        QVERIFY(qFuzzyCompare(m_window->settings().brush().opacity, 0.3F));
        press(Qt::Key_0);
        QCOMPARE(m_window->settings().brush().opacity, 1.0F);
    }

    void colorKeysSwapAndReset()
    {
        const std::array<float, 4> white{1, 1, 1, 1};
        press(Qt::Key_X);
        QVERIFY(m_window->settings().brush().color == white);
        press(Qt::Key_D);
        QVERIFY((m_window->settings().brush().color == std::array<float, 4>{0, 0, 0, 1}));
    }

    void keysTypedIntoAFieldAreNotCommands()
    {
        auto* opacity = widgetNamed<QDoubleSpinBox>(*m_window, "Opacity");
        opacity->setFocus();
        opacity->selectAll();
        QTest::keyClicks(opacity, "7");
        QTest::keyClicks(opacity, "5");
        QTest::keyClick(opacity, Qt::Key_Return);
        QVERIFY(qFuzzyCompare(m_window->settings().brush().opacity, 0.75F));
        // Enter has given the keyboard back: now digits are commands again.
        QCOMPARE(QApplication::focusWidget(), static_cast<QWidget*>(&m_window->viewport()));
        press(Qt::Key_2);
        QVERIFY(qFuzzyCompare(m_window->settings().brush().opacity, 0.2F));
    }

    void tabInTheViewHidesPanelsAndBringsThemBack()
    {
        const auto shown = [this] {
            int count = 0;
            for (QDockWidget* dock : m_window->findChildren<QDockWidget*>()) {
                count += dock->isHidden() ? 0 : 1;
            }
            return count;
        };
        const int before = shown();
        QVERIFY(before >= 4);
        press(Qt::Key_Tab);
        QCOMPARE(shown(), 0);
        press(Qt::Key_Tab);
        QCOMPARE(shown(), before);
    }

    void nextPanelKeyWalksThroughThePanelsAndBack()
    {
        QSet<QWidget*> visited;
        do {
            visited += QApplication::focusWidget();
            press(Qt::Key_F6);
        } while (!visited.contains(QApplication::focusWidget()));
        QVERIFY(visited.size() >= 6);
        QCOMPARE(QApplication::focusWidget(), static_cast<QWidget*>(&m_window->viewport()));
    }

    void mipChoiceOffersTheLevelsThereAre()
    {
        auto* mips = widgetNamed<QComboBox>(*m_window, "Mip level");
        QCOMPARE(mips->count(), 4); // level 3 and below
        press(Qt::Key_PageDown);
        QCOMPARE(m_window->settings().view().mipDrop, 1);
        QCOMPARE(mips->currentIndex(), 1);
        for (int k = 0; k < 10; ++k) {
            press(Qt::Key_PageDown);
        }
        QCOMPARE(m_window->settings().view().mipDrop, 3);
        press(Qt::Key_PageUp);
        QCOMPARE(m_window->settings().view().mipDrop, 2);
        document().open(gridProject(2, 1), {}, "small");
        QCOMPARE(m_window->settings().view().mipDrop, 0);
        QCOMPARE(mips->count(), 2);
    }

    void viewKeysToggleTheOverlays()
    {
        const ViewOptions before = m_window->settings().view();
        press(Qt::Key_W);
        press(Qt::Key_T);
        press(Qt::Key_U);
        press(Qt::Key_O);
        const ViewOptions after = m_window->settings().view();
        QCOMPARE(after.wireframe, !before.wireframe);
        QCOMPARE(after.texelGrid, !before.texelGrid);
        QCOMPARE(after.lit, !before.lit);
        QCOMPARE(after.footprint, !before.footprint);
    }

    void fillAllIsOneUndoStep()
    {
        press(Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(document().undoStack().count(), 1);
        QCOMPARE(int(document().texels().face(FaceId{77}).texel(0)[0]), 0);
    }

    void statusBarTellsSizeAndType()
    {
        auto* size = widgetNamed<QWidget>(*m_window->statusBar(), "Size of the texture");
        QTRY_COMPARE(size->property("text").toString(),
                     QString("128 faces · 8,192 texels · 3 bytes · 3 × uint8"));
        fillFace(5);
        QTRY_VERIFY(!size->property("text").toString().contains(" 3 bytes"));
    }

    void clickedHistoryStepGoesBackToIt()
    {
        fillFace(1);
        fillFace(2);
        fillFace(3);
        auto* history = m_window->findChild<QUndoView*>();
        history->setCurrentIndex(history->model()->index(1, 0));
        QCOMPARE(document().undoStack().index(), 1);
        QVERIFY(m_window->isWindowModified());
    }

    void colorPaintedWithIsRecent()
    {
        QVERIFY(!widgetNamed<QWidget>(*m_window, "Recent colour #ff0000"));
        Brush brush = m_window->settings().brush();
        brush.color = {1, 0, 0, 1};
        m_window->settings().setBrush(brush);
        fillFace(1);
        QVERIFY(widgetNamed<QWidget>(*m_window, "Recent colour #ff0000"));
    }

    void onlyColorsPaintedWithAreRecent()
    {
        const auto choose = [&](std::array<float, 4> color) {
            Brush brush = m_window->settings().brush();
            brush.color = color;
            m_window->settings().setBrush(brush);
        };
        choose({1, 0, 0, 1});
        fillFace(1);
        choose({0, 1, 0, 1});
        document().undoStack().undo();
        document().undoStack().redo();
        TexelPatch patch; // as an import leaves it
        patch.addFace(FaceId{2}, document().texels().face(FaceId{1}));
        QVERIFY(document().applyPatch(patch, document().state(), "Import"));
        LayerStack layers(document().texels());
        layers.insert(0, {});
        QVERIFY(document().editLayers(layers, kBaseLayer, "Add layer"));
        QVERIFY(widgetNamed<QWidget>(*m_window, "Recent colour #ff0000"));
        QVERIFY(!widgetNamed<QWidget>(*m_window, "Recent colour #00ff00"));
    }

    void goToFaceLooksAtItFromItsFront()
    {
        Viewport& view = m_window->viewport();
        view.lookFrom(150, -20); // from behind
        press(Qt::Key_G, Qt::ControlModifier);
        auto* address = widgetNamed<QLineEdit>(view, "Texel to go to");
        QVERIFY(address);
        QTest::keyClicks(address, "0"); // at a corner of the square
        QTest::keyClick(address, Qt::Key_Return);
        QVERIFY(!address->isVisible());
        QVERIFY(view.camera().forward().z < -0.99);
        const auto corners = document().surface()->mesh().corners(FaceId{0});
        const float third = 1 / 3.0F;
        const auto position =
            view.widgetPosition({FaceId{0}, {third, third}, pointAt(corners, third, third)});
        QVERIFY(position.has_value());
        const double away = QLineF(*position, QRectF(view.rect()).center()).length();
        QVERIFY2(away < 0.25 * view.height(), qPrintable(QString::number(away)));
    }

    void openedMeshSetsABrushThatFitsIt()
    {
        const float size = document().surface()->size();
        const float radius = m_window->settings().brush().radius;
        QVERIFY(radius > 0.001F * size && radius < 0.2F * size);
    }

    void contentsFitAtCommonWindowSizes_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::newRow("1280x800") << QSize(1280, 800);
        QTest::newRow("1600x1000") << QSize(1600, 1000);
    }
    void contentsFitAtCommonWindowSizes()
    {
        QFETCH(QSize, size);
        m_window->resize(size);
        QCoreApplication::processEvents();
        QCOMPARE(m_window->size(), size); // nothing forces the window wider
        for (QDockWidget* dock : m_window->findChildren<QDockWidget*>()) {
            dock->show();
            dock->raise();
            QCoreApplication::processEvents();
            const QSize needed = dock->widget()->minimumSizeHint();
            const QSize given = dock->widget()->size();
            QVERIFY2(needed.width() <= given.width() && needed.height() <= given.height(),
                     qPrintable(dock->windowTitle()));
        }
        QVERIFY(m_window->viewport().width() > size.width() / 2);
    }

    void layoutAndColorsAreRememberedFromOneRunToTheNext()
    {
        m_window->resize(1111, 777);
        m_window->findChild<QDockWidget*>("historyPanel")->hide();
        press(Qt::Key_X);
        m_window->close();
        QTRY_VERIFY(!m_window->isVisible());
        MainWindow again;
        again.show();
        QCOMPARE(again.size(), QSize(1111, 777));
        QVERIFY(again.findChild<QDockWidget*>("historyPanel")->isHidden());
        QVERIFY(!again.findChild<QDockWidget*>("brushPanel")->isHidden());
    }
};

} // namespace trixel::ui

TRIXEL_WINDOW_TEST_MAIN(trixel::ui::MainWindowTest)
#include "tst_main_window.moc"
