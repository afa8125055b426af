// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pictures of the three views against pictures that were looked at, with a tolerance. Run with
// TRIXEL_WRITE_PICTURES=<folder> to write what is drawn instead.
#include <QBuffer>
#include <QPainter>
#include <QSvgGenerator>
#include <QSvgRenderer>
#include <QTest>

#include "tests/ui/inspector/layout_fixture.h"

namespace trixel::ui {

namespace {

constexpr int kSide = 200;

int gap(QRgb a, QRgb b)
{
    return std::max({std::abs(qRed(a) - qRed(b)),
                     std::abs(qGreen(a) - qGreen(b)),
                     std::abs(qBlue(a) - qBlue(b))});
}

/// Of a thousand pixels so many differ visibly.
double perMilleThatDiffer(const QImage& a, const QImage& b)
{
    constexpr int kVisible = 24;
    int count = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            count += gap(a.pixel(x, y), b.pixel(x, y)) > kVisible ? 1 : 0;
        }
    }
    return 1000.0 * count / (a.width() * a.height());
}

/// Texels, grid and centres, without writing, which differs from machine to machine.
QImage drawn(LayoutFixture& f, const LayoutScene& scene)
{
    const LayoutMarks marks{
        .grid = true, .tint = false, .centres = true, .values = false, .indices = false};
    PlaneSight sight;
    sight.setHome(scene.home, scene.nearest());
    sight.setView({8, 8}, {kSide - 16, kSide - 16});
    ShownFaces faces(f.document, f.settings, f.inspection);
    QPalette palette;
    palette.setColor(QPalette::Window, Qt::black);
    palette.setColor(QPalette::Base, QColor(40, 40, 40));
    const LayoutInk ink(palette, QFont());
    const LayoutPainter layout(faces,
                               f.document.texels().format(),
                               scene,
                               sight.map(),
                               QRectF(0, 0, kSide, kSide),
                               ink,
                               marks);
    QImage picture(kSide, kSide, QImage::Format_RGB32);
    picture.fill(ink.background);
    layout.drawTexels(picture, 1);
    QPainter painter(&picture);
    layout.drawMarks(painter, {});
    layout.drawInspected(painter, *f.inspection.texel(), true);
    return picture;
}

/// The first face finer than what is reduced at once: stripes of two texels, grey as a mean.
Project stripedProject()
{
    Project project = fanProject();
    const Level level(10);
    std::vector<std::byte> bytes;
    for (std::uint32_t k = 0; k < level.texelCount(); ++k) {
        bytes.insert(bytes.end(), 3, (k / 2) % 2 == 0 ? std::byte{255} : std::byte{0});
    }
    (void)project.texels.exchange(FaceId{0}, FaceTexels::full(level, 3, bytes));
    return project;
}

QRgb middleOf(LayoutView& view)
{
    const QImage shown = view.grab().toImage();
    return shown.pixel(shown.width() / 2, shown.height() / 2 + 20);
}

} // namespace

class LayoutPicturesTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { m_settings.clear(); }

    void viewsLookAsTheyDid_data()
    {
        QTest::addColumn<LayoutKind>("kind");
        QTest::newRow("net") << LayoutKind::Net;
        QTest::newRow("packed") << LayoutKind::Packed;
        QTest::newRow("rectilinear") << LayoutKind::Rectilinear;
    }

    void viewsLookAsTheyDid()
    {
        QFETCH(LayoutKind, kind);
        LayoutFixture f;
        QVERIFY(QTest::qWaitForWindowExposed(&f.panel));
        f.inspection.hold(TexelPlace{FaceId{0}, {2, 3, TexelHalf::Upper}});
        const QImage picture = drawn(f, *f.panel.view(kind).scene());
        const QString name = QString("%1.png").arg(QTest::currentDataTag());
        if (const QString folder = qEnvironmentVariable("TRIXEL_WRITE_PICTURES");
            !folder.isEmpty()) {
            QVERIFY(picture.save(folder + "/" + name));
            return;
        }
        const QImage golden(QString(TRIXEL_TEST_DATA) + "/layout/" + name);
        QCOMPARE(golden.size(), picture.size());
        const double differ = perMilleThatDiffer(golden, picture);
        QVERIFY2(differ < 4, qPrintable(QString("%1 ‰ of %2").arg(differ).arg(name)));
    }

    void aPictureThatIsWrongIsFound()
    {
        // What the tolerance must not let through: one level coarser, or halves exchanged.
        LayoutFixture f;
        QVERIFY(QTest::qWaitForWindowExposed(&f.panel));
        f.inspection.hold(TexelPlace{FaceId{0}, {2, 3, TexelHalf::Upper}});
        LayoutScene scene = *f.panel.view(LayoutKind::Packed).scene();
        const QImage right = drawn(f, scene);
        scene.faces[0].layout = FaceLayout::packed().moved({{1, 1}, {0, -1}, {-1, 0}});
        QVERIFY(perMilleThatDiffer(right, drawn(f, scene)) > 100);
    }

    void thePanelDrawsItselfAsAPictureAndAsVectors()
    {
        LayoutFixture f;
        QVERIFY(QTest::qWaitForWindowExposed(&f.panel));
        QVERIFY(f.panel.pictureSize().isEmpty());
        f.inspection.hold(TexelPlace{FaceId{0}, {2, 3, TexelHalf::Upper}});
        const QSize size = f.panel.pictureSize();
        QVERIFY(size.width() > size.height());
        QImage raster(size, QImage::Format_RGB32);
        QPainter painter(&raster);
        f.panel.paintPicture(painter, size);
        painter.end();
        QBuffer buffer;
        QVERIFY(buffer.open(QIODevice::WriteOnly));
        QSvgGenerator generator;
        generator.setOutputDevice(&buffer);
        generator.setSize(size);
        generator.setViewBox(QRect(QPoint(0, 0), size));
        QPainter vectors(&generator);
        f.panel.paintPicture(vectors, size);
        vectors.end();
        QVERIFY(!buffer.data().contains("<image")); // few texels are shapes
        QSvgRenderer renderer(buffer.data());
        QVERIFY(renderer.isValid());
        QImage again(size, QImage::Format_RGB32);
        again.fill(Qt::white);
        QPainter paintAgain(&again);
        renderer.render(&paintAgain);
        paintAgain.end();
        QVERIFY(perMilleThatDiffer(raster, again) < 60); // letters and thin lines
        if (const QString folder = qEnvironmentVariable("TRIXEL_WRITE_PICTURES");
            !folder.isEmpty()) {
            raster.save(folder + "/panel.png");
            again.save(folder + "/panel-svg.png");
        }
    }

    void largeFacesAreDrawnAtOnceAndWellSoonAfter()
    {
        LayoutFixture f(stripedProject());
        QVERIFY(QTest::qWaitForWindowExposed(&f.panel));
        f.inspection.pointAt(FaceId{0}, {0.1F, 0.1F});
        // One of the texels, not their mean, nor the background.
        const QRgb first = middleOf(f.packed());
        QVERIFY(gap(first, qRgb(255, 255, 255)) < 3 || gap(first, qRgb(0, 0, 0)) < 3);
        QTRY_VERIFY_WITH_TIMEOUT(gap(middleOf(f.packed()), qRgb(128, 128, 128)) < 20, 20000);
    }

    void whatIsPaintedWhileAFaceIsReducedIsNotLost()
    {
        LayoutFixture f(stripedProject());
        QVERIFY(QTest::qWaitForWindowExposed(&f.panel));
        f.inspection.pointAt(FaceId{0}, {0.1F, 0.1F});
        (void)middleOf(f.packed()); // begins to reduce
        Brush brush;
        brush.radius = 0.2F;
        brush.color = {1, 0, 0, 1};
        f.document.beginStroke(brush);
        f.document.extendStroke({FaceId{0}, {0.4F, 0.4F}, 1.0F, 0});
        f.document.endStroke();
        (void)f.packed().grab();
        const QRgb grey = qRgb(128, 128, 128);
        const auto away = [&] {
            const QImage shown = f.packed().grab().toImage();
            return shown.pixel(shown.width() / 2 - 90, shown.height() / 2 + 100);
        };
        QTRY_VERIFY_WITH_TIMEOUT(gap(away(), grey) < 20, 20000); // reduced
        const QImage followed = f.packed().grab().toImage();
        f.panel.hide(); // forgets
        f.panel.show();
        f.panel.complete();
        QCOMPARE(f.packed().grab().toImage(), followed);
        f.document.undoStack().undo();
        QVERIFY(f.packed().grab().toImage() != followed); // it was there
    }

private:
    TemporarySettings m_settings;
};

} // namespace trixel::ui

QTEST_MAIN(trixel::ui::LayoutPicturesTest)
#include "tst_layout_pictures.moc"
