// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractButton>
#include <QAbstractItemModelTester>
#include <QApplication>
#include <QCheckBox>
#include <QDeadlineTimer>
#include <QDir>
#include <QImage>
#include <QLabel>
#include <QPainter>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <QThreadPool>

#include "core/io/ptx_faces.h"
#include "core/lattice/reduction.h"
#include "core/lattice/texel_family.h"
#include "tests/ui/fixtures.h"
#include "ui/document/document.h"
#include "ui/document/inspection.h"
#include "ui/inspector/difference_colors.h"
#include "ui/inspector/mip_family.h"
#include "ui/inspector/mip_model.h"
#include "ui/inspector/mip_panel.h"
#include "ui/viewport/view_settings.h"

#include <cmath>
#include <memory>

namespace trixel::ui {

namespace {

/// Waves in three directions: no two levels look alike, and the box errs in a pattern of its own.
FaceTexels waves(Level level)
{
    std::vector<std::byte> bytes;
    for (std::uint32_t k = 0; k < level.texelCount(); ++k) {
        const glm::dvec2 at = centroid(level, texelAt(level, TexelIndex{k}));
        for (const double wave : {9.0 * at.x, 14.0 * at.y, 40.0 * at.x * at.y}) {
            bytes.push_back(static_cast<std::byte>(std::lround(127 + 120 * std::sin(wave))));
        }
    }
    return FaceTexels::full(level, 3, bytes);
}

/// Faces 0 to 7 of a square: 0 painted at level 5, 1 at level 3, 2 at level 9, the others constant
/// at level 4.
Project painted()
{
    Project project = gridProject(2, 4);
    project.texels.exchange(FaceId{0}, waves(Level(5)));
    project.texels.exchange(FaceId{1}, waves(Level(3)));
    project.texels.exchange(FaceId{2}, waves(Level(9)));
    return project;
}

/// The levels' pictures alone, side by side: labels look different with every font.
QImage picturesOf(MipPanel& panel)
{
    const QImage grabbed = panel.view().grab().toImage();
    int width = 0;
    int height = 0;
    for (const MipCell& cell : panel.view().cells()) {
        width += cell.picture.toAlignedRect().width();
        height = std::max(height, cell.picture.toAlignedRect().height());
    }
    QImage strip(width, height, QImage::Format_RGB32);
    strip.fill(Qt::black);
    QPainter painter(&strip);
    int left = 0;
    for (const MipCell& cell : panel.view().cells()) {
        const QRect rect = cell.picture.toAlignedRect();
        painter.drawImage(left, 0, grabbed, rect.x(), rect.y(), rect.width(), rect.height());
        left += rect.width();
    }
    return strip;
}

/// Mean and largest difference of channels, of 255.
std::pair<double, int> apart(const QImage& a, const QImage& b)
{
    double sum = 0;
    int most = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y);
            const QRgb q = b.pixel(x, y);
            for (const int gap : {qRed(p) - qRed(q), qGreen(p) - qGreen(q), qBlue(p) - qBlue(q)}) {
                sum += std::abs(gap);
                most = std::max(most, std::abs(gap));
            }
        }
    }
    return {sum / (3.0 * a.width() * a.height()), most};
}

} // namespace

