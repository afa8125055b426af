// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>

namespace trixel::ui {

/// A field for any float: written with six significant digits, stepped by a part of some width.
class ValueSpin : public QDoubleSpinBox
{
    Q_OBJECT

public:
    explicit ValueSpin(QWidget* parent = nullptr);

    QString textFromValue(double value) const override;
    double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& position) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {64, sizeHint().height()}; }
};

} // namespace trixel::ui
