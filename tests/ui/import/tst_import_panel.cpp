// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bringing an image in, from the command to the texels, as the user does it.
#include <QCheckBox>
#include <QDragEnterEvent>
#include <QLabel>
#include <QMimeData>
#include <QStandardItemModel>

#include "core/mapping/projection.h"
#include "core/mapping/sphere_mapping.h"
#include "core/mapping/uv_mapping.h"
#include "core/study/views/camera_clip.h"
#include "tests/ui/document/layered_fixture.h"
#include "tests/ui/import/import_fixture.h"

namespace trixel::ui {

class ImportPanelTest : public ImportTest
{
    Q_OBJECT

private slots:
    void init()
    {
        openWindow();
        openGrid();
    }
    void cleanup() { closeWindow(); }

    void theCommandOpensThePanelForTheKeyboard()
    {
        QVERIFY(!panel().isVisible());
        openPanel();
        QVERIFY(panel().isAncestorOf(QApplication::focusWidget()));
        QVERIFY(!button("Apply the import")->isEnabled());
        QVERIFY2(state().contains("Choose an image"), qPrintable(state()));
    }

    void whatIsInTheImageIsSaid()
    {
        openPanel();
        typePath(path("photo.png"));
        QTRY_VERIFY2(text("About the image").contains("64 × 48"),
                     qPrintable(text("About the image")));
        QVERIFY2(text("About the image").contains("3 channels of uint8, sRGB"),
                 qPrintable(text("About the image")));
    }

    void aPlanesTexelsAreThoseThatCoreBakes()
    {
        openPanelWith("Plane");
        waitForPreview();
        // The square from (0,0) to (1,1), covered by an image of 4 : 3.
        const Projection plane =
            planarProjection({0.5 - 2.0 / 3, 0, 0}, {4.0 / 3, 0, 0}, {0, 1, 0}).value();
        const ProjectionMapping mapping(document().surface()->mesh(), plane, nullptr);
        const std::vector<std::byte> expected = baked(mapping, allFaces());
        QVERIFY(!expected.empty());
        apply();
        QVERIFY(allTexels(document().texels()) == expected);
        QCOMPARE(document().undoStack().undoText(), QString("Import image photo.png"));
    }

    void withLayersAnImageIsOneMoreAboveTheActiveOne()
    {
        const LayerId lower = addLayer(document(), "Layer 1");
        fillFace(7);
        addLayer(document(), "Layer 2");
        document().setActiveLayer(lower);
        const LayersPicture before = pictureOf(document());
        openPanelWith("Plane");
        waitForPreview();
        const auto tells = [&] {
            const QString said = widgetNamed<QLabel>(panel(), "State of the import")->text();
            return said.endsWith(" it will lie right above Layer 1.");
        };
        QVERIFY(tells()); // the preview lies over all
        document().setActiveLayer(document().layers().layers().back().id);
        QVERIFY(!tells());
        document().setActiveLayer(lower);
        QVERIFY(tells());
        const std::vector<std::byte> expected = allTexels(panel().picture()->texels);
        apply();
        const auto layers = document().layers().layers();
        QCOMPARE(layers.size(), std::size_t{3});
        QCOMPARE(layers[1].settings.name, std::string("photo"));
        QCOMPARE(document().activeLayer(), layers[1].id);
        QCOMPARE(allTexels(document().layers().base()), before.texels[0]);
        QVERIFY(allTexels(document().texels()) == expected);
        QVERIFY(isShown(document()));
        document().undoStack().undo();
        QVERIFY(pictureOf(document()) == before);
        QCOMPARE(document().activeLayer(), lower);
    }

    void aSpheresTexelsAreThoseThatCoreBakes()
    {
        openPanelWith("Sphere");
        type("Centre of the sphere, Z", "-1.5");
        type("Turn of the sphere", "30");
        choose("How the image is looked up", "Bilinear");
        choose("Where the image ends", "At pixel centres");
        waitForPreview();
        SamplerOptions options{
            ImageLookup::Bilinear, TableIndex::Corners, ImageWrap::Repeat, ImageWrap::Clamp};
        const SphereMapping mapping(
            document().surface()->mesh(), {0.5, 0.5, -1.5}, sphereTurn({0, 1, 0}, 30).value());
        const std::vector<std::byte> expected = baked(mapping, allFaces(), options);
        apply();
        QVERIFY(allTexels(document().texels()) == expected);
    }

