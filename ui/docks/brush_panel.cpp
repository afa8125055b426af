// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/brush_panel.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/docks/brush_colors.h"
#include "ui/docks/swatches.h"
#include "ui/docks/value_row.h"
#include "ui/viewport/view_settings.h"
#include "ui/window/icons.h"

#include <cmath>

namespace trixel::ui {

namespace {

constexpr int kSwatchesPerRow = 12;

QToolButton* smallButton(const QString& iconName, const QString& name, const QString& toolTip)
{
    auto* button = new QToolButton;
    button->setIcon(icon(iconName));
    button->setAutoRaise(true);
    button->setAccessibleName(name);
    button->setToolTip(toolTip);
    return button;
}

} // namespace

BrushPanel::BrushPanel(ViewSettings& settings, BrushColors& colors, QWidget* parent)
    : QWidget(parent)
    , m_settings(settings)
    , m_colors(colors)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(8);
    layout->addWidget(makeColors());
    layout->addWidget(makeValues());
    layout->addWidget(makeSwitches());
    layout->addStretch(1);

    connect(&settings, &ViewSettings::brushChanged, this, &BrushPanel::showBrush);
    connect(&colors, &BrushColors::changed, this, &BrushPanel::showColors);
    setSurfaceSize(2.0F);
    showBrush();
    showColors();
}

QWidget* BrushPanel::makeColors()
{
    auto* box = new QWidget;
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(6);

    m_front = new SwatchButton({64, 30});
    m_front->setPurpose(tr("Colour to paint with"));
    m_back = new SwatchButton({30, 30});
    m_back->setPurpose(tr("Colour to swap with"));
    QToolButton* swap = smallButton("swap", tr("Swap colours"), tr("Swap the two colours (X)"));
    QToolButton* reset = smallButton(
        "default-colors", tr("Default colours"), tr("Paint with black, swap with white (D)"));
    auto* pair = new QHBoxLayout;
    pair->setSpacing(6);
    pair->addWidget(m_front);
    pair->addWidget(m_back);
    pair->addWidget(swap);
    pair->addWidget(reset);
    pair->addStretch(1);
    grid->addLayout(pair, 0, 0);

    auto* palette = new SwatchRow(kSwatchesPerRow, tr("Palette colour"));
    palette->setColors(paletteColors());
    grid->addWidget(palette, 1, 0);
    auto* recentLabel = new QLabel(tr("Recent"));
    recentLabel->setToolTip(tr("Colours used before, the latest first"));
    m_recent = new SwatchRow(kSwatchesPerRow, tr("Recent colour"));
    m_recent->setMinimumHeight(18); // the first colour moves nothing
    auto* recent = new QHBoxLayout;
    recent->setSpacing(6);
    recent->addWidget(recentLabel);
    recent->addWidget(m_recent, 1);
    grid->addLayout(recent, 2, 0);

    connect(m_front, &SwatchButton::clicked, this, &BrushPanel::chooseColor);
    connect(m_back, &SwatchButton::clicked, &m_colors, &BrushColors::swap);
    connect(swap, &QToolButton::clicked, &m_colors, &BrushColors::swap);
    connect(reset, &QToolButton::clicked, &m_colors, &BrushColors::reset);
    const auto choose = [this](const QColor& color) { m_colors.choose(color); };
    connect(palette, &SwatchRow::chosen, this, choose);
    connect(m_recent, &SwatchRow::chosen, this, choose);
    return box;
}

