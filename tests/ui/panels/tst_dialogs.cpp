// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>

#include "tests/ui/fixtures.h"
#include "ui/dialogs/export_dialog.h"
#include "ui/dialogs/export_estimate.h"
#include "ui/dialogs/format_choice.h"
#include "ui/dialogs/new_dialog.h"

namespace trixel::ui {

namespace {

template <class T>
T* named(const QWidget& parent, const QString& name)
{
    for (T* widget : parent.findChildren<T*>()) {
        if (widget->accessibleName() == name) {
            return widget;
        }
    }
    return nullptr;
}

/// Paints every face with noise that hardly compresses.
void paintNoise(TexelStore& texels)
{
    std::uint32_t state = 1;
    for (std::size_t k = 0; k < texels.faceCount(); ++k) {
        for (std::byte& byte : texels.writable(faceId(k))) {
            state = state * 1664525U + 1013904223U;
            byte = static_cast<std::byte>(state >> 24U);
        }
    }
}

/// The grid under "Moss", noise all over, and "Rust", which covers nothing.
Project layeredProject()
{
    Project project = gridProject();
    project.layers = LayerStack(project.texels);
    LayerSettings settings;
    settings.name = "Moss";
    const LayerId moss = project.layers.insert(0, settings);
    paintNoise(project.layers.texels(moss));
    settings.name = "Rust";
    project.layers.insert(1, settings);
    return project;
}

/// What Export asks for.
ExportRequest handedOver(ExportDialog& dialog)
{
    QSignalSpy wanted(&dialog, &ExportDialog::exportWanted);
    QTest::mouseClick(named<QPushButton>(dialog, "Export"), Qt::LeftButton);
    return wanted.isEmpty() ? ExportRequest() : wanted.at(0).at(0).value<ExportRequest>();
}

} // namespace

class DialogsTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QFile file(mesh());
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 4 3 2\n");
    }

    void newDialogCountsTexelsBeforeAnythingIsMade()
    {
        NewDialog dialog(mesh());
        dialog.show();
        auto* create = named<QPushButton>(dialog, "Create");
        QVERIFY(!create->isEnabled());
        QTRY_VERIFY(create->isEnabled());
        named<QComboBox>(dialog, "Resolution by")->setCurrentIndex(2);
        named<QSpinBox>(dialog, "Level of every face")->setValue(6);
        auto* result = named<QLabel>(dialog, "Result");
        QTRY_VERIFY2(result->text().contains(countText(2 * 4096)), qPrintable(result->text()));
        QVERIFY(result->text().contains(sizeText(2 * 4096 * 3)));
        named<QComboBox>(dialog, "Type of a channel")->setCurrentIndex(3);
        QTRY_VERIFY(result->text().contains(sizeText(2 * 4096 * 3 * 4)));
    }

    void newDialogHandsOverWhatWasChosen()
    {
        NewDialog dialog(mesh());
        dialog.show();
        std::optional<ProjectOptions> options;
        std::size_t faces = 0;
        QString name;
        connect(&dialog,
                &NewDialog::createWanted,
                this,
                [&](const std::shared_ptr<const TriangleMesh>& triangles,
                    const ProjectOptions& chosen,
                    const QString& title) {
                    faces = triangles->faceCount();
                    options = chosen;
                    name = title;
                });
        named<QComboBox>(dialog, "Resolution by")->setCurrentIndex(1);
        named<QDoubleSpinBox>(dialog, "Texels per unit of length")->setValue(32);
        named<QComboBox>(dialog, "Channels")->setCurrentIndex(2);
        auto* create = named<QPushButton>(dialog, "Create");
        QTRY_VERIFY(create->isEnabled());
        QTest::mouseClick(create, Qt::LeftButton);
        QVERIFY(options.has_value());
        QCOMPARE(faces, std::size_t{2});
        QCOMPARE(name, QString("square"));
        QCOMPARE(options->size, SizeChoice::Density);
        QCOMPARE(options->density, 32.0);
        QCOMPARE(int(options->format.channels), 4);
        QVERIFY(options->format.alpha == std::uint16_t{3});
    }

    void newDialogSaysWhatIsWrongWithTheMesh()
    {
        NewDialog dialog(m_folder.filePath("missing.obj"));
        dialog.show();
        auto* about = named<QLabel>(dialog, "About the mesh");
        QTRY_VERIFY2(about->text().contains("missing.obj"), qPrintable(about->text()));
        QVERIFY(!named<QPushButton>(dialog, "Create")->isEnabled());
        // Another name typed is read again.
        auto* path = named<QLineEdit>(dialog, "Mesh file");
        path->selectAll();
        QTest::keyClicks(path, mesh());
        QTRY_VERIFY(named<QPushButton>(dialog, "Create")->isEnabled());
    }

    void newDialogRefusesFewerTexelsThanFaces()
    {
        NewDialog dialog(mesh());
        dialog.show();
        auto* create = named<QPushButton>(dialog, "Create");
        QTRY_VERIFY(create->isEnabled());
        named<QComboBox>(dialog, "Resolution by")->setCurrentIndex(1);
        named<QDoubleSpinBox>(dialog, "Texels per unit of length")->setValue(1e9);
        auto* result = named<QLabel>(dialog, "Result");
        QTRY_VERIFY(result->text().contains("level 12")); // the highest there is
    }

    void exportDialogEstimatesAndHandsOver()
    {
        Project project = gridProject();
        paintNoise(project.texels);
        ExportDialog dialog({project, {}, {}}, m_folder.filePath("grid.ptx"));
        dialog.show();
        auto* size = named<QLabel>(dialog, "Size estimate");
        const std::uint64_t full = 128 * 64 * 3;
        QTRY_VERIFY2(size->text().contains(sizeText(full + full / 3)), qPrintable(size->text()));
        named<QCheckBox>(dialog, "Store reduced levels")->setChecked(false);
        QTRY_VERIFY(size->text().contains(sizeText(full)));

        QSignalSpy wanted(&dialog, &ExportDialog::exportWanted);
        QTest::mouseClick(named<QPushButton>(dialog, "Export"), Qt::LeftButton);
        QCOMPARE(wanted.count(), 1);
        const auto request = wanted.at(0).at(0).value<ExportRequest>();
        QCOMPARE(QString::fromStdString(request.path.string()), m_folder.filePath("grid.ptx"));
        QCOMPARE(std::get<PtxExportOptions>(request.options).mips, false);
    }

    void endingAndKindOfExportFollowEachOther()
    {
        ExportDialog dialog({gridProject(), {}, {}}, m_folder.filePath("grid.ptx"));
        dialog.show();
        auto* path = named<QLineEdit>(dialog, "Destination");
        auto* kind = named<QComboBox>(dialog, "Kind");
        path->setText(m_folder.filePath("grid.png"));
        QVERIFY2(kind->currentText().contains("Packed atlas"), qPrintable(kind->currentText()));
        QVERIFY(named<QComboBox>(dialog, "Packing")->isVisible());
        kind->setCurrentIndex(kind->findData(".obj"));
        QCOMPARE(path->text(), m_folder.filePath("grid.obj"));
        QVERIFY(named<QSpinBox>(dialog, "Padding")->isVisible());
        QVERIFY(named<QComboBox>(dialog, "Texture format")->isEnabled());
        path->setText(m_folder.filePath("grid.glb"));
        QVERIFY(!named<QComboBox>(dialog, "Texture format")->isEnabled());
    }

    void presetsChooseKindAndSettingsUntilSomethingIsChanged()
    {
        ExportDialog dialog({gridProject(), {}, {}}, m_folder.filePath("grid.ptx"));
        dialog.show();
        auto* preset = named<QComboBox>(dialog, "Destination preset");
        preset->setCurrentIndex(preset->findText("Game engine", Qt::MatchStartsWith));
        QCOMPARE(named<QLineEdit>(dialog, "Destination")->text(), m_folder.filePath("grid.glb"));
        QVERIFY(named<QCheckBox>(dialog, "Sides are powers of two")->isChecked());
        QCOMPARE(named<QSpinBox>(dialog, "Padding")->value(), 4);
        QVERIFY(preset->currentText().startsWith("Game engine"));
        named<QSpinBox>(dialog, "Padding")->setValue(3);
        QCOMPARE(preset->currentText(), QString("Custom"));
    }

    void sizeAndPagesAreSaidAndPartsCanBeChosen()
    {
        ExportDialog dialog({gridProject(), {FaceId{3}, FaceId{4}}, {}},
                            m_folder.filePath("a.png"));
        dialog.show();
        auto* size = named<QLabel>(dialog, "Size estimate");
        QTRY_VERIFY2(size->text().contains("1 page of"), qPrintable(size->text()));
        QVERIFY(size->text().contains("in the other packing"));
        const QString whole = size->text();
        named<QCheckBox>(dialog, "Only selected faces")->click();
        QTRY_VERIFY(size->text().contains("1 page of") && size->text() != whole);
        QSignalSpy wanted(&dialog, &ExportDialog::exportWanted);
        named<QComboBox>(dialog, "Channels")->setCurrentIndex(2);
        QTRY_VERIFY(size->text().contains("1 page of"));
        QTest::mouseClick(named<QPushButton>(dialog, "Export"), Qt::LeftButton);
        QCOMPARE(wanted.count(), 1);
        const auto request = wanted.at(0).at(0).value<ExportRequest>();
        QCOMPARE(request.part.faces.size(), std::size_t{2});
        QCOMPARE(request.part.channels, std::vector<std::uint16_t>{1});
    }

    void layersAreOfferedWhereThereAreSome()
    {
        ExportDialog plain({gridProject(), {}, {}}, m_folder.filePath("a.ptx"));
        plain.show();
        QVERIFY(!named<QComboBox>(plain, "Layer")->isVisible());
        QVERIFY(!handedOver(plain).part.layer);

        ExportDialog dialog({layeredProject(), {}, {}}, m_folder.filePath("a.ptx"));
        dialog.show();
        auto* layer = named<QComboBox>(dialog, "Layer");
        QVERIFY(layer->isVisible());
        QCOMPARE(layer->count(), 4);
        QCOMPARE(layer->itemText(1), QString("Rust")); // lies above the other
        QCOMPARE(layer->itemText(2), QString("Moss"));
        QCOMPARE(layer->itemText(3), QString("Base"));
        QVERIFY(!handedOver(dialog).part.layer);
    }

    void aLayerAloneHasAChannelMoreAndItsSizeIsSaid()
    {
        ExportDialog dialog({layeredProject(), {}, {}}, m_folder.filePath("a.ptx"));
        dialog.show();
        auto* size = named<QLabel>(dialog, "Size estimate");
        auto* layer = named<QComboBox>(dialog, "Layer");
        auto* channels = named<QComboBox>(dialog, "Channels");
        named<QCheckBox>(dialog, "Store reduced levels")->setChecked(false);
        QCOMPARE(channels->itemText(0), QString("All 3"));
        layer->setFocus();
        QTest::keyClick(layer, Qt::Key_Down);
        QTest::keyClick(layer, Qt::Key_Down);
        QCOMPARE(layer->currentText(), QString("Moss"));
        QCOMPARE(channels->itemText(0), QString("All 4"));
        QVERIFY(channels->itemText(4).contains("opacity"));
        // Of the noise all texels are written, with their coverage.
        const std::uint64_t full = 128 * 64 * 4;
        QTRY_VERIFY2(size->text().contains(sizeText(full)), qPrintable(size->text()));
        channels->setCurrentIndex(4);
        const ExportRequest request = handedOver(dialog);
        QVERIFY(request.part.layer == LayerId{1});
        QCOMPARE(request.part.channels, std::vector<std::uint16_t>{3});
    }

    void theLayerOfTheLatestExportIsChosenAgain()
    {
        const Project project = layeredProject();
        ExportRequest latest;
        latest.part.layer = LayerId{2};
        ExportDialog dialog({project, {}, latest}, m_folder.filePath("a.ptx"));
        QCOMPARE(named<QComboBox>(dialog, "Layer")->currentText(), QString("Rust"));
        latest.part.layer = LayerId{9}; // gone meanwhile
        ExportDialog other({project, {}, latest}, m_folder.filePath("a.ptx"));
        QCOMPARE(named<QComboBox>(other, "Layer")->currentIndex(), 0);
    }

    void whatAFormatCannotHoldIsSaidAndNotExported()
    {
        Project project = gridProject();
        project.texels = TexelStore(128,
                                    TexelFormat{TexelType::UInt16, 5, std::nullopt},
                                    Level(1),
                                    std::vector<std::byte>(10));
        ExportDialog dialog({project, {}, {}}, m_folder.filePath("a.png"));
        dialog.show();
        auto* size = named<QLabel>(dialog, "Size estimate");
        QTRY_VERIFY2(size->text().contains("1 to 4 channels"), qPrintable(size->text()));
        QVERIFY(!named<QPushButton>(dialog, "Export")->isEnabled());
        named<QComboBox>(dialog, "Channels")->setCurrentIndex(1);
        QTRY_VERIFY(named<QPushButton>(dialog, "Export")->isEnabled());
    }

    void exportDialogRefusesUselessDestinations()
    {
        ExportDialog dialog({gridProject(), {}, {}}, {});
        dialog.show();
        auto* path = named<QLineEdit>(dialog, "Destination");
        auto* button = named<QPushButton>(dialog, "Export");
        QVERIFY(!button->isEnabled());
        path->setText(m_folder.filePath("nowhere/x.ptx"));
        QVERIFY(!button->isEnabled());
        QVERIFY(named<QLabel>(dialog, "Note")->text().contains("does not exist"));
        path->setText(m_folder.filePath("fine"));
        QVERIFY(button->isEnabled());
    }

    void estimateIsNearWhatIsWritten_data()
    {
        QTest::addColumn<bool>("painted");
        QTest::newRow("unpainted") << false;
        QTest::newRow("noise") << true;
    }
    void estimateIsNearWhatIsWritten()
    {
        QFETCH(bool, painted);
        Project project = gridProject(24, 4);
        if (painted) {
            paintNoise(project.texels);
        }
        const ExportEstimate estimate = estimatePtx(project.texels, TexelType::UInt8, true);
        NoProgress progress;
        const QString path = m_folder.filePath("estimate.ptx");
        QVERIFY(exportPtx(path.toStdString(), project, {}, progress).has_value());
        const double ratio = double(estimate.likelyBytes) / double(QFile(path).size());
        QVERIFY2(ratio > 0.5 && ratio < 2.0, qPrintable(QString::number(ratio)));
    }

private:
    QString mesh() const { return m_folder.filePath("square.obj"); }

    QTemporaryDir m_folder;
};

} // namespace trixel::ui

QTEST_MAIN(trixel::ui::DialogsTest)
#include "tst_dialogs.moc"