    void uvsTexelsAreThoseThatCoreBakes()
    {
        NoProgress progress;
        TriangleMesh mesh = gridMesh(4);
        for (const Triangle& triangle : mesh.triangles) {
            for (const std::uint32_t vertex : triangle) {
                mesh.cornerUvs.push_back(glm::vec2(mesh.positions[vertex]));
            }
        }
        const LevelPlan plan = planUniform(mesh.faceCount(), Level(3));
        const std::vector<float> fill{0.8F, 0.8F, 0.8F};
        document().open(newProject(mesh, plan, {}, fill, progress).value(), {}, "with uvs");
        openPanel();
        QVERIFY(widgetNamed<QComboBox>(panel(), "How the image lies on the surface")
                    ->currentText()
                    .startsWith("By the mesh’s uvs"));
        typePath(path("photo.png"));
        waitForPreview();
        const UvMapping mapping(document().surface()->mesh());
        const std::vector<std::byte> expected = baked(mapping, allFaces());
        apply();
        QVERIFY(allTexels(document().texels()) == expected);
    }

    void uvsThatTheMeshLacksCannotBeChosenAndThatIsSaid()
    {
        openPanel();
        auto* kinds = widgetNamed<QComboBox>(panel(), "How the image lies on the surface");
        const auto* model = qobject_cast<QStandardItemModel*>(kinds->model());
        QVERIFY(!model->item(0)->isEnabled());
        QVERIFY2(kinds->itemText(0).contains("none"), qPrintable(kinds->itemText(0)));
        QVERIFY2(model->item(0)->toolTip().contains("no uvs"),
                 qPrintable(model->item(0)->toolTip()));
    }

    void thePreviewIsSeenAndNothingIsChangedByIt()
    {
        const std::vector<std::byte> before = allTexels(document().texels());
        openPanelWith("Plane");
        waitForPreview();
        QVERIFY(m_window->viewport().showsOtherTexels());
        QVERIFY2(state().contains("128 faces") && state().contains("8,192 texels"),
                 qPrintable(state()));
        const QColor middle(130, 120, 0); // about what the picture has there
        QTRY_VERIFY(std::abs(seenInTheMiddle().red() - middle.red()) < 60);
        auto* beforeChoice = widgetNamed<QRadioButton>(panel(), "Show the texels as they are");
        QTest::mouseClick(beforeChoice, Qt::LeftButton, {}, QPoint(8, beforeChoice->height() / 2));
        QVERIFY(!m_window->viewport().showsOtherTexels());
        QVERIFY(allTexels(document().texels()) == before);
        QCOMPARE(document().undoStack().count(), 0);
    }

    void thePreviewIsTheVeryResult()
    {
        openPanelWith("Plane");
        waitForPreview();
        const auto picture = panel().picture();
        apply();
        QVERIFY(allTexels(picture->texels) == allTexels(document().texels()));
    }

    void oneUndoStepBringsBackTheVeryBits()
    {
        fillFace(3);
        const std::vector<std::byte> before = allTexels(document().texels());
        openPanelWith("Plane");
        waitForPreview();
        apply();
        const std::vector<std::byte> after = allTexels(document().texels());
        QVERIFY(after != before);
        QTRY_VERIFY(!panel().isVisible());
        press(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(allTexels(document().texels()) == before);
        press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(allTexels(document().texels()) == after);
    }

    void closingThePanelLeavesAllAsItWas()
    {
        const std::vector<std::byte> before = allTexels(document().texels());
        openPanelWith("Plane");
        waitForPreview();
        click("Close without importing");
        QTRY_VERIFY(!panel().isVisible());
        QVERIFY(!m_window->viewport().showsOtherTexels());
        QVERIFY(allTexels(document().texels()) == before);
        QCOMPARE(document().undoStack().count(), 0);
        QVERIFY(!document().isModified());
    }

    void cancellingTheWorkLeavesAllAsItWas()
    {
        document().open(gridProject(8, 7), {}, "fine"); // 2 million texels
        openPanelWith("Plane");
        waitForPreview(false);
        click("Apply the import");
        QVERIFY(panel().isApplying());
        click("Cancel the import");
        QTRY_VERIFY_WITH_TIMEOUT(!panel().isApplying(), 30000);
        QCOMPARE(document().undoStack().count(), 0);
        QVERIFY(facesThatDiffer(document().texels(), gridProject(8, 7).texels).empty());
        QVERIFY(panel().isVisible());
    }

    void onlySelectedFacesAreTouchedIfChosen()
    {
        m_window->selection().set({faceId(2), faceId(5)});
        const TexelStore before = document().texels();
        openPanelWith("Plane");
        choose("Faces that the image is laid onto", "Selected: 2");
        waitForPreview();
        apply();
        const std::set<FaceId> expected{faceId(2), faceId(5)};
        QVERIFY(facesThatDiffer(before, document().texels()) == expected);
    }

    void noSelectedFacesIsOneSentence()
    {
        openPanelWith("Plane");
        choose("Faces that the image is laid onto", "Selected: 0");
        QTRY_VERIFY2(state().contains("No faces are selected"), qPrintable(state()));
        QVERIFY(!button("Apply the import")->isEnabled());
    }

    void anImageThatReachesNothingIsOneSentence()
    {
        openPanelWith("Plane");
        waitForPreview();
        type("Centre of the plane, X", "100");
        QTRY_VERIFY2(problem().contains("reaches no texel"), qPrintable(problem()));
        QVERIFY(!button("Apply the import")->isEnabled());
        QVERIFY(!m_window->viewport().showsOtherTexels());
        type("Centre of the plane, X", "0.5");
        waitForPreview();
        QVERIFY(problem().isEmpty());
        QVERIFY(button("Apply the import")->isEnabled());
    }

    void hostileImagesAreOneSentenceBesideTheField_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<QString>("word");
        QTest::newRow("empty") << QByteArray() << "The file is empty.";
        QTest::newRow("text") << QByteArray(200, 'x') << "Expected an image";
        QTest::newRow("huge") << hugePng() << "It is damaged";
    }
    void hostileImagesAreOneSentenceBesideTheField()
    {
        QFETCH(QByteArray, bytes);
        QFETCH(QString, word);
        writeFile(path("huge.png"), bytes);
        openPanelWith("Plane", "huge.png");
        QTRY_VERIFY2(!text("About the image").contains("Reading") &&
                         text("About the image").contains(word),
                     qPrintable(text("About the image")));
        QVERIFY(text("About the image").endsWith('.'));
        QVERIFY(!text("About the image").contains('\n'));
        QVERIFY(!button("Apply the import")->isEnabled());
        typePath(path("photo.png")); // all is well again
        waitForPreview();
        QVERIFY(button("Apply the import")->isEnabled());
    }

