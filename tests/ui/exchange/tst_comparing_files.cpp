// SPDX-License-Identifier: GPL-3.0-or-later
//
// File > Compare…, driven as a user does.
#include <QCheckBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QSignalSpy>
#include <QTableView>

#include "core/study/views/view_map.h"
#include "tests/ui/exchange/exchange_fixture.h"
#include "ui/exchange/compare_dialog.h"
#include "ui/exchange/difference_model.h"
#include "ui/exchange/difference_panel.h"
#include "ui/viewport/map_legend.h"
#include "ui/viewport/view_map.h"

namespace trixel::ui {

class ComparingFilesTest : public ExchangeTest
{
    Q_OBJECT

private slots:
    void init()
    {
        openWindow();
        m_window->resize(900, 600);
        openPainted();
    }
    void cleanup() { closeWindow(); }

    void everyFaceThatDiffersIsListedWorstFirst()
    {
        compareWith(changed());
        DifferencePanel& found = panel();
        QTRY_COMPARE(found.model().rowCount(), 3);
        QCOMPARE(found.model().differenceAt(0).face, FaceId{40}); // all of it
        QCOMPARE(found.model().differenceAt(1).face, FaceId{9});  // of another level
        QCOMPARE(found.model().differenceAt(2).face, FaceId{20}); // one texel
        const QString summary = textOf(found, "What differs");
        QVERIFY2(summary.contains("3 of 128 faces differ, 1 of another level"),
                 qPrintable(summary));
        QVERIFY2(summary.contains("PSNR"), qPrintable(summary));
        QCOMPARE(found.model().index(2, DifferenceModel::Texels).data().toInt(), 1);
        QCOMPARE(found.model().index(1, DifferenceModel::Levels).data().toString(),
                 QString("3 | 4"));
    }

    void theMapShowsTheDifferenceOfEachFace()
    {
        compareWith(changed());
        ViewMap& map = m_window->viewMap();
        QTRY_VERIFY(map.isComplete());
        QCOMPARE(m_window->settings().view().map, ViewMapKind::Difference);
        QVERIFY(map.legend().title().contains("other.ptx"));
        QVERIFY(m_window->viewport().hasFaceColors());
        m_window->viewport().frameFace(FaceId{40});
        const QPointF middle = m_window->viewport().rect().center();
        const auto at = m_window->viewport().surfacePointAt(middle);
        QVERIFY(at.has_value());
        const auto value = map.valueAt(middle);
        QVERIFY(value.has_value());
        QCOMPARE(*value, panel().comparison()->rms[at->face]);
        QCOMPARE(panel().comparison()->rms[FaceId{40}],
                 static_cast<float>(panel().model().differenceAt(0).rms));
        QCOMPARE(panel().comparison()->rms[FaceId{1}], 0.0F);
        // Gone with another map, and back.
        press(Qt::Key_1, Qt::ControlModifier);
        QVERIFY(!m_window->viewport().hasFaceColors());
        actionNamed(*m_window, "Difference from File")->trigger();
        QTRY_VERIFY(m_window->viewport().hasFaceColors());
    }

    void aClickOnARowSelectsTheFaceAndGoesThere()
    {
        compareWith(changed());
        QTRY_COMPARE(panel().model().rowCount(), 3);
        auto* table = widgetNamed<QTableView>(panel(), "Faces by their difference");
        QVERIFY(table != nullptr);
        const render::CameraPose before = m_window->viewport().camera().pose();
        QTest::mouseClick(table->viewport(),
                          Qt::LeftButton,
                          {},
                          table->visualRect(panel().model().index(2, 0)).center());
        QVERIFY(m_window->selection().contains(FaceId{20}));
        QCOMPARE(m_window->selection().faces().size(), std::size_t{1});
        QVERIFY(!(m_window->viewport().camera().pose() == before));
        QTest::mouseClick(widgetNamed<QPushButton>(panel(), "Select all faces that differ"),
                          Qt::LeftButton);
        QCOMPARE(m_window->selection().faces().size(), std::size_t{3});
    }

