// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>

#include "core/filter/filter_method.h"

namespace trixel::ui {

class ViewSettings;

/// The filter method of the view, chosen from the table of all methods.
class MethodBox : public QComboBox
{
    Q_OBJECT

public:
    explicit MethodBox(ViewSettings& settings, QWidget* parent = nullptr);

private:
    void follow();

    ViewSettings& m_settings;
};

} // namespace trixel::ui
