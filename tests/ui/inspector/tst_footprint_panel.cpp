// SPDX-License-Identifier: GPL-3.0-or-later
//
// The footprint panel as its user meets it: with mouse and keys.
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QImage>
#include <QPainter>
#include <QSignalSpy>
#include <QSlider>
#include <QTabBar>
#include <QTest>
#include <QToolButton>

#include "core/footprint/svd2.h"
#include "tests/ui/fixtures.h"
#include "tests/ui/viewport/view_fixture.h"
#include "ui/document/background_job.h"
#include "ui/document/filter_scene_source.h"
#include "ui/document/inspection.h"
#include "ui/inspector/footprint_net_view.h"
#include "ui/inspector/footprint_panel.h"
#include "ui/inspector/footprint_table.h"
#include "ui/inspector/sweep_bar.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <random>

namespace trixel::ui {

namespace {

constexpr FaceId kFace = faceId(60);
constexpr glm::vec2 kPoint{0.3F, 0.4F};

/// The grid with noise on it.
Project noisyProject()
{
    Project project = gridProject(8, 3);
    std::mt19937 random(3);
    for (std::uint32_t f = 0; f < project.texels.faceCount(); ++f) {
        for (std::byte& value : project.texels.writable(faceId(f))) {
            value = static_cast<std::byte>(random() >> 24U);
        }
    }
    return project;
}

/// A shown view and a shown panel, looking at the grid from somewhat aside.
struct Bench
{
    Document document;
    Inspection inspection{document};
    ViewSettings settings;
    BackgroundJobs jobs;
    FilterSceneSource source{document, jobs};
    Viewport viewport{document, settings};
    std::unique_ptr<FootprintPanel> panel;

    explicit Bench(bool opened = true)
    {
        viewport.resize(400, 400);
        viewport.show();
        (void)QTest::qWaitForWindowExposed(&viewport);
        if (opened) {
            document.open(noisyProject(), {}, "noise");
            viewport.lookFrom(30, 20);
            viewport.settle();
        }
        panel = std::make_unique<FootprintPanel>(
            FootprintWork{document, inspection, settings, source, viewport});
        panel->resize(360, 900);
        panel->show();
        (void)QTest::qWaitForWindowExposed(panel.get());
    }

    void point(FaceId face = kFace, glm::vec2 uv = kPoint)
    {
        inspection.pointAt(face, uv);
        QCoreApplication::processEvents();
        QTRY_VERIFY(panel->netView().picture());
    }
    const Footprint& footprint() const { return panel->probe().live()->placed.footprint; }
    QString row(FootprintRow row) const { return panel->table().text(row); }
    /// By a click on its tab.
    void openPage(const QString& title)
    {
        auto* bar = panel->findChild<QTabBar*>();
        for (int k = 0; k < bar->count(); ++k) {
            if (bar->tabText(k) == title) {
                QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(k).center());
                QCOMPARE(bar->currentIndex(), k);
                return;
            }
        }
        QFAIL("there is no such page");
    }

    /// Drags a handle of the net by so many pixels, as a hand does: in small steps.
    glm::dvec2 drag(NetHandle handle, QPoint by)
    {
        FootprintNetView& view = panel->netView();
        const QPoint from = view.handleAt(handle)->toPoint();
        const NetView seen = view.view();
        movePointer(view, from);
        QTest::mousePress(&view, Qt::LeftButton, {}, from);
        for (int k = 1; k <= 4; ++k) {
            movePointer(view, from + by * k / 4, Qt::LeftButton);
            QCoreApplication::processEvents();
        }
        QTest::mouseRelease(&view, Qt::LeftButton, {}, from + by);
        QCoreApplication::processEvents();
        return seen.toPlane(from + by);
    }
};

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

/// How often a widget is drawn.
class PaintCount : public QObject
{
public:
    explicit PaintCount(QWidget& widget) { widget.installEventFilter(this); }
    int paints() const { return m_paints; }

protected:
    bool eventFilter(QObject* /*watched*/, QEvent* event) override
    {
        m_paints += event->type() == QEvent::Paint ? 1 : 0;
        return false;
    }

private:
    int m_paints = 0;
};

double distance(glm::dvec2 a, glm::dvec2 b)
{
    return glm::length(a - b);
}

} // namespace