    void aClickOnAHeaderSorts()
    {
        compareWith(changed());
        QTRY_COMPARE(panel().model().rowCount(), 3);
        auto* table = widgetNamed<QTableView>(panel(), "Faces by their difference");
        QHeaderView* header = table->horizontalHeader();
        QTest::mouseClick(header->viewport(),
                          Qt::LeftButton,
                          {},
                          {header->sectionViewportPosition(DifferenceModel::Face) + 8, 8});
        QTRY_VERIFY(panel().model().differenceAt(0).face == FaceId{9} ||
                    panel().model().differenceAt(0).face == FaceId{40});
        QTRY_VERIFY(!panel().model().isSorting());
        const auto face = [&](int row) { return panel().model().differenceAt(row).face; };
        QVERIFY((face(0) < face(1) && face(1) < face(2)) ||
                (face(0) > face(1) && face(1) > face(2)));
    }

    void theSameTexelsDifferNowhere()
    {
        compareWith(document().snapshot());
        QTRY_VERIFY(panel().comparison() != nullptr);
        QVERIFY(textOf(panel(), "What differs").contains("no texel differs"));
        QVERIFY(panel().comparison()->diff.faces.empty());
        fillFace(2);
        QVERIFY(textOf(panel(), "What differs").contains("changed since"));
        QTest::mouseClick(widgetNamed<QPushButton>(panel(), "Compare again"), Qt::LeftButton);
        QTRY_COMPARE(panel().comparison()->diff.faces.size(), std::size_t{1});
    }

    void facesInAnotherOrderAreOfferedTheirMatch()
    {
        const QString file = writePtx("other.ptx", reversed(document().snapshot()));
        CompareDialog& dialog = ask(file);
        auto* match = widgetNamed<QCheckBox>(dialog, "Match its faces to this mesh's");
        QTRY_VERIFY((match = widgetNamed<QCheckBox>(dialog, "Match its faces to this mesh's")) !=
                    nullptr);
        QVERIFY(match->isChecked());
        const QString about = textOf(dialog, "About the second file");
        QVERIFY2(about.contains("by their positions: 128 of 128 faces"), qPrintable(about));
        QTest::mouseClick(widgetNamed<QPushButton>(dialog, "Compare"), Qt::LeftButton);
        QTRY_VERIFY(panel().comparison() != nullptr);
        QVERIFY(panel().comparison()->diff.faces.empty());
        QVERIFY(textOf(panel(), "What differs").contains("Matched by their positions"));
        // By number instead, as the box says.
        panel().compare(file, false);
        QTRY_VERIFY(!panel().comparison()->diff.faces.empty());
    }

    void whatDoesNotFitIsSaidBesideTheField()
    {
        CompareDialog& dialog = ask({});
        auto* compare = widgetNamed<QPushButton>(dialog, "Compare");
        auto* field = widgetNamed<QLineEdit>(dialog, "Second file");
        const auto expectSaid = [&](const QString& file, const QString& words) {
            type(*field, file);
            QTRY_VERIFY2(textOf(dialog, "About the second file").contains(words),
                         qPrintable(textOf(dialog, "About the second file")));
            QVERIFY(!compare->isEnabled());
            QVERIFY(!textOf(dialog, "About the second file").contains('\n'));
        };
        expectSaid(path("none.ptx"), "none.ptx: ");
        expectSaid(writePtx("small.ptx", gridProject(4)),
                   "small.ptx: is a texture of 32 faces, the mesh has 128");
        expectSaid(writePtx("grey.ptx", grey()),
                   "grey.ptx: has 1 channel, this project 3 channels");
        writeFile(path("noise.ptx"), "Ptex, or so one would think, but nothing more");
        expectSaid(path("noise.ptx"), "noise.ptx: ");
        type(*field, writePtx("fits.ptx", gridProject()));
        QTRY_VERIFY(compare->isEnabled());
        QVERIFY(textOf(dialog, "About the second file").contains("128 faces, uint8, 3 channels"));
    }

