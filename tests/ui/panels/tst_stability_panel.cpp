// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAccessible>
#include <QApplication>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QThread>
#include <QToolButton>
#include <QTreeWidget>

#include "tests/ui/fixtures.h"
#include "ui/charts/stability_plot.h"
#include "ui/docks/chart_view.h"
#include "ui/docks/stability_export.h"
#include "ui/docks/stability_panel.h"
#include "ui/document/background_job.h"
#include "ui/document/document.h"

#include <atomic>
#include <limits>
#include <memory>

namespace trixel::ui {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The textbook's form fails at the last two of four values; ours as told.
StabilitySweep madeUpSweep(const std::string& name, double ours)
{
    return {.name = name,
            .title = "Sweep of " + name,
            .hazard = "The difference cancels.",
            .property = "The area is right.",
            .axisTitle = "angle (rad)",
            .errorTitle = "relative error",
            .bound = 1e-6,
            .values = {{1, "1"}, {1e-3, "1e-3"}, {1e-6, "1e-6"}, {kInfinity, "Inf"}},
            .curves = {{"det = xx yy - xy²", true, {1e-16, 1e-9, 1e-2, kInfinity}},
                       {"product of lengths", false, {0, 1e-16, 1e-15, ours}}}};
}

struct FakeSweeps
{
    std::atomic<bool> mayEnd = false;
    double ours = 1e-3; ///< largest error of our form in the second sweep

    Result<StabilityReport> run(const StabilityInput& input, StabilityWatcher& watcher)
    {
        StabilityReport report;
        report.sweeps = {madeUpSweep("lines", 1e-14), madeUpSweep("poles", ours)};
        if (input.project) {
            AssetFinding needle;
            needle.name = "needle";
            needle.title = "Needle faces";
            needle.count = 3;
            needle.face = FaceId{7};
            report.findings = {needle};
        }
        watcher.swept(report.sweeps[0]);
        while (!mayEnd) {
            if (!watcher.report(0.5)) {
                return cancelled();
            }
            QThread::msleep(1);
        }
        return report;
    }
};

} // namespace

