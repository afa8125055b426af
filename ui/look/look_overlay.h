// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "ui/viewport/hovered_texel.h"

#include <optional>

class QToolButton;

namespace trixel::ui {

class Document;
class LookLegend;
class ViewSettings;
class Viewport;

/// In the upper left corner of the view: a chip that says in what the look differs from the neutral
/// one, so that nobody paints under a false look unaware, and resets it when clicked; below it the
/// legend of false colours and marks.
class LookOverlay : public QObject
{
    Q_OBJECT

public:
    /// A child of the view.
    LookOverlay(const Document& document, ViewSettings& settings, Viewport& viewport);

    const QToolButton& chip() const { return *m_chip; }
    const LookLegend& legend() const { return *m_legend; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void showLook();
    void place();
    void takeHovered(const std::optional<HoveredTexel>& texel);

    const Document& m_document;
    ViewSettings& m_settings;
    Viewport& m_viewport;
    QToolButton* m_chip;
    LookLegend* m_legend;
    QString m_words;
};

} // namespace trixel::ui