    void aFileThatIsDamagedFurtherInLeavesEverythingAsItWas()
    {
        const QString file = writePtx("other.ptx", changed());
        CompareDialog& dialog = ask(file);
        auto* compare = widgetNamed<QPushButton>(dialog, "Compare");
        QTRY_VERIFY(compare->isEnabled());
        QVERIFY(QFile::remove(file)); // meanwhile
        QTest::mouseClick(compare, Qt::LeftButton);
        QTRY_VERIFY(m_window->messages().sentence().startsWith("other.ptx"));
        QVERIFY(panel().comparison() == nullptr);
        QVERIFY(m_window->viewMap().legend().state().contains("Nothing was compared"));
    }

    void anotherDocumentForgetsTheComparison()
    {
        compareWith(changed());
        QTRY_VERIFY(panel().comparison() != nullptr);
        openGrid();
        QVERIFY(panel().comparison() == nullptr);
        QVERIFY(!m_window->viewport().hasFaceColors());
    }

    void comparingCanBeCancelled()
    {
        const QString file = writePtx("other.ptx", changed());
        panel().compare(file, false);
        QVERIFY(m_window->jobs().latest() != nullptr);
        m_window->jobs().latest()->cancel();
        QTRY_VERIFY(m_window->jobs().isIdle());
        QVERIFY(panel().comparison() == nullptr);
        QVERIFY(m_window->messages().sentence().isEmpty());
    }

private:
    DifferencePanel& panel() { return *m_window->findChild<DifferencePanel*>(); }

    /// The document with three other faces.
    Project changed()
    {
        Project other = document().snapshot();
        const std::array black{std::byte{0}, std::byte{0}, std::byte{0}};
        other.texels.exchange(FaceId{40}, FaceTexels::constant(Level(3), black));
        other.texels.writable(FaceId{20})[3 * 11] = std::byte{255};
        const std::array red{std::byte{60}, std::byte{100}, std::byte{50}};
        other.texels.exchange(FaceId{9}, FaceTexels::constant(Level(4), red));
        return other;
    }
    Project grey()
    {
        Project project = gridProject();
        project.texels = TexelStore(
            128, TexelFormat{TexelType::UInt8, 1, {}}, Level(1), std::array{std::byte{9}});
        return project;
    }
    /// The same surface with its faces in the opposite order.
    static Project reversed(const Project& project)
    {
        NoProgress progress;
        TriangleMesh mesh = project.surface->mesh();
        std::ranges::reverse(mesh.triangles);
        Project other;
        other.surface = Surface::build(std::move(mesh), progress).value();
        other.texels = project.texels;
        const std::uint32_t count = project.texels.faceCount();
        for (std::uint32_t k = 0; k < count; ++k) {
            other.texels.exchange(FaceId{k}, project.texels.face(FaceId{count - 1 - k}));
        }
        return other;
    }
    CompareDialog& ask(const QString& file)
    {
        actionNamed(*m_window, "Compare…")->trigger();
        auto* dialog = openDialog<CompareDialog>();
        check(dialog != nullptr, "the dialog is open");
        if (!file.isEmpty()) {
            type(*widgetNamed<QLineEdit>(*dialog, "Second file"), file);
        }
        return *dialog;
    }
    void compareWith(const Project& project)
    {
        CompareDialog& dialog = ask(writePtx("other.ptx", project));
        auto* compare = widgetNamed<QPushButton>(dialog, "Compare");
        QTRY_VERIFY(compare->isEnabled());
        QTest::keyClick(&dialog, Qt::Key_Return);
        QTRY_VERIFY(panel().comparison() != nullptr);
        QVERIFY(panel().isVisible());
    }
};

} // namespace trixel::ui

TRIXEL_WINDOW_TEST_MAIN(trixel::ui::ComparingFilesTest)
#include "tst_comparing_files.moc"