class FootprintPanelTest : public QObject
{
    Q_OBJECT

private slots:
    void emptyPanelHasNothingToShow()
    {
        Bench bench(false);
        QVERIFY(!bench.panel->netView().picture());
        QCOMPARE(bench.row(FootprintRow::First), QString("–"));
        QVERIFY(!named<QToolButton>(*bench.panel, "Freeze the footprint")->isChecked());
    }

    void pixelOfTheInspectedPointIsShown()
    {
        Bench bench;
        bench.point();
        const auto& live = bench.panel->probe().live();
        QVERIFY(live);
        QCOMPARE(live->placed.face, kFace);
        QCOMPARE(live->source, FootprintSource::Screen);
        QVERIFY(bench.row(FootprintRow::Place).startsWith("face 60 at 0.3000, 0.4000"));
        // The Jacobian takes W1 and W2 to one pixel right and one down.
        const ScreenDerivatives& f = *live->derivatives;
        const auto pixels = [&](glm::dvec2 w) { return w.x * f.perU + w.y * f.perV; };
        QVERIFY(distance(pixels(bench.footprint().w1), {1, 0}) < 2e-3);
        QVERIFY(distance(pixels(bench.footprint().w2), {0, 1}) < 2e-3);
        const QString text = bench.row(FootprintRow::Jacobian);
        QVERIFY2(text.contains("∂x/∂u " + QString::number(f.perU.x, 'g', 4)), qPrintable(text));
        QVERIFY2(text.contains("∂y/∂v " + QString::number(f.perV.y, 'g', 4)), qPrintable(text));
    }

    void footprintOfThePixelFollowsTheView()
    {
        Bench bench;
        bench.point();
        const Footprint before = bench.footprint();
        bench.viewport.lookFrom(70, 0);
        QCoreApplication::processEvents();
        QVERIFY(distance(before.w1, bench.footprint().w1) > 1e-4);
        QVERIFY(svd2(bench.footprint().w1, bench.footprint().w2).major >
                svd2(before.w1, before.w2).major);
    }

    void draggingAHandleChangesThatVectorAlone()
    {
        Bench bench;
        bench.point();
        for (const NetHandle handle : {NetHandle::W1, NetHandle::W2}) {
            const Footprint before = bench.footprint();
            const glm::dvec2 to = bench.drag(handle, {31, -22});
            QCOMPARE(bench.panel->probe().source(), FootprintSource::ByHand);
            const FootprintNet& net = bench.panel->netView().picture()->net;
            const bool first = handle == NetHandle::W1;
            // A handle is at the middle of a side, half a vector from the centre.
            const glm::dvec2 dragged =
                net.shape.toPlane(first ? bench.footprint().w1 : bench.footprint().w2);
            QVERIFY(distance(dragged / 2.0, to) < 1e-6);
            QVERIFY(distance(first ? before.w2 : before.w1,
                             first ? bench.footprint().w2 : bench.footprint().w1) < 1e-12);
        }
        QCOMPARE(named<QComboBox>(*bench.panel, "Source of the footprint")->currentText(),
                 QString("By hand"));
    }

