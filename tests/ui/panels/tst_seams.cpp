// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QTreeWidget>

#include "tests/ui/window/window_fixture.h"
#include "ui/docks/seam_model.h"
#include "ui/docks/seam_panel.h"

#include <algorithm>
#include <random>

namespace trixel::ui {

namespace {

std::shared_ptr<const SeamReport> reportOf(std::size_t edges)
{
    auto report = std::make_shared<SeamReport>();
    std::mt19937 random(3);
    std::uniform_int_distribution<int> level(0, 8);
    std::uniform_int_distribution<std::uint32_t> face(0, 1'000'000);
    for (std::size_t k = 0; k < edges; ++k) {
        SeamJump jump;
        jump.face = FaceId{face(random)};
        jump.neighbour = FaceId{face(random)};
        jump.edge = kLocalEdges[k % 3];
        jump.level = Level(level(random));
        jump.neighbourLevel = Level(level(random));
        jump.jump = 1.0F - static_cast<float>(k) / static_cast<float>(edges);
        jump.mean = static_cast<float>(random() % 1000) / 1000.0F;
        report->jumps.push_back(jump);
    }
    return report;
}

} // namespace

class SeamsTest : public WindowTest
{
    Q_OBJECT

private slots:
    void cleanup() { closeWindow(); }

    void theModelKeepsThePromisesOfModels()
    {
        SeamModel model;
        const QAbstractItemModelTester tester(
            &model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.setReport(reportOf(200));
        QCOMPARE(model.rowCount(), 200);
        for (int column = 0; column < SeamModel::ColumnCount; ++column) {
            for (const Qt::SortOrder order : {Qt::AscendingOrder, Qt::DescendingOrder}) {
                model.sort(column, order);
                QTRY_VERIFY(!model.isSorting());
            }
        }
        model.setReport(reportOf(10));
        model.setReport(nullptr);
        QCOMPARE(model.rowCount(), 0);
    }

    void sortingOrdersByTheColumnAndKeepsTheChosenEdge()
    {
        SeamModel model;
        model.setReport(reportOf(500));
        const QPersistentModelIndex chosen = model.index(123, 0);
        const SeamJump edge = model.jumpAt(123);
        model.sort(SeamModel::Face, Qt::AscendingOrder);
        QTRY_VERIFY(!model.isSorting());
        for (int row = 1; row < 500; ++row) {
            QVERIFY(model.jumpAt(row - 1).face <= model.jumpAt(row).face);
        }
        QCOMPARE(model.jumpAt(chosen.row()), edge);
        model.sort(SeamModel::Mean, Qt::DescendingOrder);
        QTRY_VERIFY(!model.isSorting());
        for (int row = 1; row < 500; ++row) {
            QVERIFY(model.jumpAt(row - 1).mean >= model.jumpAt(row).mean);
        }
        QCOMPARE(model.jumpAt(chosen.row()), edge);
        model.sort(SeamModel::Jump, Qt::DescendingOrder);
        QCOMPARE(chosen.row(), 123);
    }

    void anOlderOrderDoesNotOvertakeANewer()
    {
        SeamModel model;
        model.setReport(reportOf(100'000));
        model.sort(SeamModel::Levels, Qt::AscendingOrder);
        model.sort(SeamModel::Face, Qt::DescendingOrder);
        QTRY_VERIFY(!model.isSorting());
        for (int row = 1; row < 1000; ++row) {
            QVERIFY(model.jumpAt(row - 1).face >= model.jumpAt(row).face);
        }
    }

    void aLargeReportComesInParts()
    {
        constexpr int kEdges = 2 * SeamModel::kRowsAtOnce + 7;
        SeamModel model;
        model.setReport(reportOf(kEdges));
        QCOMPARE(model.rowCount(), SeamModel::kRowsAtOnce);
        const QPersistentModelIndex least = model.index(SeamModel::kRowsAtOnce - 1, 0);
        model.sort(SeamModel::Jump, Qt::AscendingOrder); // of all edges, not of those given
        QTRY_VERIFY(!model.isSorting());
        QCOMPARE(model.jumpAt(0).jump, 1.0F - float(kEdges - 1) / float(kEdges));
        QVERIFY(!least.isValid()); // comes after the rows given
        model.fetchMore({});
        model.fetchMore({});
        QCOMPARE(model.rowCount(), kEdges);
        QVERIFY(!model.canFetchMore({}));
        model.fetchMore({});
        QCOMPARE(model.rowCount(), kEdges);
        QCOMPARE(model.jumpAt(kEdges - 1).jump, 1.0F);
    }

    void scrollingToTheEndBringsMoreRows()
    {
        SeamModel model;
        model.setReport(reportOf(3 * SeamModel::kRowsAtOnce));
        QTableView table;
        table.setModel(&model);
        table.show();
        table.scrollToBottom();
        QTRY_COMPARE(model.rowCount(), 2 * SeamModel::kRowsAtOnce);
    }

    void measuringListsTheEdgesWorstFirst()
    {
        open();
        QVERIFY(!panel().report());
        choose("point");
        QTest::mouseClick(button("&Measure"), Qt::LeftButton);
        QTRY_VERIFY(panel().report());
        // Of the grid's inner edges only those about the two painted faces jump.
        const int edges = panel().model().rowCount();
        QCOMPARE(edges, (128 * 3 - 32) / 2);
        QCOMPARE(panel().model().jumpAt(0).jump, panel().model().jumpAt(5).jump);
        QVERIFY(panel().model().jumpAt(0).jump > 0.5F);
        QCOMPARE(panel().model().jumpAt(6).jump, 0.0F);
    }

    void aContinuousMethodHasNoSeams()
    {
        open();
        choose("lattice-linear");
        panel().measure();
        QTRY_VERIFY(panel().report());
        QVERIFY(panel().model().jumpAt(0).jump <= float(kSeamless));
    }

    void aClickedRowMovesTheCameraAndMarksTheEdge()
    {
        open();
        choose("point");
        panel().measure();
        QTRY_VERIFY(panel().report());
        auto* table = panel().findChild<QTableView*>();
        QCoreApplication::processEvents();
        m_window->viewport().frameAll();
        const render::CameraPose before = m_window->viewport().camera().pose();
        const QRect cell = table->visualRect(table->model()->index(2, 0));
        QTest::mouseClick(table->viewport(), Qt::LeftButton, Qt::NoModifier, cell.center());
        const render::CameraPose after = m_window->viewport().camera().pose();
        QVERIFY(after.distance < before.distance / 2);
        // The edge is in the middle of the view, and drawn.
        const SeamJump jump = panel().model().jumpAt(2);
        const auto corners = document().surface()->mesh().corners(jump.face);
        const auto a = corners[indexOf(jump.edge)];
        const auto b = corners[(indexOf(jump.edge) + 1) % 3];
        const auto place = m_window->viewport().camera().project((a + b) / 2.0F);
        const QRect view = m_window->viewport().rect();
        QVERIFY(std::abs(place->x - view.center().x()) < view.width() / 4.0);
        QVERIFY(std::abs(place->y - view.center().y()) < view.height() / 4.0);
        const QColor line =
            m_window->viewport().grabFramebuffer().pixelColor(int(place->x), int(place->y));
        QVERIFY(line.red() > 200 && line.blue() < 120);
    }

    void enterGoesToTheChosenEdge()
    {
        open();
        choose("point");
        panel().measure();
        QTRY_VERIFY(panel().report());
        auto* table = panel().findChild<QTableView*>();
        m_window->viewport().frameAll();
        const render::CameraPose before = m_window->viewport().camera().pose();
        table->setFocus();
        table->setCurrentIndex(table->model()->index(4, 0));
        QTest::keyClick(table, Qt::Key_Return);
        QVERIFY(!(m_window->viewport().camera().pose() == before));
    }

    void anotherMethodIsMeasuredAnew()
    {
        open();
        choose("point");
        panel().measure();
        QTRY_VERIFY(panel().report());
        const auto first = panel().report();
        choose("lattice-linear");
        QTRY_VERIFY(panel().report() != first);
        QVERIFY(panel().model().jumpAt(0).jump <= float(kSeamless));
        auto* compared = panel().findChild<QTreeWidget*>();
        QCOMPARE(compared->topLevelItemCount(), 2);
    }

    void comparingMeasuresEveryMethod()
    {
        open();
        QTest::mouseClick(button("&Compare methods"), Qt::LeftButton);
        auto* compared = panel().findChild<QTreeWidget*>();
        const int methods = static_cast<int>(filterMethods().size());
        QTRY_COMPARE_WITH_TIMEOUT(compared->topLevelItemCount(), methods, 60000);
        QTRY_VERIFY(!panel().isMeasuring());
    }

    void paintingSaysThatTheFiguresAreOld()
    {
        open();
        panel().measure();
        QTRY_VERIFY(panel().report());
        fillFace(5);
        const auto labels = panel().findChildren<QLabel*>();
        QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
            return label->text().contains("changed since");
        }));
    }

