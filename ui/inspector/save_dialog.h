// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>

#include <functional>

class QWidget;

namespace trixel::ui {

/// One way to write a file, as the dialog offers it.
struct SaveKind
{
    QString filter; ///< "Tables (*.csv)"
    QString ending; ///< "csv", which a name without one gets
};

/// Asks for a file, beginning in the folder that was written to last and remembering the one
/// chosen. The dialog is the system's own where there is one.
/// \param name   without ending
/// \param kinds  at least one
/// \param then   called with the path and the number of the kind; not when the dialog is left
void askWhereToSave(QWidget& parent,
                    const QString& title,
                    const QString& name,
                    const QList<SaveKind>& kinds,
                    std::function<void(const QString& path, int kind)> then);

} // namespace trixel::ui
