// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bookmarking views, going back to them and managing them, as the user does it.
#include <QAbstractItemModelTester>
#include <QDockWidget>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QTreeView>

#include "core/study/views/view_camera.h"
#include "render/camera_view.h"
#include "tests/ui/sample_views.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/docks/camera_files.h"
#include "ui/docks/value_row.h"
#include "ui/docks/views_model.h"
#include "ui/docks/views_panel.h"
#include "ui/document/view_bookmarks.h"

#include <glm/geometric.hpp>

namespace trixel::ui {

class ViewsTest : public WindowTest
{
    Q_OBJECT

private slots:
    void init()
    {
        openWindow();
        openGrid();
    }
    void cleanup() { closeWindow(); }

    void aViewBookmarkedAndGoneBackToGivesTheSamePicture()
    {
        Viewport& view = m_window->viewport();
        view.lookFrom(30, 20, 1.4);
        view.settle();
        const QImage before = view.grabFramebuffer();
        const ViewCamera there = view.view();
        press(Qt::Key_B, Qt::ControlModifier);
        QCOMPARE(bookmarks().count(), 1);
        QCOMPARE(bookmarks().name(0), QString("View 1"));
        const ViewCamera& kept = bookmarks().views().cameras[0];
        QCOMPARE(kept.width, view.camera().viewport().x);
        QCOMPARE(kept.height, view.camera().viewport().y);

        view.lookFrom(-80, -40, 0.5);
        view.settle();
        QVERIFY(view.grabFramebuffer() != before);
        press(Qt::Key_1, Qt::AltModifier);
        view.settle();
        QCOMPARE(view.grabFramebuffer(), before);
        // Orbiting goes on about the same point.
        QVERIFY(glm::length(view.camera().pose().target - there.target) < 1e-9);
        const QPoint middle = view.rect().center();
        QTest::mousePress(&view, Qt::LeftButton, Qt::AltModifier, middle);
        QTest::mouseMove(&view, middle + QPoint(60, 10));
        QTest::mouseRelease(&view, Qt::LeftButton, Qt::AltModifier, middle + QPoint(60, 10));
        QVERIFY(glm::length(view.camera().pose().target - there.target) < 1e-9);
        QVERIFY(glm::length(view.view().position - there.position) > 0.01);
    }

    void bookmarkingIsUndoneAndDoneAgain()
    {
        press(Qt::Key_B, Qt::ControlModifier);
        press(Qt::Key_B, Qt::ControlModifier);
        QCOMPARE(bookmarks().name(1), QString("View 2"));
        QVERIFY(m_window->isWindowModified());
        press(Qt::Key_Z, Qt::ControlModifier);
        press(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(bookmarks().isEmpty());
        QVERIFY(!m_window->isWindowModified());
        press(Qt::Key_Y, Qt::ControlModifier);
        QCOMPARE(bookmarks().count(), 1);
    }

    void theMenuListsTheViews()
    {
        fill();
        QAction* first = actionNamed(*m_window, "1  front & centre");
        QVERIFY(first == nullptr); // an ampersand is written twice
        first = actionNamed(*m_window, "1  front  centre");
        QVERIFY(first && first->isVisible() && first->isEnabled());
        QVERIFY(actionNamed(*m_window, "2  side")->isVisible());
        actionNamed(*m_window, "2  side")->trigger();
        QVERIFY(sees("side"));
        bookmarks().replaceAll({});
        QVERIFY(!first->isVisible() && !first->isEnabled());
    }

    void theMenuListsMoreThanHaveShortcuts()
    {
        SceneViews many;
        for (int k = 0; k < 40; ++k) {
            many.cameras.push_back(camera("shot " + std::to_string(k + 1), k));
        }
        bookmarks().replaceAll(many);
        QMenu* menu = submenu();
        QVERIFY(menu != nullptr);
        emit menu->aboutToShow();
        emit menu->aboutToShow(); // again: nothing is listed twice
        QList<QAction*> found;
        for (QAction* action : menu->actions()) {
            if (action->text() == "shot 12") {
                found += action;
            }
        }
        QCOMPARE(found.size(), 1);
        found.first()->trigger();
        QVERIFY(sees("shot 12"));
    }

    void withoutViewsThePanelSaysWhatToDo()
    {
        showPanel();
        QVERIFY(list() == nullptr);
        bool told = false;
        for (const QLabel* label : panel().findChildren<QLabel*>()) {
            told = told || (label->isVisible() && label->text().contains("Ctrl+B"));
        }
        QVERIFY(told);
    }

    void enterAndDoubleClickGoToAView()
    {
        fill();
        showPanel();
        QTest::keyClick(list(), Qt::Key_Home);
        QTest::keyClick(list(), Qt::Key_Down);
        QTest::keyClick(list(), Qt::Key_Return);
        QVERIFY(sees("side"));
        const QPoint first = list()->visualRect(model().index(0, 0)).center();
        QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, first);
        QTest::mouseDClick(list()->viewport(), Qt::LeftButton, {}, first);
        QVERIFY(sees("front & centre"));
    }

