// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/value_spin.h"

#include <QLineEdit>

#include <cmath>

namespace trixel::ui {

namespace {

constexpr double kMost = 3.4e38;
constexpr int kDigits = 6;

} // namespace

ValueSpin::ValueSpin(QWidget* parent)
    : QDoubleSpinBox(parent)
{
    setRange(-kMost, kMost);
    setDecimals(15); // rounding is for the eye alone
    setKeyboardTracking(false);
    setAlignment(Qt::AlignRight);
    QLocale plain = locale();
    plain.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
    setLocale(plain);
}

QString ValueSpin::textFromValue(double value) const
{
    return locale().toString(value, 'g', kDigits);
}

double ValueSpin::valueFromText(const QString& text) const
{
    bool isNumber = false;
    const double number = locale().toDouble(text.trimmed(), &isNumber);
    return isNumber && std::isfinite(number) ? number : value();
}

QValidator::State ValueSpin::validate(QString& text, int& /*position*/) const
{
    bool isNumber = false;
    const double number = locale().toDouble(text.trimmed(), &isNumber);
    return isNumber && std::abs(number) <= kMost ? QValidator::Acceptable
                                                 : QValidator::Intermediate;
}

QSize ValueSpin::sizeHint() const
{
    const QSize usual = QDoubleSpinBox::minimumSizeHint();
    return {fontMetrics().horizontalAdvance("−0.000000") + 34, usual.height()};
}

} // namespace trixel::ui
