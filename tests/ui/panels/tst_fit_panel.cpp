// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fitting levels to views, as the user does it.
#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalSpy>
#include <QThread>
#include <QTreeWidget>

#include "tests/ui/document/layered_fixture.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/docks/fit_panel.h"
#include "ui/docks/fit_result.h"
#include "ui/docks/value_row.h"
#include "ui/document/view_bookmarks.h"
#include "ui/viewport/map_legend.h"
#include "ui/viewport/view_map.h"

#include <atomic>
#include <memory>

namespace trixel::ui {

namespace {

/// The real work, which waits until it may begin.
struct HeldWork
{
    std::atomic<bool> mayEnd = true;
    std::atomic<int> runs = 0;
    std::atomic<bool> isMadeUp = false; ///< face 24 becomes one black texel, whatever the views

    Result<SceneFit> run(const FitInput& input, Progress& progress)
    {
        ++runs;
        while (!mayEnd) {
            if (!progress.report(0.5)) {
                return cancelled();
            }
            QThread::msleep(1);
        }
        return isMadeUp ? madeUp(input) : fitWork()(input, progress);
    }

    static SceneFit madeUp(const FitInput& input)
    {
        SceneFit fit;
        fit.fitted = input.project.texels;
        const std::vector<std::byte> black(fit.fitted.format().texelBytes());
        FaceTexels one = FaceTexels::constant(Level(0), black);
        fit.plan.fitted.addFace(FaceId{24}, one);
        fit.fitted.exchange(FaceId{24}, std::move(one));
        fit.plan.levels = levelsOf(fit.fitted);
        fit.plan.errors = FaceMap<float>(fit.fitted.faceCount(), 0.001F);
        fit.plan.errors[FaceId{9}] = 0.004F;
        fit.plan.cost = levelCost(input.project.texels, fit.plan.levels);
        return fit;
    }
};

} // namespace

class FitPanelTest : public WindowTest
{
    Q_OBJECT

private slots:
    void init()
    {
        openWindow();
        document().open(gridProject(4, 4), {}, "grid"); // 32 faces
        for (const std::uint32_t face : {9U, 10U, 11U}) {
            fillFace(face);
        }
        paintNoise(9);
        m_window->viewport().lookFrom(0, 0, 0.3);
        m_work = std::make_shared<HeldWork>();
        m_panel =
            std::make_unique<FitPanel>(document(),
                                       m_window->settings(),
                                       m_window->jobs(),
                                       m_window->viewport(),
                                       m_window->viewMap(),
                                       [work = m_work](const FitInput& input, Progress& progress) {
                                           return work->run(input, progress);
                                       });
        m_panel->resize(320, 700);
        m_panel->show();
        m_panel->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_panel.get()));
    }
    void cleanup()
    {
        m_panel.reset();
        closeWindow();
    }

    void planIsShownBeforeItIsAppliedAsOneStep()
    {
        const std::vector<std::byte> before = allTexels(document().texels());
        addPresentView(); // a step of its own
        const int steps = document().undoStack().count();
        plan();
        const FitPlan& fit = m_panel->run().outcome()->fit.plan;
        QVERIFY(fit.cost.texelsAfter < fit.cost.texelsBefore);
        QVERIFY(text("Texels").contains("→"));
        QVERIFY(text("Memory").contains("→"));
        QVERIFY(!text("RMS").isEmpty());
        QVERIFY(allTexels(document().texels()) == before); // only said so far
        QSignalSpy told(m_panel.get(), &FitPanel::applied);
        click("Apply the plan");
        QCOMPARE(told.size(), 1);
        QCOMPARE(document().undoStack().count(), steps + 1);
        QCOMPARE(document().texels().texelCount(), fit.cost.texelsAfter);
        QVERIFY(allTexels(document().texels()) == allTexels(m_panel->run().outcome()->fit.fitted));
        QVERIFY(!button("Apply the plan")->isEnabled());
        QVERIFY2(state().contains("applied"), qPrintable(state()));
        document().undoStack().undo();
        QVERIFY(allTexels(document().texels()) == before);
        document().undoStack().redo();
        QVERIFY(allTexels(document().texels()) == allTexels(m_panel->run().outcome()->fit.fitted));
    }

    void withLayersEachGetsTheLevelsOfThePlan()
    {
        addLayer(document(), "Layer 1");
        fillFace(20);
        const LayersPicture before = pictureOf(document());
        addPresentView(); // a step of its own
        const int steps = document().undoStack().count();
        plan();
        const FitPlan& fit = m_panel->run().outcome()->fit.plan;
        QSignalSpy told(m_panel.get(), &FitPanel::applied);
        click("Apply the plan");
        QTRY_COMPARE(told.size(), 1);
        QCOMPARE(document().undoStack().count(), steps + 1);
        QVERIFY(levelsOf(document().texels()) == fit.levels);
        QVERIFY(levelsOf(document().layers().layers().front().texels) == fit.levels);
        QVERIFY(isShown(document()));
        QVERIFY2(state().contains("applied"), qPrintable(state()));
        document().undoStack().undo();
        QVERIFY(pictureOf(document()) == before);
    }

    void anUndonePlanMayBeAppliedAgain()
    {
        plan();
        click("Apply the plan");
        document().undoStack().undo();
        QVERIFY(m_panel->isCurrent());
        click("Apply the plan");
        QCOMPARE(document().texels().texelCount(),
                 m_panel->run().outcome()->fit.plan.cost.texelsAfter);
    }

    void tableCountsEveryFaceBeforeAndAfter()
    {
        plan();
        auto* table = widgetNamed<QTreeWidget>(*m_panel, "Faces by level");
        QVERIFY(table);
        int before = 0;
        int after = 0;
        for (int row = 0; row < table->topLevelItemCount(); ++row) {
            before += table->topLevelItem(row)->text(1).toInt();
            after += table->topLevelItem(row)->text(2).toInt();
        }
        QCOMPARE(before, 32);
        QCOMPARE(after, 32);
        QCOMPARE(table->topLevelItem(0)->text(0), QString("4"));
        QCOMPARE(table->topLevelItem(0)->text(1), QString("32"));
    }

    void theFastestMethodBecomesTheViews()
    {
        plan();
        const auto& method = m_panel->run().outcome()->fit.method;
        QVERIFY(method);
        m_window->settings().setMethod({"exact", std::nullopt});
        click("Use the fastest method");
        QVERIFY(m_window->settings().method() == method->method);
        QVERIFY(!button("Use the fastest method")->isEnabled());
    }

    void errorsAreMappedOverTheViewUntilApplied()
    {
        m_work->isMadeUp = true;
        plan();
        QCOMPARE(m_window->settings().view().map, ViewMapKind::Fit);
        QVERIFY(choice("Show the errors of the fit")->isChecked());
        ViewMap& map = m_window->viewMap();
        QTRY_VERIFY(map.isComplete());
        const FitPlan& fit = m_panel->run().outcome()->fit.plan;
        for (const std::uint32_t face : {2U, 9U, 10U, 20U}) {
            const auto value = map.valueAt(placeOf(face));
            QVERIFY(value);
            QCOMPARE(*value, fit.errors[FaceId{face}]);
        }
        QVERIFY(fit.errors[FaceId{9}] != fit.errors[FaceId{20}]);
        QVERIFY2(map.legend().title().contains("tolerance"), qPrintable(map.legend().title()));
        click("Apply the plan");
        QCOMPARE(m_window->settings().view().map, ViewMapKind::None);
        QVERIFY(choice("Show the texels as they are")->isChecked());
    }

    void facesInNoViewHaveNoErrorOnTheMap()
    {
        const render::CameraPose far = m_window->viewport().camera().pose();
        m_window->viewport().frameFace(FaceId{20});
        clickUnseen();
        plan();
        const FitPlan& fit = m_panel->run().outcome()->fit.plan;
        QVERIFY(fit.unseenFaces > 0);
        QVERIFY2(text("Unseen").startsWith(QString::number(fit.unseenFaces)),
                 qPrintable(text("Unseen")));
        m_window->viewport().setCamera(far);
        ViewMap& map = m_window->viewMap();
        QTRY_VERIFY(map.isComplete());
        QVERIFY(map.valueAt(placeOf(20)));
        QVERIFY(!map.valueAt(placeOf(0)));
    }

    void facesNoViewSeesKeepTheirPaintUnlessTheyAreGivenUp()
    {
        auto* box = widgetNamed<QCheckBox>(*m_panel, "Faces no view sees keep one texel");
        QVERIFY(box);
        QVERIFY2(!box->isChecked(), "nobody loses paint who did not ask for it");
        QVERIFY(!box->toolTip().isEmpty());
        m_window->viewport().frameFace(FaceId{31}); // far from the noise on face 9
        plan();
        const FitPlan kept = m_panel->run().outcome()->fit.plan;
        QVERIFY(kept.unseenFaces > 0);
        QVERIFY(kept.levels[FaceId{9}] != Level(0));
        QVERIFY2(text("Unseen").contains("→"), qPrintable(text("Unseen")));

        clickUnseen();
        QVERIFY(box->isChecked());
        QVERIFY(!button("Apply the plan")->isEnabled());
        QVERIFY2(state().contains("no view sees"), qPrintable(state()));
        plan();
        const FitPlan& given = m_panel->run().outcome()->fit.plan;
        QCOMPARE(given.unseenFaces, kept.unseenFaces);
        QVERIFY(given.levels[FaceId{9}] == Level(0));
        QVERIFY(given.unseenTexelsAfter < kept.unseenTexelsAfter);
        QVERIFY(button("Apply the plan")->isEnabled());
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Space); // back to what the plan was not made for
        QVERIFY(!button("Apply the plan")->isEnabled());
    }

    void fittedTexelsAreShownWithoutChangingAny()
    {
        m_window->settings().setView({.lit = false, .footprint = false});
        const std::vector<std::byte> before = allTexels(document().texels());
        m_work->isMadeUp = true;
        plan();
        choice("Show the texels as they are")->click();
        const QImage now = picture();
        QTest::mouseClick(choice("Show the fitted texels"), Qt::LeftButton, {}, QPoint(8, 8));
        QCOMPARE(m_window->settings().view().map, ViewMapKind::None);
        QVERIFY(m_window->viewport().showsOtherTexels());
        const QImage fitted = picture();
        QVERIFY(fitted != now);
        QVERIFY(allTexels(document().texels()) == before);
        QTest::keyClick(choice("Show the fitted texels"), Qt::Key_Left);
        QVERIFY(choice("Show the texels as they are")->isChecked());
        QVERIFY(picture() == now);
        QTest::mouseClick(choice("Show the fitted texels"), Qt::LeftButton, {}, QPoint(8, 8));
        click("Apply the plan");
        QVERIFY(!m_window->viewport().showsOtherTexels());
        QVERIFY(picture() == fitted);
    }

    void texelsThatOthersShowAreNotSaidToBeFitted()
    {
        plan();
        choice("Show the fitted texels")->click();
        QVERIFY(choice("Show the fitted texels")->isChecked());
        m_window->viewport().showOtherTexels(document().texels()); // as an import's preview does
        QVERIFY(!choice("Show the fitted texels")->isChecked());
        m_window->viewport().showOtherTexels(std::nullopt);
        QVERIFY(choice("Show the texels as they are")->isChecked());
    }

    void paintingShowsTheDocumentsOwnTexelsAgain()
    {
        plan();
        choice("Show the fitted texels")->click();
        QVERIFY(m_window->viewport().showsOtherTexels());
        fillFace(20);
        QVERIFY(!m_window->viewport().showsOtherTexels());
        QVERIFY(choice("Show the texels as they are")->isChecked());
        QVERIFY(!choice("Show the fitted texels")->isEnabled());
    }

    void namesOfViewsMayChangeWithoutHarmToThePlan()
    {
        plan();
        document().bookmarks().rename(0, "Hero");
        QCOMPARE(views()->item(0)->text(), QString("Hero"));
        QVERIFY(m_panel->isCurrent());
        click("Apply the plan");
        QCOMPARE(document().texels().texelCount(),
                 m_panel->run().outcome()->fit.plan.cost.texelsAfter);
    }

    void cancelLeavesEverythingAsItWas()
    {
        const std::vector<std::byte> before = allTexels(document().texels());
        m_work->mayEnd = false;
        addPresentView();
        click("Plan the fit");
        QVERIFY(m_panel->run().isRunning());
        QTRY_VERIFY(bar()->value() > 0);
        QVERIFY(bar()->isVisible());
        click("Cancel the plan");
        QTRY_VERIFY(!m_panel->run().isRunning());
        QVERIFY(!m_panel->run().outcome());
        QVERIFY(!bar()->isVisible());
        QVERIFY(allTexels(document().texels()) == before);
        QVERIFY(button("Plan the fit")->isEnabled());
        QVERIFY(!button("Apply the plan")->isEnabled());
    }

    void aPlanIsStaleOnceTexelsChangeAndCurrentAgainAfterUndo()
    {
        plan();
        fillFace(20);
        QVERIFY(!button("Apply the plan")->isEnabled());
        QVERIFY2(state().contains("texels have changed"), qPrintable(state()));
        QCOMPARE(button("Plan the fit")->text().remove('&'), QString("Plan again"));
        document().undoStack().undo();
        QVERIFY(button("Apply the plan")->isEnabled());
    }

    void aPlanIsStaleOnceViewsOrToleranceChange()
    {
        plan();
        views()->setFocus();
        views()->setCurrentRow(0);
        QTest::keyClick(views(), Qt::Key_Space); // unchecks it
        QVERIFY(!button("Apply the plan")->isEnabled());
        QTest::keyClick(views(), Qt::Key_Space);
        QVERIFY(button("Apply the plan")->isEnabled());
        setTolerance("2");
        QVERIFY(!button("Apply the plan")->isEnabled());
        QVERIFY2(state().contains("tolerance"), qPrintable(state()));
    }

    void texelsThatChangeMeanwhileMakeThePlanStale()
    {
        m_work->mayEnd = false;
        addPresentView();
        click("Plan the fit");
        fillFace(20);
        m_work->mayEnd = true;
        QTRY_VERIFY(m_panel->run().outcome());
        QVERIFY(!button("Apply the plan")->isEnabled());
    }

    void anotherProjectEndsThePlan()
    {
        m_work->mayEnd = false;
        addPresentView();
        click("Plan the fit");
        document().open(gridProject(), {}, "other");
        QTRY_VERIFY(!m_panel->run().isRunning());
        QVERIFY(!m_panel->run().outcome());
        QCOMPARE(views()->count(), 0);
        m_work->mayEnd = true;
        plan();
        document().open(gridProject(), {}, "third");
        QVERIFY(!m_panel->run().outcome());
        QVERIFY(!button("Apply the plan")->isEnabled());
    }

    void whatIsMissingIsOneSentence()
    {
        QVERIFY(!button("Plan the fit")->isEnabled());
        QVERIFY2(state().contains("view"), qPrintable(state()));
        addPresentView();
        QVERIFY(button("Plan the fit")->isEnabled());
        setTolerance("0");
        QVERIFY(!button("Plan the fit")->isEnabled());
        QVERIFY2(state().contains("tolerance"), qPrintable(state()));
        setTolerance("1");
        QVERIFY(button("Plan the fit")->isEnabled());
        auto* distance = widgetNamed<QDoubleSpinBox>(*m_panel, "Distance of the nearest view");
        widgetNamed<QCheckBox>(*m_panel, "Keep every view beyond a distance")->click();
        type(*distance, "0");
        QVERIFY2(state().contains("distance"), qPrintable(state()));
        QCOMPARE(m_work->runs.load(), 0);
    }

    void nothingToSaveIsSaid()
    {
        document().open(gridProject(2, 0), {}, "coarse");
        plan();
        QVERIFY2(state().contains("nothing to save"), qPrintable(state()));
        QVERIFY(!button("Apply the plan")->isEnabled());
    }

    void aDistanceAloneWillDoAndIsExplained()
    {
        auto* beyond = widgetNamed<QCheckBox>(*m_panel, "Keep every view beyond a distance");
        auto* distance = widgetNamed<QDoubleSpinBox>(*m_panel, "Distance of the nearest view");
        QTest::mouseClick(beyond, Qt::LeftButton, {}, QPoint(8, beyond->height() / 2));
        QVERIFY(beyond->isChecked());
        // The square from (0,0) to (1,1) is seen from the front.
        QVERIFY(std::abs(distance->value() - m_window->viewport().camera().eye().z) < 0.02);
        QTRY_VERIFY2(distance->toolTip().contains("texels"), qPrintable(distance->toolTip()));
        const double chosen = distance->value();
        type(*distance, "200");
        QCOMPARE(distance->value(), 200.0);
        QVERIFY(chosen < 200);
        click("Plan the fit");
        QTRY_VERIFY(m_panel->run().outcome());
        QVERIFY(!m_panel->run().outcome()->fit.method); // no picture to measure in
        QCOMPARE(m_panel->run().outcome()->settings.views.distant.size(), std::size_t{1});
        QCOMPARE(m_panel->run().outcome()->settings.views.distant[0].distance, 200.0);
        QVERIFY(button("Apply the plan")->isEnabled());
    }

    void theWindowsCommandOpensThePanelForTheKeyboard()
    {
        auto* panel = m_window->findChild<FitPanel*>();
        QVERIFY(!panel->isVisible());
        press(Qt::Key_L, Qt::ControlModifier);
        QTRY_VERIFY(panel->isVisible());
        QVERIFY(panel->isAncestorOf(QApplication::focusWidget()));
    }

    void theWindowSaysWhatWasSavedAndOffersUndo()
    {
        auto* panel = m_window->findChild<FitPanel*>();
        press(Qt::Key_L, Qt::ControlModifier);
        QTRY_VERIFY(panel->isVisible());
        const std::vector<std::byte> before = allTexels(document().texels());
        for (const char* name : {"Add the present view", "Plan the fit"}) {
            QTest::mouseClick(widgetNamed<QPushButton>(*panel, name), Qt::LeftButton);
        }
        QTRY_VERIFY(panel->run().outcome());
        QTest::mouseClick(widgetNamed<QPushButton>(*panel, "Apply the plan"), Qt::LeftButton);
        QVERIFY2(m_window->messages().sentence().contains("→"),
                 qPrintable(m_window->messages().sentence()));
        for (auto* undo : m_window->messages().findChildren<QPushButton*>()) {
            QTest::mouseClick(undo, Qt::LeftButton);
        }
        QVERIFY(allTexels(document().texels()) == before);
    }

