// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/layers/layer_actions.h"

#include <QAction>
#include <QLabel>
#include <QMenu>

#include "ui/document/document.h"
#include "ui/layers/layer_words.h"
#include "ui/window/actions.h"

namespace trixel::ui {

namespace {

struct Looks
{
    QString text;
    QString tip;
    QKeySequence keys;
    QString icon;
};

Looks looksOf(LayerCommand command)
{
    constexpr auto kCtrl = Qt::CTRL;
    constexpr auto kAlt = Qt::ALT;
    const auto tr = [](const char* text) { return LayerActions::tr(text); };
    switch (command) {
    case LayerCommand::Add:
        return {tr("&New Layer"),
                tr("Add a layer above the active one, to paint over what is there"),
                kCtrl | Qt::SHIFT | Qt::Key_N,
                "layer-add"};
    case LayerCommand::Duplicate:
        return {tr("&Duplicate Layer"),
                tr("Add a copy of the active layer above it"),
                kCtrl | Qt::Key_J,
                "layer-duplicate"};
    case LayerCommand::Rename:
        return {tr("&Rename Layer"), tr("Give the active layer another name"), {}, {}};
    case LayerCommand::Show:
        return {tr("&Show Layer"), tr("Show or hide the active layer"), kCtrl | Qt::Key_Comma, {}};
    case LayerCommand::MoveUp:
        return {tr("Move Layer &Up"),
                tr("Move the active layer above the next one"),
                kCtrl | Qt::Key_BracketRight,
                "layer-up"};
    case LayerCommand::MoveDown:
        return {tr("Move Layer Do&wn"),
                tr("Move the active layer below the one before"),
                kCtrl | Qt::Key_BracketLeft,
                "layer-down"};
    case LayerCommand::GoAbove:
        return {tr("Go to Layer &Above"),
                tr("Paint on the layer above"),
                kAlt | Qt::Key_BracketRight,
                {}};
    case LayerCommand::GoBelow:
        return {tr("Go to Layer &Below"),
                tr("Paint on the layer below"),
                kAlt | Qt::Key_BracketLeft,
                {}};
    case LayerCommand::MergeDown:
        return {tr("&Merge Down"),
                tr("Merge the active layer into the one below"),
                kCtrl | Qt::Key_M,
                "layer-merge"};
    case LayerCommand::Flatten:
        return {tr("&Flatten"), tr("Make what is shown the base, without layers"), {}, {}};
    case LayerCommand::Delete:
        return {tr("D&elete Layer"), tr("Delete the active layer"), {}, "layer-delete"};
    }
    return {};
}

/// A line above, as menus set apart.
bool startsGroup(LayerCommand command)
{
    return command == LayerCommand::MoveUp || command == LayerCommand::GoAbove ||
           command == LayerCommand::MergeDown || command == LayerCommand::Delete;
}

} // namespace

LayerActions::LayerActions(Document& document, LayerCommands& commands, QWidget& window)
    : QObject(&window)
    , m_document(document)
    , m_commands(commands)
{
    for (const LayerCommand command : kLayerCommands) {
        make(command, window);
    }
    connect(&commands, &LayerCommands::changed, this, &LayerActions::follow);
    follow();
}

void LayerActions::make(LayerCommand command, QWidget& window)
{
    const Looks looks = looksOf(command);
    QAction* action = ActionMaker(window)(looks.text, looks.tip, looks.keys, looks.icon);
    action->setCheckable(command == LayerCommand::Show);
    action->setIconText(QString(looks.text).remove('&'));
    connect(action, &QAction::triggered, this, [this, command] {
        m_commands.run(command);
        follow(); // a tick that a click has set stays only where it is so
    });
    m_actions[static_cast<std::size_t>(command)] = action;
}

QAction* LayerActions::action(LayerCommand command) const
{
    return m_actions[static_cast<std::size_t>(command)];
}

void LayerActions::follow()
{
    for (const LayerCommand command : kLayerCommands) {
        QAction* one = action(command);
        const QString why = m_commands.whyNot(command);
        const QString tip = one->statusTip();
        const QString keys = one->shortcut().toString(QKeySequence::NativeText);
        const QString withKeys = keys.isEmpty() ? tip : QString("%1 (%2)").arg(tip, keys);
        one->setEnabled(why.isEmpty());
        one->setToolTip(why.isEmpty() ? withKeys : QString("%1\n%2").arg(withKeys, why));
    }
    const LayerId active = m_document.activeLayer();
    action(LayerCommand::Show)
        ->setChecked(m_document.isOpen() &&
                     (active == kBaseLayer || m_document.layers().settings(active).isVisible));
}

void LayerActions::fillMenu(QMenu& menu) const
{
    for (const LayerCommand command : kLayerCommands) {
        if (startsGroup(command)) {
            menu.addSeparator();
        }
        menu.addAction(action(command));
    }
}

QLabel* LayerActions::makeLabel()
{
    auto* label = new QLabel;
    label->setAccessibleName(tr("Active layer"));
    label->setToolTip(tr("The layer that strokes, erasers and fills change"));
    label->setTextFormat(Qt::PlainText);
    const auto show = [this, label] {
        const LayerStack& layers = m_document.layers();
        const LayerId active = m_document.activeLayer();
        QString name = layerName(layers, active);
        constexpr int kLongest = 24;
        if (name.size() > kLongest) {
            name = name.left(kLongest) + "…";
        }
        const bool isHidden = active != kBaseLayer && !layers.settings(active).isVisible;
        label->setText(isHidden ? tr("On %1 (hidden) ·").arg(name) : tr("On %1 ·").arg(name));
        label->setVisible(!layers.isPlain());
    };
    connect(&m_commands, &LayerCommands::changed, label, show);
    show();
    return label;
}

} // namespace trixel::ui