QWidget* BrushPanel::makeValues()
{
    auto* box = new QWidget;
    auto* form = new QFormLayout(box);
    form->setContentsMargins(0, 0, 0, 0);
    form->setVerticalSpacing(5);
    form->setHorizontalSpacing(8);
    form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);

    m_radius = new ValueRow(
        Scale::Logarithmic,
        1e-3,
        1.0,
        {tr("Radius"), tr("Radius of the brush on the surface, in world units ([ and ])"), {}});
    form->addRow(tr("&Radius"), m_radius);
    connect(m_radius, &ValueRow::edited, this, [this](double value) {
        Brush brush = m_settings.brush();
        brush.radius = static_cast<float>(value);
        m_settings.setBrush(brush);
    });
    addPercent(form,
               tr("&Hardness"),
               tr("Part of the radius painted at full strength (Shift+[ and Shift+])"),
               &Brush::hardness);
    addPercent(form,
               tr("&Opacity"),
               tr("The most that one stroke covers, however often it crosses itself (1 to 0)"),
               &Brush::opacity);
    addPercent(
        form, tr("F&low"), tr("What each dab adds until the opacity is reached"), &Brush::flow);
    addPercent(form,
               tr("S&pacing"),
               tr("Distance from one dab to the next, as a part of the brush's diameter"),
               &Brush::spacing,
               200.0);
    return box;
}

void BrushPanel::addPercent(QFormLayout* form,
                            const QString& label,
                            const QString& toolTip,
                            float Brush::*value,
                            double high)
{
    const double low = value == &Brush::spacing ? 1.0 : 0.0;
    auto* row =
        new ValueRow(Scale::Linear, low, high, {QString(label).remove('&'), toolTip, tr(" %")});
    form->addRow(label, row);
    m_percents.emplace_back(row, value);
    connect(row, &ValueRow::edited, this, [this, value](double percent) {
        Brush brush = m_settings.brush();
        brush.*value = static_cast<float>(percent / 100.0);
        m_settings.setBrush(brush);
    });
}

QWidget* BrushPanel::makeSwitches()
{
    auto* box = new QWidget;
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(4);
    grid->addWidget(makeSwitch(tr("Pressure to &size"),
                               tr("A pen's pressure scales the radius"),
                               &Brush::pressureToSize),
                    0,
                    0);
    grid->addWidget(makeSwitch(tr("Pressure to op&acity"),
                               tr("A pen's pressure scales the opacity"),
                               &Brush::pressureToOpacity),
                    0,
                    1);
    grid->addWidget(makeSwitch(tr("Paint &through"),
                               tr("Paint faces on the far side within the radius too"),
                               &Brush::paintThrough),
                    1,
                    0);
    return box;
}

QCheckBox* BrushPanel::makeSwitch(const QString& text, const QString& toolTip, bool Brush::*value)
{
    auto* box = new QCheckBox(text);
    box->setToolTip(toolTip);
    box->setAccessibleName(QString(text).remove('&'));
    m_switches.emplace_back(box, value);
    connect(box, &QCheckBox::clicked, this, [this, value](bool on) {
        Brush brush = m_settings.brush();
        brush.*value = on;
        m_settings.setBrush(brush);
    });
    return box;
}

void BrushPanel::setSurfaceSize(float size)
{
    const float unit = size > 0 && std::isfinite(size) ? size : 1.0F;
    m_radius->setRange(static_cast<double>(unit * kLeastRadius),
                       static_cast<double>(unit * kMostRadius));
    m_radius->setValue(static_cast<double>(m_settings.brush().radius));
}

void BrushPanel::showBrush()
{
    const Brush& brush = m_settings.brush();
    m_radius->setValue(static_cast<double>(brush.radius));
    for (const auto& [row, value] : m_percents) {
        row->setValue(100.0 * static_cast<double>(brush.*value));
    }
    for (const auto& [box, value] : m_switches) {
        box->setChecked(brush.*value);
    }
}

void BrushPanel::showColors()
{
    m_front->setColor(m_colors.color());
    m_back->setColor(m_colors.other());
    m_recent->setColors(m_colors.recent());
}

void BrushPanel::chooseColor()
{
    auto* dialog = new QColorDialog(m_colors.color(), window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Colour to Paint With"));
    dialog->setOption(QColorDialog::ShowAlphaChannel, m_hasAlpha);
    connect(dialog, &QColorDialog::colorSelected, this, [this](const QColor& color) {
        m_colors.choose(color);
    });
    dialog->open();
}

} // namespace trixel::ui
