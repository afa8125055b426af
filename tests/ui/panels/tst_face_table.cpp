// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QDockWidget>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScrollBar>
#include <QSignalSpy>
#include <QToolButton>
#include <QTreeWidget>

#include "core/base/read_file.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/docks/report_panel.h"
#include "ui/docks/seam_model.h"
#include "ui/docks/seam_panel.h"
#include "ui/docks/stability_panel.h"
#include "ui/document/inspection.h"
#include "ui/inspector/face_listing.h"
#include "ui/inspector/face_panel.h"
#include "ui/inspector/face_table_model.h"
#include "ui/inspector/face_table_view.h"

#include <algorithm>

namespace trixel::ui {

class FaceTableTest : public WindowTest
{
    Q_OBJECT

private slots:
    // One window serves all tests but those that begin without one.
    void cleanupTestCase() { closeWindow(); }

    void theModelKeepsThePromisesOfModels()
    {
        Document document;
        FaceSelection selection(document);
        ViewSettings settings;
        BackgroundJobs jobs;
        FaceListing listing(document, selection, settings, jobs);
        FaceTableModel model(listing, selection);
        const QAbstractItemModelTester tester(
            &model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        QCOMPARE(model.rowCount(), 0);
        listing.setWatched(true);
        document.open(gridProject(), {}, "grid");
        QTRY_COMPARE(model.rowCount(), 128);
        document.fillFaces(std::array{FaceId{7}, FaceId{9}}, {1, 0, 0, 1});
        QTRY_VERIFY(!listing.isBusy());
        for (int column = 0; column < FaceTableModel::kColumns; ++column) {
            for (const Qt::SortOrder order : {Qt::AscendingOrder, Qt::DescendingOrder}) {
                model.sort(column, order);
                QTRY_VERIFY(!listing.isBusy());
                QCOMPARE(model.rowCount(), 128);
            }
        }
        for (const char* filter : {"mean<0.5", "face>100", "selected", ""}) {
            listing.setFilter(parseFaceFilter(filter).value());
            QTRY_VERIFY(!listing.isBusy());
        }
        document.open(gridProject(3), {}, "other");
        QTRY_COMPARE(model.rowCount(), 18);
    }

    void sortingKeepsTheCurrentFace()
    {
        Document document;
        FaceSelection selection(document);
        ViewSettings settings;
        BackgroundJobs jobs;
        FaceListing listing(document, selection, settings, jobs);
        FaceTableModel model(listing, selection);
        listing.setWatched(true);
        document.open(gridProject(), {}, "grid");
        QTRY_COMPARE(model.rowCount(), 128);
        const QPersistentModelIndex current = model.index(20, 1);
        model.sort(0, Qt::DescendingOrder);
        QTRY_COMPARE(model.faceAt(0), FaceId{127});
        QCOMPARE(current.row(), 107);
        QCOMPARE(current.column(), 1);
        QCOMPARE(model.rowOf(FaceId{20}), std::optional(107));
    }

    void nothingIsDoneWhileNobodyLooks()
    {
        closeWindow();
        openWindow();
        openGrid();
        auto* hidden = m_window->findChild<FacePanel*>();
        QVERIFY(hidden);
        QTest::qWait(200);
        QVERIFY(!hidden->listing().figures());
        press(Qt::Key_F8, Qt::ShiftModifier);
        QTRY_COMPARE(hidden->model().rowCount(), 128);
        hidden->parentWidget()->hide();
        const auto before = hidden->listing().figures();
        fillFace(3);
        QTest::qWait(300);
        QCOMPARE(hidden->listing().figures(), before);
        hidden->parentWidget()->show();
        QTRY_COMPARE(hidden->listing().figures()->highest(FaceId{3}), 1.0F);
        closeWindow();
    }

    void cellsTellWhatTheFaceHolds()
    {
        open();
        fillFace(20);
        QTRY_COMPARE(text(20, FaceColumn::Highest), QString("1"));
        QCOMPARE(text(20, FaceColumn::Face), QString("20"));
        QCOMPARE(text(20, FaceColumn::Level), QString("3"));
        QCOMPARE(text(20, FaceColumn::Texels), QString("64"));
        QCOMPARE(text(20, FaceColumn::Bytes), QString("3"));
        QCOMPARE(text(20, FaceColumn::Constant), QString("yes"));
        QCOMPARE(text(20, FaceColumn::Lowest), QString("0"));
        QCOMPARE(text(20, FaceColumn::Mean), QString("0.3333"));
        QCOMPARE(text(20, FaceColumn::Jump), QString("–"));
        // Edges of 1/8, 1/8 and √2/8: 8 texels over √(4/3)/8.
        QCOMPARE(text(20, FaceColumn::Density), QString("55.43"));
    }

    void aChannelLookedAtAloneIsToldAlone()
    {
        open();
        fillFace(20); // red
        render::Look look = m_window->settings().look();
        look.channel = 0;
        m_window->settings().setLook(look);
        QTRY_COMPARE(text(20, FaceColumn::Lowest), QString("1"));
        QVERIFY(model()
                    .headerData(int(FaceColumn::Mean), Qt::Horizontal, Qt::ToolTipRole)
                    .toString()
                    .contains("channel 0"));
        look.channel = 1;
        m_window->settings().setLook(look);
        QTRY_COMPARE(text(20, FaceColumn::Highest), QString("0"));
    }

    void aStrokeIsToldWhenItEnds()
    {
        open();
        QTRY_VERIFY(!panel().listing().isBusy());
        Brush brush = m_window->settings().brush();
        brush.radius = 0.05F;
        document().beginStroke(brush);
        StrokeSample sample;
        sample.face = FaceId{40};
        sample.uv = {0.3F, 0.3F};
        document().extendStroke(sample);
        const auto before = panel().listing().figures();
        QTest::qWait(300);
        QCOMPARE(panel().listing().figures(), before);
        document().endStroke();
        QTRY_VERIFY(panel().listing().figures() != before);
        const auto painted = facesThatDiffer(document().texels(), gridProject().texels);
        QVERIFY(!painted.empty());
        for (const FaceId face : painted) {
            QCOMPARE(panel().listing().figures()->isConstant(face),
                     document().texels().face(face).isConstant());
        }
    }

    void aClickOnAHeaderSorts()
    {
        open();
        fillFace(20);
        QTRY_COMPARE(text(20, FaceColumn::Highest), QString("1"));
        clickHeader(FaceColumn::Mean);
        QTRY_COMPARE(model().faceAt(0), FaceId{20});
        clickHeader(FaceColumn::Mean);
        QTRY_COMPARE(model().faceAt(127), FaceId{20});
    }

    void clicksSelectInTheOneSelection()
    {
        open();
        clickRow(4);
        QCOMPARE(selected(), faces({4}));
        clickRow(6, Qt::ControlModifier);
        QCOMPARE(selected(), faces({4, 6}));
        clickRow(4, Qt::ControlModifier);
        QCOMPARE(selected(), faces({6}));
        clickRow(3);
        clickRow(6, Qt::ShiftModifier);
        QCOMPARE(selected(), faces({3, 4, 5, 6}));
        clickRow(1, Qt::ControlModifier);
        clickRow(2, Qt::ShiftModifier | Qt::ControlModifier);
        QCOMPARE(selected(), faces({1, 2, 3, 4, 5, 6}));
        // Selected rows look it.
        const QImage picture = table().viewport()->grab().toImage();
        const auto colorOf = [&](int row) {
            const QRect cell = table().visualRect(model().index(row, 0));
            return picture.pixelColor(cell.left() + 2, cell.center().y());
        };
        const auto apart = [](const QColor& a, const QColor& b) {
            return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) +
                   std::abs(a.blue() - b.blue());
        };
        QVERIFY(apart(colorOf(4), colorOf(0)) > 60);
        QVERIFY(apart(colorOf(4), colorOf(2)) < 10);
    }

