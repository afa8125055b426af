// SPDX-License-Identifier: GPL-3.0-or-later
//
// A window whose panel of imports is used as a person does, with an image to bring in.
#pragma once

#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QSpinBox>

#include "core/io/image/read_image.h"
#include "core/mapping/bake.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/import/import_panel.h"

#include <vector>

namespace trixel::ui {

class ImportTest : public WindowTest
{
protected:
    void openPanel()
    {
        writePicture("photo.png", 64, 48);
        m_window->viewport().lookFrom(0, 0);
        press(Qt::Key_O, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(panel().isVisible());
    }
    void openPanelWith(const QString& mapping, const QString& name = "photo.png")
    {
        openPanel();
        choose("How the image lies on the surface", mapping);
        panel().begin(path(name)); // as if it had been dropped
    }
    ImportPanel& panel() { return *m_window->findChild<ImportPanel*>(); }

    /// No two pixels alike.
    void writePicture(const QString& name, int width, int height)
    {
        QImage picture(width, height, QImage::Format_RGB888);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                picture.setPixel(x, y, qRgb(4 * x % 256, 5 * y % 256, (x * 7 + y * 13) % 256));
            }
        }
        QVERIFY(picture.save(path(name)));
    }
    void typePath(const QString& file)
    {
        auto* field = widgetNamed<QLineEdit>(panel(), "Image file");
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, file);
        QTest::keyClick(field, Qt::Key_Tab);
    }
    /// An entry of a box, by the keyboard; the beginning of its text is enough.
    void choose(const QString& box, const QString& entry)
    {
        auto* combo = widgetNamed<QComboBox>(panel(), box);
        QVERIFY2(combo, qPrintable(box));
        combo->setFocus();
        QTest::keyClick(combo, Qt::Key_Home);
        for (int k = 0; k < combo->count() && !combo->currentText().startsWith(entry); ++k) {
            QTest::keyClick(combo, Qt::Key_Down);
        }
        QVERIFY2(combo->currentText().startsWith(entry), qPrintable(combo->currentText()));
    }
    void type(const QString& field, const QString& number)
    {
        auto* spin = widgetNamed<QDoubleSpinBox>(panel(), field);
        QVERIFY2(spin, qPrintable(field));
        spin->setFocus();
        spin->selectAll();
        QTest::keyClicks(spin, number);
        QTest::keyClick(spin, Qt::Key_Tab);
    }
    void click(const QString& name)
    {
        QVERIFY2(button(name) && button(name)->isEnabled(), qPrintable(name + ": " + state()));
        QTest::mouseClick(button(name), Qt::LeftButton);
    }
    void waitForPreview(bool complete = true)
    {
        QTRY_VERIFY_WITH_TIMEOUT(panel().picture() && (!complete || panel().picture()->isComplete),
                                 30000);
    }
    void apply()
    {
        QTRY_VERIFY_WITH_TIMEOUT(button("Apply the import")->isEnabled(), 30000);
        const int steps = document().undoStack().index();
        click("Apply the import");
        QTRY_COMPARE_WITH_TIMEOUT(document().undoStack().index(), steps + 1, 60000);
    }
    QPushButton* button(const QString& name) { return widgetNamed<QPushButton>(panel(), name); }
    QString text(const QString& name)
    {
        auto* label = widgetNamed<QLabel>(panel(), name);
        return label != nullptr ? label->text() : QString();
    }
    QString state() { return text("State of the import"); }
    QString problem() { return text("What is wrong with the mapping"); }

    std::vector<FaceId> allFaces() { return facesBelow(document().texels().faceCount()); }
    static std::vector<FaceId> facesBelow(std::uint32_t count)
    {
        std::vector<FaceId> faces;
        for (std::uint32_t f = 0; f < count; ++f) {
            faces.push_back(faceId(f));
        }
        return faces;
    }
    /// What core makes of it.
    std::vector<std::byte> baked(const Mapping& mapping,
                                 const std::vector<FaceId>& faces,
                                 const SamplerOptions& options = {},
                                 const QString& name = "photo.png")
    {
        NoProgress progress;
        Image image = readImage(ImageWorker(), path(name).toStdString(), progress).value();
        const ImageTiles tiles =
            ImageTiles::make({{UdimTile{}, std::move(image), "image"}}, options, Threads{1})
                .value();
        TexelStore texels = document().texels();
        const auto patch = bake(texels, faces, mapping, tiles, {}, progress);
        return patch ? allTexels(texels) : std::vector<std::byte>();
    }
};

} // namespace trixel::ui