    void typedVectorIsByHand()
    {
        Bench bench;
        bench.point();
        bench.openPage("Vectors");
        auto* box = named<QDoubleSpinBox>(*bench.panel, "W2 along u");
        QVERIFY(box->isVisible());
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, "0.125");
        QTest::keyClick(box, Qt::Key_Return);
        QCOMPARE(bench.panel->probe().source(), FootprintSource::ByHand);
        QCOMPARE(bench.footprint().w2.x, 0.125);
        QTest::keyClick(box, Qt::Key_Up); // half a texel of level 3
        QCOMPARE(bench.footprint().w2.x, 0.125 + 1.0 / 16);
    }

    void textureAlignedFootprintIsABoxAlongTheAxes()
    {
        Bench bench;
        bench.point();
        auto* source = named<QComboBox>(*bench.panel, "Source of the footprint");
        source->setFocus();
        QTest::keyClick(source, Qt::Key_Down);
        QCOMPARE(bench.panel->probe().source(), FootprintSource::TextureAligned);
        QCOMPARE(bench.footprint().w1.y, 0.0);
        QCOMPARE(bench.footprint().w2.x, 0.0);
        QVERIFY(bench.footprint().w1.x > 0 && bench.footprint().w2.y > 0);
        QCoreApplication::processEvents(); // the numbers follow
        // It stays one as long as it is along the axes.
        bench.openPage("Vectors");
        auto* box = named<QDoubleSpinBox>(*bench.panel, "W1 along u");
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Up);
        QCOMPARE(bench.panel->probe().source(), FootprintSource::TextureAligned);
        bench.drag(NetHandle::W1, {5, -25});
        QCOMPARE(bench.panel->probe().source(), FootprintSource::ByHand);
    }

    void answersComeAfterTheFootprint()
    {
        Bench bench;
        bench.point();
        QTRY_VERIFY_WITH_TIMEOUT(bench.row(FootprintRow::Texels).contains("sum to 1.0000"), 20'000);
        QVERIFY(bench.row(FootprintRow::MethodCost).contains("taps in"));
        QVERIFY(bench.row(FootprintRow::ExactCost).contains("taps in"));
        QVERIFY(bench.row(FootprintRow::Difference).contains("/255"));
        QVERIFY(bench.row(FootprintRow::Spread).contains("texels, asked"));
        const NetPicture& picture = *bench.panel->netView().picture();
        QVERIFY(picture.weights && !picture.weights->texels.empty());
        // The exact method against itself.
        bench.settings.setMethod({"exact", std::nullopt});
        QTRY_VERIFY_WITH_TIMEOUT(bench.row(FootprintRow::Difference).startsWith("0 = 0/255"),
                                 20'000);
    }

    void frozenFootprintStaysWhileTheViewOrbits()
    {
        Bench bench;
        bench.point();
        auto* freeze = named<QToolButton>(*bench.panel, "Freeze the footprint");
        QTest::mouseClick(freeze, Qt::LeftButton);
        QVERIFY(bench.panel->isFrozen());
        const QString frozen = bench.panel->table().frozenText(FootprintRow::First);
        QCOMPARE(frozen, bench.row(FootprintRow::First));
        bench.viewport.lookFrom(75, 10);
        QCoreApplication::processEvents();
        QCOMPARE(bench.panel->table().frozenText(FootprintRow::First), frozen);
        QVERIFY(bench.row(FootprintRow::First) != frozen);
        QVERIFY(bench.panel->netView().picture()->frozen);
        QTest::mouseClick(freeze, Qt::LeftButton);
        QVERIFY(!bench.panel->isFrozen());
        QVERIFY(bench.panel->table().frozenText(FootprintRow::First).isEmpty());
    }

    void sweepPlaysTowardsGrazingAndPauses()
    {
        Bench bench;
        bench.point();
        const render::CameraPose pose = bench.viewport.camera().pose();
        bench.openPage("Sweep");
        auto* play = named<QToolButton>(*bench.panel, "Play the sweep");
        QTest::mouseClick(play, Qt::LeftButton);
        QVERIFY(bench.panel->sweepBar().isPlaying());
        QCOMPARE(bench.panel->probe().source(), FootprintSource::Tilted);
        QTRY_VERIFY_WITH_TIMEOUT(bench.panel->probe().degrees() > 8, 20'000);
        QTest::mouseClick(play, Qt::LeftButton);
        const double paused = bench.panel->probe().degrees();
        QTest::qWait(150);
        QCOMPARE(bench.panel->probe().degrees(), paused);
        QCOMPARE(bench.viewport.camera().pose(), pose); // the user's view stays

        auto* slider = named<QSlider>(*bench.panel, "Angle of the tilted view");
        slider->setFocus();
        QTest::keyClick(slider, Qt::Key_End);
        QCoreApplication::processEvents();
        QCOMPARE(bench.panel->probe().degrees(), 89.0);
        const double anisotropy = glm::length(bench.panel->netView().picture()->net.major) /
                                  glm::length(bench.panel->netView().picture()->net.minor);
        QVERIFY(anisotropy > 40);
        QTRY_VERIFY_WITH_TIMEOUT(bench.panel->sweepBar().plot().points().size() == 45, 30'000);
    }

    void clickedTexelIsGoneTo()
    {
        Bench bench;
        bench.point();
        FootprintNetView& view = bench.panel->netView();
        const QPoint at = view.rect().center() + QPoint(60, 40);
        const auto place = view.picture()->net.placeAt(view.view().toPlane(at));
        QVERIFY(place);
        const FaceId face = view.picture()->net.faces[place->face].face;
        QTest::mouseClick(&view, Qt::LeftButton, {}, at);
        QVERIFY(bench.inspection.isHeld());
        QCOMPARE(bench.inspection.texel()->place.face, face);
        QVERIFY(distance(glm::dvec2(bench.inspection.texel()->uv), place->uv) < 1e-6);
    }

    void wheelAndKeysZoomAndZeroFits()
    {
        Bench bench;
        bench.point();
        FootprintNetView& view = bench.panel->netView();
        const double fitted = view.view().scale;
        view.setFocus();
        QTest::keyClick(&view, Qt::Key_Plus);
        QVERIFY(view.view().scale > fitted * 1.2);
        QTest::keyClick(&view, Qt::Key_0);
        QCOMPARE(view.view().scale, fitted);
        // What is under the pointer stays there.
        const QPointF at(70, 90);
        const glm::dvec2 before = view.view().toPlane(at);
        QWheelEvent wheel(
            at, view.mapToGlobal(at), {}, {0, 240}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&view, &wheel);
        QVERIFY(view.view().scale > fitted * 1.5);
        QVERIFY(distance(view.view().toPlane(at), before) < 1e-9);
    }

    void pictureForPapersIsWhatIsSeen()
    {
        Bench bench;
        QVERIFY(bench.panel->netView().pictureSize().isEmpty());
        bench.point();
        QTRY_VERIFY_WITH_TIMEOUT(bench.panel->netView().picture()->weights, 20'000);
        FootprintNetView& view = bench.panel->netView();
        QImage seen = view.grab().toImage().convertToFormat(QImage::Format_RGB32);
        QImage drawn(view.pictureSize(), QImage::Format_RGB32);
        QPainter painter(&drawn);
        static_cast<PictureSource&>(view).paintPicture(painter, drawn.size());
        painter.end();
        QCOMPARE(drawn, seen);
    }

    void hiddenPanelDoesNothing()
    {
        Bench bench;
        bench.point();
        bench.panel->hide();
        QSignalSpy changes(&bench.panel->probe(), &FootprintProbe::changed);
        const Footprint before = bench.footprint();
        bench.inspection.pointAt(faceId(3), {0.2F, 0.2F});
        bench.viewport.lookFrom(0, 60);
        QTest::qWait(50);
        QCOMPARE(changes.count(), 0);
        QCOMPARE(bench.footprint().w1, before.w1);
        bench.panel->show();
        QTRY_COMPARE(bench.panel->probe().live()->placed.face, faceId(3));
    }

    void otherProjectEndsTheFrozenFootprint()
    {
        Bench bench;
        bench.point();
        bench.panel->setFrozen(true);
        bench.document.open(gridProject(2, 1), {}, "other");
        QCoreApplication::processEvents();
        QVERIFY(!bench.panel->isFrozen());
        QVERIFY(!bench.panel->netView().picture());
    }

    void viewMayEndBeforeThePanel()
    {
        Document document;
        Inspection inspection(document);
        ViewSettings settings;
        BackgroundJobs jobs;
        FilterSceneSource source(document, jobs);
        auto viewport = std::make_unique<Viewport>(document, settings);
        document.open(noisyProject(), {}, "noise");
        auto panel = std::make_unique<FootprintPanel>(
            FootprintWork{document, inspection, settings, source, *viewport});
        panel->show();
        inspection.pointAt(kFace, kPoint);
        QTRY_VERIFY(panel->netView().picture());
        viewport.reset(); // as a window that ends does
        panel.reset();
        QVERIFY(inspection.texel());
    }

    void everyControlIsNamedAndExplained()
    {
        Bench bench;
        bench.point();
        int controls = 0;
        for (const QString page : {"Numbers", "Vectors", "Sweep"}) {
            bench.openPage(page);
            for (const QWidget* widget : bench.panel->findChildren<QWidget*>()) {
                if (widget->focusPolicy() == Qt::NoFocus ||
                    !widget->isVisibleTo(bench.panel.get()) || widget->inherits("QLineEdit") ||
                    widget->inherits("QScrollBar")) {
                    continue;
                }
                ++controls;
                const auto* button = qobject_cast<const QAbstractButton*>(widget);
                const bool isNamed = !widget->accessibleName().isEmpty() ||
                                     (button != nullptr && !button->text().isEmpty());
                QVERIFY2(isNamed, widget->metaObject()->className());
                QVERIFY2(!widget->toolTip().isEmpty(), qPrintable(widget->accessibleName()));
            }
        }
        QVERIFY(controls >= 12);
    }

    void playingTheSweepShowsItsPage()
    {
        Bench bench;
        bench.point();
        QVERIFY(!bench.panel->sweepBar().isVisible());
        bench.panel->sweepBar().setPlaying(true);
        QVERIFY(bench.panel->sweepBar().isVisible());
        bench.panel->sweepBar().setPlaying(false);
    }

    void netKeepsItsRoomInALowPanel()
    {
        Bench bench;
        bench.panel->resize(310, 440); // beside the brush in a window 900 pixels high
        bench.point();
        QTRY_VERIFY(bench.panel->netView().height() >= 140);
        QCOMPARE(bench.panel->size(), QSize(310, 440));
        QVERIFY(!bench.panel->netView().visibleRegion().isEmpty());
        QCOMPARE(bench.panel->netView().visibleRegion().boundingRect(),
                 bench.panel->netView().rect());
    }

    void numbersThatStayAreNotDrawnAnew()
    {
        Bench bench;
        bench.point();
        QTRY_VERIFY_WITH_TIMEOUT(bench.row(FootprintRow::Texels).contains("sum to 1.0000"), 20'000);
        QAbstractItemModel* model = bench.panel->table().model();
        QSignalSpy changes(model, &QAbstractItemModel::dataChanged);
        bench.inspection.pointAt(kFace, kPoint + glm::vec2(1e-3F, 0)); // another place, same face
        QCoreApplication::processEvents();
        QVERIFY(!changes.isEmpty());
        // What the place changes is told at once, what takes an answer when that is there.
        QVERIFY(changes.count() < model->rowCount());
        QList<int> rows;
        for (const QList<QVariant>& change : changes) {
            const auto first = change[0].value<QModelIndex>();
            QCOMPARE(first, change[1].value<QModelIndex>()); // one cell
            QCOMPARE(first.column(), 1);
            QVERIFY(!rows.contains(first.row())); // once each
            rows += first.row();
        }
    }

    void netIsNotDrawnAnewForAnswersThatAreNumbers()
    {
        Bench bench;
        bench.point();
        QTRY_VERIFY_WITH_TIMEOUT(bench.panel->netView().picture()->weights, 20'000);
        QTest::qWait(50);
        PaintCount count(bench.panel->netView());
        QSignalSpy changes(bench.panel->table().model(), &QAbstractItemModel::dataChanged);
        bench.settings.setMethod({"exact", std::nullopt});
        // Value, value of exact and weights: the last of them alone are seen in the net.
        QTRY_VERIFY_WITH_TIMEOUT(bench.row(FootprintRow::Difference).startsWith("0 = 0/255"),
                                 20'000);
        QTest::qWait(200);
        QVERIFY(changes.count() >= 2);
        QVERIFY2(count.paints() <= 1, qPrintable(QString::number(count.paints())));
    }

    void selectedNumbersAreCopied()
    {
        Bench bench;
        bench.point();
        FootprintTable& table = bench.panel->table();
        const QModelIndex first = table.model()->index(static_cast<int>(FootprintRow::First), 1);
        table.scrollTo(first);
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, table.visualRect(first).center());
        QApplication::clipboard()->clear();
        QTest::keyClick(&table, Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QApplication::clipboard()->text(), "W1\t" + bench.row(FootprintRow::First) + "\n");
    }
};

} // namespace trixel::ui

QTEST_MAIN(trixel::ui::FootprintPanelTest)
#include "tst_footprint_panel.moc"