    void aRangeFollowsTheOrderShown()
    {
        open();
        clickHeader(FaceColumn::Face);
        QTRY_COMPARE(model().faceAt(0), FaceId{127});
        clickRow(0);
        clickRow(2, Qt::ShiftModifier);
        QCOMPARE(selected(), faces({125, 126, 127}));
    }

    void draggingSelectsARange()
    {
        open();
        QTest::mousePress(table().viewport(), Qt::LeftButton, {}, centreOf(2));
        for (const int row : {3, 4, 5}) {
            QTest::mouseMove(table().viewport(), centreOf(row));
            QMouseEvent move(QEvent::MouseMove,
                             centreOf(row),
                             table().viewport()->mapToGlobal(centreOf(row)),
                             Qt::NoButton,
                             Qt::LeftButton,
                             Qt::NoModifier);
            QApplication::sendEvent(table().viewport(), &move);
        }
        QTest::mouseRelease(table().viewport(), Qt::LeftButton, {}, centreOf(5));
        QCOMPARE(selected(), faces({2, 3, 4, 5}));
    }

    void keysWalkExtendToggleAndSelectAll()
    {
        open();
        clickRow(4);
        press(Qt::Key_Down);
        QCOMPARE(selected(), faces({5}));
        press(Qt::Key_Down, Qt::ShiftModifier);
        press(Qt::Key_Down, Qt::ShiftModifier);
        QCOMPARE(selected(), faces({5, 6, 7}));
        press(Qt::Key_End, Qt::ControlModifier);
        QCOMPARE(selected(), faces({5, 6, 7}));
        QCOMPARE(table().currentIndex().row(), 127);
        press(Qt::Key_Space);
        QCOMPARE(selected(), faces({5, 6, 7, 127}));
        press(Qt::Key_Home);
        QCOMPARE(selected(), faces({0}));
        press(Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(selected().size(), 128U);
    }

    void selectAllTakesTheListedFacesOnly()
    {
        open();
        filter("face<10");
        QTRY_COMPARE(model().rowCount(), 10);
        table().setFocus();
        press(Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(selected().size(), 10U);
    }

    void typedDigitsGoToTheFaceAndPaintNothing()
    {
        open();
        clickRow(0);
        const float opacity = m_window->settings().brush().opacity;
        press(Qt::Key_1);
        press(Qt::Key_0);
        press(Qt::Key_5);
        QCOMPARE(model().faceAt(table().currentIndex().row()), FaceId{105});
        QVERIFY(table().viewport()->rect().contains(table().visualRect(table().currentIndex())));
        QCOMPARE(m_window->settings().brush().opacity, opacity);
        QTest::qWait(1300);
        press(Qt::Key_9);
        QCOMPARE(model().faceAt(table().currentIndex().row()), FaceId{9});
        QTest::qWait(1300);
        for (int k = 0; k < 4; ++k) {
            press(Qt::Key_9);
        }
        QVERIFY(says("Face 9999 is not listed."));
    }

    void theSelectionMadeElsewhereIsGoneTo()
    {
        open();
        m_window->selection().set({FaceId{90}, FaceId{100}});
        QCOMPARE(model().faceAt(table().currentIndex().row()), FaceId{90});
        QVERIFY(table().viewport()->rect().contains(table().visualRect(table().currentIndex())));
        QVERIFY(model().index(90, 0).data(FaceTableModel::SelectedRole).toBool());
        QVERIFY(!model().index(91, 0).data(FaceTableModel::SelectedRole).toBool());
        QVERIFY(says("2 selected"));
    }

    void aRowUnderThePointerIsInspected()
    {
        open();
        QTest::mouseMove(table().viewport(), centreOf(3));
        QTRY_VERIFY(m_window->inspection().texel());
        QTRY_COMPARE(m_window->inspection().texel()->place.face, FaceId{3});
        QVERIFY(m_window->inspection().isPointedAt());
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(&table(), &leave);
        QVERIFY(!m_window->inspection().isPointedAt());
    }

    void theInspectedFaceIsLitAndGoneToOnlyWhenHeld()
    {
        open();
        m_window->inspection().pointAt(FaceId{2}, {0.3F, 0.3F});
        const QImage picture = table().viewport()->grab().toImage();
        const auto colorOf = [&](int row) {
            const QRect cell = table().visualRect(model().index(row, 0));
            return picture.pixelColor(cell.left() + 2, cell.center().y());
        };
        QVERIFY(colorOf(2) != colorOf(4)); // of the same parity
        const int top = table().verticalScrollBar()->value();
        m_window->inspection().pointAt(FaceId{120}, {0.3F, 0.3F});
        QCOMPARE(table().verticalScrollBar()->value(), top);
        m_window->inspection().hold(FaceId{120}, {0.3F, 0.3F});
        QVERIFY(table().verticalScrollBar()->value() > top);
    }

    void enterAndDoubleClickGoToTheFace()
    {
        open();
        m_window->viewport().frameAll();
        const double far = m_window->viewport().camera().pose().distance;
        clickRow(5);
        press(Qt::Key_Return);
        QVERIFY(m_window->viewport().camera().pose().distance < far / 2);
        m_window->viewport().frameAll();
        QTest::mouseDClick(table().viewport(), Qt::LeftButton, {}, centreOf(6));
        QVERIFY(m_window->viewport().camera().pose().distance < far / 2);
    }

    void aFilterListsWhatPassesAndSaysWhatItCannotRead()
    {
        open();
        fillFace(20);
        QTRY_COMPARE(text(20, FaceColumn::Highest), QString("1"));
        filter("mean<0.5");
        QTRY_COMPARE(model().rowCount(), 1);
        QCOMPARE(model().faceAt(0), FaceId{20});
        QVERIFY(says("1 of 128 faces"));
        filter("mean<");
        QTRY_VERIFY(says("expected a number"));
        QCOMPARE(model().rowCount(), 1); // as before
        filter("face>1000");
        QTRY_VERIFY(says("No face passes the filter."));
        filter("");
        QTRY_COMPARE(model().rowCount(), 128);
    }

    void conditionsAreOfferedInAMenu()
    {
        open();
        m_window->selection().set({FaceId{3}, FaceId{70}});
        auto* button = widgetNamed<QToolButton>(panel(), "Add a condition to the filter");
        QVERIFY(button);
        QAction* offered = button->menu()->actions().front();
        offered->trigger();
        QTRY_COMPARE(model().rowCount(), 2);
        QCOMPARE(model().faceAt(1), FaceId{70});
        m_window->selection().add({FaceId{71}}); // follows what is selected elsewhere
        QTRY_COMPARE(model().rowCount(), 3);
        clickRow(0); // but not the table's own clicks
        QTest::qWait(100);
        QCOMPARE(model().rowCount(), 3);
    }

    void measuredSeamsFillTheColumn()
    {
        open();
        fillFace(20);
        m_window->settings().setMethod({"point", std::nullopt});
        m_window->seams().measure();
        QTRY_VERIFY(m_window->seams().report());
        QTRY_COMPARE(text(0, FaceColumn::Jump), QString("0 %"));
        QVERIFY(text(20, FaceColumn::Jump) != "0 %");
        filter("jump>10%");
        QTRY_COMPARE(model().rowCount(), 4); // the painted one and those about it
        filter("");
        document().open(gridProject(3), {}, "other");
        QTRY_COMPARE(text(0, FaceColumn::Jump), QString("–"));
    }

    void selectedRowsAreCopiedAsTabSeparatedLines()
    {
        open();
        clickHeader(FaceColumn::Face);
        QTRY_COMPARE(model().faceAt(0), FaceId{127});
        QGuiApplication::clipboard()->clear();
        m_window->selection().set({FaceId{3}, FaceId{9}});
        table().setFocus();
        press(Qt::Key_C, Qt::ControlModifier);
        QTRY_VERIFY(!QGuiApplication::clipboard()->text().isEmpty());
        const QStringList lines = QGuiApplication::clipboard()->text().split('\n');
        QCOMPARE(lines.size(), 4); // the last is empty
        QVERIFY(lines[0].startsWith("face\tlevel\ttexels"));
        QVERIFY(lines[1].startsWith("9\t3\t64\t3\t1\t"));
        QVERIFY(lines[2].startsWith("3\t3\t64\t3\t1\t"));
    }

    void listedRowsAreSavedOrASentenceSaysWhyNot()
    {
        open();
        filter("face<5");
        QTRY_COMPARE(model().rowCount(), 5);
        auto* save = widgetNamed<QToolButton>(panel(), "Save the table");
        QTest::mouseClick(save, Qt::LeftButton);
        auto* dialog = openDialog<QFileDialog>();
        QVERIFY(dialog);
        dialog->findChild<QLineEdit*>("fileNameEdit")->setText(path("faces.csv"));
        QMetaObject::invokeMethod(dialog, "accept");
        QTRY_VERIFY(QFile::exists(path("faces.csv")));
        QTRY_VERIFY(m_window->messages().sentence().contains("faces.csv"));
        const std::string text = readFile(path("faces.csv").toStdString()).value();
        QCOMPARE(std::count(text.begin(), text.end(), '\n'), 6);
        panel().save(path("no/such/faces.csv"));
        QTRY_VERIFY(m_window->messages().kind() == MessageBar::Kind::Error);
        QVERIFY(m_window->messages().sentence().contains("no/such"));
    }

    void aFaceChosenInTheFindingsIsSelected()
    {
        open();
        TriangleMesh mesh = gridMesh(4);
        mesh.triangles.push_back(mesh.triangles[5]); // on top of another: 5 and 32
        NoProgress progress;
        const LevelPlan plan = planUniform(mesh.faceCount(), Level(1));
        const std::vector<float> fill{0.8F, 0.8F, 0.8F};
        document().open(newProject(std::move(mesh), plan, {}, fill, progress).value(), {}, "odd");
        QTRY_COMPARE(model().rowCount(), 33);
        auto* report = m_window->findChild<ReportPanel*>();
        qobject_cast<QDockWidget*>(report->parentWidget())->raise();
        QCoreApplication::processEvents();
        auto* tree = report->findChild<QTreeWidget*>();
        QTreeWidgetItem* finding = nullptr;
        for (int k = 0; k < tree->topLevelItemCount(); ++k) {
            if (tree->topLevelItem(k)->text(0).startsWith("Faces on top")) {
                finding = tree->topLevelItem(k);
            }
        }
        QVERIFY(finding);
        QTest::mouseClick(
            tree->viewport(), Qt::LeftButton, {}, tree->visualItemRect(finding).center());
        const std::size_t all = selected().size();
        QVERIFY(all >= 1);
        QVERIFY(model()
                    .index(*model().rowOf(selected().front()), 0)
                    .data(FaceTableModel::SelectedRole)
                    .toBool());
        finding->setExpanded(true);
        QTest::mouseClick(
            tree->viewport(), Qt::LeftButton, {}, tree->visualItemRect(finding->child(0)).center());
        QCOMPARE(selected(), faces({finding->child(0)->data(0, Qt::UserRole).toUInt()}));
    }

    void aSeamAndAHazardThatAreGoneToAreSelected()
    {
        open();
        fillFace(20);
        m_window->settings().setMethod({"point", std::nullopt});
        qobject_cast<QDockWidget*>(m_window->seams().parentWidget())->raise();
        m_window->seams().measure();
        QTRY_VERIFY(m_window->seams().report() && m_window->seams().model().rowCount() > 0);
        auto* seams = m_window->seams().findChild<QTableView*>();
        QTRY_VERIFY(seams->isVisible());
        const SeamJump jump = m_window->seams().model().jumpAt(1);
        QTest::mouseClick(seams->viewport(),
                          Qt::LeftButton,
                          {},
                          seams->visualRect(seams->model()->index(1, 0)).center());
        std::vector<FaceId> both{jump.face, jump.neighbour};
        QCOMPARE(selected(), both);
        emit m_window->findChild<StabilityPanel*>()->faceChosen(FaceId{77});
        QCOMPARE(selected(), faces({77}));
    }

    void anEmptyTableSaysWhatToDo()
    {
        closeWindow();
        openWindow();
        press(Qt::Key_F8, Qt::ShiftModifier);
        QTRY_VERIFY(panel().isVisible());
        QVERIFY(says("Open a mesh to list its faces."));
    }

private:
    /// The grid in a table as it is at first.
    void open()
    {
        const bool isNew = m_window == nullptr;
        if (isNew) {
            openWindow();
        }
        openGrid();
        if (isNew) {
            press(Qt::Key_F8, Qt::ShiftModifier);
        }
        m_window->settings().setLook({});
        m_window->inspection().letGo();
        m_window->messages().dismiss();
        panel().findChild<QLineEdit*>()->clear();
        table().sortByColumn(0, Qt::AscendingOrder);
        QTRY_COMPARE(model().rowCount(), 128);
        QTRY_VERIFY(!panel().listing().isBusy() && table().isVisible());
        table().scrollToTop();
        QSize before; // docks come gently
        do {
            before = table().size();
            QTest::qWait(30);
        } while (table().size() != before);
    }
    FacePanel& panel() { return *m_window->findChild<FacePanel*>(); }
    FaceTableModel& model() { return panel().model(); }
    FaceTableView& table() { return panel().table(); }
    QString text(std::uint32_t face, FaceColumn column)
    {
        const auto row = model().rowOf(FaceId{face});
        return row ? model().index(*row, int(column)).data().toString() : QString();
    }
    QPoint centreOf(int row) { return table().visualRect(model().index(row, 0)).center(); }
    void clickRow(int row, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        QTest::mouseClick(table().viewport(), Qt::LeftButton, modifiers, centreOf(row));
    }
    void clickHeader(FaceColumn column)
    {
        QHeaderView* header = table().horizontalHeader();
        table().scrollTo(model().index(0, int(column)));
        const int x = header->sectionViewportPosition(int(column)) + 20;
        QTest::mouseClick(
            header->viewport(), Qt::LeftButton, Qt::NoModifier, {x, header->height() / 2});
    }
    void filter(const QString& typed)
    {
        auto* field = panel().findChild<QLineEdit*>();
        field->setFocus();
        field->selectAll();
        if (typed.isEmpty()) {
            QTest::keyClick(field, Qt::Key_Delete);
        }
        QTest::keyClicks(field, typed);
    }
    bool says(const QString& part)
    {
        const auto labels = panel().findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
            return label->isVisible() && label->text().contains(part);
        });
    }
    std::vector<FaceId> selected()
    {
        const auto faces = m_window->selection().faces();
        return {faces.begin(), faces.end()};
    }
    static std::vector<FaceId> faces(std::initializer_list<std::uint32_t> numbers)
    {
        std::vector<FaceId> faces;
        for (const std::uint32_t number : numbers) {
            faces.push_back(FaceId{number});
        }
        return faces;
    }
};

} // namespace trixel::ui

TRIXEL_WINDOW_TEST_MAIN(trixel::ui::FaceTableTest)
#include "tst_face_table.moc"
