// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "core/layers/layer_stack.h"
#include "core/texture/texel_store.h"
#include "ui/document/document_step.h"

#include <memory>
#include <optional>

namespace trixel::ui {

/// A stack of layers, what it looks like and which of it is painted.
struct LayersState
{
    LayerStack layers;
    std::optional<TexelStore> shown; ///< none where it has not been worked out
    LayerId active = kBaseLayer;
};

/// Undo command of any change of layers that is not paint: undo and redo are the same exchange,
/// which costs the same for any number of faces. The stacks share what is alike in them.
class SwapLayers : public DocumentStep
{
public:
    /// What is changed, other than how all looks.
    struct Kind
    {
        std::optional<LayerId> set; ///< the one layer whose settings it changes, and nothing else
        bool goesOn = false;        ///< becomes one with the step before, if that set this layer
        bool changesLevels = false; ///< of some face
    };

    /// \param next   to come; the redo of the push puts it in place
    /// \param state  the name of the document's state after the change
    SwapLayers(Document& document, LayersState next, Kind kind, StateId state, const QString& text);

    void undo() override;
    void redo() override;
    int id() const override;
    bool mergeWith(const QUndoCommand* next) override;

private:
    Document& m_document;
    std::shared_ptr<LayersState> m_other; ///< that the document does not have
    Kind m_kind;
    QObject m_watch; ///< hears of what is to be released with the document's
};

} // namespace trixel::ui
