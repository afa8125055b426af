// SPDX-License-Identifier: GPL-3.0-or-later
//
// The panel as its user has it: run, watch, point, click, keys, export.
#include <QAccessible>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QStyleOption>
#include <QTest>
#include <QThread>
#include <QToolButton>

#include "tests/ui/charts/made_up_study.h"
#include "tests/ui/fixtures.h"
#include "ui/docks/chart_advice.h"
#include "ui/docks/chart_panel.h"
#include "ui/docks/chart_view.h"
#include "ui/document/background_job.h"
#include "ui/document/document.h"
#include "ui/viewport/view_settings.h"

#include <atomic>
#include <memory>

namespace trixel::ui {

namespace {

/// A study that measures nothing: tells its points and waits to be let go.
struct FakeStudy
{
    std::atomic<bool> mayEnd = false;
    std::atomic<int> runs = 0;
    std::atomic<QThread*> thread = nullptr;
    std::string subject;
    bool hadProject = false;
    bool fails = false;

    Result<Study> run(const StudyInput& input, StudyWatcher& watcher)
    {
        ++runs;
        thread = QThread::currentThread();
        hadProject = input.project.has_value();
        Study study = madeUpStudy();
        study.subject = input.name.toStdString();
        constexpr std::size_t kTold = 20;
        for (std::size_t k = 0; k < kTold; ++k) {
            StudyPoint rough = study.points[k];
            rough.cost *= 2; // known better at the end
            watcher.measured(rough);
            watcher.measured(study.points[k]);
        }
        while (!mayEnd) {
            if (!watcher.report(0.5)) {
                return cancelled();
            }
            QThread::msleep(1);
        }
        if (fails) {
            return contentsError("The texture is too small to be measured.");
        }
        markFront(study.points);
        return study;
    }
};

} // namespace

class ChartPanelTest : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        QSettings().setValue("files/folder", m_folder.path());
        m_fake = std::make_shared<FakeStudy>();
        m_document = std::make_unique<Document>();
        m_viewSettings = std::make_unique<ViewSettings>();
        m_jobs = std::make_unique<BackgroundJobs>();
        StudyOffer offer;
        offer.title = "Made up";
        offer.about = "Measures nothing.";
        offer.stored = "Stored test textures";
        offer.header = madeUpStudy();
        offer.header.points.clear();
        offer.run = [fake = m_fake](const StudyInput& input, StudyWatcher& watcher) {
            return fake->run(input, watcher);
        };
        m_panel = std::make_unique<ChartPanel>(
            *m_document, *m_viewSettings, *m_jobs, std::vector<StudyOffer>{offer});
        m_panel->resize(900, 460);
        m_panel->show();
        m_panel->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_panel.get()));
    }
    void cleanup()
    {
        m_panel.reset();
        m_jobs.reset();
    }

    void pointsAppearWhileTheStudyRunsElsewhere()
    {
        QVERIFY(m_panel->view().plot().isEmpty());
        click("Run the study");
        QTRY_COMPARE(pointsShown(), 20);
        QVERIFY(m_panel->run().isRunning());
        QVERIFY(m_fake->thread != QThread::currentThread());
        QTRY_COMPARE(named<QProgressBar>("Progress of the study")->value(), 500);
        // A point that came again took its own place.
        QCOMPARE(m_panel->run().study().points[3].cost, madeUpStudy().points[3].cost);
        m_fake->mayEnd = true;
        QTRY_VERIFY(!m_panel->run().isRunning());
        QCOMPARE(m_panel->run().study().points.size(), madeUpStudy().points.size());
        QVERIFY(!named<QProgressBar>("Progress of the study"));
    }

    void cancelKeepsWhatWasMeasured()
    {
        click("Run the study");
        QTRY_COMPARE(pointsShown(), 20);
        click("Cancel the study");
        QTRY_VERIFY(!m_panel->run().isRunning());
        QCOMPARE(pointsShown(), 20);
        QVERIFY(named<QToolButton>("Export the study")->isEnabled());
        QVERIFY(std::ranges::any_of(m_panel->run().study().points, &StudyPoint::onFront));
        click("Run the study"); // and again
        QTRY_COMPARE(m_fake->runs, 2);
    }

    void failureIsToldInOneSentence()
    {
        QSignalSpy told(m_panel.get(), &ChartPanel::failed);
        m_fake->fails = true;
        m_fake->mayEnd = true;
        click("Run the study");
        QTRY_COMPARE(told.size(), 1);
        QVERIFY(told[0][0].toString().contains("too small"));
        QVERIFY(named<QPushButton>("Run the study")->isEnabled());
    }

    void runsOnASnapshotOfTheProjectWhenThereIsOne()
    {
        auto* subject = named<QComboBox>("Subject of the study");
        QCOMPARE(subject->count(), 1);
        m_document->open(gridProject(), {}, "grid");
        QCOMPARE(subject->count(), 2);
        QCOMPARE(subject->currentText(), QString("This project"));
        m_fake->mayEnd = true;
        click("Run the study");
        QTRY_VERIFY(!m_panel->run().isRunning());
        QVERIFY(m_fake->hadProject);
        QCOMPARE(m_panel->run().study().subject, std::string("grid"));
    }

    void hoverNamesThePointAndItsFigures()
    {
        runToEnd();
        const std::size_t source = sourceOf("probes-2", 16);
        QTest::mouseMove(&m_panel->view(), at(source));
        QTRY_COMPARE(m_panel->view().current(), std::optional(source));
        QString spoken = QAccessible::queryAccessibleInterface(&m_panel->view())
                             ->text(QAccessible::Description)
                             .replace(QChar(0x00A0), ' ');
        for (const char* part : {"probes 16", "135 ns", "0.743 %", "3,000 samples"}) {
            QVERIFY2(spoken.contains(part), qPrintable(spoken));
        }
        const QImage hovered = m_panel->view().grab().toImage();
        QTest::mouseMove(&m_panel->view(), {3, 3});
        QTRY_VERIFY(!m_panel->view().current().has_value());
        QVERIFY(hovered != m_panel->view().grab().toImage());
    }

    void clickedPointIsTheMethodInUse()
    {
        runToEnd();
        QSignalSpy changed(m_viewSettings.get(), &ViewSettings::methodChanged);
        const QImage before = m_panel->view().grab().toImage();
        QTest::mouseClick(&m_panel->view(), Qt::LeftButton, {}, at(sourceOf("ewa", 16)));
        QCOMPARE(changed.size(), 1);
        QCOMPARE(m_viewSettings->method(), (MethodChoice{"ewa", 16}));
        m_panel->view().clearFocus();
        QTest::mouseMove(&m_panel->view(), {3, 3});
        QTRY_VERIFY(!m_panel->view().current().has_value());
        QVERIFY(before != m_panel->view().grab().toImage()); // the ring
    }

    void aPeerIsNamedButNotChosen()
    {
        runToEnd();
        const MethodChoice before = m_viewSettings->method();
        const std::size_t peer = sourceOf("OpenImageIO", 0);
        QTest::mouseMove(&m_panel->view(), at(peer));
        QTRY_COMPARE(m_panel->view().current(), std::optional(peer));
        QCOMPARE(m_panel->view().cursor().shape(), Qt::ArrowCursor);
        QTest::mouseClick(&m_panel->view(), Qt::LeftButton, {}, at(peer));
        QCOMPARE(m_viewSettings->method(), before);
    }

    void keysWalkAndEnterChooses()
    {
        runToEnd();
        m_panel->view().setFocus();
        const auto key = [this](Qt::Key k, Qt::KeyboardModifiers modifiers = {}) {
            QTest::keyClick(&m_panel->view(), k, modifiers);
        };
        key(Qt::Key_Home);
        QCOMPARE(m_panel->view().current(), std::optional(sourceOf("point", 0)));
        key(Qt::Key_Right, Qt::ControlModifier);
        key(Qt::Key_Right, Qt::ControlModifier);
        QCOMPARE(m_panel->view().current(), std::optional(sourceOf("probes-1", 1)));
        key(Qt::Key_Right);
        key(Qt::Key_Right);
        QCOMPARE(m_panel->view().current(), std::optional(sourceOf("probes-1", 4)));
        key(Qt::Key_Return);
        QCOMPARE(m_viewSettings->method(), (MethodChoice{"probes-1", 4}));
        key(Qt::Key_Escape);
        QVERIFY(!m_panel->view().current().has_value());
    }

    void classAndMeasureChangeWhatIsShown()
    {
        runToEnd();
        auto* classes = named<QComboBox>("Class of footprints");
        QCOMPARE(classes->count(), 4);
        QCOMPARE(classes->currentText(), QString("All footprints"));
        const int all = pointsShown();
        classes->setFocus();
        QTest::keyClick(classes, Qt::Key_Down);
        QCOMPARE(classes->currentText(), QString("Small round"));
        QCOMPARE(pointsShown(), all - 2); // the peers were measured over all alone
        const double rms = m_panel->view().plot().series[0].points[0].y;
        auto* measure = named<QComboBox>("Measure of error");
        measure->setFocus();
        QTest::keyClick(measure, Qt::Key_Down);
        QCOMPARE(m_panel->view().plot().series[0].points[0].y, 4.6 * rms);
    }

    void theCheapestWithinTheToleranceIsOfferedAndUsed()
    {
        runToEnd();
        auto* advice = named<QLabel>("Method for the tolerance");
        type("Tolerance", "1");
        QVERIFY2(advice->text().contains("probes-2, probes 16"), qPrintable(advice->text()));
        QCOMPARE(m_panel->view().plot().level->y, 0.01);
        QVERIFY2(advice->text().contains("auto has no method"), qPrintable(advice->text()));
        type("Tolerance", "3");
        QVERIFY2(advice->text().contains("probes-1, probes 2"), qPrintable(advice->text()));
        click("Use the method for the tolerance");
        QCOMPARE(m_viewSettings->method(), (MethodChoice{"probes-1", 2}));
    }

    void autoIsToldForEachClass()
    {
        Study study;
        for (const FootprintClass c : footprintClasses()) {
            const bool grazing = std::string(trixel::nameOf(c)).ends_with("grazing");
            study.points.push_back(madeUpPoint("nearest-level", 0, 10, grazing ? 0.2 : 0.001, c));
            study.points.push_back(madeUpPoint("probes-1", 8, 80, 0.002, c));
        }
        StudyView view;
        view.tolerance = 0.01;
        ToleranceAdvice advice = adviceOf(study, view);
        QVERIFY2(advice.text.contains("by class: nearest-level, probes-1:8"),
                 qPrintable(advice.text));
        QCOMPARE(advice.details.count("grazing"), 3);
        view.footprintClass = FootprintClass::SmallGrazing;
        advice = adviceOf(study, view);
        QVERIFY2(advice.text.contains("auto takes probes-1:8 here"), qPrintable(advice.text));
    }

    void exportWritesTheFileOfTheChosenKind_data()
    {
        QTest::addColumn<int>("command");
        QTest::addColumn<QString>("ending");
        QTest::addColumn<QByteArray>("start");
        QTest::newRow("svg") << 0 << "svg" << QByteArray("<?xml");
        QTest::newRow("png") << 1 << "png" << QByteArray("\x89PNG");
        QTest::newRow("csv") << 2 << "csv" << QByteArray("series,");
        QTest::newRow("json") << 3 << "json" << QByteArray("{");
    }
    void exportWritesTheFileOfTheChosenKind()
    {
        QFETCH(int, command);
        QFETCH(QString, ending);
        QFETCH(QByteArray, start);
        runToEnd();
        QSignalSpy written(m_panel.get(), &ChartPanel::written);
        QMenu* menu = named<QToolButton>("Export the study")->menu();
        menu->actions()[command]->trigger();
        auto* dialog = m_panel->findChild<QFileDialog*>();
        QVERIFY(dialog);
        auto* field = dialog->findChild<QLineEdit*>();
        QCOMPARE(field->text(), "speed-accuracy." + ending);
        field->setText(m_folder.filePath("chart"));
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_COMPARE(written.size(), 1);
        QFile file(m_folder.filePath("chart." + ending));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.read(20).startsWith(start));
    }

    void nothingToExportBeforeTheFirstRun()
    {
        QVERIFY(!named<QToolButton>("Export the study")->isEnabled());
        QVERIFY(!named<QPushButton>("Use the method for the tolerance")->isEnabled());
    }

    void controlsStandBesideTheChartWhereThereIsRoom()
    {
        runToEnd();
        auto* study = named<QComboBox>("Study");
        const auto right = [&] { return study->mapTo(m_panel.get(), QPoint()).x(); };
        QVERIFY(m_panel->view().x() > right());
        m_panel->resize(310, 560);
        QCoreApplication::processEvents();
        QVERIFY(m_panel->view().y() > study->mapTo(m_panel.get(), QPoint()).y());
        QVERIFY(m_panel->view().width() > 280);
        QVERIFY(m_panel->minimumSizeHint().width() <= 310);
    }

    void choicesAreReadWhole_data()
    {
        QTest::addColumn<int>("width");
        QTest::newRow("beside the chart") << 900;
        QTest::newRow("above the chart") << 310;
    }
    void choicesAreReadWhole()
    {
        QFETCH(int, width);
        m_panel =
            std::make_unique<ChartPanel>(*m_document, *m_viewSettings, *m_jobs, studyOffers());
        m_panel->resize(width, 460);
        m_panel->show();
        auto* study = named<QComboBox>("Study");
        QVERIFY(study->count() >= 5);
        for (int k = 0; k < study->count(); ++k) {
            study->setCurrentIndex(k);
            QCoreApplication::processEvents();
            for (QComboBox* choice : {study, named<QComboBox>("Subject of the study")}) {
                QStyleOptionComboBox option;
                option.initFrom(choice);
                const QRect field = choice->style()->subControlRect(
                    QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, choice);
                const int text = choice->fontMetrics().horizontalAdvance(choice->currentText());
                QVERIFY2(text <= field.width(), qPrintable(choice->currentText()));
            }
            QVERIFY(study->toolTip().length() > study->currentText().length()); // the rest of it
        }
    }

