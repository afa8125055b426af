// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QFormLayout;
class QLabel;
class QPushButton;

namespace trixel::ui {

class QuadPlacement;
class ValueRow;

/// What there is to say and to choose about four corners that lie in the view.
class PlacePage : public QWidget
{
    Q_OBJECT

public:
    /// \param placement  outlives this
    explicit PlacePage(QuadPlacement& placement, QWidget* parent = nullptr);

    /// Says what holds now.
    void follow();

private:
    QuadPlacement& m_placement;
    QLabel* m_about;
    QPushButton* m_here;
    QPushButton* m_return;
    QPushButton* m_corners;
    ValueRow* m_over;
};

} // namespace trixel::ui