class MipPanelTest : public QObject
{
    Q_OBJECT

private slots:
    void init()
    {
        m_document = std::make_unique<Document>();
        m_inspection = std::make_unique<Inspection>(*m_document);
        m_settings = std::make_unique<ViewSettings>();
        m_panel = std::make_unique<MipPanel>(*m_document, *m_inspection, *m_settings);
        m_panel->resize(900, 900);
        m_document->open(painted(), {}, "painted");
        m_panel->show();
        m_panel->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_panel.get()));
    }
    void cleanup()
    {
        m_panel.reset();
        m_settings.reset();
        m_inspection.reset();
        m_document.reset();
    }

    void saysWhatToDoBeforeAFaceIsPointedAt()
    {
        QVERIFY(view().cells().empty());
        QCOMPARE(m_panel->model().rowCount(), 0);
        QVERIFY(!table().isVisible());
        QVERIFY(countColors(view().grab().toImage()) > 2); // words
    }

    void everyLevelHasACellAndARow()
    {
        pointAt(0, {5, 6, TexelHalf::Upper});
        QCOMPARE(m_panel->model().rowCount(), 6);
        const auto cells = view().cells();
        QCOMPARE(cells.size(), std::size_t{6});
        for (int k = 0; k < 6; ++k) {
            QCOMPARE(cells[static_cast<std::size_t>(k)].level.log2(), 5 - k);
            QVERIFY(QRectF(view().rect()).contains(cells[static_cast<std::size_t>(k)].picture));
        }
        QTRY_VERIFY(view().isComplete());
        QCOMPARE(cellText(0, MipModel::LevelNumber), QString("5 · 32 × 32"));
        QCOMPARE(cellText(0, MipModel::Texels), QString("1,024"));
        QCOMPARE(cellText(5, MipModel::Texels), QString("1"));
    }

    void cellsFitInEverySizeAndArrangement()
    {
        for (const QSizeF room : {QSizeF(290, 300), QSizeF(900, 250), QSizeF(300, 900)}) {
            for (const bool trueSize : {false, true}) {
                for (const auto texels :
                     {FaceLayout::Texels::Triangles, FaceLayout::Texels::Pixels}) {
                    for (int n = 0; n <= Level::kMax; ++n) {
                        const auto cells = placeMips(Level(n), room, {texels, trueSize}, 14, 2);
                        QCOMPARE(cells.size(), static_cast<std::size_t>(n) + 1);
                        for (std::size_t k = 0; k < cells.size(); ++k) {
                            const QRectF both = cells[k].picture | cells[k].label;
                            QVERIFY(QRectF(QPointF(), room).contains(both));
                            for (std::size_t l = 0; l < k; ++l) {
                                QVERIFY(!both.intersects(cells[l].picture | cells[l].label));
                            }
                            if (trueSize && k > 0 && cells[k].picture.width() > 1) {
                                QCOMPARE(2 * cells[k].picture.width(),
                                         cells[k - 1].picture.width());
                            } else if (!trueSize) {
                                QCOMPARE(cells[k].picture.size(), cells[0].picture.size());
                            }
                        }
                    }
                }
            }
        }
    }

    void thePointerInALevelLooksAtTheTexelThere()
    {
        for (const auto texels : {FaceLayout::Texels::Triangles, FaceLayout::Texels::Pixels}) {
            m_panel->setOptions({MipContent::Right, {texels, false}});
            pointAt(0, {0, 0, TexelHalf::Lower});
            for (const int n : {5, 3, 1, 0}) {
                const Level level(n);
                for (const std::uint32_t index :
                     {0U, level.texelCount() / 2, level.texelCount() - 1}) {
                    const TexelCoord texel = texelAt(level, TexelIndex{index});
                    hover(level, texel);
                    QTRY_VERIFY(m_panel->focus().level() == level &&
                                m_panel->focus().texel(level) == texel);
                    const InspectedTexel looked = *m_inspection->texel();
                    QCOMPARE(looked.level.log2(), 5);
                    QVERIFY(ancestorOf(Level(5), looked.place.texel, level) == texel);
                }
            }
        }
        QVERIFY(m_inspection->isPointedAt());
        hoverAt({2, 2});
        QTRY_VERIFY(!m_inspection->isPointedAt());
        QCOMPARE(m_panel->focus().level().log2(), 5);
    }

    void parentsAndChildrenAreLitInEveryLevel()
    {
        for (const auto texels : {FaceLayout::Texels::Triangles, FaceLayout::Texels::Pixels}) {
            for (const ReductionRule rule : {ReductionRule::Triangles, ReductionRule::Box}) {
                checkFamily(texels, rule);
            }
        }
    }

    void lightIsDrawnOverThePictures()
    {
        pointAt(0, {20, 2, TexelHalf::Lower});
        QTRY_VERIFY(view().isComplete());
        const QImage before = picturesOf(*m_panel);
        pointAt(0, {3, 20, TexelHalf::Lower});
        const QImage after = picturesOf(*m_panel);
        int left = 0;
        for (const MipCell& cell : view().cells()) {
            const QRect rect(QPoint(left, 0), cell.picture.toAlignedRect().size());
            left += rect.width();
            // The one texel of level 0 is everybody's parent.
            QCOMPARE(before.copy(rect) == after.copy(rect), cell.level.log2() == 0);
        }
    }

    void clickingHoldsAndKeepsTheLevel()
    {
        pointAt(0, {0, 0, TexelHalf::Lower});
        const TexelCoord texel{1, 2, TexelHalf::Upper};
        QTest::mouseClick(&view(), Qt::LeftButton, Qt::NoModifier, placeOf(Level(3), texel));
        QVERIFY(m_inspection->isHeld());
        hover(Level(4), {9, 1, TexelHalf::Lower}); // held: nothing follows the pointer
        QCOMPARE(m_panel->focus().level().log2(), 3);
        QVERIFY(m_panel->focus().texel(Level(3)) == texel);
        hoverAt({2, 2});
        m_inspection->letGo();
        pointAt(0, {31, 0, TexelHalf::Lower});
        QCOMPARE(m_panel->focus().level().log2(), 3); // whose ancestor is lit
        QVERIFY((m_panel->focus().texel(Level(3)) == TexelCoord{7, 0, TexelHalf::Lower}));
        QCOMPARE(table().currentIndex().row(), 2);
    }

    void keysAndRowsChooseTheLevel()
    {
        pointAt(0, {5, 6, TexelHalf::Upper});
        QCOMPARE(table().currentIndex().row(), 0);
        view().setFocus();
        QTest::keyClick(&view(), Qt::Key_Right);
        QTest::keyClick(&view(), Qt::Key_Right);
        QCOMPARE(m_panel->focus().level().log2(), 3);
        QCOMPARE(table().currentIndex().row(), 2);
        QTest::keyClick(&view(), Qt::Key_End);
        QTest::keyClick(&view(), Qt::Key_Right);
        QCOMPARE(m_panel->focus().level().log2(), 0);
        const QRect cell = table().visualRect(table().model()->index(1, 0));
        QTest::mouseClick(table().viewport(), Qt::LeftButton, Qt::NoModifier, cell.center());
        QCOMPARE(m_panel->focus().level().log2(), 4);
        QTest::keyClick(&table(), Qt::Key_Up);
        QCOMPARE(m_panel->focus().level().log2(), 5);
        QTest::keyClick(&view(), Qt::Key_Space);
        QVERIFY(m_inspection->isHeld());
        QTest::keyClick(&view(), Qt::Key_Escape);
        QVERIFY(!m_inspection->isHeld());
        m_inspection->setLevelsDropped(
            2); // a level of one's own choice stays, the view's goes along
        QCOMPARE(m_panel->focus().level().log2(), 3);
    }

    void itIsUsableNarrowAndWide()
    {
        pointAt(0, {5, 6, TexelHalf::Upper});
        for (const QSize size : {QSize(310, 560), QSize(900, 330)}) {
            m_panel->resize(size);
            QTRY_COMPARE(m_panel->size(), size);
            QTRY_VERIFY(view().isComplete());
            QVERIFY(view().cells().front().picture.width() >= 60);
            QVERIFY(table().isVisible());
        }
    }

    void tabReachesEveryControl()
    {
        pointAt(0, {});
        QSet<QString> reached;
        view().setFocus();
        for (int k = 0; k < 12; ++k) {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
            reached += QApplication::focusWidget()->accessibleName();
        }
        for (const char* name : {"Levels of the face, side by side", "Levels in numbers"}) {
            QVERIFY2(reached.contains(name), name);
        }
        QVERIFY(reached.contains("Levels in true size"));
        for (const QWidget* widget : m_panel->findChildren<QWidget*>()) {
            if (widget->focusPolicy() != Qt::NoFocus) {
                QVERIFY2(!widget->accessibleName().isEmpty(), widget->metaObject()->className());
                QVERIFY2(!widget->toolTip().isEmpty() || widget == &view(),
                         qPrintable(widget->accessibleName()));
            }
        }
    }

    void bytesAreThoseOfMemoryAndOfTheWriter()
    {
        pointAt(0, {});
        QTRY_VERIFY(m_panel->focus().isMeasured());
        const FaceTexels& face = m_document->texels().face(FaceId{0});
        TexelStore store(1, {}, Level(), face.bytes().first(3));
        store.exchange(FaceId{0}, face);
        NoProgress progress;
        const PtxFaces faces = packPtxFaces(store, Adjacency(1), true, {1}, progress).value();
        QCOMPARE(faces.levelCount, 4);
        for (int reduction = 0; reduction < 4; ++reduction) {
            faces.forEachBlocks(reduction, [&](const PtxBlocks& blocks) {
                QCOMPARE(m_panel->focus().fileBytes(Level(5 - reduction)).value(),
                         quint64{blocks.headers.empty() ? 0 : blocks.headers.front().size()});
            });
        }
        const QStringList kept{"stored", "stored", "stored", "stored", "computed", "average"};
        for (int row = 0; row < 6; ++row) {
            QCOMPARE(cellText(row, MipModel::Kept), kept[row]);
            QCOMPARE(cellText(row, MipModel::Memory),
                     row == 0 ? QString("3.07 kB") : QString("0 B"));
        }
        QCOMPARE(cellText(5, MipModel::File), QString("0 B"));
        QVERIFY(cellText(0, MipModel::File).endsWith("B"));
    }

    void aConstantFaceCostsOneTexelAndNoBlocks()
    {
        pointAt(5, {});
        QCOMPARE(m_panel->model().rowCount(), 5);
        for (int row = 0; row < 5; ++row) {
            QCOMPARE(cellText(row, MipModel::Kept), QString("constant"));
            QCOMPARE(cellText(row, MipModel::File), QString("0 B"));
            QCOMPARE(cellText(row, MipModel::Difference), QString("0  0  0"));
        }
        QCOMPARE(cellText(0, MipModel::Memory), QString("3 B"));
    }

    void valuesAreThoseOfBothReductions()
    {
        const TexelCoord texel{5, 6, TexelHalf::Upper};
        pointAt(0, texel);
        FaceTexels right = m_document->texels().face(FaceId{0});
        FaceTexels box = right;
        bool differs = false;
        for (int row = 0; row < 6; ++row) {
            const Level level(5 - row);
            const std::size_t index =
                indexOf(texelIndex(level, ancestorOf(Level(5), texel, level)));
            QStringList rights;
            QStringList boxes;
            QStringList gaps;
            for (std::size_t c = 0; c < 3; ++c) {
                const int a = std::to_integer<int>(right.texel(index)[c]);
                const int b = std::to_integer<int>(box.texel(index)[c]);
                rights += QString::number(a);
                boxes += QString::number(b);
                gaps += (b > a ? "+" : "") + QString::number(b - a);
                differs = differs || a != b;
            }
            QCOMPARE(cellText(row, MipModel::Right), rights.join("  "));
            QCOMPARE(cellText(row, MipModel::Box), boxes.join("  "));
            QCOMPARE(cellText(row, MipModel::Difference), gaps.join("  "));
            if (row < 5) {
                right = reduced({}, right);
                box = reduced({}, box, ReductionRule::Box);
            }
        }
        QVERIFY(differs);
    }

    void theModelKeepsThePromisesOfModels()
    {
        auto& model = const_cast<MipModel&>(m_panel->model());
        const QAbstractItemModelTester tester(
            &model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        for (const std::uint32_t face : {0U, 1U, 2U, 5U, 0U}) {
            pointAt(face, {});
            QTRY_VERIFY(m_panel->focus().isMeasured());
            QCOMPARE(model.rowCount(), m_document->texels().face(FaceId{face}).level().log2() + 1);
            for (int row = 0; row < model.rowCount(); ++row) {
                for (int column = 0; column < MipModel::ColumnCount; ++column) {
                    QVERIFY(!cellText(row, column).isEmpty());
                    QVERIFY(cellText(row, column) != QString("…"));
                }
            }
        }
        m_document->open(gridProject(1, 0), {}, "other");
        QCOMPARE(model.rowCount(), 0);
        pointAt(0, {});
        QCOMPARE(model.rowCount(), 1);
    }

    void aLargeFaceIsReducedInTheBackground()
    {
        pointAt(2, {});
        QCOMPARE(m_panel->model().rowCount(), 10); // at once
        QVERIFY(m_panel->focus().levels() == nullptr);
        QCOMPARE(cellText(3, MipModel::Right), QString("…"));
        QTRY_VERIFY(m_panel->focus().levels() != nullptr);
        QVERIFY(cellText(3, MipModel::Right) != QString("…"));
        QTRY_VERIFY(view().isComplete());
    }

    void theCoarsestIsMeasuredFirst()
    {
        QList<int> counts;
        connect(&m_panel->focus(), &MipFocus::measured, this, [&] {
            int known = 0;
            for (int n = 9; n >= 2; --n) {
                known += m_panel->focus().fileBytes(Level(n)).has_value() ? 1 : 0;
                // No finer one is known before a coarser one.
                QVERIFY(n == 2 || !m_panel->focus().fileBytes(Level(n)) ||
                        m_panel->focus().fileBytes(Level(n - 1)));
            }
            counts += known;
        });
        pointAt(2, {});
        QTRY_VERIFY(m_panel->focus().isMeasured());
        QCOMPARE(counts.last(), 8);
    }

    void anotherFaceStopsTheWorkForTheOneBefore()
    {
        pointAt(2, {});
        QTest::qWait(60);
        pointAt(1, {});
        QTRY_VERIFY(m_panel->focus().isMeasured());
        QCOMPARE(m_panel->focus().levels()->base().log2(), 3);
        QTest::qWait(150);
        QCOMPARE(m_panel->focus().levels()->base().log2(), 3);
        QVERIFY(!m_panel->focus().fileBytes(Level(5)).has_value());
    }

    void aPointerOnItsWayMeasuresNoFace()
    {
        const QThreadPool& pool = *QThreadPool::globalInstance();
        QTRY_COMPARE(pool.activeThreadCount(), 0);
        for (const std::uint32_t face : {2U, 1U, 2U, 0U, 2U}) {
            pointAt(face, {});
            QCOMPARE(pool.activeThreadCount(), 0);
        }
        QTRY_VERIFY(m_panel->focus().isMeasured()); // where it rests
    }

    void workForAFaceThatWasLeftIsNotShown()
    {
        const QThreadPool& pool = *QThreadPool::globalInstance();
        QTRY_COMPARE(pool.activeThreadCount(), 0);
        pointAt(2, {});
        QDeadlineTimer patience(5000);
        while (pool.activeThreadCount() == 0 && !patience.hasExpired()) {
            QCoreApplication::processEvents();
        }
        QVERIFY(m_panel->focus().levels() == nullptr); // it is being reduced
        m_panel->hide();
        QTRY_COMPARE(pool.activeThreadCount(), 0);
        QCoreApplication::processEvents();
        QVERIFY(m_panel->focus().levels() == nullptr);
        QVERIFY(!m_panel->focus().fileBytes(Level(0)).has_value());
    }

    void paintingShowsAtOnce()
    {
        pointAt(0, {});
        const QString before = cellText(5, MipModel::Right);
        QTRY_VERIFY(view().isComplete());
        const QImage picture = picturesOf(*m_panel);
        m_document->fillFaces(std::array{FaceId{0}}, {1, 0, 0, 1});
        QCOMPARE(cellText(5, MipModel::Right), QString("255  0  0"));
        QVERIFY(before != cellText(5, MipModel::Right));
        QTRY_VERIFY(view().isComplete());
        QVERIFY(picturesOf(*m_panel) != picture);
    }

    void aStrokeIsNotMadeToCopyTheFace()
    {
        const FaceTexels& face = m_document->texels().face(FaceId{2});
        pointAt(2, {});
        QTRY_VERIFY(m_panel->focus().isMeasured());
        QTest::qWait(20); // the work has let go
        const std::byte* before = face.bytes().data();
        Brush brush;
        brush.radius = 0.05F;
        m_document->beginStroke(brush);
        StrokeSample sample;
        sample.face = FaceId{2};
        sample.uv = {0.3F, 0.3F};
        m_document->extendStroke(sample);
        QTest::qWait(200); // a pause of the hand
        QVERIFY(m_panel->focus().levels() == nullptr);
        sample.uv = {0.4F, 0.2F};
        sample.time = 0.2;
        m_document->extendStroke(sample);
        QCOMPARE(face.bytes().data(), before);
        QVERIFY(m_document->hasStroke());
        m_document->endStroke();
        QTRY_VERIFY(m_panel->focus().levels() != nullptr);
    }

    void aHiddenPanelDoesNothing()
    {
        m_panel->hide();
        pointAt(0, {});
        QVERIFY(m_panel->focus().levels() == nullptr);
        m_panel->show();
        QTRY_VERIFY(m_panel->focus().levels() != nullptr);
        QCOMPARE(m_panel->model().rowCount(), 6);
    }

    void theLookColoursThePictures()
    {
        pointAt(0, {});
        QTRY_VERIFY(view().isComplete());
        const QImage colored = picturesOf(*m_panel);
        render::Look look;
        look.channel = std::uint16_t{1};
        m_settings->setLook(look);
        QTRY_VERIFY(view().isComplete());
        const QImage grey = picturesOf(*m_panel);
        QVERIFY(apart(colored, grey).first > 5);
    }

    void contentAndFormAreChosenByMouseAndKey()
    {
        pointAt(0, {});
        QSignalSpy changed(m_panel.get(), &MipPanel::optionsChanged);
        QTest::mouseClick(button("2×2 box"), Qt::LeftButton);
        QCOMPARE(m_panel->options().content, MipContent::Box);
        button("Difference")->setFocus();
        QTest::keyClick(button("Difference"), Qt::Key_Space);
        QCOMPARE(m_panel->options().content, MipContent::Difference);
        QTest::mouseClick(button("Packed"), Qt::LeftButton);
        QCOMPARE(m_panel->options().arrangement.texels, FaceLayout::Texels::Pixels);
        auto* trueSize = m_panel->findChild<QCheckBox*>();
        QTest::keyClick(trueSize, Qt::Key_Space);
        QVERIFY(m_panel->options().arrangement.trueSize);
        QCOMPARE(changed.count(), 4);
    }

    void aPictureForPaperShowsLevelsAndLegend()
    {
        QVERIFY(m_panel->pictureSize().isEmpty());
        pointAt(0, {5, 6, TexelHalf::Upper});
        m_panel->setOptions({MipContent::Difference, {}});
        QImage paper(2 * m_panel->pictureSize(), QImage::Format_RGB32);
        QPainter painter(&paper);
        painter.scale(2, 2);
        m_panel->paintPicture(painter, m_panel->pictureSize());
        painter.end();
        QCOMPARE(paper.pixel(0, 0), qRgb(255, 255, 255));
        QSet<QRgb> colors;
        for (int y = 0; y < paper.height(); ++y) {
            for (int x = 0; x < paper.width(); ++x) {
                colors += paper.pixel(x, y);
            }
        }
        for (const double end : {-1.0, 1.0}) {
            QVERIFY(colors.contains(differenceColor(end)));
        }
        QVERIFY(colors.contains(kParentLight.rgb()) && colors.contains(kChildLight.rgb()));
    }

    void pictures_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("content");
        QTest::addColumn<bool>("packed");
        QTest::addColumn<bool>("trueSize");
        QTest::newRow("right") << "right" << 0 << false << false;
        QTest::newRow("box") << "box" << 1 << false << false;
        QTest::newRow("difference") << "difference" << 2 << false << false;
        QTest::newRow("packed") << "packed" << 0 << true << false;
        QTest::newRow("packed difference") << "packed_difference" << 2 << true << false;
        QTest::newRow("true size") << "true_size" << 0 << false << true;
    }
    void pictures()
    {
        QFETCH(QString, name);
        QFETCH(int, content);
        QFETCH(bool, packed);
        QFETCH(bool, trueSize);
        view().setFixedSize(640, 160);
        m_panel->setOptions(
            {static_cast<MipContent>(content),
             {packed ? FaceLayout::Texels::Pixels : FaceLayout::Texels::Triangles, trueSize}});
        m_inspection->hold(TexelPlace{FaceId{0}, {9, 6, TexelHalf::Upper}});
        const_cast<MipFocus&>(m_panel->focus()).choose(Level(3));
        QTRY_VERIFY(view().isComplete());
        const QImage found = picturesOf(*m_panel);
        const QString path = QString(TRIXEL_TEST_DATA) + "/mips/" + name + ".png";
        if (qEnvironmentVariableIsSet("TRIXEL_RENEW_PICTURES")) {
            QVERIFY(found.save(path));
        }
        const QImage golden = QImage(path).convertToFormat(QImage::Format_RGB32);
        QVERIFY2(!golden.isNull(), qPrintable(path));
        // Fonts may leave the cells a pixel larger or smaller.
        QVERIFY(std::abs(found.width() - golden.width()) <= 12);
        const QImage scaled =
            found.scaled(golden.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        const auto [mean, most] = apart(scaled, golden);
        QVERIFY2(mean < 3, qPrintable(QString::number(mean)));
    }

private:
    MipView& view() { return m_panel->view(); }
    QTableView& table() { return *m_panel->findChild<QTableView*>(); }
    QAbstractButton* button(const QString& name)
    {
        for (QAbstractButton* found : m_panel->findChildren<QAbstractButton*>()) {
            if (found->accessibleName() == name) {
                return found;
            }
        }
        return nullptr;
    }
    QString cellText(int row, int column)
    {
        return m_panel->model().index(row, column).data().toString().replace(QChar(0xa0), ' ');
    }
    void pointAt(std::uint32_t face, TexelCoord texel)
    {
        m_inspection->pointAt(TexelPlace{FaceId{face}, texel});
    }
    MipCell cellOf(Level level)
    {
        for (const MipCell& cell : view().cells()) {
            if (cell.level == level) {
                return cell;
            }
        }
        return {};
    }
    QPoint placeOf(Level level, TexelCoord texel)
    {
        const glm::dvec2 at = cellOf(level).layout.centre(level, texel);
        return {static_cast<int>(std::lround(at.x)), static_cast<int>(std::lround(at.y))};
    }
    void hoverAt(QPoint place)
    {
        QTest::mouseMove(&view(), place);
        QCoreApplication::processEvents();
    }
    void hover(Level level, TexelCoord texel) { hoverAt(placeOf(level, texel)); }
    static int countColors(const QImage& image)
    {
        QSet<QRgb> colors;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                colors += image.pixel(x, y);
            }
        }
        return static_cast<int>(colors.size());
    }
    /// By brute force: the middle of every texel of every level is lit exactly if it is kin.
    static void checkFamily(FaceLayout::Texels texels, ReductionRule rule)
    {
        const FaceLayout layout = texels == FaceLayout::Texels::Triangles
                                      ? FaceLayout::triangle({0, 100}, {100, 100}, {50, 0})
                                      : FaceLayout::packed().moved({{0, 100}, {100, 0}, {0, -100}});
        const Level level(2);
        for (std::uint32_t k = 0; k < level.texelCount(); ++k) {
            const TexelCoord texel = texelAt(level, TexelIndex{k});
            for (int n = 0; n <= 4; ++n) {
                const Level at(n);
                const QPainterPath path = familyOutline(layout, level, texel, at, rule);
                for (std::uint32_t t = 0; t < at.texelCount(); ++t) {
                    const TexelCoord other = texelAt(at, TexelIndex{t});
                    const glm::dvec2 middle = layout.centre(at, other);
                    QCOMPARE(path.contains(QPointF(middle.x, middle.y)),
                             isKin(level, texel, at, other, rule));
                }
            }
        }
    }
    static bool isKin(Level level, TexelCoord texel, Level at, TexelCoord other, ReductionRule rule)
    {
        if (at <= level) {
            return ancestorOf(level, texel, at) == other;
        }
        if (rule == ReductionRule::Triangles) {
            return ancestorOf(at, other, level) == texel;
        }
        const int steps = at.log2() - level.log2();
        const PackedPixel coarse = packedPixel(level, texel);
        const PackedPixel fine = packedPixel(at, other);
        return fine.x >> steps == coarse.x && fine.y >> steps == coarse.y;
    }

    std::unique_ptr<Document> m_document;
    std::unique_ptr<Inspection> m_inspection;
    std::unique_ptr<ViewSettings> m_settings;
    std::unique_ptr<MipPanel> m_panel;
};

} // namespace trixel::ui

QTEST_MAIN(trixel::ui::MipPanelTest)
#include "tst_mip_panel.moc"