class StabilityPanelTest : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        QSettings().setValue("files/folder", m_folder.path());
        m_fake = std::make_shared<FakeSweeps>();
        m_document = std::make_unique<Document>();
        m_jobs = std::make_unique<BackgroundJobs>();
        m_panel = std::make_unique<StabilityPanel>(
            *m_document,
            *m_jobs,
            [fake = m_fake](const StabilityInput& input, StabilityWatcher& watcher) {
                return fake->run(input, watcher);
            });
        m_panel->resize(900, 360);
        m_panel->show();
        m_panel->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_panel.get()));
    }
    void cleanup()
    {
        m_panel.reset();
        m_jobs.reset();
    }

    void rowsAppearWhileTheSweepsRunAndStayAfterCancel()
    {
        click("Run the sweeps");
        QTRY_COMPARE(list()->topLevelItemCount(), 1);
        QVERIFY(m_panel->run().isRunning());
        QVERIFY(!m_panel->view().plot().isEmpty());
        click("Cancel the sweeps");
        QTRY_VERIFY(!m_panel->run().isRunning());
        QCOMPARE(list()->topLevelItemCount(), 1);
        QVERIFY(named<QPushButton>("Run the sweeps")->isEnabled());
    }

    void verdictsAreWordsAndSayWhereTheTextbookFails()
    {
        runToEnd();
        QCOMPARE(list()->topLevelItem(0)->text(1), QString::fromUtf8("✓ holds"));
        QCOMPARE(list()->topLevelItem(1)->text(1), QString::fromUtf8("✗ fails"));
        QCOMPARE(list()->topLevelItem(0)->text(2), QString::fromUtf8("✗ 2 of 4"));
    }

    void noUsableAnswerOfOursIsInfinitelyWrong()
    {
        m_fake->ours = kInfinity;
        runToEnd();
        QCOMPARE(list()->topLevelItem(1)->text(1), QString::fromUtf8("✗ fails"));
        QVERIFY2(list()->topLevelItem(1)->toolTip(1).endsWith(QString::fromUtf8(" ∞")),
                 qPrintable(list()->topLevelItem(1)->toolTip(1)));
    }

    void theChosenRowIsCharted()
    {
        runToEnd();
        QCOMPARE(m_panel->view().plot().title, QString("Sweep of lines"));
        const QRect row = list()->visualItemRect(list()->topLevelItem(1));
        QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, row.center());
        const Plot& plot = m_panel->view().plot();
        QCOMPARE(plot.title, QString("Sweep of poles"));
        QCOMPARE(plot.level->y, 1e-6);
        QCOMPARE(plot.series.size(), std::size_t(2));
        QVERIFY(plot.series[0].look != plot.series[1].look);
        list()->setFocus();
        QTest::keyClick(list(), Qt::Key_Up);
        QCOMPARE(m_panel->view().plot().title, QString("Sweep of lines"));
    }

    void noUsableAnswerIsAboveAllAndZeroBelow()
    {
        runToEnd();
        ChartView& view = m_panel->view();
        const double infinite = view.positionOf(3)->y();
        const double zero = view.positionOf(4)->y();
        for (const std::size_t source : {0U, 1U, 2U, 5U, 6U, 7U}) {
            QVERIFY(view.positionOf(source)->y() > infinite + 5);
            QVERIFY(view.positionOf(source)->y() < zero - 5);
        }
        QTest::mouseMove(&view, view.positionOf(3)->toPoint());
        QTRY_COMPARE(view.current(), ChartView::Source(3));
        const QString spoken =
            QAccessible::queryAccessibleInterface(&view)->text(QAccessible::Description);
        QVERIFY2(spoken.contains("no usable answer") && spoken.contains("angle (rad): Inf") &&
                     spoken.contains("beyond the bound"),
                 qPrintable(spoken));
    }

    void facesOfTheProjectAreListedAndShown()
    {
        m_document->open(gridProject(), {}, "grid");
        runToEnd();
        QCOMPARE(list()->topLevelItemCount(), 3);
        QSignalSpy wanted(m_panel.get(), &StabilityPanel::faceChosen);
        const QRect row = list()->visualItemRect(list()->topLevelItem(2));
        list()->scrollToItem(list()->topLevelItem(2));
        QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, row.center());
        QVERIFY(!wanted.isEmpty());
        QCOMPARE(wanted[0][0].value<FaceId>(), FaceId{7});
    }

    void exportsWriteTheirFiles_data()
    {
        QTest::addColumn<int>("command");
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("holds");
        QTest::newRow("svg") << 0 << "lines.svg" << QByteArray("Sweep of lines");
        QTest::newRow("png") << 1 << "lines.png" << QByteArray("\x89PNG");
        QTest::newRow("sheet") << 2 << "stability.svg" << QByteArray("width=\"444.5mm\"");
        QTest::newRow("csv") << 3 << "stability.csv" << QByteArray("product of lengths");
        QTest::newRow("json") << 4 << "stability.json" << QByteArray("product of lengths");
    }
    void exportsWriteTheirFiles()
    {
        QFETCH(int, command);
        QFETCH(QString, name);
        QFETCH(QByteArray, holds);
        runToEnd();
        QSignalSpy written(m_panel.get(), &StabilityPanel::written);
        named<QToolButton>("Export the report")->menu()->actions()[command]->trigger();
        auto* dialog = m_panel->findChild<QFileDialog*>();
        QVERIFY(dialog);
        auto* field = dialog->findChild<QLineEdit*>();
        QCOMPARE(field->text(), name);
        field->setText(m_folder.filePath(name));
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_COMPARE(written.size(), 1);
        QFile file(m_folder.filePath(name));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().contains(holds));
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
    QTreeWidget* list() const { return named<QTreeWidget>("Hazards"); }
    void click(const QString& name)
    {
        auto* button = named<QPushButton>(name);
        QVERIFY2(button, qPrintable(name));
        QTest::mouseClick(button, Qt::LeftButton);
    }
    void runToEnd()
    {
        m_fake->mayEnd = true;
        click("Run the sweeps");
        QTRY_VERIFY(!m_panel->run().isRunning());
        QVERIFY(list()->topLevelItemCount() >= 2);
    }

    TemporarySettings m_settings;
    QTemporaryDir m_folder;
    std::shared_ptr<FakeSweeps> m_fake;
    std::unique_ptr<Document> m_document;
    std::unique_ptr<BackgroundJobs> m_jobs;
    std::unique_ptr<StabilityPanel> m_panel;
};

} // namespace trixel::ui

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    trixel::ui::StabilityPanelTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "tst_stability_panel.moc"
