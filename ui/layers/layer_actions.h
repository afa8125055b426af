// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

#include "ui/layers/layer_commands.h"

#include <array>

class QAction;
class QLabel;
class QMenu;
class QWidget;

namespace trixel::ui {

class Document;

/// The commands of layers as actions, for the menu, the panel's buttons and its context menu. Those
/// that cannot be done say why in their tool tips.
class LayerActions : public QObject
{
    Q_OBJECT

public:
    LayerActions(Document& document, LayerCommands& commands, QWidget& window);

    QAction* action(LayerCommand command) const;
    void fillMenu(QMenu& menu) const;
    /// Names the active layer where there are layers.
    QLabel* makeLabel();

private:
    void make(LayerCommand command, QWidget& window);
    void follow();

    Document& m_document;
    LayerCommands& m_commands;
    std::array<QAction*, kLayerCommands.size()> m_actions{};
};

} // namespace trixel::ui