    void f2RenamesInPlaceAndLeavesTheBrushPanelAlone()
    {
        fill();
        showPanel();
        const bool brushShown = m_window->findChild<QDockWidget*>("brushPanel")->isVisible();
        list()->setFocus();
        QTest::keyClick(list(), Qt::Key_Home);
        QTest::keyClick(list(), Qt::Key_F2);
        auto* editor = list()->findChild<QLineEdit*>();
        QVERIFY(editor != nullptr);
        QTest::keyClick(editor, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(editor, "hero");
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE(bookmarks().name(0), QString("hero"));
        QCOMPARE(document().undoStack().undoText(), QString("Rename to hero"));
        QCOMPARE(m_window->findChild<QDockWidget*>("brushPanel")->isVisible(), brushShown);
    }

    void deleteRemovesTheChosenView()
    {
        fill();
        showPanel();
        list()->setFocus();
        QTest::keyClick(list(), Qt::Key_Home);
        QTest::keyClick(list(), Qt::Key_Delete);
        QCOMPARE(bookmarks().count(), 2);
        QCOMPARE(bookmarks().name(0), QString("side"));
        press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(bookmarks().count(), 3);
        QCOMPARE(bookmarks().name(0), QString("front & centre"));
    }

    void updateGivesAViewThePresentCameraAndKeepsItsName()
    {
        fill();
        showPanel();
        m_window->viewport().lookFrom(70, 10);
        QTest::keyClick(list(), Qt::Key_Home);
        click("Update the chosen view");
        ViewCamera expected = m_window->viewport().view();
        expected.name = "front & centre";
        QVERIFY(bookmarks().views().cameras[0] == expected);
    }

    void anyViewBeyondIsAsFarAsThePresentViewAndCanBeChanged()
    {
        showPanel();
        m_window->viewport().setCamera({{0.5, 0.5, 0}, 3, 0, 0}); // before the middle of the grid
        click("Add any view beyond a distance");
        QCOMPARE(bookmarks().count(), 1);
        QVERIFY(bookmarks().isDistant(0));
        QVERIFY(std::abs(bookmarks().views().distant[0].distance - 3) < 1e-6);
        QCOMPARE(text(0, ViewsModel::Picture), QString("any beyond 3"));
        QVERIFY(
            model().index(0, 0).data(Qt::ToolTipRole).toString().contains("3 (2.12 diagonals)"));
        auto* distance = widgetNamed<ScaledSpinBox>(panel(), "Least distance from the surface");
        QVERIFY(distance != nullptr);
        distance->setFocus();
        distance->selectAll();
        QTest::keyClicks(distance, "5");
        const int steps = document().undoStack().count();
        QTest::keyClick(distance, Qt::Key_Return);
        QCOMPARE(bookmarks().views().distant[0].distance, 5.0);
        QCOMPARE(document().undoStack().count(), steps + 1);
        press(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(std::abs(distance->value() - 3) < 1e-6);
    }

    void goingToDistantViewsGoesToTheirDistance()
    {
        bookmarks().addDistant(distant("far", 1.0 / 3));
        showPanel();
        const int steps = document().undoStack().count();
        list()->setFocus();
        QTest::keyClick(list(), Qt::Key_Home);
        QTest::keyClick(list(), Qt::Key_Return);
        auto* distance = widgetNamed<ScaledSpinBox>(panel(), "Least distance from the surface");
        QVERIFY(distance != nullptr && distance->hasFocus());
        // Passing through a rounded number changes nothing.
        QTest::keyClick(distance, Qt::Key_Return);
        QCOMPARE(bookmarks().views().distant[0].distance, 1.0 / 3);
        QCOMPARE(document().undoStack().count(), steps);
    }

    void theListFollowsEveryChangeAndKeepsTheChosenView()
    {
        const QAbstractItemModelTester tester(
            &model(), QAbstractItemModelTester::FailureReportingMode::QtTest);
        fill();
        showPanel();
        list()->setCurrentIndex(model().index(1, 0));
        bookmarks().remove(0);
        QCOMPARE(list()->currentIndex().row(), 0);
        bookmarks().add(camera("another", 8));
        bookmarks().update(1, camera("", 9));
        bookmarks().replaceAll({{camera("x", 1), camera("y", 2)}, {}});
        QCOMPARE(model().rowCount(), 2);
        while (document().undoStack().canUndo()) {
            document().undoStack().undo();
        }
        QCOMPARE(model().rowCount(), 0);
        while (document().undoStack().canRedo()) {
            document().undoStack().redo();
        }
        QCOMPARE(text(0, ViewsModel::Name), QString("x"));
        openGrid();
        QCOMPARE(model().rowCount(), 0);
    }

    void savedCamerasAreLoadedAgain()
    {
        fill();
        const SceneViews before = bookmarks().views();
        showPanel();
        click("Save cameras");
        auto* dialog = openDialog<QFileDialog>();
        QVERIFY(dialog != nullptr);
        dialog->selectFile(path("shots.json"));
        QMetaObject::invokeMethod(dialog, "accept");
        QTRY_VERIFY(m_window->messages().sentence().contains("shots.json"));
        openGrid();
        QVERIFY(bookmarks().isEmpty());
        click("Load cameras");
        dialog = openDialog<QFileDialog>();
        QVERIFY(dialog != nullptr);
        dialog->selectFile(path("shots.json"));
        QMetaObject::invokeMethod(dialog, "accept");
        QTRY_VERIFY(bookmarks().views() == before);
        QCOMPARE(m_window->messages().sentence(), QString("3 views added from shots.json."));
        // Loading them once more adds none.
        panel().files().load(path("shots.json"));
        QTRY_VERIFY(m_window->messages().sentence().contains("already"));
        QCOMPARE(bookmarks().count(), 3);
    }

    void unusableCamerasFilesAreToldInTheMessageBar_data()
    {
        QTest::addColumn<QByteArray>("contents");
        QTest::addColumn<QString>("cause");
        QTest::newRow("not JSON") << QByteArray("{") << "not JSON";
        QTest::newRow("no camera") << QByteArray(R"({"version":1,"cameras":[]})") << "one camera";
        QTest::newRow("nowhere")
            << QByteArray(R"({"version":1,"cameras":[{"position":[0,0,0],"target":[0,0,0]}]})")
            << "another place";
    }
    void unusableCamerasFilesAreToldInTheMessageBar()
    {
        QFETCH(QByteArray, contents);
        QFETCH(QString, cause);
        fill();
        const SceneViews before = bookmarks().views();
        writeFile(path("bad.json"), contents);
        panel().files().load(path("bad.json"));
        QTRY_VERIFY(m_window->messages().sentence().contains(cause));
        QVERIFY(m_window->messages().sentence().startsWith("bad.json: "));
        QVERIFY(m_window->messages().kind() == MessageBar::Kind::Error);
        QVERIFY(bookmarks().views() == before);
        panel().files().load(path("missing.json"));
        QTRY_VERIFY(m_window->messages().sentence().contains("missing.json"));
    }

    void aProjectBringsItsViewsBack()
    {
        fill();
        const SceneViews before = bookmarks().views();
        const QString file = path("grid.trixel");
        document().markSaved(file, {}); // now Ctrl+S knows where
        press(Qt::Key_S, Qt::ControlModifier);
        QTRY_VERIFY(!document().isModified());
        openGrid();
        m_window->open(file);
        QTRY_VERIFY(bookmarks().views() == before);
        QVERIFY(!document().isModified());
    }

    void manageShowsThePanelWithTheKeyboardInTheList()
    {
        fill();
        dock().hide();
        actionNamed(*m_window, "Manage…")->trigger();
        QVERIFY(dock().isVisible());
        QTRY_VERIFY(list() != nullptr && list()->hasFocus());
    }

private:
    ViewBookmarks& bookmarks() { return document().bookmarks(); }
    QDockWidget& dock() { return *m_window->findChild<QDockWidget*>("viewsPanel"); }
    ViewsPanel& panel() { return *m_window->findChild<ViewsPanel*>(); }
    ViewsModel& model() { return *panel().findChild<ViewsModel*>(); }
    QTreeView* list() { return widgetNamed<QTreeView>(panel(), "Bookmarked views"); }
    QString text(int row, int column)
    {
        return model().index(row, column).data(Qt::DisplayRole).toString();
    }
    QMenu* submenu()
    {
        for (QMenu* menu : m_window->findChildren<QMenu*>()) {
            if (menu->title().remove('&') == "Bookmarked Views") {
                return menu;
            }
        }
        return nullptr;
    }

    void fill()
    {
        QVERIFY(bookmarks().replaceAll(
            {{camera("front & centre", 1), camera("side", 5)}, {distant("far", 5)}}));
    }
    void showPanel()
    {
        dock().show();
        dock().raise();
        QTRY_VERIFY(panel().isVisible());
    }
    void click(const QString& name)
    {
        auto* button = widgetNamed<QPushButton>(panel(), name);
        QVERIFY(button != nullptr && button->isEnabled());
        QTest::mouseClick(button, Qt::LeftButton);
    }
    /// Whether the view looks from where the camera of that name stands.
    bool sees(const std::string& name)
    {
        const ViewCamera now = m_window->viewport().view();
        for (const ViewCamera& one : bookmarks().views().cameras) {
            if (one.name == name) {
                return glm::length(now.position - one.position) < 1e-9 &&
                       glm::length(now.target - one.target) < 1e-9;
            }
        }
        return false;
    }
};

} // namespace trixel::ui

TRIXEL_WINDOW_TEST_MAIN(trixel::ui::ViewsTest)
#include "tst_views.moc"
