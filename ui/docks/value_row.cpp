// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/value_row.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>

#include <algorithm>
#include <cmath>

namespace trixel::ui {

namespace {

constexpr int kSliderSteps = 1000;
constexpr int kSpinWidth = 78;
constexpr int kDigits = 3;

} // namespace

ScaledSpinBox::ScaledSpinBox(Scale scale, QWidget* parent)
    : QDoubleSpinBox(parent)
    , m_scale(scale)
{
    // Rounding is for the eye alone: a mesh may be a micrometre or a mile across.
    setDecimals(scale == Scale::Logarithmic ? 15 : 1);
    QLocale plain = locale();
    plain.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
    setLocale(plain);
    setKeyboardTracking(false);
    setAlignment(Qt::AlignRight);
}

QString ScaledSpinBox::textFromValue(double value) const
{
    if (m_scale == Scale::Linear) {
        return locale().toString(value, 'f', value == std::round(value) ? 0 : 1);
    }
    constexpr double kLeastFixed = 1e-3;
    constexpr double kMostFixed = 1e5;
    if (value < kLeastFixed || value >= kMostFixed) {
        return locale().toString(value, 'g', kDigits);
    }
    const int before = static_cast<int>(std::floor(std::log10(value))) + 1;
    return locale().toString(value, 'f', std::clamp(kDigits - before, 0, 6));
}

std::optional<double> ScaledSpinBox::read(const QString& text) const
{
    QString number = text;
    if (!suffix().isEmpty() && number.endsWith(suffix())) {
        number.chop(suffix().size());
    }
    bool isNumber = false;
    const double value = locale().toDouble(number.trimmed(), &isNumber);
    return isNumber && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

double ScaledSpinBox::valueFromText(const QString& text) const
{
    return std::clamp(read(text).value_or(value()), minimum(), maximum());
}

QValidator::State ScaledSpinBox::validate(QString& text, int& /*position*/) const
{
    const std::optional<double> value = read(text);
    return value && *value >= minimum() && *value <= maximum() ? QValidator::Acceptable
                                                               : QValidator::Intermediate;
}

void ScaledSpinBox::stepBy(int steps)
{
    if (m_scale == Scale::Logarithmic) {
        const double from = value() > 0 ? value() : steps > 0 ? singleStep() : 0;
        setValue(from * std::pow(1.1, steps));
    } else {
        QDoubleSpinBox::stepBy(steps);
    }
}

ValueRow::ValueRow(Scale scale, double low, double high, const Texts& texts, QWidget* parent)
    : QWidget(parent)
    , m_scale(scale)
    , m_slider(new QSlider(Qt::Horizontal))
    , m_spin(new ScaledSpinBox(scale))
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addWidget(m_slider, 1);
    layout->addWidget(m_spin);

    m_slider->setRange(0, kSliderSteps);
    m_slider->setPageStep(kSliderSteps / 10);
    m_slider->setSingleStep(kSliderSteps / 100);
    m_slider->setAccessibleName(tr("%1 slider").arg(texts.name));
    m_slider->setToolTip(texts.toolTip);
    m_spin->setFixedWidth(kSpinWidth);
    m_spin->setSuffix(texts.suffix);
    m_spin->setAccessibleName(texts.name);
    m_spin->setToolTip(texts.toolTip);
    // The number does all that the slider does: one stop of Tab, forwards and backwards.
    m_slider->setFocusPolicy(Qt::ClickFocus);
    setFocusProxy(m_spin);
    setRange(low, high);

    connect(m_slider, &QSlider::sliderPressed, this, &ValueRow::grabbed);
    connect(m_slider, &QSlider::valueChanged, this, [this](int position) {
        const QSignalBlocker quiet(m_spin);
        m_spin->setValue(fromSlider(position));
        emit edited(m_spin->value());
    });
    connect(m_spin, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        const QSignalBlocker quiet(m_slider);
        m_slider->setValue(toSlider(value));
        emit edited(value);
    });
}

void ValueRow::setRange(double low, double high)
{
    const QSignalBlocker quietSpin(m_spin);
    m_spin->setRange(low, high);
    setValue(m_spin->value());
}

void ValueRow::setValue(double value)
{
    const QSignalBlocker quietSpin(m_spin);
    const QSignalBlocker quietSlider(m_slider);
    m_spin->setValue(value);
    m_slider->setValue(toSlider(m_spin->value()));
}

void ValueRow::setHint(const QString& toolTip)
{
    m_slider->setToolTip(toolTip);
    m_spin->setToolTip(toolTip);
}

bool ValueRow::isDragged() const
{
    return m_slider->isSliderDown();
}

int ValueRow::toSlider(double value) const
{
    const double low = m_spin->minimum();
    const double high = m_spin->maximum();
    const double part = m_scale == Scale::Logarithmic ? std::log(value / low) / std::log(high / low)
                                                      : (value - low) / (high - low);
    return static_cast<int>(std::lround(std::clamp(part, 0.0, 1.0) * kSliderSteps));
}

double ValueRow::fromSlider(int position) const
{
    const double part = static_cast<double>(position) / kSliderSteps;
    const double low = m_spin->minimum();
    const double high = m_spin->maximum();
    return m_scale == Scale::Logarithmic ? low * std::pow(high / low, part)
                                         : low + (high - low) * part;
}

} // namespace trixel::ui