private:
    /// Every texel of a face another value.
    void paintNoise(std::uint32_t face)
    {
        FaceTexels texels = document().texels().face(FaceId{face});
        std::uint32_t seed = 1;
        for (std::byte& value : texels.writable()) {
            seed = seed * 1664525 + 1013904223;
            value = static_cast<std::byte>(seed >> 24U);
        }
        TexelPatch patch;
        patch.addFace(FaceId{face}, std::move(texels));
        QVERIFY(document().applyPatch(std::move(patch), document().state(), "Noise"));
    }
    void plan()
    {
        if (views()->count() == 0) {
            addPresentView();
        }
        click("Plan the fit");
        QTRY_VERIFY_WITH_TIMEOUT(!m_panel->run().isRunning() && m_panel->isCurrent(), 30000);
    }
    void clickUnseen()
    {
        auto* box = widgetNamed<QCheckBox>(*m_panel, "Faces no view sees keep one texel");
        QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
    }
    QRadioButton* choice(const QString& name) { return widgetNamed<QRadioButton>(*m_panel, name); }
    QImage picture()
    {
        m_window->viewport().settle();
        return m_window->viewport().grabFramebuffer();
    }
    QPointF placeOf(std::uint32_t face)
    {
        const glm::vec2 uv(1.0F / 3);
        const auto corners = document().surface()->mesh().corners(FaceId{face});
        const auto at =
            m_window->viewport().widgetPosition({FaceId{face}, uv, pointAt(corners, uv.x, uv.y)});
        return at.value_or(QPointF(-1, -1));
    }
    void addPresentView() { click("Add the present view"); }
    QPushButton* button(const QString& name) { return widgetNamed<QPushButton>(*m_panel, name); }
    void click(const QString& name)
    {
        QVERIFY2(button(name), qPrintable(name));
        QVERIFY2(button(name)->isEnabled(), qPrintable(name + ": " + state()));
        QTest::mouseClick(button(name), Qt::LeftButton);
    }
    QString text(const QString& name) { return widgetNamed<QLabel>(*m_panel, name)->text(); }
    QString state() { return text("State of the plan"); }
    QProgressBar* bar()
    {
        for (auto* found : m_panel->findChildren<QProgressBar*>()) {
            return found;
        }
        return nullptr;
    }
    QListWidget* views() { return widgetNamed<QListWidget>(*m_panel, "Views to keep"); }
    void type(QDoubleSpinBox& field, const QString& number)
    {
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, number);
        QTest::keyClick(&field, Qt::Key_Tab);
    }
    void setTolerance(const QString& number)
    {
        type(*widgetNamed<QDoubleSpinBox>(*m_panel, "Tolerance of the fit"), number);
    }

    std::shared_ptr<HeldWork> m_work;
    std::unique_ptr<FitPanel> m_panel;
};

} // namespace trixel::ui

TRIXEL_WINDOW_TEST_MAIN(trixel::ui::FitPanelTest)
#include "tst_fit_panel.moc"