private:
    template <class T>
    T* named(const QString& name) const
    {
        for (T* widget : m_panel->findChildren<T*>()) {
            if (widget->accessibleName() == name && widget->isVisibleTo(m_panel.get())) {
                return widget;
            }
        }
        return nullptr;
    }
    void click(const QString& name)
    {
        auto* button = named<QPushButton>(name);
        QVERIFY2(button, qPrintable(name));
        QTest::mouseClick(button, Qt::LeftButton);
    }
    void type(const QString& name, const QString& text)
    {
        auto* field = named<QDoubleSpinBox>(name);
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    }
    void runToEnd()
    {
        m_fake->mayEnd = true;
        click("Run the study");
        QTRY_VERIFY(!m_panel->run().isRunning());
        QCOMPARE(m_panel->run().study().points.size(), madeUpStudy().points.size());
    }
    int pointsShown() const
    {
        std::size_t count = 0;
        for (const PlotSeries& series : m_panel->view().plot().series) {
            count += series.points.size();
        }
        return static_cast<int>(count);
    }
    /// Of the point over all footprints; parameter 0 for a method without.
    std::size_t sourceOf(const std::string& series, double parameter) const
    {
        const auto& points = m_panel->run().study().points;
        const auto found = std::ranges::find_if(points, [&](const StudyPoint& p) {
            return p.series == series && !p.footprintClass &&
                   (parameter == 0 || p.method == MethodChoice{series, parameter});
        });
        return static_cast<std::size_t>(found - points.begin());
    }
    QPoint at(std::size_t source) const
    {
        return m_panel->view().positionOf(source).value_or(QPointF()).toPoint();
    }

    TemporarySettings m_settings;
    QTemporaryDir m_folder;
    std::shared_ptr<FakeStudy> m_fake;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<ViewSettings> m_viewSettings;
    std::unique_ptr<BackgroundJobs> m_jobs;
    std::unique_ptr<ChartPanel> m_panel;
};

} // namespace trixel::ui

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    trixel::ui::ChartPanelTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "tst_chart_panel.moc"
