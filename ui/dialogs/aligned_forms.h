// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>

class QFormLayout;

namespace trixel::ui {

/// Makes the labels of forms that stand below each other equally wide, so that their fields begin
/// at one line.
void alignForms(const QList<QFormLayout*>& forms);

} // namespace trixel::ui
