// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;

namespace trixel::ui {

class Document;
class LayerActions;
class LayerCommands;
class LayerList;
class LayerModel;
class ValueRow;

/// The layers of the document: which is painted on, which are shown, in which order and how.
class LayerPanel : public QWidget
{
    Q_OBJECT

public:
    LayerPanel(Document& document,
               LayerCommands& commands,
               const LayerActions& actions,
               QWidget* parent = nullptr);

    /// Lets the name of the active layer be typed.
    void editName();

private:
    QWidget* makeNote();
    QWidget* makeSettings();
    QWidget* makeButtons(const LayerActions& actions);
    void addMenu(const LayerActions& actions);
    void choose(const QModelIndex& index);
    void takeOpacity(double percent);
    void follow();
    void showNote();
    void showSettings();

    Document& m_document;
    LayerCommands& m_commands;
    LayerModel* m_model;
    LayerList* m_list;
    QLabel* m_note = nullptr;
    QPushButton* m_show = nullptr;
    QComboBox* m_blend = nullptr;
    ValueRow* m_opacity = nullptr;
    bool m_dragGoesOn = false; ///< the slider is held since before the latest change
};

} // namespace trixel::ui