    void anotherDocumentEmptiesThePanel()
    {
        open();
        panel().measure();
        QTRY_VERIFY(panel().report());
        document().open(gridProject(3), {}, "other");
        QVERIFY(!panel().report());
        QCOMPARE(panel().model().rowCount(), 0);
    }

    void theViewsOwnFootprintsMeasureWhatItShows()
    {
        open();
        choose("point");
        auto* footprints = widgetNamed<QComboBox>(panel(), "Footprints to measure with");
        QVERIFY(footprints);
        footprints->setCurrentIndex(1);
        m_window->viewport().lookFrom(0, 0);
        panel().measure();
        QTRY_VERIFY(panel().report());
        const int all = panel().model().rowCount();
        m_window->viewport().frameFace(FaceId{60});
        const auto first = panel().report();
        panel().measure();
        QTRY_VERIFY(panel().report() != first);
        QVERIFY(panel().model().rowCount() > 0);
        QVERIFY2(panel().model().rowCount() < all / 2,
                 qPrintable(QString("%1 of %2").arg(panel().model().rowCount()).arg(all)));
    }

private:
    void open()
    {
        openWindow();
        openGrid();
        // Two squares of the grid, apart.
        fillFace(20);
        fillFace(90);
        m_window->findChild<QDockWidget*>("seamPanel")->raise();
        QCoreApplication::processEvents();
    }
    SeamPanel& panel() { return m_window->seams(); }
    void choose(const std::string& method)
    {
        m_window->settings().setMethod({method, std::nullopt});
    }
    QPushButton* button(const QString& text)
    {
        for (QPushButton* found : panel().findChildren<QPushButton*>()) {
            if (found->text() == text) {
                return found;
            }
        }
        return nullptr;
    }
};

} // namespace trixel::ui

TRIXEL_WINDOW_TEST_MAIN(trixel::ui::SeamsTest)
#include "tst_seams.moc"
