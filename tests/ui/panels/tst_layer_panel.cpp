// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QPersistentModelIndex>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QStyleOptionSlider>
#include <QTabBar>
#include <QToolButton>

#include "tests/ui/window/window_fixture.h"
#include "ui/layers/layer_commands.h"
#include "ui/layers/layer_list.h"
#include "ui/layers/layer_model.h"
#include "ui/layers/layer_panel.h"
#include "ui/layers/layer_words.h"

#include <algorithm>
#include <random>
#include <ranges>

namespace trixel::ui {

namespace {

/// The grid with so many layers, "Layer 1" the lowest.
LayerStack layersOver(const TexelStore& base, int count)
{
    LayerStack layers(base);
    for (int k = 0; k < count; ++k) {
        LayerSettings settings;
        settings.name = "Layer " + std::to_string(k + 1);
        layers.insert(static_cast<std::size_t>(k), settings);
    }
    return layers;
}

QStringList namesIn(const QAbstractItemModel& model)
{
    QStringList names;
    for (int row = 0; row < model.rowCount(); ++row) {
        names += model.index(row, 0).data().toString();
    }
    return names;
}

QPoint handleOf(const QSlider& slider)
{
    QStyleOptionSlider option;
    option.initFrom(&slider);
    option.subControls = QStyle::SC_SliderHandle;
    option.orientation = slider.orientation();
    option.minimum = slider.minimum();
    option.maximum = slider.maximum();
    option.sliderPosition = slider.sliderPosition();
    option.sliderValue = slider.value();
    return slider.style()
        ->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, &slider)
        .center();
}

/// Takes the handle and moves it to a share of the slider's length, in several steps.
void dragSlider(QSlider& slider, double to)
{
    const QPoint from = handleOf(slider);
    const QPoint end(static_cast<int>(to * slider.width()), from.y());
    QTest::mousePress(&slider, Qt::LeftButton, {}, from);
    for (int step = 1; step <= 6; ++step) {
        QTest::mouseMove(&slider, from + (end - from) * step / 6);
    }
    QTest::mouseRelease(&slider, Qt::LeftButton, {}, end);
}

} // namespace

class LayerPanelTest : public WindowTest
{
    Q_OBJECT

private slots:
    void init()
    {
        openWindow();
        openGrid();
        dock().show();
        dock().raise();
        QTRY_VERIFY(!list().visibleRegion().isEmpty());
    }
    void cleanup() { closeWindow(); }

