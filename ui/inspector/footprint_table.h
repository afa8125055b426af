// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/inspector/footprint_rows.h"

#include <array>
#include <optional>

class QGridLayout;
class QLabel;

namespace trixel::ui {

/// The numbers of a footprint and, beside or below each, of the frozen one.
class FootprintTable : public QWidget
{
    Q_OBJECT

public:
    explicit FootprintTable(QWidget* parent = nullptr);

    void show(const std::optional<FootprintFacts>& facts);
    void showFrozen(const std::optional<FootprintFacts>& facts);
    QString text(FootprintRow row) const;
    QString frozenText(FootprintRow row) const;
    /// All rows as lines, for the clipboard.
    QString text() const;

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void place();
    void colorFrozen();

    QGridLayout* m_grid;
    std::array<QLabel*, kFootprintRows> m_names{};
    std::array<QLabel*, kFootprintRows> m_values{};
    std::array<QLabel*, kFootprintRows> m_frozen{};
    bool m_hasFrozen = false;
    bool m_isWide = false;
};

} // namespace trixel::ui
