// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/views/view_camera.h"
#include "ui/document/document_step.h"

namespace trixel::ui {

/// Undo command of any change of the bookmarked views: undo and redo are the same exchange.
class SwapViews : public DocumentStep
{
public:
    /// \param next   the views to come; the redo of the push puts them in place
    /// \param state  the name of the document's state after the change
    SwapViews(Document& document, SceneViews next, StateId state, const QString& text);

    void undo() override;
    void redo() override;

private:
    Document& m_document;
    SceneViews m_views;
};

} // namespace trixel::ui