    void aFileThatIsNotThereIsOneSentence()
    {
        openPanelWith("Plane", "nowhere.png");
        QTRY_VERIFY2(text("About the image").contains("no such file"),
                     qPrintable(text("About the image")));
        QVERIFY(!button("Apply the import")->isEnabled());
    }

    void texelsThatChangeMeanwhileAreKept()
    {
        document().open(gridProject(8, 7), {}, "fine");
        openPanelWith("Plane");
        waitForPreview(false);
        click("Apply the import");
        fillFace(0);
        QTRY_VERIFY_WITH_TIMEOUT(!panel().isApplying(), 60000);
        QCOMPARE(document().undoStack().count(), 1); // the fill alone
        QVERIFY2(m_window->messages().sentence().contains("has changed meanwhile"),
                 qPrintable(m_window->messages().sentence()));
    }

    void paintingGoesOnUnderThePreview()
    {
        openPanelWith("Plane");
        waitForPreview();
        fillFace(0);
        QVERIFY(!m_window->viewport().showsOtherTexels()); // for now
        QTRY_VERIFY(m_window->viewport().showsOtherTexels());
        QCOMPARE(document().undoStack().count(), 1);
    }

    void aDroppedImageOpensThePanel()
    {
        writePicture("dropped.png", 20, 10);
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path("dropped.png"))});
        const QPoint middle(400, 400);
        QDragEnterEvent enter(middle, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(m_window.get(), &enter);
        QDropEvent drop(QPointF(middle), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(m_window.get(), &drop);
        QTRY_VERIFY(panel().isVisible());
        QTRY_VERIFY2(text("About the image").contains("20 × 10"),
                     qPrintable(text("About the image")));
        QCOMPARE(document().title(), QString("grid")); // still open
    }

    void anotherProjectTakesThePanelAlong()
    {
        openPanelWith("Plane");
        waitForPreview();
        document().open(gridProject(2, 2), {}, "other"); // 8 faces of 16 texels
        QTRY_VERIFY2(state().contains("8 faces with 128 texels"), qPrintable(state()));
        apply();
    }

    void opacityLetsThePaintBelowThrough()
    {
        openPanelWith("Plane");
        type("Opacity of the image", "0");
        QTRY_VERIFY2(problem().contains("reaches no texel"), qPrintable(problem()));
        type("Opacity of the image", "50");
        waitForPreview();
        apply();
    }

private:
    QColor seenInTheMiddle()
    {
        Viewport& view = m_window->viewport();
        view.settle();
        const QImage image = view.grabFramebuffer();
        return image.pixelColor(image.width() / 2, image.height() / 2);
    }
    /// A header alone, of 2^31 - 1 pixels across.
    static QByteArray hugePng()
    {
        return QByteArray::fromHex("89504e470d0a1a0a0000000d494844527fffffff7fffffff0802000000"
                                   "9bab9c31");
    }
};

} // namespace trixel::ui

TRIXEL_WINDOW_TEST_MAIN(trixel::ui::ImportPanelTest)
#include "tst_import_panel.moc"
