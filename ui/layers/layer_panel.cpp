// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/layers/layer_panel.h"

#include <QAction>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/docks/value_row.h"
#include "ui/document/document.h"
#include "ui/layers/layer_actions.h"
#include "ui/layers/layer_commands.h"
#include "ui/layers/layer_list.h"
#include "ui/layers/layer_model.h"
#include "ui/layers/layer_words.h"

namespace trixel::ui {

namespace {

constexpr int kLeastRows = 3; ///< of the list, in a panel as low as can be

} // namespace

LayerPanel::LayerPanel(Document& document,
                       LayerCommands& commands,
                       const LayerActions& actions,
                       QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_commands(commands)
    , m_model(new LayerModel(document, commands, this))
    , m_list(new LayerList)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    m_list->setModel(m_model);
    m_list->setMinimumHeight(kLeastRows * m_list->rowHeight() + 2 * m_list->frameWidth());
    layout->addWidget(m_list, 1);
    layout->addWidget(makeNote());
    layout->addWidget(makeSettings());
    layout->addWidget(makeButtons(actions));
    addMenu(actions);

    connect(
        m_list->selectionModel(), &QItemSelectionModel::currentChanged, this, &LayerPanel::choose);
    connect(
        m_list, &LayerList::deleteWanted, this, [this] { m_commands.run(LayerCommand::Delete); });
    connect(&commands, &LayerCommands::changed, this, &LayerPanel::follow);
    follow();
}

QWidget* LayerPanel::makeNote()
{
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    m_note = new QLabel;
    m_note->setWordWrap(true);
    m_note->setTextFormat(Qt::PlainText);
    m_note->setAccessibleName(tr("Note on the layers"));
    m_show = new QPushButton(tr("Sho&w"));
    m_show->setAccessibleName(tr("Show the active layer"));
    m_show->setToolTip(tr("Show the active layer, to paint on it"));
    layout->addWidget(m_note, 1);
    layout->addWidget(m_show, 0, Qt::AlignTop);
    connect(m_show, &QPushButton::clicked, this, [this] { m_commands.run(LayerCommand::Show); });
    return row;
}

QWidget* LayerPanel::makeSettings()
{
    auto* box = new QWidget;
    auto* form = new QFormLayout(box);
    form->setContentsMargins(0, 0, 0, 0);
    form->setVerticalSpacing(5);
    form->setHorizontalSpacing(8);
    form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_blend = new QComboBox;
    m_blend->setAccessibleName(tr("Blend mode"));
    for (const LayerBlend blend : kLayerBlends) {
        m_blend->addItem(titleOf(blend), static_cast<int>(blend));
    }
    m_blend->setMaxVisibleItems(static_cast<int>(kLayerBlends.size()));
    m_opacity = new ValueRow(Scale::Linear, 0, 100, {tr("Layer opacity"), {}, tr(" %")});
    form->addRow(tr("Ble&nd"), m_blend);
    form->addRow(tr("Opa&city"), m_opacity);
    connect(m_blend, &QComboBox::activated, this, [this] {
        m_commands.setBlend(m_document.activeLayer(),
                            static_cast<LayerBlend>(m_blend->currentData().toInt()));
    });
    connect(m_opacity, &ValueRow::grabbed, this, [this] { m_dragGoesOn = false; });
    connect(m_opacity, &ValueRow::edited, this, &LayerPanel::takeOpacity);
    return box;
}

QWidget* LayerPanel::makeButtons(const LayerActions& actions)
{
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    const auto add = [&](LayerCommand command) {
        auto* button = new QToolButton;
        button->setDefaultAction(actions.action(command));
        button->setToolButtonStyle(Qt::ToolButtonIconOnly);
        button->setAutoRaise(true);
        button->setAccessibleName(actions.action(command)->iconText());
        layout->addWidget(button);
    };
    add(LayerCommand::Add);
    add(LayerCommand::Duplicate);
    add(LayerCommand::MoveUp);
    add(LayerCommand::MoveDown);
    add(LayerCommand::MergeDown);
    layout->addStretch(1);
    add(LayerCommand::Delete);
    return row;
}

void LayerPanel::addMenu(const LayerActions& actions)
{
    m_list->setContextMenuPolicy(Qt::ActionsContextMenu);
    for (const LayerCommand command : kLayerCommands) {
        if (command != LayerCommand::GoAbove && command != LayerCommand::GoBelow) {
            m_list->addAction(actions.action(command));
        }
    }
}

void LayerPanel::editName()
{
    m_list->setFocus(Qt::ShortcutFocusReason);
    m_list->edit(m_list->currentIndex());
}

void LayerPanel::choose(const QModelIndex& index)
{
    if (!m_model->isFollowing() && index.isValid()) {
        m_document.setActiveLayer(m_model->layerAt(index.row()));
    }
}

/// All that one drag does is one step; a number typed is one of its own.
void LayerPanel::takeOpacity(double percent)
{
    const bool isDragged = m_opacity->isDragged();
    m_commands.setOpacity(
        m_document.activeLayer(), static_cast<float>(percent / 100), isDragged && m_dragGoesOn);
    m_dragGoesOn = isDragged;
}

void LayerPanel::follow()
{
    const int row = m_model->rowOf(m_document.activeLayer());
    if (row != m_list->currentIndex().row()) {
        m_list->setCurrentIndex(m_model->index(row));
    }
    showNote();
    showSettings();
}

void LayerPanel::showNote()
{
    const LayerStack& layers = m_document.layers();
    const LayerId active = m_document.activeLayer();
    const bool isHidden = active != kBaseLayer && !layers.settings(active).isVisible;
    QString note;
    if (!m_document.isOpen()) {
        note = tr("No mesh is open.");
    } else if (layers.isPlain()) {
        note = tr("Strokes change the base. Add a layer (Ctrl+Shift+N) to paint over it and leave "
                  "it as it is.");
    } else {
        note = whyUnseen(layers, active);
    }
    m_note->setText(note);
    m_note->parentWidget()->setVisible(!note.isEmpty());
    m_show->setVisible(isHidden);
}

void LayerPanel::showSettings()
{
    const LayerId active = m_document.activeLayer();
    const bool isSet = active != kBaseLayer;
    const LayerSettings settings = isSet ? m_document.layers().settings(active) : LayerSettings();
    const QString why = tr("The base has no settings: it is opaque and always shown.");
    m_blend->setEnabled(isSet);
    m_blend->setCurrentIndex(m_blend->findData(static_cast<int>(settings.blend)));
    m_blend->setToolTip(isSet ? tr("How the active layer meets what lies below") : why);
    m_opacity->setEnabled(isSet);
    if (!m_opacity->isDragged()) {
        m_opacity->setValue(100 * static_cast<double>(settings.opacity));
    }
    m_opacity->setHint(isSet ? tr("How much of the active layer is seen") : why);
}

} // namespace trixel::ui
