// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "core/layers/layer_stack.h"

#include <array>
#include <cstdint>
#include <functional>

namespace trixel::ui {

class BackgroundJobs;
class Document;

/// What is done to the active layer, or beside it.
enum class LayerCommand : std::uint8_t {
    Add,
    Duplicate,
    Rename,
    Show, ///< or hide
    MoveUp,
    MoveDown,
    GoAbove, ///< another layer becomes the active one
    GoBelow,
    MergeDown,
    Flatten,
    Delete
};

/// In the order in which menus list them.
inline constexpr std::array kLayerCommands{LayerCommand::Add,
                                           LayerCommand::Duplicate,
                                           LayerCommand::Rename,
                                           LayerCommand::Show,
                                           LayerCommand::MoveUp,
                                           LayerCommand::MoveDown,
                                           LayerCommand::GoAbove,
                                           LayerCommand::GoBelow,
                                           LayerCommand::MergeDown,
                                           LayerCommand::Flatten,
                                           LayerCommand::Delete};

/// What panel and menu do with the layers of a document: one undo step each. A stroke in progress
/// ends first, and one that settles is waited for.
class LayerCommands : public QObject
{
    Q_OBJECT

public:
    /// Longest name of a layer, in characters.
    static constexpr int kLongestName = 100;

    LayerCommands(Document& document, BackgroundJobs& jobs, QObject* parent = nullptr);

    /// Why it cannot be done now; empty where it can.
    QString whyNot(LayerCommand command) const;
    /// Does nothing where it cannot be done.
    void run(LayerCommand command);

    /// Another name; the same or none leaves all as it is.
    void rename(LayerId layer, const QString& name);
    void setVisible(LayerId layer, bool isVisible);
    void setBlend(LayerId layer, LayerBlend blend);
    /// \param opacity  in [0,1]
    /// \param goesOn   whether it becomes one step with a change of the opacity right before
    void setOpacity(LayerId layer, float opacity, bool goesOn = false);
    /// \param index  from the bottom, below the number of layers
    void move(LayerId layer, std::size_t index);

signals:
    /// What can be done, or not, is something else now.
    void changed();
    /// The name of the active layer is to be typed.
    void renameWanted();
    /// One sentence about what was done that is not seen; can be undone.
    void done(const QString& sentence);
    void failed(const QString& sentence);

private:
    void whenStill(std::function<void()> edit);
    void change(LayerId layer,
                const QString& text,
                const std::function<void(LayerSettings&)>& edit,
                bool goesOn = false);
    void add(LayerId above);
    void duplicate(LayerId layer);
    void moveBy(int places);
    void go(int places);
    void mergeDown(LayerId layer);
    void flatten();
    void remove(LayerId layer);

    QString whyNoRoom() const;
    QString whyNoMerge(LayerId layer) const;
    /// From the bottom; -1 for the base.
    int placeOf(LayerId layer) const;
    int activePlace() const;
    LayerId layerAt(int place) const;

    Document& m_document;
    BackgroundJobs& m_jobs;
    bool m_isMerging = false;
};

} // namespace trixel::ui
