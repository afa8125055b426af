// SPDX-License-Identifier: GPL-3.0-or-later
//
// What stops look for in the window.
#pragma once

#include <QApplication>
#include <QDialog>

#include "core/base/result.h"

#include <string>

namespace trixel::app {

/// Nothing where it holds, else an error: "tour: " and the sentence.
inline Status expect(bool holds, const std::string& sentence)
{
    return holds ? Status() : contentsError("tour: " + sentence);
}

/// The dialog that is shown; null where none is.
inline QDialog* openDialog()
{
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        auto* dialog = qobject_cast<QDialog*>(widget);
        if (dialog != nullptr && dialog->isVisible()) {
            return dialog;
        }
    }
    return nullptr;
}

} // namespace trixel::app
