// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDialogButtonBox>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>

#include "core/io/ptx.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/dialogs/export_dialog.h"
#include "ui/dialogs/new_dialog.h"
#include "ui/window/recent_files.h"

namespace trixel::ui {

class FileActionsTest : public WindowTest
{
    Q_OBJECT

private slots:
    void init() { openWindow(); }
    void cleanup() { closeWindow(); }

    void newFromMeshSaveReopenIsEqual()
    {
        writeFile(path("square.obj"), kSquareObj);
        press(Qt::Key_N, Qt::ControlModifier);
        QTRY_VERIFY(openDialog<NewDialog>());
        auto* dialog = openDialog<NewDialog>();
        QTest::keyClicks(widgetNamed<QLineEdit>(*dialog, "Mesh file"), path("square.obj"));
        auto* create = widgetNamed<QPushButton>(*dialog, "Create");
        QTRY_VERIFY(create->isEnabled());
        QTest::mouseClick(create, Qt::LeftButton);
        QTRY_COMPARE(document().texels().faceCount(), 2U);
        QCOMPARE(m_window->windowTitle(), QString("square[*] – Trixel"));

        const TexelStore unpainted = document().texels();
        paintAcrossTheView();
        QCOMPARE(document().undoStack().undoText(), QString("Brush stroke"));
        QCOMPARE(facesThatDiffer(document().texels(), unpainted).size(), std::size_t{2});
        QVERIFY(m_window->isWindowModified());
        const std::vector<std::byte> painted = allTexels(document().texels());
        saveAs("painted");
        QVERIFY(!m_window->isWindowModified());
        QCOMPARE(m_window->windowTitle(), QString("painted.trixel[*] – Trixel"));

        document().open(gridProject(), {}, "other");
        m_window->open(path("painted.trixel"));
        QTRY_COMPARE(m_window->windowTitle(), QString("painted.trixel[*] – Trixel"));
        QVERIFY(allTexels(document().texels()) == painted);
    }

    void saveKeyWritesTheKnownFileWithoutAsking()
    {
        openGrid();
        saveAs("grid");
        fillFace(5);
        press(Qt::Key_S, Qt::ControlModifier);
        QTRY_VERIFY(!document().isModified());
        QVERIFY(!openDialog<QFileDialog>());
        NoProgress progress;
        const Result<Project> saved = openProject(path("grid.trixel").toStdString(), progress);
        QVERIFY(saved.has_value());
        QVERIFY(allTexels(saved->texels) == allTexels(document().texels()));
    }

    void exportWritesAPtxThatReadsBack()
    {
        openGrid();
        fillFace(5);
        press(Qt::Key_E, Qt::ControlModifier);
        QTRY_VERIFY(openDialog<ExportDialog>());
        auto* dialog = openDialog<ExportDialog>();
        auto* destination = widgetNamed<QLineEdit>(*dialog, "Destination");
        QCOMPARE(destination->text(), path("grid.ptx"));
        QTest::mouseClick(widgetNamed<QPushButton>(*dialog, "Export"), Qt::LeftButton);
        QTRY_VERIFY(m_window->messages().sentence().startsWith("Exported grid.ptx"));
        NoProgress progress;
        const Result<PtxContents> contents = readPtx(path("grid.ptx").toStdString(), progress);
        QVERIFY(contents.has_value());
        QVERIFY(allTexels(contents->texels) == allTexels(document().texels()));
    }

