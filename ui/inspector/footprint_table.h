// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableView>

#include "ui/inspector/footprint_model.h"

#include <optional>

namespace trixel::ui {

/// The numbers of a footprint and, beside or below each, of the frozen one. Rows are as high as
/// their numbers may get, so that nothing moves while they change. Ctrl+C copies what is selected.
class FootprintTable : public QTableView
{
    Q_OBJECT

public:
    explicit FootprintTable(QWidget* parent = nullptr);

    void show(const std::optional<FootprintFacts>& facts) { m_model->show(facts); }
    void showFrozen(const std::optional<FootprintFacts>& facts) { m_model->showFrozen(facts); }
    QString text(FootprintRow row) const { return m_model->text(row); }
    QString frozenText(FootprintRow row) const { return m_model->frozenText(row); }
    /// All rows as lines, for the clipboard.
    QString text() const { return m_model->text(); }

    QSize sizeHint() const override { return {280, 180}; }
    QSize minimumSizeHint() const override;

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void arrange();
    void copySelected() const;

    FootprintModel* m_model;
};

} // namespace trixel::ui
