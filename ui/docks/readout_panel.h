// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QTimer>
#include <QWidget>

#include "ui/viewport/hover_filter.h"
#include "ui/viewport/hovered_texel.h"

#include <array>
#include <optional>

class QAction;
class QFormLayout;
class QLabel;
class QToolButton;

namespace trixel::ui {

class Document;
class Inspection;
class SwatchButton;

/// Everything about the texel looked at, to the last digit. The text of every row can be selected,
/// neighbours can be gone to; the last texel stays to be read and copied when the pointer leaves
/// the surface.
class ReadoutPanel : public QWidget
{
    Q_OBJECT

public:
    ReadoutPanel(const Document& document, Inspection& inspection, QWidget* parent = nullptr);

    /// What is seen of it follows with the next turn of the event loop, and not while the panel is
    /// hidden.
    void show(const std::optional<HoveredTexel>& texel);
    /// What filters make of the pixel that is shown.
    void showFiltered(const FilteredTexel& texel);
    /// They make nothing of it. \param reason  a sentence for the tool tips; may be empty
    void showUnfiltered(const QString& reason);
    void clear();

    /// The texel shown last.
    const std::optional<HoveredTexel>& texel() const { return m_texel; }
    /// All rows as lines of text, for the clipboard; those of the filters as far as they are known.
    QString text() const;

    /// Commands that the button Copy offers.
    void setCopyActions(const QList<QAction*>& actions);

protected:
    void showEvent(QShowEvent* event) override;

private:
    struct Row
    {
        QLabel* name = nullptr;
        QLabel* value = nullptr;
    };

    QLayout* makeHeader();
    void addTexelRows(QFormLayout& form);
    void addPixelRows(QFormLayout& form);
    QLabel& addRow(QFormLayout& form,
                   const QString& name,
                   const QString& toolTip,
                   QWidget* beside = nullptr);
    void set(const QString& name, const QString& value);
    void refresh();
    void showNeighbours();
    std::array<QString, 4> footprintValues() const;
    void showHeld();

    const Document& m_document;
    Inspection& m_inspection;
    std::optional<HoveredTexel> m_texel;
    QTimer m_soon; ///< several texels of one turn are shown once
    QHash<QString, Row> m_rows;
    QLabel* m_address = nullptr;
    QToolButton* m_hold = nullptr;
    QToolButton* m_copy = nullptr;
    QToolButton* m_hex = nullptr;
    SwatchButton* m_chip = nullptr;
};

} // namespace trixel::ui