    void exportWritesAMeshWithUvsAndRepeatsItWithOneKey()
    {
        openGrid();
        fillFace(5);
        press(Qt::Key_E, Qt::ControlModifier);
        QTRY_VERIFY(openDialog<ExportDialog>());
        auto* dialog = openDialog<ExportDialog>();
        auto* destination = widgetNamed<QLineEdit>(*dialog, "Destination");
        destination->setText(path("grid.glb"));
        QTRY_VERIFY(widgetNamed<QPushButton>(*dialog, "Export")->isEnabled());
        QTest::mouseClick(widgetNamed<QPushButton>(*dialog, "Export"), Qt::LeftButton);
        QTRY_VERIFY(m_window->messages().sentence().startsWith("Exported grid.glb"));
        QVERIFY(m_window->messages().sentence().contains("of 255"));
        QVERIFY(QFile::remove(path("grid.glb")));
        press(Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(QFileInfo::exists(path("grid.glb")));
        // The dialog begins with what was written last.
        press(Qt::Key_E, Qt::ControlModifier);
        QTRY_VERIFY(openDialog<ExportDialog>());
        QCOMPARE(widgetNamed<QLineEdit>(*openDialog<ExportDialog>(), "Destination")->text(),
                 path("grid.glb"));
        openDialog<ExportDialog>()->reject();
    }

    void brokenFileShowsTheSentenceAndChangesNothing()
    {
        openGrid();
        const std::vector<std::byte> before = allTexels(document().texels());
        writeFile(path("bad.obj"), "v 0 0 zero\n");
        m_window->open(path("bad.obj"));
        MessageBar& messages = m_window->messages();
        QTRY_VERIFY(messages.isVisible());
        QCOMPARE(messages.kind(), MessageBar::Kind::Error);
        QVERIFY2(messages.sentence().contains("bad.obj"), qPrintable(messages.sentence()));
        QVERIFY(allTexels(document().texels()) == before);
        QCOMPARE(m_window->windowTitle(), QString("grid[*] – Trixel"));
        QTest::mouseClick(widgetNamed<QWidget>(messages, "Close message"), Qt::LeftButton);
        QVERIFY(!messages.isVisible());
        m_window->open(path("bad.obj"));
        QTRY_VERIFY(messages.isVisible());
    }

    void closingUnsavedAsksAndCancelStays()
    {
        openGrid();
        fillFace(5);
        m_window->close();
        QTRY_VERIFY(openDialog<QMessageBox>());
        QVERIFY(openDialog<QMessageBox>()->text().contains("grid"));
        answer(QMessageBox::Cancel);
        QCoreApplication::processEvents();
        QVERIFY(m_window->isVisible());
        QVERIFY(document().isModified());
    }

    void closingUnsavedCanDiscard()
    {
        openGrid();
        fillFace(5);
        m_window->close();
        QTRY_VERIFY(openDialog<QMessageBox>());
        answer(QMessageBox::Discard);
        QTRY_VERIFY(!m_window->isVisible());
    }

    void closingUnsavedCanSaveFirst()
    {
        openGrid();
        saveAs("grid");
        fillFace(5);
        m_window->close();
        QTRY_VERIFY(openDialog<QMessageBox>());
        answer(QMessageBox::Save);
        QTRY_VERIFY(!m_window->isVisible());
        NoProgress progress;
        const Result<Project> saved = openProject(path("grid.trixel").toStdString(), progress);
        QVERIFY(allTexels(saved->texels) == allTexels(document().texels()));
    }

    void closingWaitsForAnExport()
    {
        m_window->document().open(gridProject(64, 4), {}, "grid");
        m_window->files().exportAs(
            {path("grid.ptx").toStdString(), PtxExportOptions{TexelType::Float, true}, {}});
        QVERIFY(m_window->files().isExporting());
        m_window->close();
        m_window->close(); // an impatient user
        QVERIFY(m_window->isVisible());
        QTRY_VERIFY(!m_window->isVisible());
        NoProgress progress;
        QVERIFY(readPtx(path("grid.ptx").toStdString(), progress).has_value());
    }

    void closingWhileSavingAsksNothingWhenAllIsSaved()
    {
        m_window->document().open(gridProject(64, 4), {}, "grid");
        fillFace(3);
        m_window->files().save(path("grid.trixel"));
        QVERIFY(m_window->files().isSaving());
        m_window->close();
        QTRY_VERIFY(!m_window->isVisible());
        QVERIFY(!openDialog<QMessageBox>());
        NoProgress progress;
        const Result<Project> saved = openProject(path("grid.trixel").toStdString(), progress);
        QVERIFY(allTexels(saved->texels) == allTexels(document().texels()));
    }

    void closingWithoutChangesAsksNothing()
    {
        openGrid();
        m_window->close();
        QTRY_VERIFY(!m_window->isVisible());
    }

    void failedSaveKeepsTheWindowOpen()
    {
        openGrid();
        saveAs("grid");
        fillFace(5);
        document().markSaved("/nowhere/grid.trixel", document().openedState());
        m_window->close();
        QTRY_VERIFY(openDialog<QMessageBox>());
        answer(QMessageBox::Save);
        QTRY_VERIFY(m_window->messages().isVisible());
        QVERIFY(m_window->isVisible());
        QVERIFY(document().isModified());
    }

    void openingOverUnsavedChangesAsksFirst()
    {
        openGrid();
        fillFace(5);
        writeFile(path("square.obj"), kSquareObj);
        m_window->open(path("square.obj"));
        QTRY_VERIFY(openDialog<QMessageBox>());
        answer(QMessageBox::Discard);
        QTRY_COMPARE(document().texels().faceCount(), 2U);
    }

    void recentFilesOfferWhatWasOpenedAndGreyWhatIsGone()
    {
        writeFile(path("a.obj"), kSquareObj);
        writeFile(path("b.obj"), kSquareObj);
        for (const char* name : {"a", "b"}) {
            m_window->open(path(QString(name) + ".obj"));
            QTRY_COMPARE(document().title(), QString(name));
        }
        QFile::remove(path("a.obj"));
        QMenu* menu = actionNamed(*m_window, "Open Recent")->menu();
        emit menu->aboutToShow();
        const QList<QAction*> actions = menu->actions();
        QVERIFY(actions[0]->text().contains("b.obj") && actions[0]->isEnabled());
        QVERIFY(actions[1]->text().contains("a.obj") && !actions[1]->isEnabled());

        openGrid();
        actions[0]->trigger();
        QTRY_COMPARE(document().title(), QString("b"));
    }

    void recentFilesAreFewAndEachOnce()
    {
        RecentFiles recent;
        for (int k = 0; k < 20; ++k) {
            recent.add(path(QString::number(k)));
        }
        recent.add(path("15"));
        QCOMPARE(recent.paths().size(), RecentFiles::kMax);
        QCOMPARE(recent.paths().first(), path("15"));
        QCOMPARE(recent.paths().count(path("15")), 1);
    }

    void droppedMeshOpens()
    {
        writeFile(path("square.obj"), kSquareObj);
        drop({path("square.obj")});
        QTRY_COMPARE(document().texels().faceCount(), 2U);
        QVERIFY(m_window->messages().sentence().contains("2 faces"));
    }

    void droppedPtxAndItsMeshOpenTogether()
    {
        NoProgress progress;
        TriangleMesh mesh;
        mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
        mesh.triangles = {{0, 1, 2}, {3, 2, 1}};
        const Adjacency adjacency = buildAdjacency(mesh.triangles);
        const std::array fill{std::byte{9}, std::byte{8}, std::byte{7}};
        const PtxContents bare{TexelStore(2, {}, Level(2), fill), adjacency, {}, true};
        QVERIFY(writePtx(path("bare.ptx").toStdString(), bare, {}, progress).has_value());
        writeFile(path("square.obj"), kSquareObj);

        drop({path("bare.ptx")});
        QTRY_VERIFY(m_window->messages().sentence().contains("does not carry its mesh"));
        QVERIFY(widgetNamed<QPushButton>(m_window->messages(), "Choose Mesh…"));
        drop({path("bare.ptx"), path("square.obj")});
        QTRY_COMPARE(document().texels().faceCount(), 2U);
        QCOMPARE(int(document().texels().face(FaceId{1}).texel(0)[0]), 9);
        QVERIFY(!m_window->messages().isVisible());
    }

    void droppedFileOfAnotherKindShowsASentence()
    {
        writeFile(path("notes.txt"), "x");
        drop({path("notes.txt")});
        QTRY_VERIFY(m_window->messages().sentence().contains("notes.txt"));
    }

private:
    void paintAcrossTheView()
    {
        Viewport& view = m_window->viewport();
        QVERIFY(view.canDraw());
        const QPoint middle = view.rect().center();
        QTest::mousePress(&view, Qt::LeftButton, {}, middle - QPoint(60, 60));
        for (int k = -50; k <= 60; k += 10) {
            QTest::mouseMove(&view, middle + QPoint(k, k));
        }
        QTest::mouseRelease(&view, Qt::LeftButton, {}, middle + QPoint(60, 60));
    }

    void saveAs(const QString& name)
    {
        press(Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(openDialog<QFileDialog>());
        auto* dialog = openDialog<QFileDialog>();
        auto* edit = dialog->findChild<QLineEdit*>("fileNameEdit");
        edit->setText(path(name)); // typed keys would open a list of completions over the button
        QSignalSpy saved(&m_window->files(), &ProjectFiles::saved);
        auto* buttons = dialog->findChild<QDialogButtonBox*>();
        QTest::mouseClick(buttons->button(QDialogButtonBox::Save), Qt::LeftButton);
        QTRY_COMPARE(saved.count(), 1);
        QTRY_VERIFY(!openDialog<QFileDialog>());
    }

    void answer(QMessageBox::StandardButton button)
    {
        QTest::mouseClick(openDialog<QMessageBox>()->button(button), Qt::LeftButton);
    }

    void drop(const QStringList& paths)
    {
        QMimeData data;
        QList<QUrl> urls;
        for (const QString& file : paths) {
            urls += QUrl::fromLocalFile(file);
        }
        data.setUrls(urls);
        const QPoint middle = m_window->rect().center();
        QDragEnterEvent enter(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(m_window.get(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent event(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(m_window.get(), &event);
        QVERIFY(event.isAccepted());
    }
};

} // namespace trixel::ui

TRIXEL_WINDOW_TEST_MAIN(trixel::ui::FileActionsTest)
#include "tst_file_actions.moc"
