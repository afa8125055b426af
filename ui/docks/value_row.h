// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>
#include <QWidget>

#include <optional>

class QSlider;

namespace trixel::ui {

/// How far apart numbers are on a slider.
enum class Scale { Linear, Logarithmic };

/// Spin box that shows three significant digits and, on a logarithmic scale, steps by a tenth of
/// the value.
class ScaledSpinBox : public QDoubleSpinBox
{
    Q_OBJECT

public:
    explicit ScaledSpinBox(Scale scale, QWidget* parent = nullptr);

    QString textFromValue(double value) const override;
    double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& position) const override;
    void stepBy(int steps) override;

private:
    std::optional<double> read(const QString& text) const;

    Scale m_scale;
};

/// A slider and a spin box for one number.
class ValueRow : public QWidget
{
    Q_OBJECT

public:
    struct Texts
    {
        QString name;    ///< for screen readers
        QString toolTip; ///< what it does, with its unit and shortcut
        QString suffix;  ///< unit behind the number, or empty
    };

    ValueRow(Scale scale, double low, double high, const Texts& texts, QWidget* parent = nullptr);

    /// \param low  above 0 on a logarithmic scale
    void setRange(double low, double high);
    double value() const { return m_spin->value(); }
    /// Brought into the range; tells nobody.
    void setValue(double value);
    /// Another tool tip than it was made with.
    void setHint(const QString& toolTip);
    /// Whether the user holds the slider.
    bool isDragged() const;
    /// The widget a label's mnemonic leads to.
    QWidget* buddy() const { return m_spin; }

signals:
    /// By the user's hand.
    void edited(double value);
    /// The user takes the slider: all edits until it is let go belong together.
    void grabbed();

private:
    int toSlider(double value) const;
    double fromSlider(int position) const;

    Scale m_scale;
    QSlider* m_slider;
    ScaledSpinBox* m_spin;
};

} // namespace trixel::ui
