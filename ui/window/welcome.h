// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QAction;

namespace trixel::ui {

/// What to do first, in the place of the view while nothing is open.
class Welcome : public QWidget
{
    Q_OBJECT

public:
    /// \param actions  offered as buttons, the first of them as the obvious one
    explicit Welcome(const QList<QAction*>& actions, QWidget* parent = nullptr);
};

} // namespace trixel::ui