    void theModelKeepsThePromisesOfModels()
    {
        Document document;
        BackgroundJobs jobs;
        LayerCommands commands(document, jobs);
        LayerModel model(document, commands);
        const QAbstractItemModelTester tester(
            &model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        QCOMPARE(model.rowCount(), 0);
        document.open(gridProject(2, 1), {}, "grid");
        QCOMPARE(namesIn(model), QStringList{"Base"});
        std::mt19937 random(7);
        for (int k = 0; k < 300; ++k) {
            const int rows = model.rowCount();
            const int row = static_cast<int>(random() % static_cast<unsigned>(rows));
            document.setActiveLayer(model.layerAt(row));
            const auto command = std::array{LayerCommand::Add,
                                            LayerCommand::Add,
                                            LayerCommand::Duplicate,
                                            LayerCommand::MoveUp,
                                            LayerCommand::MoveDown,
                                            LayerCommand::Show,
                                            LayerCommand::Delete}[random() % 7];
            if (random() % 4 == 0) {
                random() % 2 == 0 ? document.undoStack().undo() : document.undoStack().redo();
            } else if (command != LayerCommand::Add || rows < 12) {
                commands.run(command);
            }
            QStringList expected;
            for (const Layer& layer : std::views::reverse(document.layers().layers())) {
                expected += QString::fromStdString(layer.settings.name);
            }
            QCOMPARE(namesIn(model), expected + QStringList{"Base"});
        }
    }

    void whatPointsAtALayerGoesWithIt()
    {
        Document document;
        BackgroundJobs jobs;
        LayerCommands commands(document, jobs);
        document.open(gridProject(2, 1), {}, "grid");
        document.editLayers(layersOver(document.texels(), 4), LayerId{2}, "layers");
        LayerModel model(document, commands);
        const QPersistentModelIndex second = model.index(model.rowOf(LayerId{2}));
        commands.move(LayerId{2}, 3);
        QCOMPARE(second.row(), 0);
        commands.move(LayerId{3}, 0);
        commands.run(LayerCommand::Add);
        QCOMPARE(second.row(), 1);
        QCOMPARE(model.layerAt(second.row()), LayerId{2});
        document.setActiveLayer(LayerId{2});
        commands.run(LayerCommand::Delete);
        QVERIFY(!second.isValid());
    }

    void aTextureWithoutLayersIsItsBaseAlone()
    {
        QCOMPARE(names(), QStringList{"Base"});
        QVERIFY(note().contains("Ctrl+Shift+N"));
        QVERIFY(document().layers().isPlain());
    }

    void aNewLayerLiesOverTheActiveOneAndIsActive()
    {
        press(Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(names(), (QStringList{"Layer 1", "Base"}));
        QCOMPARE(current(), "Layer 1");
        click("New Layer");
        QCOMPARE(names(), (QStringList{"Layer 2", "Layer 1", "Base"}));
        choose("Layer 1");
        click("New Layer");
        QCOMPARE(names(), (QStringList{"Layer 2", "Layer 3", "Layer 1", "Base"}));
        QCOMPARE(current(), "Layer 3");
        press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(names(), (QStringList{"Layer 2", "Layer 1", "Base"}));
        QCOMPARE(current(), "Layer 1");
        press(Qt::Key_Z, Qt::ControlModifier);
        press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(names(), QStringList{"Base"});
        QVERIFY(document().layers().isPlain());
    }

    void strokesLandOnTheActiveLayer()
    {
        withLayers(2);
        choose("Layer 1");
        const std::vector<std::byte> base = allTexels(document().layers().base());
        const std::vector<std::byte> shown = allTexels(document().texels());
        const auto covers = [&](LayerId layer) {
            return std::ranges::any_of(allTexels(document().layers().texels(layer)),
                                       [](std::byte b) { return b != std::byte{0}; });
        };
        stroke();
        QVERIFY(covers(LayerId{1}));
        QVERIFY(!covers(LayerId{2}));
        QVERIFY(allTexels(document().layers().base()) == base);
        QVERIFY(allTexels(document().texels()) != shown);
        press(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(!covers(LayerId{1}));
        QVERIFY(allTexels(document().texels()) == shown);

        choose("Base");
        stroke();
        QVERIFY(!covers(LayerId{1}) && !covers(LayerId{2}));
        QVERIFY(allTexels(document().layers().base()) != base);
    }

    void theEyeHidesALayerWithoutChoosingIt()
    {
        withLayers(2);
        choose("Layer 2");
        stroke();
        const std::vector<std::byte> painted = allTexels(document().texels());
        choose("Layer 1");
        clickEye("Layer 2");
        QVERIFY(!isVisible("Layer 2"));
        QCOMPARE(current(), "Layer 1");
        QVERIFY(allTexels(document().texels()) != painted);
        press(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(isVisible("Layer 2"));
        QVERIFY(allTexels(document().texels()) == painted);
        clickEye("Layer 2");
        clickEye("Layer 2");
        QVERIFY(isVisible("Layer 2"));
    }

    void allOfAnEyesPlaceIsTheEyes()
    {
        withLayers(2);
        choose("Layer 1");
        const QRect place = list().eyeRect(row("Layer 2")).adjusted(1, 1, -1, -1);
        bool isShown = true;
        for (const QPoint at : {place.topLeft(), place.bottomRight()}) {
            QTest::mousePress(list().viewport(), Qt::LeftButton, {}, at);
            isShown = !isShown;
            QCOMPARE(isVisible("Layer 2"), isShown);
            const QPoint name = list().visualRect(row("Layer 2")).center();
            QTest::mouseMove(list().viewport(), name); // drags nothing
            QTest::mouseRelease(list().viewport(), Qt::LeftButton, {}, at);
            QCOMPARE(isVisible("Layer 2"), isShown);
            QCOMPARE(current(), "Layer 1");
        }
        choose("Layer 2"); // beside it
        QVERIFY(isVisible("Layer 2"));
    }

    void aDoubleClickOnAnEyeIsTwoClicks()
    {
        withLayers(1);
        doubleClick(eye("Layer 1"));
        QVERIFY(isVisible("Layer 1"));
        QVERIFY(!editor());
    }

    void spaceShowsAndHidesTheChosenLayer()
    {
        withLayers(1);
        choose("Layer 1");
        QTest::keyClick(&list(), Qt::Key_Space);
        QVERIFY(!isVisible("Layer 1"));
        press(Qt::Key_Comma, Qt::ControlModifier);
        QVERIFY(isVisible("Layer 1"));
        choose("Base");
        QTest::keyClick(&list(), Qt::Key_Space);
        QCOMPARE(names(), (QStringList{"Layer 1", "Base"}));
    }

    void aHiddenActiveLayerIsToldOfAndShownByAButton()
    {
        withLayers(1);
        choose("Layer 1");
        QVERIFY(!widgetNamed<QPushButton>(dock(), "Show the active layer"));
        clickEye("Layer 1");
        QVERIFY(note().contains("Layer 1 is hidden"));
        QCOMPARE(label(), "On Layer 1 (hidden) ·");
        QTest::mouseClick(widgetNamed<QPushButton>(dock(), "Show the active layer"),
                          Qt::LeftButton);
        QVERIFY(isVisible("Layer 1"));
        QVERIFY(note().isEmpty());
    }

    void namesAreTypedInTheirPlace()
    {
        withLayers(2);
        choose("Layer 1");
        QTest::keyClick(&list(), Qt::Key_F2);
        QVERIFY(editor());
        QTest::keyClicks(editor(), "  Moss  & lichen ");
        QTest::keyClick(editor(), Qt::Key_Return);
        QTRY_COMPARE(names(), (QStringList{"Layer 2", "Moss & lichen", "Base"}));
        QTRY_VERIFY(!editor());
        QCOMPARE(document().undoStack().undoText(), QString("Rename layer"));
        QVERIFY(dock().isVisible()); // F2 was meant for the list alone

        const QRect row = list().visualRect(list().model()->index(0, 0));
        doubleClick(row.center());
        QTRY_VERIFY(editor());
        editor()->selectAll();
        QTest::keyClicks(editor(), "Rust");
        QTest::keyClick(editor(), Qt::Key_Escape);
        QTRY_VERIFY(!editor());
        QCOMPARE(names(), (QStringList{"Layer 2", "Moss & lichen", "Base"}));
        press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(names(), (QStringList{"Layer 2", "Layer 1", "Base"}));
    }

    void aNameOfNothingOrTheSameChangesNothing()
    {
        withLayers(1);
        const int before = document().undoStack().index();
        QAbstractItemModel& model = *list().model();
        for (const QString& name : {QString(), QString("   "), QString("Layer 1")}) {
            model.setData(model.index(0, 0), name, Qt::EditRole);
        }
        QVERIFY(!model.setData(model.index(1, 0), "Mine", Qt::EditRole)); // the base
        QCOMPARE(document().undoStack().index(), before);
        model.setData(model.index(0, 0), QString(500, 'x'), Qt::EditRole);
        QCOMPARE(names().constFirst().size(), qsizetype{LayerCommands::kLongestName});
    }

    void aDragOfTheOpacityIsOneStep()
    {
        withLayers(1);
        choose("Layer 1");
        stroke();
        const std::vector<std::byte> opaque = allTexels(document().texels());
        const int before = document().undoStack().index();
        auto* slider = widgetNamed<QSlider>(dock(), "Layer opacity slider");
        dragSlider(*slider, 0.5);
        const float once = opacity();
        QVERIFY2(once > 0.3F && once < 0.7F, qPrintable(QString::number(once)));
        QCOMPARE(document().undoStack().index(), before + 1);
        QVERIFY(allTexels(document().texels()) != opaque);
        dragSlider(*slider, 0.2);
        QCOMPARE(document().undoStack().index(), before + 2);
        press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(opacity(), once);
        press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(opacity(), 1.0F);
        QVERIFY(allTexels(document().texels()) == opaque);
        QCOMPARE(slider->value(), slider->maximum());
    }

    void aTypedOpacityIsAStep()
    {
        withLayers(1);
        choose("Layer 1");
        const int before = document().undoStack().index();
        auto* spin = widgetNamed<QDoubleSpinBox>(dock(), "Layer opacity");
        for (const char* number : {"40", "60"}) {
            spin->setFocus();
            spin->selectAll();
            QTest::keyClicks(spin, number);
            QTest::keyClick(spin, Qt::Key_Return);
        }
        QCOMPARE(opacity(), 0.6F);
        QCOMPARE(document().undoStack().index(), before + 2);
        QCOMPARE(list().model()->index(0, 0).data(LayerModel::Hint).toString(), QString("60 %"));
        QCOMPARE(list().model()->index(0, 0).data(LayerModel::Opacity).toFloat(), 0.6F);
    }

    void theBlendModeIsChosenByKeyboard()
    {
        withLayers(1);
        choose("Layer 1");
        auto* blend = widgetNamed<QComboBox>(dock(), "Blend mode");
        blend->setFocus();
        QTest::keyClick(blend, Qt::Key_Down);
        QCOMPARE(document().layers().settings(LayerId{1}).blend, LayerBlend::Multiply);
        QCOMPARE(list().model()->index(0, 0).data(LayerModel::Hint).toString(),
                 QString("Multiply"));
        press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(blend->currentText(), QString("Normal"));
    }

    void theBaseHasNoSettingsAndSaysSo()
    {
        withLayers(1);
        choose("Base");
        for (QWidget* field :
             {static_cast<QWidget*>(widgetNamed<QComboBox>(dock(), "Blend mode")),
              static_cast<QWidget*>(widgetNamed<QDoubleSpinBox>(dock(), "Layer opacity"))}) {
            QVERIFY(!field->isEnabled());
            QVERIFY2(field->toolTip().contains("base"), qPrintable(field->toolTip()));
        }
        for (const char* name : {"Delete Layer",
                                 "Duplicate Layer",
                                 "Merge Down",
                                 "Move Layer Up",
                                 "Move Layer Down"}) {
            QVERIFY2(!button(name)->isEnabled(), name);
            QVERIFY2(button(name)->toolTip().contains('\n'), name); // and why
        }
        choose("Layer 1");
        QVERIFY(widgetNamed<QComboBox>(dock(), "Blend mode")->isEnabled());
        QVERIFY(button("Delete Layer")->isEnabled());
    }

    void rowsAreMovedByDropsAndKeys()
    {
        withLayers(3);
        choose("Layer 1");
        QAbstractItemModel& model = *list().model();
        QVERIFY(model.moveRow({}, 2, {}, 0)); // as a list does when a row is let go of
        QCOMPARE(names(), (QStringList{"Layer 1", "Layer 3", "Layer 2", "Base"}));
        QCOMPARE(current(), "Layer 1");
        QVERIFY(model.moveRow({}, 0, {}, 4)); // below the base: as low as can be
        QCOMPARE(names(), (QStringList{"Layer 3", "Layer 2", "Layer 1", "Base"}));
        QVERIFY(!model.moveRow({}, 3, {}, 0)); // the base stays
        QVERIFY(!(model.index(3, 0).flags() & Qt::ItemIsDragEnabled));
        press(Qt::Key_BracketRight, Qt::ControlModifier);
        QCOMPARE(names(), (QStringList{"Layer 3", "Layer 1", "Layer 2", "Base"}));
        press(Qt::Key_BracketLeft, Qt::ControlModifier);
        QCOMPARE(names(), (QStringList{"Layer 3", "Layer 2", "Layer 1", "Base"}));
        QVERIFY(!button("Move Layer Down")->isEnabled());
        press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(names(), (QStringList{"Layer 3", "Layer 1", "Layer 2", "Base"}));
    }

    void arrowsAndKeysGoFromLayerToLayer()
    {
        withLayers(2);
        choose("Layer 2");
        QTest::keyClick(&list(), Qt::Key_Down);
        QCOMPARE(current(), "Layer 1");
        m_window->viewport().setFocus();
        press(Qt::Key_BracketLeft, Qt::AltModifier);
        QCOMPARE(current(), "Base");
        press(Qt::Key_BracketLeft, Qt::AltModifier);
        QCOMPARE(current(), "Base");
        press(Qt::Key_BracketRight, Qt::AltModifier);
        QCOMPARE(current(), "Layer 1");
        QCOMPARE(label(), "On Layer 1 ·");
    }

    void aCopyLiesAboveAndHoldsTheSame()
    {
        withLayers(1);
        choose("Layer 1");
        stroke();
        press(Qt::Key_J, Qt::ControlModifier);
        QCOMPARE(names(), (QStringList{"Layer 1 copy", "Layer 1", "Base"}));
        const auto layers = document().layers().layers();
        QVERIFY(allTexels(layers[0].texels) == allTexels(layers[1].texels));
        QCOMPARE(current(), "Layer 1 copy");
    }

    void aLayerIsMergedIntoTheOneBelow()
    {
        withLayers(2);
        choose("Layer 2");
        stroke();
        const std::vector<std::byte> shown = allTexels(document().texels());
        press(Qt::Key_M, Qt::ControlModifier);
        QTRY_COMPARE(names(), (QStringList{"Layer 1", "Base"}));
        QCOMPARE(current(), "Layer 1");
        QVERIFY(allTexels(document().texels()) == shown);
        QTest::mouseClick(button("Merge Down"), Qt::LeftButton);
        QTRY_COMPARE(names(), QStringList{"Base"});
        QVERIFY(document().layers().isPlain());
        QVERIFY(allTexels(document().texels()) == shown);
        press(Qt::Key_Z, Qt::ControlModifier);
        press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(names(), (QStringList{"Layer 2", "Layer 1", "Base"}));
        QVERIFY(allTexels(document().texels()) == shown);
    }

    void hiddenLayersAreNotMerged()
    {
        withLayers(2);
        choose("Layer 2");
        clickEye("Layer 2");
        QVERIFY(!button("Merge Down")->isEnabled());
        QVERIFY(button("Merge Down")->toolTip().contains("hidden"));
        clickEye("Layer 2");
        QVERIFY(button("Merge Down")->isEnabled());
        clickEye("Layer 1");
        QVERIFY(!button("Merge Down")->isEnabled());
    }

    void aMergeThatCameTooLateIsDropped()
    {
        withLayers(2);
        choose("Layer 2");
        press(Qt::Key_M, Qt::ControlModifier);
        fillFace(3);
        QTRY_VERIFY(m_window->jobs().isIdle());
        QCOMPARE(names(), (QStringList{"Layer 2", "Layer 1", "Base"}));
        QVERIFY(m_window->messages().sentence().contains("nothing was done"));
        QVERIFY(button("Merge Down")->isEnabled());
    }

    void aMergeKeepsWhatWasSetMeanwhile()
    {
        Document document;
        BackgroundJobs jobs;
        LayerCommands commands(document, jobs);
        document.open(gridProject(120, 2), {}, "many"); // so many faces that looks take a while
        document.editLayers(layersOver(document.texels(), 3), LayerId{2}, "layers");
        QTRY_VERIFY(!document.isSettling());
        commands.run(LayerCommand::MergeDown);
        QTest::qSleep(300); // it is made by now, as a rule, but not told
        commands.setOpacity(LayerId{3}, 0.5F);
        QVERIFY(document.isSettling());
        QTRY_VERIFY(jobs.isIdle() && !document.isSettling());
        QCOMPARE(document.layers().settings(LayerId{3}).opacity, 0.5F);
    }

    void whatIsAskedForWhilePaintSettlesIsDoneToTheLayerItWasAskedFor()
    {
        Document document;
        BackgroundJobs jobs;
        LayerCommands commands(document, jobs);
        document.open(gridProject(8, 4), {}, "grid");
        document.editLayers(layersOver(document.texels(), 3), LayerId{3}, "layers");
        Brush brush;
        brush.radius = 0.2F;
        document.beginStroke(brush, StrokePace::Behind);
        document.extendStroke({FaceId{0}, {0.3F, 0.3F}, 1, 0});
        commands.run(LayerCommand::Delete);
        QVERIFY(document.isSettling());
        document.setActiveLayer(LayerId{1});
        QTRY_VERIFY(!document.layers().has(LayerId{3}));
        QVERIFY(document.layers().has(LayerId{1}));
        QCOMPARE(document.activeLayer(), LayerId{1});
    }

    void layersThatGoChooseNoOther()
    {
        withLayers(4);
        choose("Layer 4");
        LayerStack next = document().layers();
        next.remove(LayerId{4});
        QSignalSpy active(&document(), &Document::activeLayerChanged);
        QVERIFY(document().editLayers(std::move(next), kBaseLayer, "without the top"));
        QCOMPARE(active.size(), 1); // not for the row's neighbour
        QCOMPARE(document().activeLayer(), kBaseLayer);
        QCOMPARE(current(), "Base");
        document().undoStack().undo();
        QCOMPARE(current(), "Layer 4");
    }

    void deleteTakesAwayTheActiveLayerAndTheLastLeavesAPlainTexture()
    {
        withLayers(2);
        choose("Layer 2");
        QTest::keyClick(&list(), Qt::Key_Delete);
        QCOMPARE(names(), (QStringList{"Layer 1", "Base"}));
        QCOMPARE(current(), "Layer 1");
        click("Delete Layer");
        QVERIFY(document().layers().isPlain());
        QTest::keyClick(&list(), Qt::Key_Delete);
        QCOMPARE(names(), QStringList{"Base"});
        press(Qt::Key_Z, Qt::ControlModifier);
        press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(names(), (QStringList{"Layer 2", "Layer 1", "Base"}));
        QCOMPARE(current(), "Layer 2");
    }

    void flatteningTellsOfHiddenLayersThatGo()
    {
        withLayers(2);
        choose("Layer 1");
        stroke();
        clickEye("Layer 2");
        const std::vector<std::byte> shown = allTexels(document().texels());
        actionNamed(*m_window, "Flatten")->trigger();
        QVERIFY(document().layers().isPlain());
        QVERIFY(allTexels(document().texels()) == shown);
        QVERIFY(m_window->messages().sentence().contains("hidden layer"));
        press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(names(), (QStringList{"Layer 2", "Layer 1", "Base"}));
        QVERIFY(!isVisible("Layer 2"));
    }

    void aFullStackSaysWhyNoMoreFit()
    {
        document().open(gridProject(1, 0), {}, "grid");
        LayerStack layers(document().texels());
        while (layers.hasRoom()) {
            layers.insert(0, {});
        }
        QVERIFY(document().editLayers(layers, kBaseLayer, "many"));
        QVERIFY(!button("New Layer")->isEnabled());
        QVERIFY2(button("New Layer")->toolTip().contains("64"),
                 qPrintable(button("New Layer")->toolTip()));
        document().undoStack().undo();
        QVERIFY(button("New Layer")->isEnabled());
    }

    void anotherProjectShowsItsOwnLayers()
    {
        withLayers(3);
        choose("Layer 2");
        document().open(gridProject(4, 2), {}, "other");
        QCOMPARE(names(), QStringList{"Base"});
        QCOMPARE(current(), "Base");
        QVERIFY(label().isEmpty());
    }

    void layerCommandsAreInTheirMenu()
    {
        const QMenu* menu = nullptr;
        for (const QAction* action : m_window->menuBar()->actions()) {
            menu = QString(action->text()).remove('&') == "Layer" ? action->menu() : menu;
        }
        QVERIFY(menu);
        for (const char* name : {"New Layer", "Duplicate Layer", "Show Layer", "Merge Down"}) {
            QVERIFY2(menu->actions().contains(actionNamed(*m_window, name)), name);
        }
        QVERIFY(actionNamed(*m_window, "Show Layer")->isChecked()); // the base always is
        actionNamed(*m_window, "New Layer")->trigger();
        actionNamed(*m_window, "Show Layer")->trigger();
        QVERIFY(!isVisible("Layer 1"));
        QVERIFY(!actionNamed(*m_window, "Show Layer")->isChecked());
        dock().hide();
        actionNamed(*m_window, "Rename Layer")->trigger();
        QTRY_VERIFY(!dock().visibleRegion().isEmpty());
        QTRY_VERIFY(editor());
    }

    void tabsOfPanelsTellTheirFullTitles()
    {
        int tabs = 0;
        for (const QTabBar* bar : m_window->findChildren<QTabBar*>()) {
            for (int k = 0; bar->parent() == m_window.get() && k < bar->count(); ++k) {
                QVERIFY2(bar->tabToolTip(k).startsWith(bar->tabText(k)),
                         qPrintable(bar->tabText(k)));
                ++tabs;
            }
        }
        QVERIFY(tabs > 6);
    }

private:
    QDockWidget& dock() const { return *m_window->findChild<QDockWidget*>("layerPanel"); }
    LayerList& list() const { return *dock().findChild<LayerList*>(); }
    QStringList names() const { return namesIn(*list().model()); }
    QString current() const { return list().currentIndex().data().toString(); }
    QLineEdit* editor() const { return list().findChild<QLineEdit*>(); }
    QToolButton* button(const QString& name) const
    {
        return widgetNamed<QToolButton>(dock(), name);
    }
    QString note() const
    {
        auto* shown = widgetNamed<QLabel>(dock(), "Note on the layers");
        return shown != nullptr ? shown->text() : QString();
    }
    QString label() const
    {
        auto* shown = widgetNamed<QLabel>(*m_window, "Active layer");
        return shown != nullptr ? shown->text() : QString();
    }
    float opacity() { return document().layers().settings(LayerId{1}).opacity; }

    void withLayers(int count)
    {
        QVERIFY(document().editLayers(
            layersOver(document().texels(), count), kBaseLayer, "with layers"));
    }
    void click(const QString& name) const { QTest::mouseClick(button(name), Qt::LeftButton); }
    QModelIndex row(const QString& name) const
    {
        return list().model()->index(static_cast<int>(names().indexOf(name)), 0);
    }
    void choose(const QString& name) const
    {
        QTest::mouseClick(
            list().viewport(), Qt::LeftButton, {}, list().visualRect(row(name)).center());
        QCOMPARE(current(), name);
    }
    QPoint eye(const QString& name) const { return list().eyeRect(row(name)).center(); }
    void clickEye(const QString& name) const
    {
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, eye(name));
    }
    /// As a mouse does: the second press is what tells of it.
    void doubleClick(QPoint at) const
    {
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, at);
        QTest::mouseDClick(list().viewport(), Qt::LeftButton, {}, at);
    }
    bool isVisible(const QString& name) const
    {
        return row(name).data(Qt::CheckStateRole).toInt() == Qt::Checked;
    }
    /// With the pointer, over the middle of the view.
    void stroke()
    {
        Viewport& view = m_window->viewport();
        const QPoint middle = view.rect().center();
        QTRY_VERIFY(view.surfacePointAt(middle).has_value());
        QTest::mousePress(&view, Qt::LeftButton, {}, middle);
        for (int step = 1; step <= 5; ++step) {
            QTest::mouseMove(&view, middle + QPoint(6 * step, 2 * step));
        }
        QTest::mouseRelease(&view, Qt::LeftButton, {}, middle + QPoint(30, 10));
        QTRY_VERIFY(!document().hasStroke());
    }
};

} // namespace trixel::ui

TRIXEL_WINDOW_TEST_MAIN(trixel::ui::LayerPanelTest)
#include "tst_layer_panel.moc"
