// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/viewport/hover_filter.h"
#include "ui/viewport/viewport.h"

#include <array>
#include <optional>

class QFormLayout;
class QLabel;

namespace trixel::ui {

class Document;
class SwatchButton;

/// Everything about the texel under the pointer, to the last digit. The text of every row can be
/// selected; the last texel stays to be read and copied when the pointer leaves the surface.
class ReadoutPanel : public QWidget
{
    Q_OBJECT

public:
    explicit ReadoutPanel(const Document& document, QWidget* parent = nullptr);

    void show(const std::optional<HoveredTexel>& texel);
    /// What filters make of the pixel that is shown.
    void showFiltered(const FilteredTexel& texel);
    /// They make nothing of it. \param reason  a sentence for the tool tips; may be empty
    void showUnfiltered(const QString& reason);
    void clear();
    /// All rows as lines of text, for the clipboard.
    QString text() const;

private:
    enum Row {
        Face,
        Resolution,
        Texel,
        Storage,
        Barycentric,
        Position,
        Stored,
        Shown,
        FirstVector,
        SecondVector,
        Ellipse,
        Width,
        Filtered,
        Exact,
        Error,
        ReadAt,
        RowCount
    };

    void addRow(QFormLayout& form, Row row, const QString& name, const QString& toolTip);

    const Document& m_document;
    std::array<QLabel*, RowCount> m_names{};
    std::array<QLabel*, RowCount> m_values{};
    SwatchButton* m_chip = nullptr;
};

} // namespace trixel::ui
